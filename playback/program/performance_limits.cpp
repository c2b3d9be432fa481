// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/performance_limits.h"

#include <cmath>
#include <optional>

#include "model/file/text_file.h"
#include "playback/program/json_output.h"

namespace detent::playback {

namespace {

std::string limitWord(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<double> numberOf(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end() || !found->is_number()) return {};
  return found->get<double>();
}

std::optional<LimitedFigure> figureOf(const std::string& key) {
  for (const LimitedFigure figure : {LimitedFigure::keyForce, LimitedFigure::travel}) {
    if (key == keyOf(figure)) return figure;
  }
  return {};
}

std::optional<Limit> limitOf(const Json& entry) {
  if (!entry.is_object()) return {};
  const std::optional<LimitedFigure> figure = figureOf(limitWord(entry, "figure"));
  Limit limit{limitWord(entry, "standard"), limitWord(entry, "edition"),
              limitWord(entry, "clause"),   limitWord(entry, "kind"),
              LimitedFigure::keyForce,      numberOf(entry, "least"),
              numberOf(entry, "most"),      numberOf(entry, "tolerance").value_or(0)};
  if (limit.kind.empty()) limit.kind = "required";
  if (!figure || limit.standard.empty() || (!limit.least && !limit.most)) return {};
  if (limit.tolerance < 0 || (limit.least && limit.most && *limit.least > *limit.most)) return {};
  if (limit.kind != "required" && limit.kind != "preferred") return {};
  limit.figure = *figure;
  return limit;
}

Failure unusable(const std::string& file, const std::string& place) {
  return {FailureCode::unreadableInput, file, place, "is no limit",
          "Give \"standard\", \"figure\" (\"key_force_N\" or \"travel_mm\") and \"least\" or \"most\", least "
          "below most; "
          "\"kind\" is \"required\" or \"preferred\", \"tolerance\" 0 or more"};
}

}  // namespace

const char* keyOf(LimitedFigure figure) {
  return figure == LimitedFigure::keyForce ? "key_force_N" : "travel_mm";
}

Result<std::vector<Limit>> readLimits(const std::string& file) {
  Result<std::string> text = readTextFile(file);
  if (!text) return text.failure();
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_array() || json.empty())
    return Failure{FailureCode::unreadableInput, file, "", "is no JSON array of limits",
                   "See docs/reference/press-forecast.md, \"Limits of standards\""};
  std::vector<Limit> limits;
  for (const Json& entry : json) {
    std::optional<Limit> limit = limitOf(entry);
    if (!limit) return unusable(file, "entry " + std::to_string(limits.size() + 1));
    limits.push_back(*std::move(limit));
  }
  return limits;
}

}  // namespace detent::playback
