// SPDX-License-Identifier: GPL-3.0-or-later
// Thresholds and ratings: lists of trials, journals, tables in every format.
#include <algorithm>
#include <fstream>
#include <map>
#include <optional>

#include "model/file/text_file.h"
#include "playback/study/statistics/resampling.h"
#include "playback/study/trials/answer_tables.h"
#include "playback/study/trials/study_output.h"
#include "playback/study/trials/study_page.h"
#include "playback/study/trials/trial_controller.h"
#include "tests/playback/study/trials/study_folder.h"

using namespace detent;
using namespace detent::playback;
using detent::test::answer;
using detent::test::simulatedStart;
using detent::test::StudyFolder;

namespace {

StudyDesign thresholds(LevelQuantity quantity = LevelQuantity::peakForce, std::size_t trials = 20) {
  StudyDesign design;
  design.kind = StudyKind::threshold;
  design.quantity = quantity;
  design.trials = trials;
  design.seed = 5;
  return design;
}

StudyDesign ratings(RatingScale scale) {
  StudyDesign design;
  design.kind = StudyKind::rating;
  design.scale = scale;
  design.trials = 4;
  design.seed = 5;
  return design;
}

StudyResults resultsIn(const Study& study) {
  const Result<std::vector<ParticipantRecord>> records = readParticipants(study);
  REQUIRE(records);
  return resultsOf(study, *records);
}

ParticipantRecord recordOf(const Study& study) {
  const Result<std::vector<ParticipantRecord>> records = readParticipants(study);
  REQUIRE(records);
  REQUIRE(records->size() == 1);
  REQUIRE_FALSE(records->front().damage);
  return records->front();
}

double number(const FigureTable& table, std::size_t row, const std::string& key) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].key == key) return std::get<double>(table.rows[row][c]);
  throw std::runtime_error("no column " + key);
}

const SessionStart person{SessionKind::real, Listening::quiet, "test", "", 1000};

}  // namespace

TEST_CASE("every quantity has levels, and each of them feels otherwise") {
  for (const auto& [word, quantity] : levelQuantities.all) {
    INFO(word);
    StudyDesign design = thresholds(quantity);
    // With the usual feel the slope's level follows from the weakest jump, whatever the grains' strength.
    if (quantity == LevelQuantity::grainStrength) {
      CHECK_THROWS_WITH(StudyFolder(design, {"C"}), Catch::Contains("makes no difference to the feel"));
      design.feel = Feel::paper;
    }
    const StudyFolder folder(design, {"C", "D"});
    const Study& study = *folder.study;
    CHECK(study.givenButtons() == 2);
    for (std::size_t reference = 0; reference < 2; ++reference) {
      const std::vector<double> increases = increasesOf(study, reference);
      CHECK(increases.size() >= 13);
      CHECK(std::is_sorted(increases.begin(), increases.end()));
      CHECK(increases.front() == Approx(0.01));
    }
    const StudyLevel& level = study.levels[12];
    CHECK(level.increase == Approx(0.1));
    CHECK(levelOf(study, level.button) == &level);
    CHECK(levelOf(study, 0) == nullptr);
    CHECK(study.buttons[level.button].label == "C+10%");
    CHECK(checkStimuli(study));
  }
}

TEST_CASE("a quantity that a button has nothing of is refused") {
  StudyDesign design = thresholds(LevelQuantity::grainStrength);
  design.modes = {FeedbackMode::clickOnly};
  CHECK_THROWS_WITH(StudyFolder(design, {"C"}), Catch::Contains("makes no difference to the feel"));
}

