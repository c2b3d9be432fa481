// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/rest_band.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

using namespace detent::playback;

namespace {

constexpr double rate_Hz = 1000, most_N = 0.2;

double sineAt(double time_s, double frequency_Hz) {
  return std::sin(2 * std::numbers::pi * frequency_Hz * time_s);
}

struct Passed {
  std::vector<double> in_N, out_N;
  double swing_N = 0;

  /// Range of the output between two times.
  double moved_N(double from_s, double to_s) const {
    double low = 1e9, high = -1e9;
    for (auto i = static_cast<std::size_t>(from_s * rate_Hz); i < static_cast<std::size_t>(to_s * rate_Hz);
         ++i) {
      low = std::min(low, out_N[i]);
      high = std::max(high, out_N[i]);
    }
    return high - low;
  }
};

template <class Force>
Passed pass(double seconds, Force force) {
  RestBand band;
  band.configure(most_N);
  Passed passed;
  for (int i = 0; i < static_cast<int>(seconds * rate_Hz); ++i) {
    passed.in_N.push_back(force(i / rate_Hz));
    passed.out_N.push_back(band.next(i / rate_Hz, passed.in_N.back()));
  }
  passed.swing_N = band.swing_N();
  return passed;
}

}  // namespace

TEST_CASE("rest band: what does not swing passes bit for bit, slow or fast") {
  const auto same = [](auto force) {
    const Passed passed = pass(6, force);
    return passed.in_N == passed.out_N;
  };
  CHECK(same([](double t) { return 0.05 * t; }));                   // a press of a minute
  CHECK(same([](double t) { return 0.6 + 0.5 * sineAt(t, 7); }));   // taps as fast as fingers go
  CHECK(same([](double t) { return 0.6 + 0.04 * sineAt(t, 1); }));  // a slow, deliberate movement to and fro
  CHECK(same([](double t) { return t < 3 ? 0.8 : 0.2; }));          // a step
  CHECK(same([](double t) { return 0.5 + 0.0004 * sineAt(t, 50); }));  // too small to matter
  CHECK(same([](double t) { return 1.2 * std::exp(-t) * (t < 5 ? 1 : 0.5); }));
}

TEST_CASE("rest band: a finger that swings little and fast stands still") {
  const double frequency_Hz = GENERATE(6.5, 9.0, 12.0, 50.0, 60.0, 150.0);
  const Passed passed = pass(4, [&](double t) { return 1 + 0.02 * sineAt(t, frequency_Hz); });
  INFO(frequency_Hz << " Hz");
  CHECK(passed.moved_N(0.4, 4) == 0);
  CHECK(passed.swing_N == Approx(0.04).epsilon(0.05));
}

TEST_CASE("rest band: a larger swing is movement") {
  const Passed passed = pass(4, [](double t) { return 1 + 0.11 * sineAt(t, 9); });
  CHECK(passed.in_N == passed.out_N);
}

TEST_CASE("rest band: a press or a release out of the swing passes at once, with nothing kept back") {
  const double sign = GENERATE(1, -1);
  const Passed passed =
      pass(2, [&](double t) { return 1 + 0.02 * sineAt(t, 9) + sign * (t < 1.5 ? 0 : 10 * (t - 1.5)); });
  for (std::size_t i = 1510; i < 1550; ++i) CHECK(passed.out_N[i] == passed.in_N[i]);
}

TEST_CASE("rest band: a slow press through hum goes one way only and gets there") {
  const Passed passed = pass(5, [](double t) { return 0.012 * sineAt(t, 50) + (t < 1 ? 0 : 0.1 * (t - 1)); });
  double furthest_N = 0, back_N = 0, reached_N = 0, late_N = 0;
  for (std::size_t i = 1000; i < passed.out_N.size(); ++i) {
    reached_N = std::max(reached_N, passed.in_N[i]);
    if (i >= 2000) late_N = std::max(late_N, reached_N - passed.out_N[i]);
    furthest_N = std::max(furthest_N, passed.out_N[i]);
    back_N = std::max(back_N, furthest_N - passed.out_N[i]);
  }
  CHECK(back_N < 0.02);  // the least hysteresis a program has
  CHECK(late_N < 1e-9);
  CHECK(passed.out_N.back() == Approx(0.4).margin(0.025));
}

TEST_CASE("rest band: a resting force that creeps away is followed") {
  const Passed passed = pass(20, [](double t) { return 1 + 0.02 * sineAt(t, 9) + 0.01 * t; });
  for (std::size_t i = 1000; i < passed.out_N.size(); ++i)
    REQUIRE(passed.out_N[i] == Approx(passed.in_N[i]).margin(0.085));
}

TEST_CASE("rest band: a swing that ends is forgotten") {
  const auto force = [](double t) {
    return t < 2 ? 1 + 0.02 * sineAt(t, 9) : 1 + 0.05 * std::max(0.0, t - 4);
  };
  const Passed passed = pass(6, force);
  CHECK(passed.swing_N == 0);
  for (std::size_t i = 4500; i < passed.out_N.size(); ++i) REQUIRE(passed.out_N[i] == passed.in_N[i]);
}

TEST_CASE("rest band: after a silence it begins anew; without a limit everything passes") {
  RestBand band;
  band.configure(most_N);
  for (int i = 0; i < 1000; ++i) band.next(i / rate_Hz, 1 + 0.02 * sineAt(i / rate_Hz, 9));
  CHECK(band.swing_N() > 0);
  band.startAnew();
  CHECK(band.swing_N() == 0);
  CHECK(band.next(1.5, 0.99) == 0.99);
  RestBand open;
  for (int i = 0; i < 1000; ++i) {
    const double reading_N = 1 + 0.02 * sineAt(i / rate_Hz, 9);
    REQUIRE(open.next(i / rate_Hz, reading_N) == reading_N);
  }
}
