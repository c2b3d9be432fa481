// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/force_loop.h"

#include <algorithm>
#include <utility>

#include "playback/device/round_trips.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double punctual_s = 100e-6;
// A sleeping thread wakes some tens of microseconds late. So it asks to be woken that much earlier and waits
// actively for the rest: at most 3 % of a processor (docs/develop/decisions/1106-force-loop-timing.md).
constexpr double longestAwake_s = 30e-6, awakeOfPeriod = 0.03;
constexpr std::size_t keptRows = 1 << 16;  // a minute at 1 kHz
// A missing answer in a step that itself began this late is not counted as the device's fault.
constexpr double lateShare = 0.25;
constexpr double queuePause_s = 0.0005;
constexpr double longestGap = 4;  // periods; a longer pause is a stall
constexpr int longestFade_steps =
    4000;  // longer than any fade of the force; also ends the loop of a device that never answers

}  // namespace

ForceLoop::ForceLoop(std::unique_ptr<ForceDevice> device, const ForceProgram& program,
                     const ForceLoopSettings& settings)
    : settings_(settings),
      device_(std::move(device)),
      program_(std::make_unique<ForceProgram>(program)),
      engine_(*program_),
      rows_(keptRows),
      programs_(4),
      retired_(8),
      thread_([this] { run(); }) {}

ForceLoop::~ForceLoop() {
  abandoned_ = true;
  stopping_ = true;
  thread_.join();
}

void ForceLoop::setProgram(const ForceProgram& program) {
  std::unique_ptr<ForceProgram> used;
  while (retired_.try_dequeue(used)) used.reset();
  programs_.enqueue(std::make_unique<ForceProgram>(program));
}

void ForceLoop::takeProgram() {
  std::unique_ptr<ForceProgram> next;
  if (!programs_.try_dequeue(next)) return;
  std::swap(program_, next);
  engine_.setProgram(*program_);
  device_->setProgram(*program_);
  retired_.try_enqueue(std::move(next));  // the other thread frees it
}

void ForceLoop::awaitProgram() {
  while (!stopping_ && programs_.peek() == nullptr) sleepUntil(now_s() + queuePause_s);
}

void ForceLoop::hold(bool held) { heldUntil_s_ = held ? now_s() + holdLasts_s : 0; }

void ForceLoop::takeOrders() {
  if (settings_.holdToRun) engine_.setHeld(now_s() < heldUntil_s_);
  if (rearming_.exchange(false)) {
    device_->rearm();
    engine_.rearm();
  }
  // after the arming, so that the stop wins if both were requested
  if (emergency_.exchange(false)) engine_.emergencyStop();
}

bool ForceLoop::isStall(double pause_s) const {
  return settings_.paced && pause_s > std::max(program_->limits.stall_s, longestGap * program_->period_s);
}

void ForceLoop::step() {
  requested_s_ = now_s();
  // The device has removed the force during the pause, so it must increase from zero again.
  if (exchanged_s_ > 0 && isStall(requested_s_ - exchanged_s_)) command_.force_N = 0;
  ForceReading reading = device_->exchange(command_);
  if (settings_.paced) {
    const double before_s = std::exchange(exchanged_s_, now_s());
    // The handle may have moved while a delayed loop took no readings.
    if (before_s > 0) reading.periods = std::max(1.0, (exchanged_s_ - before_s) / program_->period_s);
  }
  // An answer that waited while this program stood still shows the position before the pause.
  if (isStall(exchanged_s_ - requested_s_)) reading.fresh = false;
  if (settings_.paced && !reading.fresh)
    ++(late_s_ > lateShare * program_->period_s ? deadlines_.computerLate : deadlines_.deviceLate);
  command_ = engine_.step(reading);
}

ForceLoopStatus ForceLoop::status() const {
  const std::lock_guard lock(statusMutex_);
  return published_;
}

void ForceLoop::takeSteps(std::vector<ForceStep>& steps) {
  ForceStep step;
  while (rows_.try_dequeue(step)) steps.push_back(step);
}

void ForceLoop::publish(bool finished) {
  std::unique_lock lock(statusMutex_, std::defer_lock);
  if (finished) {
    lock.lock();
  } else if (!lock.try_lock()) {
    return;
  }
  published_.last = engine_.last();
  published_.deadlines = deadlines_;
  published_.guard = engine_.counts();
  published_.link = device_->counts();
  published_.lowestBalance_mJ = engine_.lowestBalance_mJ();
  published_.droppedRows = dropped_;
  published_.device = device_->state();
  published_.halt = engine_.halt();
  published_.finished = finished;
}

void ForceLoop::keep(ForceStep step, bool wait) {
  if (settings_.paced) {
    step.time_s = exchanged_s_;
    step.requested_s = requested_s_;
  }
  while (!rows_.try_enqueue(step)) {
    if (!wait || abandoned_) {
      ++dropped_;
      return;
    }
    sleepUntil(now_s() + queuePause_s);
  }
}

void ForceLoop::waitFor(double due_s) {
  sleepUntil(due_s - std::min(longestAwake_s, awakeOfPeriod * program_->period_s));
  while (now_s() < due_s) {
  }
  const double late_s = late_s_ = std::max(0.0, now_s() - due_s);
  ++deadlines_.steps;
  deadlines_.within100us += late_s <= punctual_s ? 1 : 0;
  deadlines_.missed += late_s >= program_->period_s ? 1 : 0;
  deadlines_.worst_s = std::max(deadlines_.worst_s, late_s);
  deadlines_.mean_s += (late_s - deadlines_.mean_s) / static_cast<double>(deadlines_.steps);
}

void ForceLoop::run() {
  if (settings_.paced) {
    requestPunctualWakeUp();
    deadlines_.realtime = requestRealtime(forcePriority);
  }
  double due_s = now_s();
  for (std::int64_t i = 0; !stopping_ && (settings_.steps == 0 || i < settings_.steps); ++i) {
    if (settings_.paced) {
      waitFor(due_s);
      // After a stall the loop continues from now, without catching up.
      due_s = std::max(due_s, now_s() - program_->period_s) + program_->period_s;
    }
    if (!settings_.paced && i > 0 && i == settings_.waitsAfter_steps) awaitProgram();
    takeProgram();
    takeOrders();
    step();
    keep(engine_.last(), !settings_.paced);
    publish(false);
  }
  engine_.stop();
  for (int i = 0; i < longestFade_steps && !engine_.silent(); ++i) {
    if (settings_.paced) sleepUntil(due_s += program_->period_s);
    step();
  }
  // Sent last: no force from here on, whatever law the device runs and whoever stopped the loop.
  ForceCommand nothing;
  nothing.halted = true;
  device_->exchange(nothing);
  publish(true);
}

}  // namespace detent::playback
