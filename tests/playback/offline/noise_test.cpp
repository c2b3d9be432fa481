// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor's noise under a still finger and under presses, on every sample button:
// docs/develop/decisions/0906.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <random>

#include <catch2/catch.hpp>

#include "model/file/button_file.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/prepare_program.h"
#include "playback/realtime/stroke_tracker.h"

using namespace detent;
using namespace detent::playback;

namespace {

constexpr double sensor_Hz = 425;

std::vector<std::pair<std::string, HapticProgram>> sampleButtons() {
  std::vector<std::pair<std::string, HapticProgram>> programs;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(DETENT_SOURCE_DIR) + "/samples/buttons")) {
    if (entry.path().extension() != ".json") continue;
    const Result<Button> button = readButtonFile(entry.path());
    REQUIRE(button);
    programs.emplace_back(entry.path().stem().string(), prepareProgram(*button, {}, {})->program);
  }
  std::sort(programs.begin(), programs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return programs;
}

struct Felt {
  std::size_t grains = 0, pressJumps = 0, releaseJumps = 0, bottomOuts = 0, events = 0;
};

/// Felt events of readings with noise, from `since_s` on.
template <class Force>
Felt feel(const HapticProgram& program, double seconds, double since_s, double noise_N, std::uint64_t seed,
          Force force) {
  PressTrace trace;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, noise_N);
  const auto count = static_cast<std::size_t>(seconds * sensor_Hz);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / sensor_Hz;
    trace.readings.push_back({t, force(t) + noise(random)});
  }
  ConditionerCounts counts;
  StrokeTracker tracker;
  tracker.use(&program);
  Felt felt;
  for (const EngineInput& input : conditionedInputs(trace, program, 1, 0, counts)) {
    const Crossings& crossings = tracker.updateForce(input.value);
    if (input.time_frames < since_s) continue;
    for (std::size_t i = 0; i < crossings.count; ++i) {
      const CrossingKind kind = crossings.items[i].kind;
      ++felt.events;
      felt.grains += kind == CrossingKind::grain ? 1 : 0;
      felt.pressJumps += kind == CrossingKind::pressJump ? 1 : 0;
      felt.releaseJumps += kind == CrossingKind::releaseJump ? 1 : 0;
      felt.bottomOuts += kind == CrossingKind::bottomOut ? 1 : 0;
    }
  }
  return felt;
}

constexpr double begin_s = 0.5;  // time before the first touch of the sensor

double minimumJerk(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

}  // namespace

TEST_CASE("noise: a finger held still for a minute feels nothing, anywhere on any sample button") {
  constexpr double reach_s = 0.3, settle_s = 1.0, hold_s = 60;
  std::size_t holds = 0, restless = 0;
  for (const auto& [name, program] : sampleButtons()) {
    const double highest_N = 1.2 * strongestForce_N(program);
    for (double sd_N : {0.012, 0.02, 0.04}) {
      for (double held_N = 0.05; held_N < highest_N; held_N += 0.05) {
        const Felt felt = feel(
            program, begin_s + reach_s + settle_s + hold_s, begin_s + reach_s + settle_s, sd_N, 17 + holds,
            [held_N = held_N](double t) { return held_N * minimumJerk((t - begin_s) / reach_s); });
        ++holds;
        restless += felt.events > 0 ? 1 : 0;
        INFO(name << ", " << held_N << " N, noise " << sd_N << " N: " << felt.events << " events");
        CHECK(felt.pressJumps + felt.releaseJumps + felt.bottomOuts == 0);
        CHECK(felt.events == 0);
      }
    }
  }
  std::cout << holds << " holds of a minute, " << restless << " of them felt anything\n";
  CHECK(restless == 0);
}

TEST_CASE("noise: slow and fast presses feel each jump and the bottom-out exactly once") {
  std::uint64_t seed = 1;
  std::size_t wrong = 0;
  for (const auto& [name, program] : sampleButtons()) {
    const double peak_N = 1.3 * strongestForce_N(program);
    const StateProgram& state = program.states[0];
    for (double sd_N : {0.012, 0.02, 0.04}) {
      for (double press_s : {0.06, 0.12, 0.5, 2.0, 5.0}) {
        for (int repeat = 0; repeat < 10; ++repeat) {
          const Felt felt = feel(program, begin_s + 2 * press_s + 0.7, 0, sd_N, seed++, [&](double t) {
            const double since = t - begin_s;
            return since < press_s + 0.1 ? peak_N * minimumJerk(since / press_s)
                                         : peak_N * (1 - minimumJerk((since - press_s - 0.1) / press_s));
          });
          INFO(name << ", " << press_s << " s, noise " << sd_N << " N, seed " << seed - 1);
          CHECK(felt.pressJumps == state.press.jumpCount);
          CHECK(felt.releaseJumps == state.release.jumpCount);
          CHECK(felt.bottomOuts == (state.hasBottomOut ? 1U : 0U));
          wrong += felt.pressJumps != state.press.jumpCount || felt.releaseJumps != state.release.jumpCount ||
                           felt.bottomOuts != (state.hasBottomOut ? 1U : 0U)
                       ? 1
                       : 0;
        }
      }
    }
  }
  std::cout << seed - 1 << " noisy presses, " << wrong
            << " of them with a jump or bottom-out too many or too few\n";
}
