// SPDX-License-Identifier: GPL-3.0-or-later
// Timing studies: which presses count, journals, tables. Times are injected; nobody waits.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "model/file/text_file.h"
#include "playback/study/trials/study_output.h"
#include "playback/study/trials/study_page.h"
#include "playback/study/trials/study_plan.h"
#include "playback/study/trials/timing_controller.h"
#include "playback/study/trials/timing_tables.h"
#include "tests/playback/study/trials/study_folder.h"

using namespace detent;
using namespace detent::playback;
using detent::test::answer;
using detent::test::StudyFolder;

namespace {

StudyDesign timing(TimingTask task, std::size_t trials = 18) {
  StudyDesign design;
  design.kind = StudyKind::timing;
  design.task = task;
  design.trials = trials;
  design.seed = 5;
  return design;
}

Trial oneTrial(double interval_s, double window_s = 0) {
  Trial trial;
  trial.number = 1;
  trial.choices = {0};
  trial.interval_s = interval_s;
  trial.window_s = window_s;
  return trial;
}

double timingNumber(const FigureTable& table, std::size_t row, const std::string& key) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].key == key) return std::get<double>(table.rows[row][c]);
  throw std::runtime_error("no column " + key);
}

std::vector<ParticipantRecord> recordsOf(const Study& study) {
  const Result<std::vector<ParticipantRecord>> records = readParticipants(study);
  REQUIRE(records);
  for (const ParticipantRecord& record : *records) REQUIRE_FALSE(record.damage);
  return *records;
}

const SessionStart timingPerson{SessionKind::real, Listening::quiet, "test", "", 1000};

}  // namespace

TEST_CASE("intervals and windows come each as often, for every button") {
  const StudyFolder folder(timing(TimingTask::window), {"A", "B"});
  std::map<std::tuple<std::size_t, double, double>, int> seen;
  for (const Trial& trial : planTrials(*folder.study, "P01"))
    ++seen[{trial.choices.at(0), trial.interval_s, trial.window_s}];
  CHECK(seen.size() == 2 * 9);
  for (const auto& [times, count] : seen) CHECK(count == 2);
  CHECK(countedTrials(*folder.study) == 36);
}

TEST_CASE("a cue has four even beats, and the first press near the last of them counts") {
  const StudyFolder folder(timing(TimingTask::cue), {"A"});
  const Trial trial = oneTrial(0.6);
  TimingController controller(*folder.study, trial, 100, 110);
  REQUIRE(controller.beats_s().size() == 4);
  for (std::size_t i = 1; i < 4; ++i)
    CHECK(controller.beats_s()[i] - controller.beats_s()[i - 1] == Approx(0.6));
  const double cue_s = controller.cue_s();
  controller.pressed(cue_s - 0.58, 0.001);  // taps with the third beat
  CHECK_FALSE(controller.over(cue_s + 0.55));
  controller.pressed(cue_s - 0.03, 0.002);
  controller.pressed(cue_s + 0.2, 0.001);
  CHECK_FALSE(controller.over(cue_s + 0.3));
  CHECK(controller.over(cue_s + 0.75));
  CHECK(controller.fault() == TimingFault::notFelt);
  controller.felt({1, 0, 1, 2});
  REQUIRE(controller.fault() == TimingFault::none);
  const Answer given = controller.answer(cue_s + 0.8);
  CHECK(*countedPress(trial, given.presses_s) == Approx(-0.03));
  CHECK(given.presses_s.size() == 3);
  CHECK(given.pressWithin_s == 0.002);
  CHECK(given.onset_s == Approx(10));
  CHECK(given.firstPress_s == Approx(cue_s - 0.58 - 110));
}

TEST_CASE("a trial without a press that counts is none") {
  const StudyFolder folder(timing(TimingTask::window), {"A"});
  const Trial trial = oneTrial(0.8, 0.1);
  TimingController controller(*folder.study, trial, 0, 0);
  CHECK(controller.wayAt(controller.cue_s() - 0.8) == Approx(0));
  CHECK(controller.wayAt(controller.cue_s()) == Approx(1));
  controller.felt({1, 1, 1, 2});
  for (const double off_s : {-0.41, 0.81}) controller.pressed(controller.cue_s() + off_s, 0);
  CHECK(controller.over(controller.cue_s() + 0.81));
  CHECK(controller.fault() == TimingFault::noPress);
}

