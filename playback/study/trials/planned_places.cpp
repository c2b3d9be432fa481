// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/planned_places.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/text_file.h"

namespace detent::playback {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* planFile = "plan.json";
constexpr int planVersion = 1;

Failure brokenPlan(const fs::path& file, Message problem) {
  return {FailureCode::unreadableInput, file.string(), "", std::move(problem),
          Message("Restore the file from a copy, or plan again before the first participant begins")};
}

}  // namespace

PlannedPlaces usualPlaces(std::size_t people) {
  PlannedPlaces plan;
  for (std::size_t i = 1; i <= people; ++i)
    plan.participants.push_back((i < 10 ? "P0" : "P") + std::to_string(i));
  return plan;
}

Result<PlannedPlaces> placesOf(const fs::path& folder) {
  const fs::path file = folder / planFile;
  std::error_code error;
  if (!fs::exists(file, error)) return PlannedPlaces{};
  const Result<std::string> text = readTextFile(file.string());
  if (!text) return text.failure();
  try {
    const Json json = Json::parse(*text);
    if (json.at("format") != "detent-study-plan" || json.at("version") != planVersion)
      return brokenPlan(file, Message("the file is not a study plan that this program knows"));
    PlannedPlaces plan;
    plan.listsSha256 = json.at("lists_sha256");
    if (json.contains("unfinished")) {  // plans of version 1 may lack it
      const auto rule = unfinishedRules.value(json.at("unfinished").get<std::string>());
      if (!rule)
        return brokenPlan(
            file, Message("this program does not know the plan's rule for participants who did not finish"));
      plan.unfinished = *rule;
    }
    for (const Json& id : json.at("participants")) plan.participants.push_back(id.get<std::string>());
    return plan;
  } catch (const Json::exception&) {
    return brokenPlan(file, Message("the content is broken"));
  }
}

std::size_t placeOf(const PlannedPlaces& plan, const std::string& participant, std::size_t begunBefore) {
  const auto at = std::find(plan.participants.begin(), plan.participants.end(), participant);
  if (at == plan.participants.end()) return plan.participants.size() + begunBefore;
  return static_cast<std::size_t>(at - plan.participants.begin());
}

Result<Done> writePlaces(const fs::path& folder, const PlannedPlaces& plan, const std::string& studySha256,
                         const std::string& listsSha256) {
  const Json json{{"format", "detent-study-plan"},
                  {"version", planVersion},
                  {"study_sha256", studySha256},
                  {"lists_sha256", listsSha256},
                  {"unfinished", unfinishedRules.word(plan.unfinished)},
                  {"participants", plan.participants}};
  return writeTextFileAtomically((folder / planFile).string(), jsonText(json, 2) + "\n");
}

}  // namespace detent::playback
