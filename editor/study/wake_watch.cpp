// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/wake_watch.h"

#include <algorithm>
#include <chrono>

namespace detent::editor {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double every_s = 0.001;

double now_s() { return Seconds(Clock::now().time_since_epoch()).count(); }

}  // namespace

WakeWatch::WakeWatch() : due_s_(now_s() + every_s), thread_([this] { run(); }) {}

WakeWatch::~WakeWatch() {
  ending_ = true;
  thread_.join();
}

double WakeWatch::latest_s() const {
  // read first: when a due wake-up has happened, its lateness is stored before this value changes
  const double due_s = due_s_;
  return std::max(latest_s_.load(), now_s() - due_s);
}

void WakeWatch::run() {
  while (!ending_) {
    std::this_thread::sleep_for(Seconds(due_s_ - now_s()));
    const double woken_s = now_s();
    latest_s_ = std::max(latest_s_.load(), woken_s - due_s_);
    due_s_ = woken_s + every_s;
  }
}

}  // namespace detent::editor
