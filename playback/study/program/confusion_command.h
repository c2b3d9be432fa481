// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play confusion: will people tell these buttons apart?

#include <string>

#include "playback/program/command.h"
#include "playback/study/perception/confusion.h"

namespace detent::playback {

void addConfusionCommand(CLI::App& program, Action& chosen);

/// What differs most, as a clause: "the press differs in strength (2.3 noticeable steps)".
std::string reasonOf(const PredictedPair& pair);

}  // namespace detent::playback
