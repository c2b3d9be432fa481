// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words of the command line for the data that prepare_force.h and the loop report.

#include <string>

#include "playback/force_feedback.h"

namespace detent::playback {

/// A sentence with displacement, drawn slope and felt slope of a remark.
std::string sentenceOf(const ForceRemark& remark, const Button& button);
/// "wall_softened": the same for scripts.
std::string codeOf(ForceRemarkKind kind);
/// A sentence with range and slope of a stretch, and the steepest slope that the device bears.
std::string sentenceOf(const UnstableStretch& stretch, const Button& button);
std::string codeOf(StabilityBound bound);
/// Code for scripts: "none", "emergency_stop", "reversed_polarity", "handle_not_moving", "encoder_dead",
/// "runaway", "repeated_drop_outs", "place_lost", "not_held".
std::string codeOf(ForceHalt halt);
/// Cause and remedy; empty if a person did it on purpose.
std::string sentenceOf(ForceHalt halt);
/// State of a log row: the state's name, "momentary" if it has none.
std::string stateName(const Button& button, std::uint32_t state);

}  // namespace detent::playback
