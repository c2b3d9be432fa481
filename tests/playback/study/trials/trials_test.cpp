// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "model/file/text_file.h"
#include "model/sha256.h"
#include "playback/offline/standard_press.h"
#include "playback/realtime/press_counter.h"
#include "playback/study/statistics/shuffle.h"
#include "playback/study/trials/participant_session.h"
#include "playback/study/trials/printed_counts.h"
#include "playback/study/trials/study_output.h"
#include "playback/study/trials/study_page.h"
#include "playback/study/trials/study_plan.h"
#include "playback/study/trials/trial_controller.h"
#include "tests/playback/study/trials/study_folder.h"

using namespace detent;
using namespace detent::playback;
namespace fs = std::filesystem;
using detent::test::answer;
using detent::test::sample;
using detent::test::simulatedStart;
using detent::test::StudyFolder;

namespace {

void edit(const fs::path& file, const std::string& from, const std::string& to) {
  std::ifstream in(file);
  std::ostringstream all;
  all << in.rdbuf();
  std::string text = all.str();
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE(
    "a button's file whose name is not UTF-8 is refused by name; a study's own folder may have such a name") {
  const StudyFolder made;
  const fs::path odd = made.folder().parent_path() / "odd\xFF.button.json";
  fs::copy_file(sample("A"), odd);
  const fs::path folder = made.folder().parent_path() / "made\xFF";
  const Result<Study> refused = createStudy(folder, {odd.string(), sample("B")}, "", {});
  REQUIRE_FALSE(refused);
  CHECK(refused.failure().code == FailureCode::wrongUsage);
  CHECK(english(refused.failure().subject.name) == odd.string());
  CHECK_FALSE(fs::exists(folder));
  const Result<Study> study = createStudy(folder, {sample("A"), sample("B")}, "", {});
  REQUIRE(study);
  answer(*study, "P01", "perfect", 3);
  const StudyResults results = resultsOf(*study, *readParticipants(*study));
  CHECK(resultsJson(results).find("\"made\xEF\xBF\xBD\"") != std::string::npos);
  CHECK(writeBids(results, folder / "bids"));
}

TEST_CASE(
    "plan: every pair as often as requested, sides and X balanced independently, the same list each time") {
  StudyDesign design;
  design.seed = 5;
  const StudyFolder made(design, {"A", "B", "C", "D", "E", "F"});
  const std::vector<Trial> plan = planTrials(*made.study, "P01");
  CHECK(plan.size() == 150);
  std::map<std::pair<std::size_t, std::size_t>, std::array<int, 3>> pairs;
  for (const Trial& t : plan) {
    const auto [low, high] = std::minmax(t.choices[0], t.choices[1]);
    auto& [trials, swapped, xIsHigh] = pairs[{low, high}];
    ++trials;
    swapped += t.choices[0] > t.choices[1] ? 1 : 0;
    xIsHigh += t.choices[t.target] == high ? 1 : 0;
  }
  CHECK(pairs.size() == 15);
  for (const auto& [pair, n] : pairs) {
    CHECK(n[0] == 10);
    CHECK(n[1] == 5);
  }
  const std::vector<Trial> again = planTrials(*made.study, "P01"), other = planTrials(*made.study, "P02");
  std::size_t same = 0;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    CHECK((plan[i].choices == again[i].choices && plan[i].target == again[i].target));
    same += plan[i].choices == other[i].choices ? 1 : 0;
  }
  CHECK(same < 40);
}

namespace {

/// Of one pair's trials: how many there are, with the second button as alpha, as X, and with X as alpha.
struct Balance {
  int trials = 0, swapped = 0, secondIsX = 0, left = 0;
};
std::map<std::pair<std::size_t, std::size_t>, Balance> balanceOf(const std::vector<Trial>& plan) {
  std::map<std::pair<std::size_t, std::size_t>, Balance> pairs;
  for (const Trial& t : plan) {
    const std::pair<std::size_t, std::size_t> key = std::minmax(t.choices[0], t.choices[1]);
    Balance& b = pairs[key];
    ++b.trials;
    b.swapped += t.choices[0] == key.second ? 1 : 0;
    b.secondIsX += t.choices[t.target] == key.second ? 1 : 0;
    b.left += t.target == 0 ? 1 : 0;
  }
  return pairs;
}

}  // namespace

TEST_CASE(
    "plan: who is alpha, who is X and on which side it falls are balanced as far as the number allows") {
  for (const std::size_t trials : {8U, 10U, 9U, 7U}) {
    StudyDesign design;
    design.trials = trials;
    const StudyFolder made(design, {"A", "B", "C", "D"});
    for (const char* id : {"P01", "P02", "P03"}) {
      int left = 0;
      for (const auto& [pair, b] : balanceOf(planTrials(*made.study, id))) {
        const int half = static_cast<int>(trials / 2), odd = static_cast<int>(trials % 2);
        CHECK(b.trials == static_cast<int>(trials));
        CHECK((b.swapped == half || b.swapped == half + odd));
        CHECK((b.secondIsX == half || b.secondIsX == half + odd));
        if (trials % 4 == 0) CHECK(b.left == half);
        CHECK(std::abs(2 * b.left - b.trials) <=
              2);  // two that remain are another alpha and another X: on one side
        left += 2 * b.left - b.trials;
      }
      if (trials % 2 == 1) continue;
      CHECK(left == 0);  // over the pairs the sides come out even
    }
  }
}

TEST_CASE("plan: a study of version 1 keeps the lists it was begun with") {
  const StudyFolder made;
  Study old = *made.study;
  old.version = 1;
  const std::vector<Trial> plan = planTrials(old, "P01"), later = planTrials(old, "P01", 5);
  for (const auto& [pair, b] : balanceOf(plan)) CHECK(b.left == 5);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    CHECK(plan[i].choices == later[i].choices);
    CHECK_FALSE(plan[i].breakBefore);
  }
}

