// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play performance: how fast, how surely and with how much force will people press these buttons?

#include <string>
#include <vector>

#include "playback/performance/forecast.h"
#include "playback/performance/limits.h"
#include "playback/program/command.h"

namespace detent::playback {

void addPerformanceCommand(CLI::App& program, Action& chosen);

/// What is foretold of one button and the limits it was held against, as scripts read it.
std::string buttonJson(const PressForecast& forecast, const std::vector<LimitFinding>& findings);

}  // namespace detent::playback
