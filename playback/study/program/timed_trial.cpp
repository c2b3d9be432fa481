// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/program/timed_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "model/message.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double blocked_s = 1e-4;      // a wait so long has blocked
constexpr double timedPoll_s = 0.01;    // a sensor's presses are timed by themselves; this is for the picture
constexpr std::size_t wayColumns = 40;  // of the ball, from its start to the window

/// The window's line: the ball runs through it.
class Track {
 public:
  explicit Track(const Trial& trial) {
    if (trial.window_s > 0)
      window_ = std::max<std::size_t>(
          1, static_cast<std::size_t>(std::lround(wayColumns * trial.window_s / trial.interval_s)));
  }

  /// Draws where it has moved to; `way` 1: at the window's beginning.
  void draw(double way) {
    const double column = std::clamp(way, 0.0, 3.0) * wayColumns;
    const auto at = static_cast<std::size_t>(column);
    if (at == drawnAt_) return;
    drawnAt_ = at;
    std::string line(wayColumns, ' ');
    line += "[" + std::string(window_, ' ') + "]" + std::string(8, ' ');
    const std::size_t brackets = at < wayColumns             ? 0
                                 : at < wayColumns + window_ ? 1
                                                             : 2,
                      place = at + brackets;
    if (way > 0 && place < line.size()) line[place] = 'o';
    std::fprintf(stderr, "\r  %s", line.c_str());
  }

 private:
  std::size_t window_ = 0, drawnAt_ = static_cast<std::size_t>(-1);
};

class TimedTrial {
 public:
  explicit TimedTrial(const TimedDesk& at)
      : at_(at), run_(at.study, at.session, at.player, at.began_s), track_(run_.trial()) {}

  Result<TrialEnd> ask() {
    for (;;) {
      if (at_.cancelled()) return TrialEnd::paused;
      draw();
      if (const std::optional<TrialEnd> left = key()) return *left;
      const Result<TimedOutcome> outcome = run_.look();
      if (!outcome) return outcome.failure();
      if (outcome->state != TimedState::running) return ended(*outcome);
    }
  }

 private:
  bool window() const { return at_.study.design.task == TimingTask::window; }
  const std::vector<double>& beats_s() const { return run_.desk().beats_s(); }

  void draw() {
    if (window()) return track_.draw(run_.desk().wayAt(now_s()));
    for (; drawn_ < beats_s().size() && beats_s()[drawn_] <= now_s(); ++drawn_)
      std::fprintf(stderr, "  %s", drawn_ + 1 < beats_s().size() ? "." : "O");
  }

  /// Longest time until the next picture.
  double wait_s() const {
    const double at_s = now_s();
    double wait_s = timedPoll_s;
    if (drawn_ < beats_s().size()) wait_s = std::min(wait_s, beats_s()[drawn_] - at_s);
    return std::max(wait_s, 0.0);
  }

  /// Waits for a key.
  std::optional<TrialEnd> key() {
    const double wait = wait_s(), from_s = now_s();
    const std::optional<char> key = at_.terminal.key(wait);
    const double at_s = now_s();
    // A key that was waited for is as late as this thread is woken; one that was already there came since the
    // previous poll.
    if (!key) latestWake_s_ = std::max(latestWake_s_, at_s - from_s - wait);
    const double within_s = at_s - from_s > blocked_s ? latestWake_s_ : at_s - looked_s_;
    looked_s_ = at_s;
    if (!key) return {};
    if (*key == escapeKey) at_.player.stopForce();
    if (*key == ' ') run_.pressed(at_s, within_s);
    if (*key == 'p' || *key == 'P' || *key == 4) return TrialEnd::paused;  // Ctrl-D
    if (*key == 'q' || *key == 'Q') return TrialEnd::stopping;
    return {};
  }

  const char* wordsOf(TimingFault fault) const {
    switch (fault) {
      case TimingFault::none:
        return "";
      case TimingFault::noPress:
        return at_.words.noPress;
      case TimingFault::held:
        return at_.words.held;
      case TimingFault::notFelt:
        break;
    }
    return at_.words.notFelt;
  }

  TrialEnd ended(const TimedOutcome& outcome) {
    switch (outcome.state) {
      case TimedState::running:
      case TimedState::kept:
        break;
      case TimedState::lost:
        std::fprintf(stderr, "\n%s\n", filled(at_.words.interrupted, {nameOf(outcome.trouble)}).c_str());
        awaitDevice(at_.player, at_.terminal, at_.words, outcome.trouble, at_.cancelled);
        return TrialEnd::again;
      case TimedState::anew:
        std::fprintf(stderr, "\n%s\n",
                     outcome.failure ? filled(at_.words.interrupted, {outcome.failure->sentence()}).c_str()
                                     : wordsOf(outcome.fault));
        return TrialEnd::again;
    }
    if (window())
      std::fprintf(stderr, "  %s\n", outcome.hit ? at_.words.hit : at_.words.missed);
    else
      std::fprintf(stderr, "%s\n", at_.study.design.task == TimingTask::tapping ? at_.words.enough : "");
    return TrialEnd::answered;
  }

  const TimedDesk& at_;
  TimedRun run_;
  Track track_;
  double looked_s_ = now_s(), latestWake_s_ = 0;
  std::size_t drawn_ = 0;  ///< beats
};

}  // namespace

void awaitDevice(StudyPlayer& player, RawTerminal& terminal, const ParticipantWords& words,
                 StudyTrouble trouble, const Cancelled& cancelled) {
  if (trouble == StudyTrouble::forceStopped) std::fprintf(stderr, "%s\n", words.rearm);
  while (player.troubleSinceAsked() != StudyTrouble::none && !cancelled()) {
    const char key = terminal.key(timedPoll_s).value_or('\0');
    if (key == 'a' || key == 'A') player.rearm();
    if (key == escapeKey) player.stopForce();
  }
}

Result<TrialEnd> askTimed(const TimedDesk& desk) { return TimedTrial(desk).ask(); }

}  // namespace detent::playback