TEST_CASE("plan: modes are blocks with a rest between, each as often first; pairs are shared out alike") {
  StudyDesign design;
  design.modes = {FeedbackMode::full, FeedbackMode::clickOnly, FeedbackMode::slopeOnly};
  design.pairsEach = 2;
  const StudyFolder made(design, {"A", "B", "C", "D"});
  std::map<FeedbackMode, int> first;
  std::map<std::pair<std::size_t, std::size_t>, int> people;
  for (std::size_t begun = 0; begun < 9; ++begun) {
    const std::vector<Trial> plan = planTrials(*made.study, "P" + std::to_string(begun), begun);
    ++first[plan.front().mode];
    CHECK_FALSE(plan.front().breakBefore);
    int changes = 0;
    for (std::size_t i = 1; i < plan.size(); ++i) {
      const bool changed = plan[i].mode != plan[i - 1].mode;
      changes += changed ? 1 : 0;
      CHECK(plan[i].breakBefore == changed);  // blocks of 20 trials need none within
    }
    CHECK(changes == 2);
    for (const auto& [pair, b] : balanceOf(plan)) ++people[pair];
  }
  for (const auto& [mode, n] : first) CHECK(n == 3);
  REQUIRE(people.size() == 6);
  for (const auto& [pair, n] : people) CHECK(n == 3);
}

TEST_CASE("plan: modes, practice, a subset of pairs, matching") {
  StudyDesign design;
  design.modes = {FeedbackMode::full, FeedbackMode::clickOnly};
  design.practice = 4;
  design.pairsEach = 2;
  const StudyFolder made(design);
  const std::vector<Trial> plan = planTrials(*made.study, "P01");
  CHECK(plan.size() == 4 + 2 * 2 * 10);
  CHECK(std::count_if(plan.begin(), plan.end(), [](const Trial& t) { return t.practice; }) == 4);
  CHECK(countedTrials(*made.study) == 40);
  StudyDesign matching;
  matching.kind = StudyKind::matching;
  matching.trials = 2;
  const StudyFolder all(matching);
  const std::vector<Trial> tasks = planTrials(*all.study, "P01");
  CHECK(tasks.size() == 6);
  for (const Trial& t : tasks) CHECK(t.choices.size() == 3);
}

TEST_CASE("design: what cannot be is refused, and nothing is left behind") {
  const StudyFolder made;
  const auto refused = [&](const StudyDesign& design, const std::vector<std::string>& files) {
    const fs::path folder = made.folder().parent_path() / "other";
    const Result<Study> study = createStudy(folder, files, "", design);
    CHECK_FALSE(study);
    CHECK_FALSE(fs::exists(folder));
    CHECK_FALSE(fs::exists(folder.string() + ".part"));
    return study ? 0 : study.failure().exitCode();
  };
  const std::vector<std::string> two{sample("A"), sample("B")};
  StudyDesign design;
  CHECK(refused(design, {sample("A")}) == 2);
  CHECK(refused(design, {sample("A"), sample("A")}) == 2);
  CHECK(refused(design, {sample("A"), "missing.button.json"}) == 3);
  design.trials = 0;
  CHECK(refused(design, two) == 2);
  design = {};
  design.modes = {FeedbackMode::off};
  CHECK(refused(design, two) == 2);
  design = {};
  design.pairsEach = 9;
  CHECK(refused(design, two) == 2);
  CHECK(createStudy(made.folder(), two, "", {}).failure().exitCode() == 2);
}

TEST_CASE("a study with a changed, missing or foreign part is refused by name") {
  {
    const StudyFolder made;
    edit(made.folder() / "buttons" / "B.button.json", "brown", "green");
    const Result<Study> study = openStudy(made.folder());
    REQUIRE_FALSE(study);
    CHECK(study.failure().sentence().find("B.button.json") != std::string::npos);
  }
  {
    const StudyFolder made;
    fs::remove(made.folder() / "buttons" / "C.button.json");
    CHECK(openStudy(made.folder()).failure().sentence().find("C.button.json") != std::string::npos);
  }
  {
    const StudyFolder made;
    edit(made.folder() / "study.json", "\"version\": 3", "\"version\": 4");
    CHECK(openStudy(made.folder()).failure().sentence().find("version 4") != std::string::npos);
  }
  {
    const StudyFolder made;
    edit(made.folder() / "study.json", "\"seed\"", "\"sead\"");
    CHECK(openStudy(made.folder()).failure().exitCode() == 3);
  }
  {
    const StudyFolder made;
    std::ofstream(made.folder() / "study.json") << "{\"format\": ";
    CHECK(openStudy(made.folder()).failure().exitCode() == 3);
  }
  CHECK(openStudy("/nonexistent").failure().exitCode() == 3);
}

TEST_CASE("unfinished: who did not answer all trials is left out, and both results are shown") {
  StudyDesign design;
  design.trials = 6;
  const StudyFolder made(design, {"A", "B"});
  const auto results = [&] {
    const Result<Study> study = openStudy(made.folder());
    REQUIRE(study);
    return resultsOf(*study, *readParticipants(*study));
  };
  answer(*made.study, "P01", "errors=1", 2);
  CHECK(results().groups.at(0).participantCount == 1);  // nobody has finished yet
  CHECK(results().otherGroups.empty());
  for (const char* id : {"P02", "P03"}) answer(*made.study, id, "perfect", 100);
  const StudyResults left = results();
  CHECK(left.unfinishedLeftOut);
  CHECK(left.groups.at(0).participantCount == 2);
  CHECK(left.groups.at(0).errors == Count{0, 12});
  CHECK(left.otherGroups.at(0).participantCount == 3);
  CHECK(left.otherGroups.at(0).errors == Count{2, 14});
  REQUIRE(left.rows.size() == 14);
  CHECK_FALSE(left.rows.front().finished);
  CHECK(left.rows.back().finished);
  CHECK_THAT(resultsText(left), Catch::Contains("With those who did not finish"));
  CHECK_THAT(resultsPage(left, {}), Catch::Contains("With those who did not finish"));
  CHECK_THAT(resultsCsv(left), Catch::Contains(",0,\n") && Catch::EndsWith(",1,\n"));
  CHECK_FALSE(
      writeUnfinishedRule(*made.study, Unfinished::counted));  // refused, because participants have begun
}