TEST_CASE("what has more stands first as often as second, and its level follows the answers") {
  StudyDesign design = thresholds();
  design.practice = 2;
  const StudyFolder folder(design, {"C", "D"});
  const Study& study = *folder.study;
  CHECK(countedTrials(study) == 40);
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const Trial& trial : planTrials(study, "P01"))
    if (!trial.practice) ++sides[{trial.choices[0], trial.target}];
  for (const auto& [side, count] : sides) CHECK(count == 10);
  CHECK(sides.size() == 4);

  answer(study, "P01", "threshold=0.05", 100);
  const ParticipantRecord record = recordOf(study);
  CHECK(record.complete());
  std::map<std::size_t, std::vector<double>> increasesByLevel;
  for (const Trial& trial : record.plan) {
    const StudyLevel* level = levelOf(study, trial.choices[trial.target]);
    REQUIRE(level != nullptr);
    CHECK(level->reference == trial.choices[1 - trial.target]);
    if (trial.practice) CHECK(level->increase == Approx(1));
    if (!trial.practice) increasesByLevel[level->reference].push_back(level->increase);
  }
  for (const auto& [reference, increases] : increasesByLevel) {
    CHECK(increases.front() > 0.1);  // without any answer the trial plan begins in the middle
    CHECK(*std::min_element(increases.begin(), increases.end()) < 0.08);
  }
}

TEST_CASE("whoever is interrupted goes on with the very level that would have come") {
  const StudyFolder once(thresholds(), {"C"}), twice(thresholds(), {"C"});
  answer(*once.study, "P01", "threshold=0.1", 100);
  for (int i = 0; i < 4; ++i) answer(*twice.study, "P01", "threshold=0.1", 5);
  const ParticipantRecord whole = recordOf(*once.study), pieces = recordOf(*twice.study);
  REQUIRE(pieces.complete());
  for (std::size_t i = 0; i < whole.plan.size(); ++i) CHECK(whole.plan[i].choices == pieces.plan[i].choices);
}

