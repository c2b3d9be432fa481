// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play confusion: will people tell these buttons apart?

#include <string>

#include "playback/program/command.h"
#include "playback/study/perception/confusion.h"

namespace detent::playback {

void addConfusionCommand(CLI::App& program, Action& chosen);

/// What differs most, as a clause: "most on the press: how strong it is (2.3 noticeable steps)"; that nothing does, where d' is 0.
std::string reasonOf(const PredictedPair& pair);

}  // namespace detent::playback