TEST_CASE("merge: laboratories become one study, and P01 of two are two people") {
  StudyDesign design;
  design.trials = 6;
  design.seed = 1;
  const StudyFolder berlin(design, {"A", "B"});
  design.seed = 2;
  const StudyFolder kyoto(design, {"A", "B"});
  answer(*berlin.study, "P01", "perfect", 100);
  answer(*berlin.study, "P02", "perfect", 100);
  answer(*kyoto.study, "P01", "errors=1", 100);
  const fs::path out = berlin.folder().parent_path() / "merged";
  CHECK_FALSE(mergeStudies({berlin.folder(), kyoto.folder()}, {}, out));  // both folders are called "study"
  CHECK_FALSE(mergeStudies({berlin.folder(), kyoto.folder()}, {"one"}, out));
  const Result<Study> study = mergeStudies({berlin.folder(), kyoto.folder()}, {"berlin", "kyoto"}, out);
  REQUIRE(study);
  const auto records = readParticipants(*study);
  REQUIRE(records);
  REQUIRE(records->size() == 3);
  CHECK(records->at(0).participant == "berlin-P01");
  CHECK(records->at(2).participant == "kyoto-P01");
  const StudyResults results = resultsOf(*study, *records);
  CHECK(results.groups.at(0).participantCount == 3);
  CHECK(results.groups.at(0).errors == Count{6, 18});
  CHECK(results.warnings.empty());
  CHECK_THAT(resultsCsv(results), Catch::Contains("kyoto-P01") && Catch::EndsWith(",kyoto\n"));
  REQUIRE(writeBids(results, out / "bids"));
  CHECK_THAT(*readTextFile((out / "bids/participants.tsv").string()),
             Catch::Contains("sub-kyotoP01\tkyoto-P01\tkyoto\t1\n"));
  CHECK_FALSE(ParticipantSession::open(*study, "P03", simulatedStart));  // at a site
  CHECK_FALSE(writeUnfinishedRule(*study, Unfinished::counted));
  fs::remove(siteFolder(out, "berlin") / "participants/P01.jsonl");  // with its head: missed at its site
  fs::remove(siteFolder(out, "berlin") / "participants/P01.head");
  CHECK(missingParticipants(*readParticipants(*openStudy(out))).size() == 1);
}

TEST_CASE("merge: studies that ask for other answers are not merged, and nothing is left behind") {
  StudyDesign design;
  const StudyFolder one(design, {"A", "B"});
  design.feel = Feel::paper;
  const StudyFolder other(design, {"A", "B"});
  const StudyFolder buttons({}, {"A", "C"});
  const fs::path out = one.folder().parent_path() / "merged";
  CHECK_FALSE(mergeStudies({one.folder(), other.folder()}, {"a", "b"}, out));
  CHECK_FALSE(mergeStudies({one.folder(), buttons.folder()}, {"a", "b"}, out));
  CHECK_FALSE(mergeStudies({one.folder(), "/nonexistent"}, {"a", "b"}, out));
  CHECK_FALSE(fs::exists(out));
  CHECK_FALSE(fs::exists(out.string() + ".part"));
}

TEST_CASE("unfinished: the rule is chosen before the first person and kept") {
  StudyDesign design;
  design.trials = 6;
  const StudyFolder made(design, {"A", "B"});
  REQUIRE(writeUnfinishedRule(*made.study, Unfinished::counted));
  CHECK(placesOf(made.folder())->unfinished == Unfinished::counted);
  answer(*made.study, "P01", "errors=1", 2);
  answer(*made.study, "P02", "perfect", 100);
  const Result<Study> study = openStudy(made.folder());
  const StudyResults counted = resultsOf(*study, *readParticipants(*study));
  CHECK_FALSE(counted.unfinishedLeftOut);
  CHECK(counted.groups.at(0).participantCount == 2);
  CHECK(counted.otherGroups.at(0).participantCount == 1);
  CHECK_THAT(resultsText(counted), Catch::Contains("Without those who did not finish"));
}

TEST_CASE(
    "feel: a study plays what everything else plays unless the paper's is requested; its files say which") {
  for (const Feel feel : {usualSettings().feel, Feel::paper}) {
    StudyDesign design;
    design.feel = feel;
    const StudyFolder made(design);
    CHECK(openStudy(made.folder())->design.feel == feel);
    PlaybackSettings settings;
    settings.feel = feel;
    for (std::size_t b = 0; b < made.study->buttons.size(); ++b) {
      const auto played = programFor(*made.study, b, FeedbackMode::full);
      const auto elsewhere = prepareProgram(made.study->buttons[b].button, {}, settings);
      REQUIRE(played);
      REQUIRE(elsewhere);
      CHECK(renderStandardPress(played->program, 48000)->samples ==
            renderStandardPress(elsewhere->program, 48000)->samples);
    }
    answer(*made.study, "P01", "perfect", 1);
    const StudyResults results = resultsOf(*made.study, *readParticipants(*made.study));
    const std::string word = feels.word(feel);
    CHECK_THAT(resultsCsv(results), Catch::EndsWith("," + word + ",0,\n"));
    CHECK_THAT(resultsText(results), Catch::Contains("Feel: " + word));
    CHECK_THAT(resultsJson(results), Catch::Contains("\"feel\":\"" + word + "\""));
    CHECK_THAT(resultsPage(results, {}), Catch::Contains("feel " + word));
  }
  CHECK(StudyDesign{}.feel == Feel::clear);
}

TEST_CASE("feel: a study made before the feel was kept has the paper's") {
  StudyDesign design;
  design.feel = Feel::paper;
  const StudyFolder made(design);
  edit(made.folder() / "study.json", "\"version\": 3", "\"version\": 2");
  edit(made.folder() / "study.json", "  \"feel\": \"paper\",\n", "");
  const Result<Study> old = openStudy(made.folder());
  REQUIRE(old);
  CHECK(old->design.feel == Feel::paper);
  CHECK(checkStimuli(*old));
}

TEST_CASE("stimuli: what would feel different now is refused before anyone answers") {
  const StudyFolder made;
  CHECK(checkStimuli(*made.study));
  made.study->stimuli[1].sha256[0] ^= 1;
  CHECK(checkStimuli(*made.study).failure().sentence().find("feel different") != std::string::npos);
}

TEST_CASE("session: resumes at the very trial; the plan and the answers are those of an unbroken one") {
  const StudyFolder made, unbroken;
  answer(*made.study, "P01", "guess", 7);
  answer(*made.study, "P01", "guess", 5);
  answer(*made.study, "P01", "guess", 1000);
  answer(*unbroken.study, "P01", "guess", 1000);
  const auto one = readParticipants(*made.study), other = readParticipants(*unbroken.study);
  REQUIRE((one && other));
  REQUIRE(one->front().complete());
  CHECK(one->front().sessions.size() == 3);
  for (std::size_t i = 0; i < one->front().answers.size(); ++i)
    CHECK(one->front().answers[i].answer.choice == other->front().answers[i].answer.choice);
}