TEST_CASE("a threshold comes back, in text, JSON, CSV, BIDS and on the page") {
  const StudyFolder folder(thresholds(LevelQuantity::travel, 150), {"C"});
  for (const char* id : {"P01", "P02", "P03"}) answer(*folder.study, id, "threshold=0.2", 1000);
  const StudyResults results = resultsIn(*folder.study);
  REQUIRE(results.tables.size() == 2);
  const FigureTable& persons = results.tables[0];
  REQUIRE(persons.rows.size() == 3);
  for (std::size_t row = 0; row < 3; ++row) {
    CHECK(number(persons, row, "low_percent") < 20);
    CHECK(number(persons, row, "high_percent") > 20);
    CHECK(number(persons, row, "trials") == 150);
  }
  CHECK(number(results.tables[1], 0, "threshold_percent") == Approx(20).epsilon(0.2));
  CHECK(results.groups.empty());
  CHECK_THAT(resultsText(results), Catch::Contains("increase of travel told in 75 of 100"));
  CHECK_THAT(resultsText(results), Catch::Contains("SIMULATED"));
  CHECK_THAT(resultsJson(results), Catch::Contains("\"threshold_percent\""));
  CHECK_THAT(resultsPage(results, {}), Catch::Contains("Thresholds over participants"));
  const std::string csv = resultsCsv(results);
  CHECK_THAT(csv, Catch::StartsWith("study,participant,trial,pair,a,b,x,answer,correct,replays_a,replays_b,"
                                    "replays_x,answer_s,condition,level,feel,finished,site\n"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 451);
  REQUIRE(writeBids(results, folder.folder() / "bids"));
  const Result<std::string> described =
      readTextFile((folder.folder() / "bids" / "task-study_events.json").string());
  REQUIRE(described);
  CHECK_THAT(*described, Catch::Contains("\"level\""));
}

TEST_CASE("ratings: each round has everything once, pairs are turned") {
  const StudyFolder folder(ratings(RatingScale::pairwise), {"A", "B", "C"});
  const std::vector<Trial> plan = planTrials(*folder.study, "P01");
  REQUIRE(plan.size() == 12);
  std::map<std::vector<std::size_t>, int> seen;
  for (std::size_t round = 0; round < 4; ++round) {
    std::vector<std::size_t> sums;
    for (std::size_t i = 0; i < 3; ++i) {
      const Trial& trial = plan[3 * round + i];
      ++seen[trial.choices];
      sums.push_back(trial.choices[0] + trial.choices[1]);
    }
    std::sort(sums.begin(), sums.end());
    CHECK(sums == std::vector<std::size_t>{1, 2, 3});
  }
  for (const auto& [choices, count] : seen) CHECK(count == 2);
  CHECK(seen.size() == 6);
}

TEST_CASE("a rating has to lie on its scale and to be felt") {
  const StudyFolder folder(ratings(RatingScale::preference), {"A"});
  Result<ParticipantSession> session = ParticipantSession::open(*folder.study, "P01", person);
  REQUIRE(session);
  TrialController controller(*folder.study, *session->trial(), 0, 1);
  CHECK_FALSE(controller.hasX());
  CHECK_FALSE(controller.mayAnswer());
  controller.tried(0, 2);
  controller.felt({1, 1, 2, 3});
  REQUIRE(controller.mayAnswer());
  Answer given = controller.answer(0, 3);
  CHECK_FALSE(session->record(given));
  for (const double wrong : {0.0, 8.0, 3.5, -1.0}) {
    given.rating = wrong;
    CHECK_FALSE(session->record(given));
  }
  given.rating = 7;
  CHECK(session->record(given));
  given.trial = 2;
  given.felt = {{1, 0, 2, 3}};
  CHECK_FALSE(session->record(given));
  CHECK(recordOf(*folder.study).answers.front().answer.rating == 7);
}

TEST_CASE("magnitudes of people with numbers of their own come to one scale") {
  StudyDesign design = ratings(RatingScale::magnitude);
  const StudyFolder folder(design, {"A", "B", "C"});
  for (const double unit : {1.0, 10.0, 250.0}) {
    const std::string id = "P" + std::to_string(static_cast<int>(unit));
    Result<ParticipantSession> session = ParticipantSession::open(*folder.study, id, simulatedStart);
    REQUIRE(session);
    while (const Trial* trial = session->trial()) {
      Answer given = simulatedAnswer(*folder.study, id, *trial, {});
      given.rating = unit * static_cast<double>(trial->choices[0] + 1);
      REQUIRE(session->record(given));
    }
  }
  const FigureTable scores = resultsIn(*folder.study).tables.at(0);
  REQUIRE(scores.rows.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(number(scores, i, "value") / number(scores, 0, "value") == Approx(double(i + 1)));
    CHECK(number(scores, i, "low") == Approx(number(scores, i, "high")));
  }
  const FigureTable differences = resultsIn(*folder.study).tables.at(1);
  CHECK(number(differences, 0, "difference") == Approx(0.5));  // A over B
}

TEST_CASE("an interval stays on its scale, and two people have none") {
  const StudyFolder folder(ratings(RatingScale::preference), {"A", "B"});
  const auto rate = [&](const std::string& id, double a, double b) {
    Result<ParticipantSession> session = ParticipantSession::open(*folder.study, id, simulatedStart);
    REQUIRE(session);
    while (const Trial* trial = session->trial()) {
      Answer given = simulatedAnswer(*folder.study, id, *trial, {});
      given.rating = trial->choices[0] == 0 ? a : b;
      REQUIRE(session->record(given));
    }
  };
  const auto cellAt = [&](std::size_t row, std::size_t column) {
    return resultsIn(*folder.study).tables.at(0).rows.at(row).at(column);
  };
  constexpr std::size_t low = 4, high = 5;
  rate("P1", 1, 7);
  rate("P2", 2, 6);
  CHECK(std::holds_alternative<std::monostate>(cellAt(0, low)));
  CHECK(std::holds_alternative<std::monostate>(cellAt(1, high)));
  rate("P3", 1, 7);
  // 4/3 and 20/3, Student's t of 2 degrees of freedom 4.3027, standard error 1/3
  CHECK(std::get<double>(cellAt(0, low)) == 1);
  CHECK(std::get<double>(cellAt(0, high)) == Approx(4.0 / 3 + 4.302653 / 3));
  CHECK(std::get<double>(cellAt(1, low)) == Approx(20.0 / 3 - 4.302653 / 3));
  CHECK(std::get<double>(cellAt(1, high)) == 7);
}

TEST_CASE("ratings of 1 to 7 are compared by order alone, too") {
  const StudyFolder folder(ratings(RatingScale::preference), {"A", "B", "C"});
  for (const char* id : {"P1", "P2", "P3", "P4", "P5", "P6"}) {
    Result<ParticipantSession> session = ParticipantSession::open(*folder.study, id, simulatedStart);
    REQUIRE(session);
    std::size_t a = 0;
    while (const Trial* trial = session->trial()) {
      Answer given = simulatedAnswer(*folder.study, id, *trial, {});
      // A: 4, 5, 4, 5; B: 7, however far above that is; C: always 4
      given.rating = trial->choices[0] == 0 ? (++a % 2 == 1 ? 4 : 5) : trial->choices[0] == 1 ? 7 : 4;
      REQUIRE(session->record(given));
    }
  }
  const FigureTable order = resultsIn(*folder.study).tables.at(2);
  CHECK(order.key == "rating_order");
  CHECK(number(order, 0, "higher_percent") == 0);           // A above B
  CHECK(number(order, 0, "p") == Approx(2.0 / 64));         // six people of one mind
  CHECK(number(order, 1, "higher_percent") == Approx(75));  // A above C: half above, half equal
  CHECK(number(order, 2, "higher_percent") == 100);         // B above C
  CHECK(number(order, 2, "p_holm") == Approx(3 * 2.0 / 64));
}

TEST_CASE("matching: each button and pair has its interval, the level of chance and an exact p against it") {
  StudyDesign design;
  design.kind = StudyKind::matching;
  design.trials = 10;
  design.seed = 5;
  const StudyFolder folder(design, {"A", "B", "C"});
  const std::map<std::string, std::size_t> wrong{{"P1", 0}, {"P2", 1}, {"P3", 2},
                                                 {"P4", 3}, {"P5", 4}, {"P6", 2}};
  std::vector<Count> right;
  for (const auto& [id, errors] : wrong) {
    Result<ParticipantSession> session = ParticipantSession::open(*folder.study, id, simulatedStart);
    REQUIRE(session);
    std::size_t left = errors;
    while (const Trial* trial = session->trial()) {
      Answer given = simulatedAnswer(*folder.study, id, *trial, {});
      given.choice = trial->target;
      if (trial->choices[trial->target] == 2 && left > 0) {  // takes C for B
        given.choice = static_cast<std::size_t>(
            std::find(trial->choices.begin(), trial->choices.end(), std::size_t{1}) - trial->choices.begin());
        --left;
      }
      REQUIRE(session->record(given));
    }
    right.push_back({10 - errors, 10});
  }
  const StudyResults results = resultsIn(*folder.study);
  const FigureTable &matches = results.tables.at(0), &taken = results.tables.at(1);
  // 48 of 60 against a third, 12 of 120 and 0 of 108 against a half, by scipy
  CHECK(number(matches, 2, "right") == 48);
  CHECK(number(matches, 2, "chance_percent") == Approx(100.0 / 3));
  CHECK(number(matches, 2, "low_percent") == Approx(68.2182).margin(1e-3));
  CHECK(number(matches, 2, "high_percent") == Approx(88.1715).margin(1e-3));
  CHECK(number(matches, 2, "p") == Approx(1.53784521e-13).epsilon(1e-6));
  CHECK(number(matches, 2, "p_holm") == number(matches, 2, "p"));  // the largest of the three
  const std::optional<Interval> resampled = participantBootstrap(right);
  REQUIRE(resampled);
  CHECK(number(matches, 2, "resampled_low_percent") == Approx(100 * resampled->low));
  CHECK(number(matches, 2, "resampled_high_percent") == Approx(100 * resampled->high));
  CHECK(number(taken, 2, "confused") == 12);
  CHECK(number(taken, 2, "trials") == 120);
  CHECK(number(taken, 2, "low_percent") == Approx(5.8134).margin(1e-3));
  CHECK(number(taken, 2, "high_percent") == Approx(16.6682).margin(1e-3));
  CHECK(number(taken, 2, "p") == Approx(8.90063236e-21).epsilon(1e-6));
  CHECK(number(taken, 1, "confused") == 0);
  CHECK(number(taken, 1, "p") == Approx(3.08148791e-33).epsilon(1e-6));
  CHECK(number(taken, 1, "trials") == 108);  // C taken for B says nothing of A and C
  CHECK(number(taken, 1, "chance_percent") == 50);
  CHECK_THAT(resultsText(results), Catch::Contains("Pairs taken for each other"));
  CHECK_THAT(resultsJson(results), Catch::Contains("\"chance_percent\""));
}

TEST_CASE("preferences come back as scores, and persons' signs are flipped") {
  const StudyFolder folder(ratings(RatingScale::pairwise), {"A", "B", "C"});
  for (const char* id : {"P1", "P2", "P3", "P4", "P5", "P6"}) answer(*folder.study, id, "errors=0.3", 100);
  const StudyResults results = resultsIn(*folder.study);
  const FigureTable &scores = results.tables.at(0), &differences = results.tables.at(1);
  CHECK(number(scores, 0, "value") < number(scores, 1, "value"));
  CHECK(number(scores, 1, "value") < number(scores, 2, "value"));
  CHECK(number(differences, 0, "difference") < 50);
  CHECK(number(differences, 0, "p") == Approx(2.0 / 64));  // six people of one mind
  CHECK(number(differences, 0, "p_holm") >= number(differences, 0, "p"));
  CHECK_THAT(resultsCsv(results), Catch::Contains("condition,rating,feel,finished,site\n"));
}

TEST_CASE("answers off their list or scale are refused when a journal is read") {
  const StudyFolder folder(ratings(RatingScale::preference), {"A"});
  const Study& study = *folder.study;
  std::string chain;
  std::vector<std::string> lines{headerLine(study, detent::test::beginner("P01"), {}, chain)};
  lines.push_back(sessionLine(simulatedStart, 0, chain));
  const Trial trial = planTrials(study, "P01").front();
  Answer given = simulatedAnswer(study, "P01", trial, {});
  given.rating = 9;
  lines.push_back(answerLine(study, trial, given, chain));
  const Result<ParticipantRecord> record = replayJournal(study, "P01", lines, "", "P01.jsonl");
  REQUIRE_FALSE(record);
  CHECK_THAT(record.failure().sentence(), Catch::Contains("line 3"));
}

TEST_CASE("a threshold can answer only threshold studies") {
  const StudyFolder folder(ratings(RatingScale::preference), {"A"});
  const Result<Simulation> simulation = simulationNamed("threshold=0.1");
  REQUIRE(simulation);
  CHECK_FALSE(checkSimulation(*folder.study, *simulation));
  CHECK_FALSE(simulationNamed("threshold=0"));
  CHECK_FALSE(simulationNamed("threshold=0.1x"));
}

TEST_CASE("same/different: order and sameness are balanced, felt and kept", "[study]") {
  StudyDesign design;
  design.kind = StudyKind::sameDifferent;
  design.trials = 8;
  const StudyFolder made(design, {"A", "B"});
  std::map<std::vector<std::size_t>, std::size_t> felt;
  for (const Trial& trial : planTrials(*made.study, "P1")) {
    const std::vector<std::size_t> buttons = feltButtons(design, trial);
    ++felt[buttons];
    CHECK((buttons[0] == buttons[1]) == (answerName(*made.study, trial, trial.target) == "same"));
  }
  CHECK(felt ==
        std::map<std::vector<std::size_t>, std::size_t>{{{0, 0}, 2}, {{0, 1}, 2}, {{1, 0}, 2}, {{1, 1}, 2}});
  Answer given;
  given.felt = {{1, 1, 0, 0}, {1, 0, 0, 0}};
  CHECK_FALSE(feltEnough(*made.study, given));
  given.felt[1].whole = 1;
  CHECK(feltEnough(*made.study, given));
  Result<ParticipantSession> session = ParticipantSession::open(*made.study, "P1", simulatedStart);
  REQUIRE(session);
  const Simulation perfect = *simulationNamed("perfect");
  while (const Trial* trial = session->trial())
    REQUIRE(session->record(simulatedAnswer(*made.study, "P1", *trial, perfect)));
  const StudyResults results = resultsIn(*made.study);
  REQUIRE(results.tables.size() == 1);
  CHECK(number(results.tables[0], 0, "hits_percent") == 100);
  CHECK(number(results.tables[0], 0, "false_alarms_percent") == 0);
  CHECK(number(results.tables[0], 0, "different") == 4);
}
