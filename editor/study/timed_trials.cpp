// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/timed_trials.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <QInputEvent>
#include <utility>

#include "editor/document/message_words.h"

namespace detent::editor {

namespace {

// longest delay until presses are handled; shorter than any screen's frame
constexpr int frame_ms = 4;
constexpr int padDown_ms = 80;  // duration for which a key is shown on the pad
/// Window systems count in ms, and the clocks of some tick only once per ms.
constexpr double stampStep_s = 0.002;
constexpr double oldestStamp_s = 0.2;  // an older stamp belongs to another clock

/// Age of an event by its stamp; empty if the stamp is not of the steady clock, with which X11 and Wayland
/// stamp input.
std::optional<double> ageOf(quint64 stamp_ms) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  const double now_ms = std::chrono::duration<double, std::milli>(now).count();
  constexpr double wrap_ms = 4294967296.0;  // X11 counts in 32 bits
  double age_ms = std::fmod(now_ms - (static_cast<double>(stamp_ms) + 0.5), wrap_ms);
  if (age_ms < -1) age_ms += wrap_ms;
  if (age_ms > 1000 * oldestStamp_s) return {};
  return std::max(0.0, age_ms / 1000);
}

}  // namespace

std::string TimedTrials::pressRoute() {
  return "key or pad: by the window system's own stamp, to 2 ms and as late as this machine wakes a program; "
         "without a stamp: when the window got it (press_within_s tells how late both may be); the "
         "keyboard's scan and the screen are not known";
}

TimedTrials::TimedTrials(const playback::Study& study, playback::StudyPlayer& player, TimingPage* page,
                         TimedWords words, QObject* parent)
    : QObject(parent),
      study_(study),
      player_(player),
      page_(page),
      words_(std::move(words)),
      began_s_(player.clock_s()),
      looked_s_(began_s_) {
  frame_.setTimerType(Qt::PreciseTimer);
  frame_.setInterval(frame_ms);
  connect(&frame_, &QTimer::timeout, this, &TimedTrials::poll);
  connect(page_, &TimingPage::pressed, this, &TimedTrials::press);
  if (page_->pad() != nullptr) page_->pad()->installEventFilter(this);
}

void TimedTrials::show(playback::ParticipantSession& session) {
  session_ = &session;
  away_ = false;
  stamp_ms_.reset();
  run_.emplace(study_, session, player_, began_s_);
  looked_s_ = player_.clock_s();
  if (!player_.sensed()) wakes_.emplace();
  frame_.start();
  draw();
}

void TimedTrials::leave() {
  frame_.stop();
  wakes_.reset();
  run_.reset();
  away_ = false;
}

void TimedTrials::note(const QInputEvent& event) { stamp_ms_ = event.timestamp(); }

bool TimedTrials::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick)
    note(static_cast<const QInputEvent&>(*event));
  return QObject::eventFilter(watched, event);
}

void TimedTrials::press() {
  const std::optional<quint64> stamp_ms = std::exchange(stamp_ms_, {});
  if (!run_ || !wakes_) return;
  const double now_s = player_.clock_s();
  const std::optional<double> age_s = stamp_ms ? ageOf(*stamp_ms) : std::nullopt;
  run_->pressed(now_s - age_s.value_or(0), age_s ? stampStep_s + wakes_->latest_s() : now_s - looked_s_);
  looked_s_ = now_s;
  QPushButton* const pad = page_->pad();
  if (pad == nullptr || pad->isDown()) return;
  pad->setDown(true);
  QTimer::singleShot(padDown_ms, pad, [pad] { pad->setDown(false); });
}

void TimedTrials::poll() {
  looked_s_ = player_.clock_s();
  if (away_) {
    if (player_.takeTrouble() != playback::StudyTrouble::none) return;
    leave();
    return emit back();
  }
  if (!run_) return;
  draw();
  const Result<playback::TimedOutcome> outcome = run_->update();
  if (!outcome) {
    leave();
    return emit failed(sentenceOf(outcome.failure()));
  }
  if (outcome->state != playback::TimedState::running) ended(*outcome);
}

void TimedTrials::draw() {
  const playback::TimingController& controller = run_->controller();
  const double now_s = player_.clock_s();
  TimingView view;
  view.task = study_.design.task;
  if (view.task == playback::TimingTask::cue) {
    view.beats = controller.beats_s().size();
    view.beatsCome =
        static_cast<std::size_t>(std::count_if(controller.beats_s().begin(), controller.beats_s().end(),
                                               [&](double at_s) { return at_s <= now_s; }));
  }
  if (view.task == playback::TimingTask::window) {
    view.way = controller.wayAt(now_s);
    view.windowShare = run_->trial().window_s / run_->trial().interval_s;
  }
  view.run_s = study_.design.run_s;
  if (view.task == playback::TimingTask::tapping) {
    view.left_s = controller.left_s(now_s);
    if (view.left_s < view.run_s) page_->showResult(QStringLiteral(" "));  // "Halt" was the run's before
  }
  if (view != page_->picture()->view()) page_->picture()->show(view);
}

void TimedTrials::ended(const playback::TimedOutcome& outcome) {
  run_.reset();
  page_->showTrouble({});
  switch (outcome.state) {
    case playback::TimedState::running:
      return;
    case playback::TimedState::lost:
      away_ = true;
      return emit away(outcome.trouble);
    case playback::TimedState::anew:
      page_->showTrouble(outcomeWords(outcome));
      page_->showResult(QStringLiteral(" "));
      return show(*session_);
    case playback::TimedState::kept:
      break;
  }
  frame_.stop();
  wakes_.reset();
  QString result = QStringLiteral(" ");
  if (study_.design.task == playback::TimingTask::window) result = outcome.hit ? words_.hit : words_.missed;
  if (study_.design.task == playback::TimingTask::tapping) result = words_.enough;
  page_->showResult(result);
  emit kept();
}

QString TimedTrials::outcomeWords(const playback::TimedOutcome& outcome) const {
  switch (outcome.fault) {
    case playback::TimingFault::none:
      return outcome.failure ? words_.notKept.arg(sentenceOf(*outcome.failure)) : QString();
    case playback::TimingFault::noPress:
      return words_.noPress;
    case playback::TimingFault::held:
      return words_.held;
    case playback::TimingFault::notFelt:
      break;
  }
  return words_.notFelt;
}

}  // namespace detent::editor
