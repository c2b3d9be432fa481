// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/performance_json.h"

namespace detent::playback {

namespace {

Json numberOrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

Json bandJson(const Band& band) { return {{"median", band.median}, {"low", band.low}, {"high", band.high}}; }

Json forecastJson(const PressForecast& forecast) {
  Json json{{"name", forecast.name},
            {"operating_point_mm", numberOrNull(forecast.operatingPoint_mm)},
            {"reset_point_mm", numberOrNull(forecast.resetPoint_mm)},
            {"jump_is_felt", forecast.jumpIsFelt}};
  Json reasons = Json::object();
  for (std::size_t f = 0; f < pressFigureCount; ++f) {
    const char* key = pressFigureNames()[f].key;
    const std::vector<double>& values = forecast.ofFingers[f];
    json[key] = values.empty() ? Json(nullptr) : bandJson(bandOf(values));
    if (values.empty()) reasons[key] = reasonOf(forecast.why[f]);
  }
  json["reasons"] = std::move(reasons);
  return json;
}

}  // namespace detent::playback
