// SPDX-License-Identifier: GPL-3.0-or-later
// A finger that rests feels nothing: held at every 0.05 N, with the hum of the mains, with tremor and with
// the sensor's noise. Rendered by detent-play as a program.

#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/cli/run_program.h"
#include "tests/playback/plant/finger.h"
#include "tests/playback/plant/transport.h"

using namespace detent::test;

namespace {

constexpr double rise_s = 0.2, settle_s = 0.4, hold_s = 1.6;  // one level: up, until quiet, held

struct Disturbance {
  double hum_N =
      0;  ///< amplitude at the mains' frequency; of its harmonics 2, 3 and 5 a third, a fifth and a tenth
  double tremorShare = 0;  ///< amplitude at 9 Hz, of the force
  double noise_N = 0;      ///< SD, uncorrelated
  double mains_Hz = 50;
  double sensor_Hz = 1000;
};

double gaussian(Chance& chance) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += chance.between(0, 1);
  return sum;
}

/// Up in steps of 0.05 N, each held; disturbed from the middle of its settling on.
double humShare(double mainsTurns) {
  return std::sin(mainsTurns) + std::sin(2 * mainsTurns + 1) / 3 + std::sin(3 * mainsTurns + 2) / 5 +
         std::sin(5 * mainsTurns + 3) / 10;
}

std::string staircase(double highest_N, const Disturbance& disturbance) {
  std::ostringstream csv;
  csv << "time_s,force_N\n";
  Chance chance(91);
  const double level_s = rise_s + settle_s + hold_s;
  const int levels = static_cast<int>(std::lround(highest_N / 0.05));
  for (int k = 0; k / disturbance.sensor_Hz < level_s * levels; ++k) {
    const double time_s = k / disturbance.sensor_Hz, within_s = std::fmod(time_s, level_s);
    const double level = std::floor(time_s / level_s);
    const double force_N = 0.05 * (level + eased(within_s, 0, rise_s));
    const double share = eased(within_s, rise_s, 0.1) - eased(within_s, level_s - 0.05, 0.05);
    const double turns = 2 * std::numbers::pi * time_s;
    const double off_N = disturbance.hum_N * humShare(disturbance.mains_Hz * turns) +
                         disturbance.tremorShare * force_N * std::sin(9 * turns) +
                         disturbance.noise_N * gaussian(chance);
    char row[64];
    std::snprintf(row, sizeof row, "%.6f,%.6f\n", time_s, std::max(0.0, force_N + share * off_N));
    csv << row;
  }
  return csv.str();
}

struct Rest {
  int events = 0;     ///< events while a level was held
  std::string first;  ///< of them
  double held_s = 0;
};

Rest restOn(const std::string& button, const Disturbance& disturbance) {
  constexpr double highest_N = 1.2;
  const detent::tests::ProgramFolder folder("plant_rest");
  folder.write("press.csv", staircase(highest_N, disturbance));
  const detent::tests::ProgramResult result =
      folder.run(DETENT_PLAY, {"render", DETENT_SOURCE_DIR "/samples/buttons/" + button + ".button.json",
                               "--press", "press.csv", "-o", "press.wav", "--events", "events.csv"});
  INFO(result.err);
  REQUIRE(result.exitCode == 0);
  Rest rest;
  std::istringstream rows(folder.read("events.csv"));
  std::string row;
  std::getline(rows, row);
  const double level_s = rise_s + settle_s + hold_s;
  while (std::getline(rows, row)) {
    const double within_s = std::fmod(std::stod(row), level_s);
    if (within_s < rise_s + settle_s || within_s > level_s - 0.06) continue;
    if (rest.events++ == 0) rest.first = row;
  }
  rest.held_s = (hold_s - 0.06) * highest_N / 0.05;
  return rest;
}

void expectSilence(const Disturbance& disturbance) {
  for (const char* button : {"A", "B", "C", "D", "E", "F"}) {
    const Rest rest = restOn(button, disturbance);
    INFO(button << ": " << rest.events << " events in " << rest.held_s << " s; first: " << rest.first);
    CHECK(rest.events == 0);
  }
}

}  // namespace

TEST_CASE("held still at every 0.05 N: no event", "[rest]") { expectSilence({}); }

TEST_CASE("held with a sensor's noise of 3 mN, at 1 and at 10 kHz: no event", "[rest]") {
  expectSilence({0, 0, 0.003});
  expectSilence({0, 0, 0.003, 50, 10000});
}

TEST_CASE("held with a mains hum of 12 mN and its harmonics: no event", "[rest]") {
  expectSilence({0.012, 0, 0.001, 50});
  expectSilence({0.012, 0, 0.001, 60});
  expectSilence({0.012, 0, 0.001, 50, 125});
}

TEST_CASE("held with a tremor of 2 % at 9 Hz: no event", "[rest]") { expectSilence({0, 0.02, 0.001}); }

TEST_CASE("held with hum, tremor and noise together, by sensors of 425 Hz to 10 kHz: no event", "[rest]") {
  const double sensor_Hz = GENERATE(425.0, 1000.0, 3200.0, 10000.0);
  INFO(sensor_Hz << " readings a second");
  expectSilence({0.012, 0.02, 0.003, 50, sensor_Hz});
}
