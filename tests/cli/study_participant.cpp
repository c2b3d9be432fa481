// SPDX-License-Identifier: GPL-3.0-or-later
// A participant without eyes: what detent-edit's station does with a study, driven by single keys on standard
// input, so that tests can break devices under it. Prints "trial N", "lost: WHY", "answered", "early", "end".
//
//   study_participant STUDY ID [--device NAME] [--sensor PORT] [--force DEVICE] [--rehearse]
//
// Keys: 1 to 9 and x put a stimulus under the finger, a to i answer, space presses in a timing study, e stops
// the force, r arms it again, q leaves.

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include <poll.h>
#include <unistd.h>

#include "playback/study.h"
#include "playback/study/study_player.h"
#include "playback/study/timed_run.h"

using namespace detent;
using namespace detent::playback;

namespace {

constexpr double answerPoll_s = 0.05, timedPoll_s = 0.01;
constexpr char leaves = 'q';

/// A key within that time; 'q' at the end of the input.
std::optional<char> key(double within_s) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, static_cast<int>(1000 * within_s)) <= 0) return {};
  char typed = leaves;
  return ::read(STDIN_FILENO, &typed, 1) == 1 ? typed : leaves;
}

void say(const std::string& words) {
  std::printf("%s\n", words.c_str());
  std::fflush(stdout);
}

class Participant {
 public:
  Participant(const Study& study, ParticipantSession& session, StudyPlayer& player)
      : study_(study), session_(session), player_(player), began_s_(player.clock_s()) {}

  Result<Done> work() {
    while (session_.trial() != nullptr) {
      say("trial " + std::to_string(session_.trial()->number));
      Result<bool> goesOn = study_.design.kind == StudyKind::timing ? timed() : answered();
      if (!goesOn) return goesOn.failure();
      if (!*goesOn) return Done{};
    }
    say("end");
    return session_.end("complete");
  }

 private:
  StudyTrouble trouble() { return player_.takeTrouble(); }

  /// Keys that go to the device. False: the participant leaves.
  bool obeyed(char typed) {
    if (typed == 'e') player_.stopForce();
    if (typed == 'r') player_.rearm();
    return typed != leaves;
  }

  /// Waits until the device is connected again.
  bool deviceBack(StudyTrouble why) {
    say(std::string("lost: ") + nameOf(why));
    while (trouble() != StudyTrouble::none)
      if (const auto typed = key(answerPoll_s); typed && !obeyed(*typed)) return false;
    return true;
  }

  Result<bool> timed() {
    TimedRun run(study_, session_, player_, began_s_);
    for (;;) {
      const std::optional<char> typed = key(timedPoll_s);
      if (typed && !obeyed(*typed)) return false;
      if (typed == ' ') run.pressed(player_.clock_s(), timedPoll_s);
      const Result<TimedOutcome> outcome = run.update();
      if (!outcome) return outcome.failure();
      if (outcome->state == TimedState::kept) say("answered");
      if (outcome->state == TimedState::lost) return deviceBack(outcome->trouble);
      if (outcome->state != TimedState::running) return true;
    }
  }

  Result<bool> answered() {
    TrialController work(study_, *session_.trial(), began_s_, player_.clock_s());
    player_.beginTrial();
    trouble();
    for (;;) {
      if (const StudyTrouble why = trouble(); why != StudyTrouble::none) {
        if (Result<Done> ok = session_.interrupted(nameOf(why)); !ok) return ok.failure();
        return deviceBack(why);
      }
      const std::optional<char> typed = key(answerPoll_s);
      work.felt(player_.takeFelt());
      if (!typed) continue;
      if (!obeyed(*typed)) return false;
      const std::size_t choices = work.trial().choices.size();
      const std::size_t slot = *typed == 'x' ? work.slotOfX() : static_cast<std::size_t>(*typed - '1');
      if (*typed == 'x' || (*typed >= '1' && slot < choices)) {
        player_.press(slot, work.buttonIn(slot), work.trial().mode);
        work.tried(slot, player_.clock_s());
      }
      const auto choice = static_cast<std::size_t>(*typed - 'a');
      if (*typed < 'a' || choice >= choices) continue;
      if (!work.mayAnswer()) {
        say("early");
        continue;
      }
      if (Result<Done> ok = session_.record(work.answer(choice, player_.clock_s())); !ok) return ok.failure();
      say("answered");
      return true;
    }
  }

  const Study& study_;
  ParticipantSession& session_;
  StudyPlayer& player_;
  const double began_s_;
};

int failed(const Failure& failure) {
  std::fprintf(stderr, "%s\n", failure.sentence().c_str());
  return static_cast<int>(failure.code);
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return 2;
  StudyPlayerSettings settings;
  for (int i = 3; i < count; ++i) {
    const std::string option = words[i];
    if (option == "--rehearse") settings.rehearse = true;
    if (i + 1 == count) break;
    if (option == "--device") settings.player.device = words[++i];
    if (option == "--sensor") settings.sensorPort = words[++i];
    if (option == "--force") settings.force = *forceDeviceFrom(words[++i]);
  }
  const Result<Study> study = openStudy(words[1]);
  if (!study) return failed(study.failure());
  const Result<std::unique_ptr<StudyPlayer>> player = StudyPlayer::start(*study, settings);
  if (!player) return failed(player.failure());
  SessionStart start;
  start.kind = (*player)->sounding() ? SessionKind::real : SessionKind::rehearsal;
  start.device = (*player)->device();
  start.route = (*player)->route();
  start.utc_s = systemClock_s();
  Result<ParticipantSession> session = ParticipantSession::open(*study, words[2], start);
  if (!session) return failed(session.failure());
  const Result<Done> done = Participant(*study, *session, **player).work();
  return done ? 0 : failed(done.failure());
}
