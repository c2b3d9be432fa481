// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sentences and codes of the command line for the results of prepare_force.h and the loop.

#include <string>

#include "playback/force_feedback.h"

namespace detent::playback {

/// A sentence with displacement, drawn slope and felt slope of a remark.
std::string sentenceOf(const ForceRemark& remark, const Button& button);
/// Code for scripts: "wall_softened".
std::string codeOf(ForceRemarkKind kind);
/// A sentence with range and slope of a stretch, and the steepest slope that is stable on the device.
std::string sentenceOf(const UnstableStretch& stretch, const Button& button);
std::string codeOf(StabilityBound bound);
/// Code for scripts: "none", "emergency_stop", "reversed_polarity", "handle_not_moving", "encoder_dead",
/// "runaway", "repeated_drop_outs", "place_lost", "not_held".
std::string codeOf(ForceHalt halt);
/// Sentence with cause and remedy; empty if a person stopped the force on purpose.
std::string sentenceOf(ForceHalt halt);
/// State of a log row: the state's name, "momentary" if it has none.
std::string stateName(const Button& button, std::uint32_t state);

}  // namespace detent::playback
