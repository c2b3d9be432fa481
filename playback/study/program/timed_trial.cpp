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
constexpr double look_s = 0.01;         // a sensor's presses are timed by themselves; this is for the picture
constexpr double feelWithin_s = 1;      // a key's finger presses meanwhile
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
      : at_(at),
        trial_(*at.session.trial()),
        shown_s_(now_s()),
        desk_(at.study, trial_, at.began_s, shown_s_),
        track_(trial_) {}

  Result<TrialEnd> ask() {
    at_.player.beginTrial();
    at_.player.place(0, trial_.choices[0], trial_.mode);
    at_.player.troubleSinceAsked();
    sound();
    while (!desk_.over(now_s())) {
      if (at_.cancelled()) return TrialEnd::paused;
      if (const StudyTrouble trouble = at_.player.troubleSinceAsked(); trouble != StudyTrouble::none)
        return again(nameOf(trouble), filled(at_.words.interrupted, {nameOf(trouble)}));
      draw();
      if (const std::optional<TrialEnd> left = look()) return *left;
    }
    // The finger of a key is still on its way.
    const double until_s = now_s() + feelWithin_s;
    while (desk_.fault() == TimingFault::notFelt && now_s() < until_s)
      if (const std::optional<TrialEnd> left = look()) return *left;
    return finish();
  }

 private:
  bool window() const { return at_.study.design.task == TimingTask::window; }

  /// The whole count-in as one piece: its beats are even to the sample.
  void sound() {
    if (at_.study.design.task != TimingTask::cue) return;
    std::vector<double> delays_s;
    const double from_s = now_s();
    for (const double beat_s : desk_.beats_s()) delays_s.push_back(std::max(0.0, beat_s - from_s));
    at_.player.soundBeats(delays_s);
  }

  void draw() {
    if (window()) return track_.draw(desk_.wayAt(now_s()));
    for (; drawn_ < desk_.beats_s().size() && desk_.beats_s()[drawn_] <= now_s(); ++drawn_)
      std::fprintf(stderr, "  %s", drawn_ + 1 < desk_.beats_s().size() ? "." : "O");
  }

  /// Until the next thing to draw, at most.
  double wait_s() const {
    const double at_s = now_s();
    double wait_s = look_s;
    if (drawn_ < desk_.beats_s().size()) wait_s = std::min(wait_s, desk_.beats_s()[drawn_] - at_s);
    return std::max(wait_s, 0.0);
  }

  /// Waits for a key and takes what the finger did.
  std::optional<TrialEnd> look() {
    const double wait = wait_s(), from_s = now_s();
    const std::optional<char> key = at_.terminal.key(wait);
    const double at_s = now_s();
    // A key that was waited for is as late as this thread is woken; one that was there already came since the look before.
    if (!key) latestWake_s_ = std::max(latestWake_s_, at_s - from_s - wait);
    const double within_s = at_s - from_s > blocked_s ? latestWake_s_ : at_s - looked_s_;
    looked_s_ = at_s;
    desk_.felt(at_.player.takeFelt());
    if (at_.player.sensed()) {
      for (const ContactClosing& c : at_.player.takeClosings())
        if (c.time_s >= shown_s_) desk_.pressed(c.time_s, c.within_s);
    } else if (key == ' ') {
      desk_.pressed(at_s, within_s);
      at_.player.press(0, trial_.choices[0], trial_.mode);
    }
    if (!key) return {};
    if (*key == 'p' || *key == 'P' || *key == 4) return TrialEnd::paused;  // Ctrl-D
    if (*key == 'q' || *key == 'Q') return TrialEnd::stopping;
    return {};
  }

  Result<TrialEnd> again(const std::string& reason, const std::string& said) {
    if (Result<Done> ok = at_.session.interrupted(reason); !ok) return ok.failure();
    std::fprintf(stderr, "\n%s\n", said.c_str());
    while (at_.player.troubleSinceAsked() != StudyTrouble::none && !at_.cancelled())
      sleepUntil(now_s() + look_s);
    return TrialEnd::again;
  }

  Result<TrialEnd> finish() {
    switch (const TimingFault fault = desk_.fault()) {
      case TimingFault::none:
        break;
      case TimingFault::noPress:
        return again(nameOf(fault), at_.words.noPress);
      case TimingFault::held:
        return again(nameOf(fault), at_.words.held);
      case TimingFault::notFelt:
        return again(nameOf(fault), at_.words.notFelt);
    }
    const Answer answer = desk_.answer(now_s());
    if (window()) {
      const double press_s = *countedPress(trial_, answer.presses_s);
      const bool hit = press_s >= 0 && press_s < trial_.window_s;
      std::fprintf(stderr, "  %s\n", hit ? at_.words.hit : at_.words.missed);
    } else {
      std::fprintf(stderr, "%s\n", at_.study.design.task == TimingTask::tapping ? at_.words.enough : "");
    }
    if (Result<Done> kept = at_.session.record(answer); !kept)
      return again("not kept", filled(at_.words.interrupted, {kept.failure().sentence()}));
    return TrialEnd::answered;
  }

  const TimedDesk& at_;
  const Trial trial_;  // the session's goes on with it
  const double shown_s_;
  TimingDesk desk_;
  Track track_;
  double looked_s_ = shown_s_, latestWake_s_ = 0;
  std::size_t drawn_ = 0;  ///< beats
};

}  // namespace

Result<TrialEnd> askTimed(const TimedDesk& desk) { return TimedTrial(desk).ask(); }

}  // namespace detent::playback