TEST_CASE("tapping runs from the first press on, and a key that repeats is no tapping") {
  StudyDesign design = timing(TimingTask::tapping, 2);
  design.run_s = 4;
  const StudyFolder folder(design, {"A"});
  const Trial trial = oneTrial(0);
  for (const bool held : {false, true}) {
    TimingController controller(*folder.study, trial, 0, 0);
    CHECK_FALSE(controller.over(60));
    CHECK(controller.left_s(60) == 4);
    double at_s = 60;
    for (int i = 0; i < 50; ++i, at_s += held && i > 20 ? 0.033 : 0.15) controller.pressed(at_s, 0);
    controller.felt({50, 50, 1, 2});
    CHECK_FALSE(controller.over(63.9));
    CHECK(controller.over(at_s + 1));
    CHECK((controller.fault() == TimingFault::held) == held);
    if (!held) CHECK(controller.answer(70).presses_s.size() == 27);  // 4 s of 0.15
  }
}

TEST_CASE("what nobody pressed is not kept, nor what nobody felt") {
  const StudyFolder folder(timing(TimingTask::cue), {"A"});
  Result<ParticipantSession> session = ParticipantSession::open(*folder.study, "P01", timingPerson);
  REQUIRE(session);
  Answer given;
  given.trial = 1;
  given.felt = {{1, 0, 1, 2}};
  CHECK_FALSE(session->record(given));  // no press
  given.presses_s = {0.02, 0.01};
  CHECK_FALSE(session->record(given));  // not rising
  given.presses_s = {std::nan("")};
  CHECK_FALSE(session->record(given));
  given.presses_s = {3.0};
  CHECK_FALSE(session->record(given));  // the press does not count, so there is no answer
  given.presses_s = {0.02};
  given.felt = {{0, 0, 0, 0}};
  CHECK_FALSE(session->record(given));  // not felt
  given.felt = {{1, 0, 1, 2}};
  CHECK(session->record(given));
  const ParticipantRecord record = recordsOf(*folder.study).at(0);
  REQUIRE(record.answers.size() == 1);
  CHECK(record.answers[0].answer.presses_s == std::vector<double>{0.02});
}

TEST_CASE("a journal whose times do not fit the plan is refused") {
  const StudyFolder folder(timing(TimingTask::cue), {"A"});
  const Study& study = *folder.study;
  for (const bool wrongInterval : {false, true}) {
    std::string chain;
    std::vector<std::string> lines{headerLine(study, detent::test::beginner("P01"), {}, chain)};
    lines.push_back(sessionLine(detent::test::simulatedStart, 0, chain));
    Trial trial = planTrials(study, "P01").front();
    Answer given;
    given.trial = 1;
    given.presses_s = {wrongInterval ? 0.01 : 9.0};
    given.felt = {{1, 1, 0, 0}};
    if (wrongInterval) trial.interval_s += 0.1;
    lines.push_back(answerLine(study, trial, given, chain));
    const Result<ParticipantRecord> record = replayJournal(study, "P01", lines, "", "P01.jsonl");
    REQUIRE_FALSE(record);
    CHECK_THAT(record.failure().sentence(), Catch::Contains("line 3"));
  }
}

TEST_CASE("route and how presses were timed stand in the journal") {
  const StudyFolder folder(timing(TimingTask::cue), {"A"});
  SessionStart start = timingPerson;
  start.route.timing = TimingRoute{"key: read from the terminal", "picture", {}};
  REQUIRE(ParticipantSession::open(*folder.study, "P01", start));
  const ParticipantRecord record = recordsOf(*folder.study).at(0);
  REQUIRE(record.sessions.at(0).route.timing);
  CHECK(record.sessions[0].route.timing->press == "key: read from the terminal");
  CHECK_FALSE(record.sessions[0].route.timing->cueLatency_s);
}

