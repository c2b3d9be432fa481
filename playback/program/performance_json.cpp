// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/performance_json.h"

#include "playback/program/performance_limits.h"

namespace detent::playback {

namespace {

Json numberOrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

const char* figureName(LimitOutcome outcome) {
  if (outcome == LimitOutcome::withinTolerance) return "within_tolerance";
  return outcome == LimitOutcome::pass ? "pass" : "fail";
}

Json jsonOf(const LimitFinding& finding) {
  const Limit& limit = finding.limit;
  return {{"standard", limit.standard},       {"edition", limit.edition},
          {"clause", limit.clause},           {"kind", limit.kind},
          {"figure", keyOf(limit.figure)},    {"least", numberOrNull(limit.least)},
          {"most", numberOrNull(limit.most)}, {"tolerance", limit.tolerance},
          {"value", finding.value},           {"outcome", figureName(finding.outcome)}};
}

}  // namespace

Json bandJson(const Band& band) { return {{"median", band.median}, {"low", band.low}, {"high", band.high}}; }

Json forecastJson(const PressForecast& forecast, const std::vector<LimitFinding>& findings) {
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
  Json limits = Json::array();
  for (const LimitFinding& finding : findings) limits.push_back(jsonOf(finding));
  json["limits"] = std::move(limits);
  return json;
}

}  // namespace detent::playback