TEST_CASE(
    "journal: cut at any byte of its end, every whole answer is there and the next trial is the right one") {
  const StudyFolder made;
  answer(*made.study, "P01", "perfect", 3);
  const fs::path file = made.folder() / "participants" / "P01.jsonl";
  std::ifstream in(file);
  std::ostringstream all;
  all << in.rdbuf();
  const std::string text = all.str();
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  const JournalText whole = splitJournal(text.substr(0, last));
  for (std::size_t length = last; length < text.size(); length += 17) {
    std::ofstream(file, std::ios::binary) << text.substr(0, length);
    REQUIRE(writeHead(file, whole.lines.size(), chainAfter(whole.lines)));  // as after a crash
    const Result<ParticipantSession> session = ParticipantSession::open(*made.study, "P01", simulatedStart);
    REQUIRE(session);
    CHECK(session->record().answers.size() == 2);
    CHECK(session->trial()->number == 3);
  }
}

TEST_CASE("journal: a file of another kind in its place is no participant who has not begun") {
  const StudyFolder made;
  answer(*made.study, "P01", "perfect", 3);
  std::ofstream(made.folder() / "participants" / "P02.jsonl", std::ios::binary) << "my notes";
  const Result<ParticipantRecord> record = readParticipant(*made.study, "P02");
  REQUIRE_FALSE(record);
  CHECK_THAT(record.failure().sentence(), Catch::Contains("is not a journal"));
}

TEST_CASE("journal: a line changed, taken out or added by hand is named") {
  const auto failureAfter = [](const std::string& from, const std::string& to) {
    const StudyFolder made;
    answer(*made.study, "P01", "guess", 6);
    edit(made.folder() / "participants" / "P01.jsonl", from, to);
    answer(*made.study, "P02", "guess", 2);
    const auto records = readParticipants(*made.study);
    REQUIRE(records);
    REQUIRE(records->size() == 2);
    REQUIRE(records->front().damage);
    CHECK(records->front().answers.empty());
    CHECK(records->back().answers.size() == 2);  // the damage costs that participant only
    const StudyResults results = resultsOf(*made.study, *records);
    CHECK(results.rows.size() == 2);
    CHECK(results.warnings.front().find("P01 is left out") == 0);
    CHECK_FALSE(ParticipantSession::open(*made.study, "P01", simulatedStart));
    return *records->front().damage;
  };
  CHECK(failureAfter("\"trial\":3", "\"trial\":4").sentence().find("line 5") != std::string::npos);
  CHECK(failureAfter("\"correct\":true", "\"correct\":false").sentence().find("by hand") !=
        std::string::npos);
  CHECK(failureAfter("\"version\":1", "\"version\":9").exitCode() == 3);
  const StudyFolder one, other;
  answer(*one.study, "P01", "guess", 2);
  fs::copy_file(one.folder() / "participants" / "P01.jsonl", one.folder() / "participants" / "P02.jsonl");
  const auto copied = readParticipants(*one.study);
  REQUIRE(copied);
  CHECK(copied->front().answers.size() == 2);
  CHECK(copied->back().damage->sentence().find("P01") != std::string::npos);
}

TEST_CASE("journal: whole lines cut off its end, emptied or gone, it is noticed") {
  const StudyFolder made;
  answer(*made.study, "P01", "guess", 6);
  const fs::path file = made.folder() / "participants" / "P01.jsonl";
  const std::string text = *readTextFile(file.string());
  const auto damaged = [&] {
    CHECK_FALSE(ParticipantSession::open(*made.study, "P01", simulatedStart));
    return readParticipants(*made.study)->front().damage.has_value();
  };
  std::ofstream(file, std::ios::binary) << text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  CHECK(damaged());
  std::ofstream(file, std::ios::binary) << "";
  CHECK(damaged());
  fs::remove(file);
  CHECK(damaged());
  std::ofstream(file, std::ios::binary) << text;
  const std::string head = *readTextFile(headFileOf(file).string());
  for (const char* worthless : {"", "abc\n"}) {
    std::ofstream(headFileOf(file), std::ios::binary) << worthless;
    CHECK(damaged());
  }
  fs::remove(headFileOf(file));  // the journal says that a head file existed
  CHECK(damaged());
  std::ofstream(headFileOf(file), std::ios::binary) << head;
  CHECK_FALSE(readParticipants(*made.study)->front().damage);
  // A head that is behind by a line is a crash between the two.
  std::ofstream(file, std::ios::binary) << text;
  std::ofstream(headFileOf(file)) << "1 " << chainAfter({text.substr(0, text.find('\n'))}) << "\n";
  CHECK_FALSE(readParticipants(*made.study)->front().damage);
  CHECK(ParticipantSession::open(*made.study, "P01", simulatedStart));
}

TEST_CASE("journal: of a browser no head is expected, and what was not felt is no answer in it") {
  const StudyFolder made;
  const SessionStart person{SessionKind::real, Listening::quiet, "a browser's output", "", 1000};
  ParticipantRecord record = test::beginner("P01");
  record.place = 3;
  record.plan = planTrials(*made.study, "P01", 3);
  const fs::path file = journalOf(*made.study, "P01");
  const auto written = [&](const Answer& answer) {
    // The route behind the header, and the hash over all: as the browser does it.
    const std::string header = headerOfBrowser(*made.study, record);
    const std::string body =
        header.substr(0, header.size() - 1) +
        R"(,"route":{"sensor":"","sensor_calibration":"","sound":"a browser's output"}})";
    std::string chain = sha256Hex(body).substr(0, 16);
    std::string text = body.substr(0, body.size() - 1) + R"(,"chain":")" + chain + "\"}\n";
    text += sessionLine(person, 0, chain) + "\n";
    text += answerLine(*made.study, record.plan[0], answer, chain) + "\n";
    std::ofstream(file, std::ios::binary) << text;
    return readParticipants(*made.study)->front();
  };
  const Answer felt = simulatedAnswer(*made.study, "P01", record.plan[0], {});
  const ParticipantRecord read = written(felt);
  REQUIRE_FALSE(read.damage);
  CHECK(read.answers.size() == 1);
  CHECK(read.place == 3);
  CHECK(read.sessions[0].device == "a browser's output");
  Answer unfelt = felt;
  unfelt.feltX = {1, 0, 1.2, 0.4};
  CHECK(written(unfelt).damage);
  unfelt = felt;
  unfelt.felt.pop_back();
  CHECK(written(unfelt).damage);
  unfelt = felt;
  unfelt.replays.push_back(1);
  CHECK(written(unfelt).damage);
}

