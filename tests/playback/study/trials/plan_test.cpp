// SPDX-License-Identifier: GPL-3.0-or-later
// A study before the first person comes: lists that are kept to, power, the page.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "model/file/text_file.h"
#include "model/sha256.h"
#include "playback/study/trials/study_plan.h"
#include "playback/study/trials/trial_plan.h"
#include "tests/playback/study/trials/study_folder.h"

using namespace detent;
using namespace detent::playback;
namespace fs = std::filesystem;
using detent::test::answer;
using detent::test::simulatedStart;
using detent::test::StudyFolder;

namespace {

StudyDesign twoModes() {
  StudyDesign design;
  design.seed = 11;
  design.trials = 2;
  design.pairsEach = 2;
  design.modes = {FeedbackMode::full, FeedbackMode::clickOnly};
  return design;
}

/// The list a journal was worked through by, as that of study plan.
std::string listOf(const Study& study, const std::string& id) {
  const Result<ParticipantRecord> record = readParticipant(study, id);
  REQUIRE(record);
  return listCsv(study, id, record->place);
}

double cellOf(const FigureTable& table, std::size_t row, const std::string& key) {
  const auto at = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const FigureColumn& column) { return column.key == key; });
  REQUIRE(at != table.columns.end());
  return std::get<double>(table.rows[row][static_cast<std::size_t>(at - table.columns.begin())]);
}

}  // namespace

TEST_CASE("plan: the lists made before are those that are worked through, whoever comes first") {
  const StudyFolder made(twoModes());
  const fs::path lists = made.folder().parent_path() / "lists";
  const Result<std::string> sha256 = writeLists(*made.study, usualPlaces(4), lists);
  REQUIRE(sha256);
  for (const char* id : {"P03", "P01", "P04"}) answer(*made.study, id, "perfect", 3);
  std::string all;
  for (const char* id : {"P01", "P02", "P03", "P04"})
    all += *readTextFile((lists / (std::string(id) + ".csv")).string());
  CHECK(*sha256 == sha256Hex(all));
  for (const char* id : {"P01", "P03", "P04"})
    CHECK(listOf(*made.study, id) == *readTextFile((lists / (std::string(id) + ".csv")).string()));
  fs::remove(made.folder() / "plan.json");  // a journal that has begun knows its place
  CHECK(readParticipant(*made.study, "P03")->place == 2);
  CHECK(readParticipant(*made.study, "P03")->answers.size() == 3);
}

TEST_CASE("plan: modes and pairs of the planned are balanced, those who come besides are behind them") {
  const StudyFolder made(twoModes());
  const PlannedPlaces planned = usualPlaces(12);
  CHECK(planned.participants.back() == "P12");
  std::size_t fullFirst = 0;
  for (std::size_t place = 0; place < 12; ++place)
    if (planTrials(*made.study, planned.participants[place], place).front().mode == FeedbackMode::full)
      ++fullFirst;
  CHECK(fullFirst == 6);
  CHECK(placeOf(planned, "P05", 0) == 4);
  CHECK(placeOf(planned, "guest", 3) == 15);
  CHECK(placeOf({}, "guest", 3) == 3);
}

TEST_CASE("plan: after the first person no lists are made, and a broken plan begins nobody") {
  const StudyFolder made(twoModes());
  std::ofstream(made.folder() / "plan.json") << "{\"format\":";
  const Result<ParticipantSession> refused = ParticipantSession::open(*made.study, "P01", simulatedStart);
  REQUIRE_FALSE(refused);
  CHECK(refused.failure().sentence().find("plan.json") != std::string::npos);
  fs::remove_all(made.folder() / "participants");
  fs::create_directory(made.folder() / "participants");
  fs::remove(made.folder() / "plan.json");
  answer(*made.study, "P01", "perfect", 1);
  const Result<std::string> late = writeLists(*made.study, usualPlaces(3), made.folder() / "lists");
  REQUIRE_FALSE(late);
  CHECK(late.failure().code == FailureCode::wrongUsage);
}

TEST_CASE("plan: power rises with people and differences, and six people are the fewest") {
  const StudyFolder made(twoModes());
  const std::vector<FigureTable> tables = powerTables(*made.study);
  REQUIRE(tables.size() == 3);
  const FigureTable& one = tables[0];
  for (std::size_t row = 0; row < one.rows.size(); ++row)
    if (std::get<double>(one.rows[row][0]) == 10)
      CHECK(cellOf(one, row, "right_90") == Approx(73.6).margin(0.05));
  const FigureTable& two = tables[1];
  CHECK(std::get<double>(two.rows.front()[0]) == 6);
  CHECK(cellOf(two, two.rows.size() - 1, "more_30") > 99);
  const FigureTable& needed = tables[2];
  CHECK(cellOf(needed, needed.rows.size() - 1, "more_30") == 6);          // the most trials
  CHECK(std::holds_alternative<std::monostate>(needed.rows.front()[1]));  // 2 trials a pair, 5 points
  CHECK(cellOf(two, 0, "more_5") < cellOf(two, two.rows.size() - 1, "more_5"));
}

TEST_CASE("plan: the page says design, power, lists and tests of every kind") {
  for (const StudyKind kind :
       {StudyKind::abx, StudyKind::matching, StudyKind::threshold, StudyKind::rating}) {
    StudyDesign design;
    design.kind = kind;
    design.trials = 4;
    const StudyFolder made(design, {"B", "D"});
    FigureTable power{"p", "Power", "", {{"people", "people", 0, ""}}, {{9.0}}};
    const std::string page = preregistrationPage(*made.study, {14, "5ca1ab1e", {power}});
    for (const char* words : {"14 participants", "5ca1ab1e", "Hypotheses", "Analysis", "mt19937_64"})
      CHECK(page.find(words) != std::string::npos);
    CHECK((page.find("against one half") != std::string::npos) == (kind == StudyKind::matching));
    CHECK((page.find("by order alone") != std::string::npos) == (kind == StudyKind::rating));
    CHECK(page.find(made.study->sha256) != std::string::npos);
    CHECK(page.find(made.study->buttons[1].sha256) != std::string::npos);
  }
}
