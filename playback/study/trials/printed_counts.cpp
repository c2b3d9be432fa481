// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/printed_counts.h"

#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/file/text_file.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr int countsVersion = 1;
constexpr const char* fileName = "counts.json";

Count countFrom(const Json& json) { return {json.at("errors"), json.at("trials")}; }

std::string percent(const Count& count) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * rateOf(count));
  return text;
}

std::string fraction(std::size_t part, std::size_t whole) {
  return std::to_string(part) + "/" + std::to_string(whole);
}

GroupResult groupFrom(const Json& json, const std::vector<std::string>& labels) {
  GroupResult group;
  group.condition = json.at("condition");
  group.participantCount = json.at("participants");
  const std::size_t perTest = json.at("trials_per_test");
  group.meanTime_min = json.at("mean_time_min");
  group.sdTime_min = json.at("sd_time_min");
  group.errors = countFrom(json.at("printed_errors"));
  group.fails = countFrom(json.at("printed_fails"));
  group.wilson = wilson(group.errors);
  group.clopperPearson = clopperPearson(group.errors);
  for (const auto& [first, second] : pairsOf(labels.size())) {
    PairResult pair = pairResult(
        first, second,
        {json.at("errors").at(labels[first] + "-" + labels[second]), group.participantCount * perTest});
    if (json.contains("pair_fails"))
      pair.failCount = json["pair_fails"].value(labels[first] + "-" + labels[second], std::size_t{0});
    group.pairs.push_back(std::move(pair));
  }
  return group;
}

void check(const GroupResult& group, std::vector<std::string>& wrong) {
  Count sum;
  for (const PairResult& pair : group.pairs) {
    sum.errors += pair.errors.errors;
    sum.trials += pair.errors.trials;
  }
  if (sum != group.errors)
    wrong.push_back(group.condition + ": the pairs add up to " + fraction(sum.errors, sum.trials) +
                    " errors, printed are " + fraction(group.errors.errors, group.errors.trials));
  if (const std::size_t tests = group.pairs.size() * group.participantCount; tests != group.fails.trials)
    wrong.push_back(group.condition + ": " + std::to_string(tests) + " tests were made, printed are " +
                    std::to_string(group.fails.trials));
}

/// A printed matching experiment: the number of right matches, and the text's figures for each participant.
GroupResult matchingFrom(const Json& json, std::vector<std::string>& wrong) {
  GroupResult group;
  group.condition = json.at("condition");
  group.participantCount = json.at("participants");
  const std::size_t buttons = json.at("buttons"), right = json.at("printed_right");
  const std::size_t printed = json.at("printed_trials"), trials = group.participantCount * buttons;
  group.errors = {printed - right, printed};
  group.wilson = wilson(group.errors);
  group.clopperPearson = clopperPearson(group.errors);
  const Count printedRight{right, printed};
  if (trials != printed) {
    const auto same =
        static_cast<std::size_t>(std::lround(rateOf(printedRight) * static_cast<double>(trials)));
    wrong.push_back(group.condition + ": \"" + fraction(right, printed) + "\" is printed (" +
                    percent(printedRight) + "), but " + std::to_string(group.participantCount) +
                    " participants x " + std::to_string(buttons) + " buttons are " + std::to_string(trials) +
                    " trials; " + fraction(same, trials) + " would be " + percent({same, trials}) + " too, " +
                    std::to_string(printed) + " trials would need " + std::to_string(printed / buttons) +
                    " participants");
  }
  const auto each = json.at("right_per_participant").get<std::vector<std::size_t>>();
  const std::size_t sum = std::accumulate(each.begin(), each.end(), std::size_t{0});
  if (each.size() == group.participantCount && sum * printed != right * trials)
    wrong.push_back(group.condition + ": what the text tells of each participant adds up to at most " +
                    fraction(sum, trials) + " (" + percent({sum, trials}) + "), not " +
                    percent(printedRight));
  return group;
}

}  // namespace

bool holdsPrintedCounts(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(folder / fileName, error);
}

Result<StudyResults> readPrintedCounts(const std::filesystem::path& folder) {
  const std::string file = (folder / fileName).string();
  const auto broken = [&](Message problem) {
    return Failure{FailureCode::unreadableInput, file, "", std::move(problem), Message("Restore the file")};
  };
  Result<std::string> text = readTextFile(file);
  if (!text) return text.failure();
  try {
    const Json json = Json::parse(*text);
    if (json.at("format") != "detent-study-counts" || json.at("version") != countsVersion)
      return broken(Message("the file does not hold counted answers, version %1", countsVersion));
    StudyResults results;
    results.study = json.at("title");
    results.source = json.at("source");
    results.labels = json.at("labels").get<std::vector<std::string>>();
    results.names = results.labels;
    results.trialsPerTest = json.at("trials_per_test");
    results.rule = discriminationRule(results.trialsPerTest);
    for (const Json& group : json.at("groups")) {
      results.groups.push_back(groupFrom(group, results.labels));
      check(results.groups.back(), results.warnings);
    }
    if (json.contains("matching"))
      results.groups.push_back(matchingFrom(json.at("matching"), results.warnings));
    return results;
  } catch (const Json::exception&) {
    return broken(Message("the content is broken"));
  }
}

}  // namespace detent::playback