TEST_CASE("results: a person whose journal was taken out of the folder with its head is missed") {
  const StudyFolder made;
  for (const char* id : {"P01", "P02", "P03"}) answer(*made.study, id, "guess", 2);
  const auto warned = [&] {
    const StudyResults results = resultsOf(*made.study, *readParticipants(*made.study));
    return results.warnings.front().find("1 who began before P03") == 0;
  };
  CHECK_FALSE(warned());
  fs::remove(made.folder() / "participants" / "P02.jsonl");
  CHECK_FALSE(warned());  // the head file shows that the participant existed
  fs::remove(made.folder() / "participants" / "P02.head");
  CHECK(warned());
}

TEST_CASE("session: ids that sound alike are one person; who listened in one condition goes on in it") {
  const StudyFolder made;
  answer(*made.study, "P01", "guess", 2);
  for (const char* id : {"P1", "P-1", "P_1", "p01", "P001"}) {
    const auto session = ParticipantSession::open(*made.study, id, simulatedStart);
    REQUIRE_FALSE(session);
    CHECK(session.failure().exitCode() == 2);
    CHECK(session.failure().sentence().find("P01") != std::string::npos);
  }
  CHECK(ParticipantSession::open(*made.study, "P10", simulatedStart));
  SessionStart masked = simulatedStart;
  masked.listening = Listening::masked;
  const auto other = ParticipantSession::open(*made.study, "P01", masked);
  REQUIRE_FALSE(other);
  CHECK(other.failure().exitCode() == 2);
  CHECK(ParticipantSession::open(*made.study, "P02", masked));
  CHECK(listeningOf(*made.study, "P02", {}) == Listening::masked);
  CHECK(listeningOf(*made.study, "P03", {}) == Listening::quiet);
}

TEST_CASE("session: a person's answer to what was not felt is not kept; what was felt is") {
  const StudyFolder made;
  SessionStart person{SessionKind::real, Listening::quiet, "JACK", "", 1000};
  person.route = {"/dev/ttyACM0", "linear 0 9.81; residual 0.02 N; 14 weights", "JACK, 48000 Hz, 64 frames"};
  {
    Result<ParticipantSession> session = ParticipantSession::open(*made.study, "P01", person);
    REQUIRE(session);
    Answer answer = simulatedAnswer(*made.study, "P01", *session->trial(), {});
    for (Felt* felt : {&answer.felt[0], &answer.felt[1], &answer.feltX}) {
      // a press that began but did not reach the bottom
      const Felt kept = std::exchange(*felt, {1, 0, 1.2, 0.4});
      CHECK_FALSE(session->record(answer));
      *felt = kept;
    }
    answer.feltX = {2, 1, 1.75, 3.5};
    CHECK(session->record(answer));
  }
  const ParticipantRecord record = readParticipants(*made.study)->front();
  REQUIRE(record.answers.size() == 1);
  CHECK(record.answers[0].answer.feltX.travel_mm == 3.5);
  CHECK(record.sessions[0].route.sensorCalibration == person.route.sensorCalibration);
  const std::string journal = *readTextFile((made.folder() / "participants" / "P01.jsonl").string());
  CHECK(journal.substr(0, journal.find('\n')).find("14 weights") != std::string::npos);  // the first line
  const std::string csv = feltCsv(resultsOf(*made.study, {record}));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
  CHECK(csv.find(",2,1,1.75,3.5,quiet") != std::string::npos);
}

TEST_CASE("study: without stimuli, or with a session of a kind nobody knows, it is refused and not run") {
  const StudyFolder made;
  const fs::path file = made.folder() / "study.json";
  std::string text = *readTextFile(file.string());
  const std::size_t at = text.find("\"stimuli\": [");
  std::ofstream(file) << text.substr(0, at) << "\"stimuli\": []\n}\n";
  const Result<Study> study = openStudy(made.folder());
  REQUIRE_FALSE(study);
  CHECK(study.failure().exitCode() == 3);

  const StudyFolder other;
  std::string chain;
  REQUIRE(writeHead(other.folder() / "participants" / "P01.jsonl", 0, {}));
  std::ofstream journal(other.folder() / "participants" / "P01.jsonl");
  journal << headerLine(*other.study, detent::test::beginner("P01"), {}, chain) << "\n";
  std::string line = sessionLine(simulatedStart, 0, chain);
  const std::string body = line.substr(0, line.rfind(",\"chain\"")) + "}";
  const std::string strange =
      body.substr(0, body.find("simulated")) + "telepathy" + body.substr(body.find("simulated") + 9);
  chain = chainAfter(
      {headerLine(*other.study, detent::test::beginner("P01"), {}, *std::make_unique<std::string>())});
  journal << strange.substr(0, strange.size() - 1) << ",\"chain\":\""
          << sha256Hex(chain + strange).substr(0, 16) << "\"}\n";
  journal.close();
  const auto records = readParticipants(*other.study);
  REQUIRE(records->front().damage);
  CHECK(records->front().damage->sentence().find("telepathy") != std::string::npos);
}

TEST_CASE(
    "session: one process at a time; no person's answers among simulated ones; ids name no file outside") {
  const StudyFolder made;
  {
    const Result<ParticipantSession> first = ParticipantSession::open(*made.study, "P01", simulatedStart);
    REQUIRE(first);
    CHECK(ParticipantSession::open(*made.study, "P01", simulatedStart).failure().exitCode() == 3);
    CHECK(ParticipantSession::open(*made.study, "P02", simulatedStart));
  }
  SessionStart person = simulatedStart;
  person.kind = SessionKind::real;
  CHECK(ParticipantSession::open(*made.study, "P01", person).failure().exitCode() == 2);
  for (const char* id : {"", "../P01", "a/b", "P 1", "-P1", "012345678901234567890123456789012"})
    CHECK_FALSE(ParticipantSession::open(*made.study, id, simulatedStart));
}

