// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_conditioner.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace detent::playback;

TEST_CASE("conditioner: what cannot be a reading is rejected and counted") {
  ForceConditioner c;
  CHECK(c.judge(0.000, 0.1) == ConditionerVerdict::resume);
  CHECK(c.judge(0.002, std::nan("")) == ConditionerVerdict::reject);
  CHECK(c.judge(0.002, INFINITY) == ConditionerVerdict::reject);
  CHECK(c.judge(0.002, 1000) == ConditionerVerdict::reject);
  CHECK(c.judge(0.002, -5) == ConditionerVerdict::reject);
  CHECK(c.judge(0.002, 0.2) == ConditionerVerdict::accept);
  CHECK(c.judge(0.001, 0.2) == ConditionerVerdict::reject);  // out of order
  CHECK(c.judge(0.002, 0.2) == ConditionerVerdict::reject);  // twice the same time
  CHECK(c.counts().notFinite == 2);
  CHECK(c.counts().outOfRange == 2);
  CHECK(c.counts().outOfOrder == 2);
  CHECK(c.counts().accepted == 2);
}

TEST_CASE("conditioner: a single spike is a glitch, a confirmed step is a press") {
  ForceConditioner c;
  c.judge(0, 0.1);
  CHECK(c.judge(1 / 425.0, 25) == ConditionerVerdict::reject);
  CHECK(c.judge(2 / 425.0, 0.1) == ConditionerVerdict::accept);
  CHECK(c.counts().glitches == 1);
  CHECK(c.judge(3 / 425.0, 20) == ConditionerVerdict::reject);
  CHECK(c.judge(4 / 425.0, 20.5) == ConditionerVerdict::accept);
  CHECK(c.counts().glitches == 1);
  // A press faster than one reading of 425 Hz is no glitch.
  ForceConditioner fast;
  fast.judge(0, 0);
  CHECK(fast.judge(1 / 425.0, 8) == ConditionerVerdict::accept);
}

TEST_CASE("conditioner: silence and a stuck sensor are seen, and a return starts anew") {
  ForceConditioner c;
  CHECK(c.silent(0));
  for (int i = 0; i < 5000; ++i) c.judge(i / 425.0, 0.7);
  CHECK(c.stuck());
  CHECK_FALSE(c.silent(5000 / 425.0));
  CHECK(c.silent(5000 / 425.0 + 1));
  CHECK(c.judge(100, 0.3) == ConditionerVerdict::resume);
  CHECK(c.counts().gaps == 1);
  CHECK_FALSE(c.stuck());
  for (int i = 0; i < 5000; ++i) c.judge(101 + i / 425.0, 0.0);  // an untouched sensor is not stuck
  CHECK_FALSE(c.stuck());
}

TEST_CASE("conditioner: after one time far ahead it hears again within a tenth of a second") {
  ForceConditioner conditioner;
  std::size_t lost = 0;
  for (int i = 0; i < 1000; ++i) {
    const double time_s = i / 425.0 + (i == 500 ? 0.4 : 0);
    if (conditioner.judge(time_s, 0.5) == ConditionerVerdict::reject) ++lost;
  }
  CHECK(lost < 42);  // of 425 readings per second
  CHECK(conditioner.counts().wrongTimes == 1);
}

TEST_CASE("conditioner: once it rests through noise at 10 kHz, a finger that stands moves no more") {
  ConditionerSettings settings;
  settings.mostNoise = 0.2;
  ForceConditioner conditioner(settings);
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 0.003);
  int reading = 0, moved = 0;
  for (int level = 0; level < 100; ++level) {
    for (int i = 0; i < 15000; ++i) {
      const double share = std::min(i / 2000.0, 1.0), before_N = conditioner.value();
      const double force_N = 0.05 * (level + share * share * share * (10 + share * (6 * share - 15)));
      conditioner.judge(++reading / 10000.0, force_N + noise(random));
      if (i >= 6000 && conditioner.value() != before_N) ++moved;
    }
  }
  CHECK(moved == 0);
}
