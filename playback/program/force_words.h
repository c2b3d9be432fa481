// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What prepare_force.h and the loop report as data, in the words of the command line.

#include <string>

#include "playback/force_feedback.h"

namespace detent::playback {

/// "wall at 4.00 mm: 143 N/mm is steeper than this device renders, 2 N/mm is felt".
std::string sentenceOf(const ForceRemark& remark, const Button& button);
/// "wall_softened": the same for scripts.
std::string codeOf(ForceRemarkKind kind);
/// "the wall from 4.00 to 4.01 mm (142 N/mm) is steeper than the 0.667 N/mm that this device's damping
/// bears".
std::string sentenceOf(const UnstableStretch& stretch, const Button& button);
std::string codeOf(StabilityBound bound);
/// For scripts: "none", "emergency_stop", "reversed_polarity", "handle_not_moving", "encoder_dead",
/// "runaway", "repeated_drop_outs", "place_lost", "not_held".
std::string codeOf(ForceHalt halt);
/// Cause and remedy; empty if a person did it on purpose.
std::string sentenceOf(ForceHalt halt);
/// Of a log row: the state's name, "momentary" where it has none.
std::string stateName(const Button& button, std::uint32_t state);

}  // namespace detent::playback