TEST_CASE("session: clocks that disagree are reported, times stay as measured") {
  const StudyFolder made;
  SessionStart later = simulatedStart;
  later.kind = SessionKind::rehearsal;
  answer(*made.study, "P01", "perfect", 4, later);
  later.utc_s -= 5000;
  answer(*made.study, "P01", "perfect", 4, later);
  const auto records = readParticipants(*made.study);
  REQUIRE(records);
  REQUIRE(records->front().notes.size() == 1);
  CHECK(records->front().notes[0].find("two clocks disagree") != std::string::npos);
  double before = -1;
  for (const RecordedAnswer& a : records->front().answers) {
    CHECK(a.onset_s > before);
    before = a.onset_s;
  }
  // Simulated times are made up.
  answer(*made.study, "P02", "perfect", 4);
  SessionStart earlier = simulatedStart;
  earlier.utc_s -= 5000;
  answer(*made.study, "P02", "perfect", 4, earlier);
  CHECK((*readParticipants(*made.study))[1].notes.empty());
}

TEST_CASE("session: a trial broken off by the device is marked, its row says so") {
  const StudyFolder made;
  {
    Result<ParticipantSession> session = ParticipantSession::open(*made.study, "P01", simulatedStart);
    REQUIRE(session);
    REQUIRE(session->interrupted("sound device lost"));
    CHECK(session->trial()->number == 1);
  }
  answer(*made.study, "P01", "perfect", 2);
  {
    Result<ParticipantSession> session = ParticipantSession::open(*made.study, "P01", simulatedStart);
    REQUIRE(session);
    REQUIRE(session->interrupted("sound device lost"));
    REQUIRE(session->record(simulatedAnswer(*made.study, "P01", *session->trial(), {})));
  }
  const auto records = readParticipants(*made.study);
  const std::vector<TrialRow> rows = rowsOf(*made.study, *records);
  CHECK(rows[0].condition == "quiet/simulated/repeated");  // gone on with on another day
  CHECK(rows[1].condition == "quiet/simulated");
  CHECK(rows[2].condition == "quiet/simulated/repeated");
}

TEST_CASE("session: an early end keeps the columns; stopping is reported") {
  const StudyFolder made;
  {
    Result<ParticipantSession> session = ParticipantSession::open(*made.study, "P01", simulatedStart);
    REQUIRE(session->record(simulatedAnswer(*made.study, "P01", *session->trial(), {})));
    REQUIRE(session->end("stopped by the participant"));
    CHECK(session->trial() == nullptr);
  }
  CHECK(readParticipants(*made.study)->front().next() == nullptr);
  const StudyResults results = resultsOf(*made.study, *readParticipants(*made.study));
  const std::string csv = resultsCsv(results);
  CHECK(csv.rfind("study,participant,trial,pair,a,b,x,answer,correct,replays_a,replays_b,replays_x,answer_s,"
                  "condition,feel,finished,site\n",
                  0) == 0);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 2);
  CHECK(std::any_of(results.warnings.begin(), results.warnings.end(),
                    [](const std::string& w) { return w.find("ended early") != std::string::npos; }));
  // A participant who comes back goes on where they stopped.
  Result<ParticipantSession> again = ParticipantSession::open(*made.study, "P01", simulatedStart);
  REQUIRE(again);
  REQUIRE(again->trial() != nullptr);
  CHECK(again->trial()->number == 2);
  REQUIRE(again->record(simulatedAnswer(*made.study, "P01", *again->trial(), {})));
  CHECK(readParticipants(*made.study)->front().answers.size() == 2);
}

TEST_CASE("trial controller: nothing is answered unfelt; times and tries are counted") {
  const StudyFolder made;
  const Trial trial = planTrials(*made.study, "P01").front();
  TrialController controller(*made.study, trial, 100, 110);
  CHECK_FALSE(controller.mayAnswer());
  controller.felt({1, 1, 1, 1});  // nothing is under the finger yet
  controller.tried(0, 111);
  controller.felt({1, 1, 1.5, 3});
  controller.tried(controller.slotOfX(), 112);
  controller.felt({1, 1, 1.5, 3});
  CHECK_FALSE(controller.mayAnswer());
  controller.tried(1, 113);
  CHECK_FALSE(controller.mayAnswer());
  controller.felt({1, 0, 0.5, 1});  // released too early
  CHECK_FALSE(controller.mayAnswer());
  controller.tried(1, 114);
  controller.felt({1, 1, 1.2, 2.5});
  REQUIRE(controller.mayAnswer());
  const Answer a = controller.answer(1, 116);
  CHECK(a.replays == std::vector<std::size_t>{1, 2});
  CHECK(a.onset_s == 10);
  CHECK(a.firstPress_s == 1);
  CHECK(a.answer_s == 6);
  CHECK(a.felt[1].presses == 2);
  CHECK(a.felt[1].whole == 1);
  CHECK(a.felt[1].peak_N == 1.2);
  CHECK(a.feltX.travel_mm == 3);
}

TEST_CASE("results: a perfect and a guessing participant, the rule and its p") {
  const StudyFolder made;
  answer(*made.study, "P01", "perfect", 1000);
  answer(*made.study, "P02", "errors=1", 1000);
  const StudyResults results = resultsOf(*made.study, *readParticipants(*made.study));
  REQUIRE(results.groups.size() == 1);
  const GroupResult& group = results.groups.front();
  CHECK(group.errors == Count{30, 60});
  CHECK(group.fails == Count{3, 6});
  CHECK(*results.rule.mostErrors == 1);
  CHECK(results.rule.p == Approx(11.0 / 1024));
  for (const PairResult& pair : group.pairs) {
    CHECK(pair.failCount == std::size_t{1});
    CHECK(pair.tests[0].discriminates);
    CHECK(pair.tests[0].adjusted == Approx(3.0 / 1024));
  }
  CHECK(results.anySimulated);
  CHECK(resultsText(results).find("SIMULATED") != std::string::npos);
  CHECK(resultsPage(results, {}).find("SIMULATION") != std::string::npos);
  CHECK(discriminationRule(4).mostErrors == std::nullopt);
  CHECK(*discriminationRule(5).mostErrors == 0);
}

