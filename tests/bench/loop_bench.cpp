// SPDX-License-Identifier: GPL-3.0-or-later
// detent_loop_bench [ROUNDS]: how punctual a loop of 1 kHz is by the ways there are to wait, in turns of two
// seconds each, so that what else the machine does meets all alike. Figures:
// docs/measurements/bench-force.md, docs/develop/decisions/1106-force-loop-timing.md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>

#include "playback/device/force_loop.h"
#include "playback/device/steady_clock.h"
#include "tests/playback/force/force_run.h"
#include "tests/playback/force/sample_files.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

constexpr double period_s = 0.001, turn_s = 2;
constexpr int loopPriority = 70;

using Wait = void (*)(double due_s);

void sleepFor(double left_s) {
  timespec t{};
  t.tv_nsec = static_cast<long>(std::clamp(left_s, 0.0, 0.9) * 1e9);
  clock_nanosleep(CLOCK_MONOTONIC, 0, &t, nullptr);
}
void byLength(double due_s) {
  for (double left_s = due_s - now_s(); left_s > 0; left_s = due_s - now_s()) sleepFor(left_s);
}
template <int early_us>
void sleepThenSpin(double due_s) {
  sleepUntil(due_s - early_us * 1e-6);
  while (now_s() < due_s) {
  }
}

struct Lateness {
  std::vector<double> late_s;
  double cpu_s = 0, elapsed_s = 0;
  bool realtime = false;
};

double threadCpu_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void bareTurn(Wait wait, bool punctual, bool realtime, Lateness& out) {
  std::thread([&] {
    prctl(PR_SET_TIMERSLACK, punctual ? 1UL : 50000UL);
    if (realtime) out.realtime = requestRealtime(loopPriority);
    const double begin_s = now_s(), cpu_s = threadCpu_s();
    double due_s = begin_s;
    while (due_s < begin_s + turn_s) {
      wait(due_s);
      out.late_s.push_back(std::max(0.0, now_s() - due_s));
      due_s = std::max(due_s, now_s() - period_s) + period_s;
    }
    out.cpu_s += threadCpu_s() - cpu_s;
    out.elapsed_s += now_s() - begin_s;
  }).join();
}

struct OwnLoop {
  std::uint64_t steps = 0, within = 0;
  double worst_s = 0, sum_s = 0;
  bool realtime = false;
};

void ownTurn(OwnLoop& own) {
  const ForceDeviceProfile profile = simulatedDevice();
  const PreparedForce prepared = forceOf(sampleButton("B"), profile);
  ForceLoop loop(std::make_unique<SimulatedForceDevice>(simulationOf(profile, prepared),
                                                        SimulatedFinger({}, FingerPresses{})),
                 prepared.program, {true, static_cast<std::int64_t>(turn_s / period_s)});
  while (!loop.status().finished) sleepUntil(now_s() + 0.02);
  const DeadlineCounts d = loop.status().deadlines;
  own.steps += d.steps;
  own.within += d.within100us;
  own.worst_s = std::max(own.worst_s, d.worst_s);
  own.sum_s += d.mean_s * static_cast<double>(d.steps);
  own.realtime = d.realtime;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  const struct {
    const char* name;
    Wait wait;
    bool punctual, realtime;
  } ways[] = {{"by length, slack 50 us", byLength, false, false},
              {"by length, real-time", byLength, false, true},
              {"until a time, slack 50 us", sleepUntil, false, false},
              {"until a time, slack 1 ns", sleepUntil, true, false},
              {"until a time, slack 1 ns, real-time", sleepUntil, true, true},
              {"the same, 30 us early, then spinning", sleepThenSpin<30>, true, true},
              {"the same, 200 us early, then spinning", sleepThenSpin<200>, true, true}};
  std::vector<Lateness> found(std::size(ways));
  OwnLoop own;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < found.size(); ++i)
      bareTurn(ways[i].wait, ways[i].punctual, ways[i].realtime, found[i]);
    ownTurn(own);
  }
  std::printf(
      "| waiting, %d turns of 2 s | within 100 us %% | mean us | 99.9 %% us | worst us | of a processor %% "
      "|\n",
      rounds);
  std::printf("|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::vector<double>& late_s = found[i].late_s;
    std::sort(late_s.begin(), late_s.end());
    double sum_s = 0;
    for (const double s : late_s) sum_s += s;
    const auto within = std::upper_bound(late_s.begin(), late_s.end(), 100e-6) - late_s.begin();
    const double n = static_cast<double>(late_s.size());
    std::printf("| bare: %s%s | %.3f | %.1f | %.0f | %.0f | %.1f |\n", ways[i].name,
                ways[i].realtime && !found[i].realtime ? " (refused)" : "",
                100 * static_cast<double>(within) / n, 1e6 * sum_s / n,
                1e6 * late_s[static_cast<std::size_t>(0.999 * (n - 1))], 1e6 * late_s.back(),
                100 * found[i].cpu_s / found[i].elapsed_s);
  }
  std::printf("| Detent's loop, simulated device%s | %.3f | %.1f | | %.0f | |\n",
              own.realtime ? "" : " (no real-time)",
              100 * static_cast<double>(own.within) / static_cast<double>(own.steps),
              1e6 * own.sum_s / static_cast<double>(own.steps), 1e6 * own.worst_s);
  return 0;
}
