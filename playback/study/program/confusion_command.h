// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play confusion: predicts whether people can distinguish these buttons.

#include <string>

#include "playback/program/command.h"
#include "playback/study/perception/confusion.h"

namespace detent::playback {

void addConfusionCommand(CLI::App& program, Action& chosen);

/// Forecast for two buttons of these names, for scripts.
std::string pairJson(const std::string& a, const std::string& b, const PredictedPair& pair,
                     const PairRank& rank);

}  // namespace detent::playback
