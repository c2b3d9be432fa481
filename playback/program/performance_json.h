// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A forecast of presses as JSON, in the shape that scripts rely on.

#include "playback/performance/forecast.h"
#include "playback/program/json_output.h"

namespace detent::playback {

/// "median", "low", "high": 5 to 95 % of the fingers.
Json bandJson(const Band& band);

/// Forecast of one button.
Json forecastJson(const PressForecast& forecast);

}  // namespace detent::playback
