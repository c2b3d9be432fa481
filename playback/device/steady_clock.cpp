// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/steady_clock.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

namespace detent::playback {

double now_s() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC_RAW, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void sleepUntil(double time_s) {
  // Sleeping on the raw clock is not offered; a relative sleep a little short, then the rest.
  for (double left_s = time_s - now_s(); left_s > 0; left_s = time_s - now_s()) {
    timespec t{};
    t.tv_sec = static_cast<time_t>(left_s);
    t.tv_nsec = static_cast<long>((left_s - static_cast<double>(t.tv_sec)) * 1e9);
    clock_nanosleep(CLOCK_MONOTONIC, 0, &t, nullptr);
  }
}

bool requestRealtime(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

}  // namespace detent::playback