TEST_CASE("results: eight people all better in one mode: p is exact, and Holm counts pairs and modes") {
  StudyDesign design;
  design.modes = {FeedbackMode::full, FeedbackMode::clickOnly};
  const StudyFolder made(design);
  std::vector<ParticipantRecord> people;
  for (int i = 0; i < 8; ++i) {
    ParticipantRecord p;
    p.participant = "P" + std::to_string(i + 1);
    p.begunBefore = static_cast<std::size_t>(i);
    p.plan = planTrials(*made.study, p.participant, p.begunBefore);
    int wrongInClicks = 1 + i;
    for (const Trial& trial : p.plan) {
      const bool wrong = trial.mode == FeedbackMode::clickOnly && wrongInClicks-- > 0;
      RecordedAnswer given;
      given.answer.trial = trial.number;
      given.answer.choice = wrong ? 1 - trial.target : trial.target;
      p.answers.push_back(given);
    }
    people.push_back(p);
  }
  const StudyResults results = resultsOf(*made.study, people);
  REQUIRE(results.comparisons.size() == 4);  // all trials, and three pairs
  const GroupComparison& all = results.comparisons[0];
  CHECK(all.paired);
  CHECK(all.participants == 8);
  CHECK(all.p == Approx(2.0 / 256));  // 0.0078
  CHECK(all.adjusted == all.p);
  REQUIRE(all.interval);
  CHECK(all.interval->low * all.interval->high > 0);  // zero is outside the interval
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(results.comparisons[i].pair == i - 1);
    CHECK(results.comparisons[i].adjusted >= results.comparisons[i].p);
  }
  CHECK(resultsText(results).find("p = 0.0078") != std::string::npos);
  CHECK(resultsPage(results, {}).find("8, in both") != std::string::npos);
  // One person's tests are adjusted over six: three pairs in two modes.
  CHECK(results.groups[0].pairs[0].tests[0].adjusted >= results.groups[0].pairs[0].tests[0].p);
  CHECK(results.groups[1].pairs[0].tests[0].adjusted == Approx(6.0 / 1024));
}

TEST_CASE("results: of several comparisons each line of a pair stands below its conditions") {
  StudyDesign design;
  design.trials = 2;
  design.modes = {FeedbackMode::full, FeedbackMode::clickOnly, FeedbackMode::slopeOnly};
  const StudyFolder made(design, {"A", "B"});
  answer(*made.study, "P01", "guess", 6);
  const std::string text = resultsText(resultsOf(*made.study, *readParticipants(*made.study)));
  std::istringstream lines(text.substr(text.find("Conditions against each other")));
  std::string line, before;
  std::size_t pairs = 0;
  for (; std::getline(lines, line); before = line) {
    if (!line.starts_with("  A-B ")) continue;
    ++pairs;
    CHECK(before.find(" - ") != std::string::npos);
  }
  CHECK(pairs == 3);
}

TEST_CASE("results: every line of the text fits 80 columns, and long labels still differ") {
  StudyResults results;
  results.labels = {"a very long label one", "a very long label two", "c"};
  results.names = results.labels;
  GroupResult group;
  group.condition = "masked/click-only";
  for (const auto& [first, second] : pairsOf(3)) group.pairs.push_back(pairResult(first, second, {3, 90}));
  results.groups.push_back(group);
  std::istringstream text(resultsText(results));
  std::set<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    CHECK(line.size() <= 80);
    if (line.find("3/90") != std::string::npos) CHECK(lines.insert(line).second);
  }
  CHECK(lines.size() == 3);
}

TEST_CASE("page: every bar of the chart has a name of its own, however long the labels are") {
  StudyResults results;
  results.labels = {"switch with a long name, sample 1", "switch with a long name, sample 2", "c",
                    "switch with a l~1"};
  results.names = results.labels;
  GroupResult group;
  group.condition = "quiet";
  for (const auto& [first, second] : pairsOf(results.labels.size()))
    group.pairs.push_back(pairResult(first, second, {3, 90}));
  results.groups.push_back(group);
  const std::string page = resultsPage(results, {});
  std::set<std::string> names;
  std::size_t bars = 0;
  for (std::size_t at = page.find("<title>", page.find("<svg")); at != std::string::npos;
       at = page.find("<title>", at + 1), ++bars) {
    const std::size_t begin = page.rfind('>', at - 1) + 1;
    names.insert(page.substr(begin, at - begin));
  }
  CHECK(bars == 6);
  CHECK(names.size() == bars);
}

TEST_CASE("results: no two pairs are named alike, whatever hyphens their labels hold") {
  const std::vector<std::string> plain{"A", "B"}, hyphens{"A-B", "C", "A", "B-C"}, mixed{"A-B", "C | D", "E"};
  CHECK(pairName(plain, 0, 1) == "A-B");
  for (const std::vector<std::string>& labels : {hyphens, mixed}) {
    std::set<std::string> names;
    for (const auto& [first, second] : pairsOf(labels.size())) names.insert(pairName(labels, first, second));
    CHECK(names.size() == pairsOf(labels.size()).size());
  }
}

TEST_CASE("results: words are wrapped at 80 letters, not bytes, behind their sign") {
  std::string words;
  for (int i = 0; i < 60; ++i) words += "\xc3\xbc\xc3\xbc\xc3\xbc ";
  std::istringstream lines(wrapped(words, "- "));
  std::string line;
  std::size_t count = 0;
  for (; std::getline(lines, line); ++count) {
    CHECK(line.rfind(count == 0 ? "- " : "  ", 0) == 0);
    CHECK(widthOf(line) <= 80);
    CHECK((widthOf(line) > 74 || count == 3));
  }
  CHECK(count == 4);
  CHECK(wrapped("", "- ").empty());
}

TEST_CASE("results: no error is half an error, never infinity, and above one error") {
  const Sensitivity s = sensitivityOf({0, 90});
  CHECK(s.noError);
  CHECK(s.low == Approx(4.31).margin(0.01));
  CHECK(s.differencing > sensitivityOf({1, 90}).differencing);
  CHECK(std::isfinite(s.independent));
  CHECK(sensitivityOf({45, 90}).differencing == 0);
}