TEST_CASE("simulated people come back, in every format") {
  for (const auto& [word, task] : timingTasks.all) {
    INFO(word);
    const bool tapping = task == TimingTask::tapping;
    const StudyFolder folder(timing(task, tapping ? 2 : 45), {"A", "B"});
    const std::string place = tapping ? "0.16" : "0.1";
    for (const char* id : {"P01", "P02", "P03", "P04", "P05", "P06"})
      answer(*folder.study, id, "timing=" + place + ",0.07", 1000);
    const StudyResults results = resultsOf(*folder.study, recordsOf(*folder.study));
    REQUIRE(results.tables.size() == 3);
    const FigureTable &laboratory = results.tables[0], &people = results.tables[1],
                      &pairs = results.tables[2];
    REQUIRE(laboratory.rows.size() == 2);
    for (std::size_t row = 0; row < 2; ++row) {
      CHECK(timingNumber(laboratory, row, "spread_percent") == Approx(7).margin(0.9));
      CHECK(timingNumber(laboratory, row, tapping ? "place_ms" : "place_percent") ==
            Approx(tapping ? 160 : 10).margin(tapping ? 3 : 9));
      CHECK(timingNumber(laboratory, row, "people") == 6);
    }
    CHECK(people.rows.size() == 12);
    CHECK(timingNumber(pairs, 0, "people") == 6);
    CHECK(std::get<std::string>(pairs.rows[0][2]) == "place");
    CHECK_THAT(resultsText(results), Catch::Contains("Timing, task " + std::string(word)));
    CHECK_THAT(resultsJson(results), Catch::Contains("\"spread_low_percent\""));
    CHECK_THAT(resultsPage(results, {}), Catch::Contains("Buttons against each other"));
    const std::string csv = resultsCsv(results);
    CHECK_THAT(csv,
               Catch::Contains("condition,interval_s,window_s,press_s,press_within_s,feel,finished,site\n"));
    REQUIRE(writeBids(results, folder.folder() / "bids"));
    // A study's output is a valid input file: one button of it gives the same figures.
    const std::string file = (folder.folder() / "one.csv").string();
    std::string one = csv.substr(0, csv.find('\n') + 1);
    for (std::size_t at = csv.find('\n') + 1; at < csv.size(); at = csv.find('\n', at) + 1)
      if (const std::string line = csv.substr(at, csv.find('\n', at) - at);
          line.find(",A,") != std::string::npos)
        one += line + "\n";
    REQUIRE(writeTextFileAtomically(file, one));
    const Result<TimedPeople> read = readTimedPresses(file, task);
    REQUIRE(read);
    const Result<std::vector<FigureTable>> again = timingTables(*read, file);
    REQUIRE(again);
    for (const char* key : {"spread_percent", "spread_low_percent"})
      CHECK(timingNumber(again->at(0), 0, key) == Approx(timingNumber(laboratory, 0, key)).epsilon(1e-9));
  }
}

TEST_CASE("timing tables keep to 80 letters, with several conditions too") {
  for (const auto& [word, task] : timingTasks.all) {
    INFO(word);
    StudyDesign design = timing(task, task == TimingTask::tapping ? 1 : 18);
    design.modes = {FeedbackMode::full, FeedbackMode::clickOnly, FeedbackMode::slopeOnly};
    const StudyFolder folder(design, {"A", "B"});
    for (const char* id : {"participant-01", "participant-02"})
      answer(*folder.study, id, "timing=0.16,0.07", 1000);
    const StudyResults results = resultsOf(*folder.study, recordsOf(*folder.study));
    std::istringstream text(resultsText(results));
    std::size_t groups = 0;
    for (std::string line; std::getline(text, line);) {
      INFO(line);
      CHECK(widthOf(line) <= 80);
      if (line == "  quiet/click-only/simulated:") ++groups;
    }
    CHECK(groups >= 1);
  }
}

