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
/// Of a log row: the state's name, "momentary" where it has none.
std::string stateName(const Button& button, std::uint32_t state);

}  // namespace detent::playback