TEST_CASE("results: labels that CSV and HTML must quote come out whole") {
  StudyResults results;
  results.study = "a,\"b\"";
  results.labels = {"<x>", "y"};
  results.names = results.labels;
  TrialRow row;
  row.participant = "P01";
  row.x = "y,\nz";
  results.rows.push_back(row);
  CHECK(resultsCsv(results).find("\"a,\"\"b\"\"\"") != std::string::npos);
  CHECK(resultsCsv(results).find("\"y,\nz\"") != std::string::npos);
  CHECK(resultsPage(results, {}).find("&lt;x&gt;") != std::string::npos);
}

TEST_CASE("Kim & Lee's printed counts: their percentages, and what does not add up") {
  const std::string folder = std::string(DETENT_SOURCE_DIR) + "/samples/studies/kim-lee-2013";
  REQUIRE(holdsPrintedCounts(folder));
  const Result<StudyResults> results = readPrintedCounts(folder);
  REQUIRE(results);
  std::string text = resultsText(*results);
  while (text.find("\n  ") != std::string::npos) text.replace(text.find("\n  "), 3, " ");  // wrapped
  for (const char* figure :
       {"8 / 1350 (0.59 %)", "46 / 1350 (3.41 %)", "1 / 135 (0.74 %)", "8 / 135 (5.93 %)",
        "\"76/96\" is printed (79.2 %)", "72 trials", "57/72", "24 participants", "52/72"})
    CHECK(text.find(figure) != std::string::npos);
  CHECK(results->warnings.size() == 2);
  for (const PairResult& pair : results->groups.front().pairs) CHECK_FALSE(pair.failCount.has_value());
}

TEST_CASE("results: of fewer than five trials nobody passes or fails, and it is said") {
  StudyDesign design;
  design.trials = 4;
  const StudyFolder made(design);
  answer(*made.study, "P01", "perfect", 1000);
  const StudyResults results = resultsOf(*made.study, *readParticipants(*made.study));
  REQUIRE_FALSE(results.groups.empty());
  CHECK(results.groups[0].fails.trials == 0);
  CHECK_FALSE(results.groups[0].pairs[0].failCount);
  CHECK(std::any_of(results.warnings.begin(), results.warnings.end(),
                    [](const std::string& w) { return w.find("too few for a test") != std::string::npos; }));
}

TEST_CASE("page: what was foretold of a mode stands beside what was found in it") {
  const StudyFolder made;
  answer(*made.study, "P01", "perfect", 1000);
  const StudyResults results = resultsOf(*made.study, *readParticipants(*made.study));
  ForetoldPair pair{FeedbackMode::full, 0, 1, 2, 0.1, "nobody knows", "by its click"};
  CHECK(resultsPage(results, {pair}).find("by its click") != std::string::npos);
  CHECK(resultsPage(results, {pair}).find("nobody knows") != std::string::npos);
  pair.mode = FeedbackMode::clickOnly;
  CHECK(resultsPage(results, {pair}).find("by its click") == std::string::npos);
}

namespace {

enum class Sensor { good, zeros, silent, stuck, lost, light };

/// A person who tries to answer everything while the sensor does this; how many answers the journal holds
/// then.
std::size_t answersWith(const Study& study, const std::string& id, Sensor sensor) {
  StudyRandom random = randomSeededBy(id);
  Result<ParticipantSession> session =
      ParticipantSession::open(study, id, {SessionKind::real, Listening::quiet, "JACK", "", 1000});
  REQUIRE(session);
  for (int tries = 0; tries < 12 && session->trial() != nullptr; ++tries) {
    const Trial& trial = *session->trial();
    TrialController controller(study, trial, 0, tries);
    for (std::size_t slot = 0; slot <= controller.slotOfX(); ++slot) {
      const Result<PreparedProgram> prepared = programFor(study, controller.buttonIn(slot), trial.mode);
      const auto program = std::make_unique<HapticProgram>(prepared->program);
      StrokeTracker tracker;
      PressCounter counter;
      tracker.use(program.get());
      counter.use(program.get());
      const double strongest_N = 1.3 * strongestForce_N(*program), stuck_N = strongest_N * drawShare(random);
      controller.tried(slot, tries + 0.1);
      for (int i = 0; i <= 200 && sensor != Sensor::silent; ++i) {
        const double share = i <= 100 ? i / 100.0 : (200 - i) / 100.0;
        double force_N = strongest_N * share;
        if (sensor == Sensor::zeros) force_N = 0.02 * drawShare(random);
        if (sensor == Sensor::stuck) force_N = stuck_N;
        if (sensor == Sensor::light) force_N = 0.2 * strongest_N * share;
        if (sensor == Sensor::lost && i > 120) break;  // the sensor is lost on the way up
        tracker.updateForce(force_N);
        counter.take(tracker.position());
      }
      const PressCount count = counter.taken();
      controller.felt({count.begun, count.whole, count.peak_N, count.travel_mm});
    }
    if (controller.mayAnswer()) {
      REQUIRE(session->record(controller.answer(drawBelow(random, 2), tries + 1.0)));
    } else {  // a front end without a trial controller comes no further
      Answer blind = simulatedAnswer(study, id, trial, {});
      for (std::size_t slot = 0; slot < controller.slotOfX(); ++slot)
        blind.felt[slot] = controller.feltOf(slot);
      blind.feltX = controller.feltOf(controller.slotOfX());
      CHECK_FALSE(session->record(blind));
    }
  }
  return session->record().answers.size();
}

}  // namespace

TEST_CASE("200 studies with a dead, silent, stuck, lost or barely touched sensor: none is answered as real") {
  StudyDesign design;
  design.trials = 2;
  const StudyFolder made(design);
  std::size_t answered = 0;
  for (int i = 0; i < 200; ++i)
    answered += answersWith(*made.study, "S" + std::to_string(i),
                            std::array{Sensor::zeros, Sensor::silent, Sensor::stuck, Sensor::lost,
                                       Sensor::light}[static_cast<std::size_t>(i) % 5]);
  CHECK(answered == 0);
  CHECK(answersWith(*made.study, "good", Sensor::good) == 6);
  const auto records = readParticipants(*made.study);
  CHECK(std::count_if(records->begin(), records->end(),
                      [](const ParticipantRecord& r) { return r.complete(); }) == 1);
}