TEST_CASE("a table that is too wide says above its rows what many of them share") {
  FigureTable table{"t", "Title", "", {}, {}};
  table.columns = {{"who", "who", 0, ""}, {"where", "where", 0, ""}, {"n", "n", 0, ""}};
  const std::string far(40, 'f'), near(30, 'n'), name(20, 'w');
  for (const std::string& where : {near, far})
    for (const char last : {'1', '2'}) table.rows.push_back({name + last, where, 7.0});
  CHECK_THAT(tableText(table), Catch::Contains("  " + name + "1 " + near + std::string(11, ' ') + "7\n"));
  table.columns.back().heading = std::string(30, 'n');
  const std::string right(29, ' ');
  CHECK(tableText(table) == "Title\n  who                   " + std::string(30, 'n') + "\n  " + near +
                                ":\n  " + name + "1 " + right + "7\n  " + name + "2 " + right + "7\n  " +
                                far + ":\n  " + name + "1 " + right + "7\n  " + name + "2 " + right + "7\n");
  table.columns[0].heading = std::string(90, 'n');  // a heading wider than the table: no value is lost
  CHECK_THAT(tableText(table), Catch::Contains(name + "2"));
}

TEST_CASE("timing studies: designs that mean nothing are refused") {
  StudyDesign design = timing(TimingTask::window);
  CHECK(checkDesign(design, 1));
  design.windows_s = {0.7};
  CHECK_FALSE(checkDesign(design, 1));  // longer than an interval
  design.windows_s = {0.1, 0.1};
  CHECK_FALSE(checkDesign(design, 1));
  design.windows_s = {std::nan("")};
  CHECK_FALSE(checkDesign(design, 1));
  design.windows_s = {0.1};
  for (const std::vector<double>& intervals : {std::vector<double>{}, {0.1}, {6}, {-1}}) {
    design.intervals_s = intervals;
    CHECK_FALSE(checkDesign(design, 1));
  }
  design = timing(TimingTask::tapping);
  design.run_s = 1;
  CHECK_FALSE(checkDesign(design, 1));
}

TEST_CASE("who simulates a timing study says when they press") {
  const StudyFolder cue(timing(TimingTask::cue), {"A"}), tapping(timing(TimingTask::tapping), {"A"});
  CHECK_FALSE(checkSimulation(*cue.study, *simulationNamed("perfect")));
  CHECK(checkSimulation(*cue.study, *simulationNamed("timing=-0.1,0.05")));
  CHECK_FALSE(checkSimulation(*tapping.study, *simulationNamed("timing=-0.1,0.05")));
  for (const char* wrong : {"timing=0.1", "timing=,0.1", "timing=0.1,0", "timing=0.1,0.1x", "timing=9,0.1"})
    CHECK_FALSE(simulationNamed(wrong));
  CHECK_FALSE(simulationNamed("presses=/nowhere.csv"));
}

TEST_CASE("a person of whom no press can count answers nothing, and is not waited for") {
  const StudyFolder folder(timing(TimingTask::cue), {"A"});
  auto session = ParticipantSession::open(*folder.study, "P01", timingPerson);
  REQUIRE(session);
  const Answer answer =
      simulatedAnswer(*folder.study, "P01", *session->trial(), *simulationNamed("timing=2,0.01"));
  CHECK(answer.presses_s.empty());
  CHECK_FALSE(session->record(answer));
}

TEST_CASE("timing studies: lists tell the times, and the plan what people and trials come to") {
  const StudyFolder folder(timing(TimingTask::window), {"A", "B"});
  const std::string list = listCsv(*folder.study, "P01", 0);
  CHECK_THAT(list, Catch::Contains(",x,interval_s,window_s\n"));
  CHECK_THAT(list, Catch::Contains(",0.6,0.08\n"));
  const std::vector<FigureTable> power = powerTables(*folder.study);
  REQUIRE(power.size() == 2);
  CHECK(timingNumber(power[0], 0, "people") == 6);
  CHECK_THAT(preregistrationPage(*folder.study, {12, "", power, {}}), Catch::Contains("hit a moving target"));
}
