// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play performance: forecasts how fast, how reliably and with how much force people will press these
// buttons.

#include <string>
#include <vector>

#include "playback/performance/forecast.h"
#include "playback/program/command.h"

namespace detent::playback {

void addPerformanceCommand(CLI::App& program, Action& chosen);

/// Forecast of one button as JSON.
std::string buttonJson(const PressForecast& forecast);

}  // namespace detent::playback
