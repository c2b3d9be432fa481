// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/family.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/speed_family.h"

namespace detent::importer {
namespace {

// Speeds that differ by less were meant to be equal: testers keep a speed to a few percent.
constexpr double sameSpeed = 1.05;
// From this ratio on, a second speed is worth a graph of its own. With a smaller difference, the error of one
// record becomes a large error of the change with speed.
constexpr double otherSpeed = 1.5;

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[320];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

double ratioOf(double a, double b) { return std::max(a, b) / std::min(a, b); }

Failure oneSpeed(const std::string& input, double speed_mm_per_s) {
  return {FailureCode::wrongUsage, input, "",
          format("all that is there was pressed at one speed, %.3g mm/s", speed_mm_per_s),
          "Record the button again, at least one and a half times as fast or as slow, and name that record "
          "too; a button of "
          "one speed is imported without --family"};
}

Result<FamilyRecord> recordOf(const std::string& input, const ImportReport& report) {
  if (!report.pressSpeed)
    return Failure{FailureCode::unreadableInput, input, "",
                   "no column of times tells how fast it was pressed",
                   "Export it with the time of each sample, under a title such as \"Time (s)\"; or import "
                   "each record alone "
                   "and state the speeds: detent-graph family A B --speeds V,W -o OUT"};
  FamilyRecord record{input, report.pressSpeed->mean_mm_per_s, {}, report.confidence};
  if (report.releaseSpeed) record.releaseSpeed_mm_per_s = report.releaseSpeed->mean_mm_per_s;
  return record;
}

void doubt(Family& family, const ImportReport& report, const FamilyRecord& record) {
  if (report.pressSpeed->uneven > otherSpeed)
    family.doubts.emplace_back(
        FamilyDoubt::pressUneven,
        record.input + format(": one half of its press was %.2g times as fast as the other; let "
                              "a machine press, or press more evenly",
                              report.pressSpeed->uneven));
  if (record.releaseSpeed_mm_per_s &&
      ratioOf(*record.releaseSpeed_mm_per_s, record.speed_mm_per_s) > otherSpeed)
    family.doubts.emplace_back(
        FamilyDoubt::releaseApart,
        record.input + format(": its release, at %.3g mm/s, stands at the %.3g mm/s of its press",
                              *record.releaseSpeed_mm_per_s, record.speed_mm_per_s));
}

Result<Done> checkSpeeds(Family& family) {
  std::vector<FamilyRecord> records = family.records;
  std::ranges::sort(records, {}, &FamilyRecord::speed_mm_per_s);
  if (ratioOf(records.front().speed_mm_per_s, records.back().speed_mm_per_s) < sameSpeed)
    return oneSpeed(records.front().input, records.front().speed_mm_per_s);
  for (std::size_t i = 1; i < records.size(); ++i) {
    const FamilyRecord &slow = records[i - 1], &fast = records[i];
    const double ratio = fast.speed_mm_per_s / slow.speed_mm_per_s;
    if (ratio < sameSpeed)
      return Failure{FailureCode::wrongUsage, fast.input, "",
                     format("it was pressed at %.3g mm/s, as ", fast.speed_mm_per_s) + slow.input + " was",
                     "Leave one of the two out"};
    if (ratio < otherSpeed)
      family.doubts.emplace_back(FamilyDoubt::speedsClose,
                                 slow.input + " and " + fast.input +
                                     format(": %.3g and %.3g mm/s differ by less than a factor of %.2g; "
                                            "noise may be all their graphs differ by",
                                            slow.speed_mm_per_s, fast.speed_mm_per_s, otherSpeed));
  }
  return Done{};
}

}  // namespace

const char* nameOf(FamilyDoubt doubt) {
  switch (doubt) {
    case FamilyDoubt::speedsClose:
      return "speeds-close";
    case FamilyDoubt::pressUneven:
      return "press-uneven";
    case FamilyDoubt::releaseApart:
      return "release-apart";
  }
  return "";
}

Result<Family> importFamily(const std::vector<std::string>& inputs, const ImportRequest& request,
                            const Progress& progress) {
  if (inputs.size() > Button::mostSpeeds)
    return Failure{FailureCode::wrongUsage, "--family", "", format("is given %zu records", inputs.size()),
                   "Keep two to four of the records"};
  std::vector<Button> buttons;
  std::vector<double> speeds;
  std::optional<Family> family;
  for (const std::string& input : inputs) {
    auto session = ImportSession::open(input, request.limits);
    if (!session) return session.failure();
    if (!session->isForceLog())
      return Failure{FailureCode::wrongUsage, input, "",
                     "the file is not a record of a press and states no speed",
                     "Import it alone and state the speeds: detent-graph family A B --speeds V,W -o OUT"};
    ImportRequest one = request;
    one.path = input;
    const auto [report, evidence, question, interpretations] = session->attempt(one, progress);
    if (!report) return report.failure();
    auto record = recordOf(input, *report);
    if (!record) return record.failure();
    if (!family) family = Family{report->button, {}, {}};
    doubt(*family, *report, *record);
    buttons.push_back(report->button);
    speeds.push_back(record->speed_mm_per_s);
    family->records.push_back(*std::move(record));
  }
  if (inputs.size() < 2) return oneSpeed(inputs.front(), speeds.front());
  if (auto fits = checkSpeeds(*family); !fits) return fits.failure();
  auto button = familyOf(buttons, speeds);
  if (!button) return button.failure();
  family->button = *std::move(button);
  return *std::move(family);
}

std::string familyJson(const Family& family, const std::string& output) {
  using Json = nlohmann::ordered_json;
  Json json = {{"status", "ok"},
               {"output", output},
               {"records", Json::array()},
               {"warnings", Json::array()},
               {"warning_codes", Json::array()}};
  for (const FamilyRecord& record : family.records) {
    Json one = {{"input", record.input},
                {"press_speed_mm_per_s", record.speed_mm_per_s},
                {"confidence", record.confidence}};
    if (record.releaseSpeed_mm_per_s) one["release_speed_mm_per_s"] = *record.releaseSpeed_mm_per_s;
    json["records"].push_back(std::move(one));
  }
  for (const auto& [code, sentence] : family.doubts) {
    json["warnings"].push_back(sentence);
    json["warning_codes"].push_back(nameOf(code));
  }
  return jsonText(json);
}

std::string familyText(const Family& family, const std::string& output) {
  std::string text;
  for (const FamilyRecord& record : family.records)
    text += record.input +
            format(": pressed at %.3g mm/s, confidence %.2f\n", record.speed_mm_per_s, record.confidence);
  for (const auto& [code, sentence] : family.doubts) text += "warning: " + sentence + "\n";
  if (!output.empty()) text += "wrote " + output + "\n";
  return text;
}

}  // namespace detent::importer
