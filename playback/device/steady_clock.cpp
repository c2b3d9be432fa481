// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/steady_clock.h"

#include <cmath>

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <time.h>

namespace detent::playback {

double now_s() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC_RAW, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// The system cannot sleep on the raw clock, so the time is converted to CLOCK_MONOTONIC. It is given as an
// absolute time, so that a thread that is interrupted before it sleeps does not wake late. If it is
// interrupted between reading the two clocks, it wakes early and sleeps again.
void sleepUntil(double time_s) {
  for (;;) {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    const double left_s = time_s - now_s();
    if (left_s <= 0) return;
    constexpr long perSecond = 1000000000;
    t.tv_sec += static_cast<time_t>(left_s);
    t.tv_nsec += static_cast<long>((left_s - std::floor(left_s)) * perSecond);
    if (t.tv_nsec >= perSecond) t.tv_nsec -= perSecond, ++t.tv_sec;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
  }
}

void requestPunctualWakeUp() { prctl(PR_SET_TIMERSLACK, 1UL); }

RealtimeWhile::RealtimeWhile(int priority) {
  sched_param before{};
  if (pthread_getschedparam(pthread_self(), &policyBefore_, &before) != 0) return;
  priorityBefore_ = before.sched_priority;
  granted_ = requestRealtime(priority);
}

RealtimeWhile::~RealtimeWhile() {
  sched_param before{};
  before.sched_priority = priorityBefore_;
  if (granted_) pthread_setschedparam(pthread_self(), policyBefore_, &before);
}

bool requestRealtime(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

}  // namespace detent::playback
