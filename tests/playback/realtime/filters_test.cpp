// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/realtime/biquad.h"
#include "playback/realtime/limiter.h"
#include "playback/realtime/rain_noise.h"
#include "playback/realtime/sine.h"

using namespace detent::playback;

TEST_CASE("sine: within 1e-12 of the true sine over a cycle") {
  for (int i = 0; i <= 10000; ++i) {
    const double phase = i / 10000.0;
    CHECK(std::fabs(sineOfCycles(phase) - std::sin(2 * M_PI * phase)) < 1e-12);
  }
}

TEST_CASE("low-pass: -3 dB at 150 Hz at every rate; what it would do to the bursts") {
  for (double rate : {8000.0, 48000.0, 192000.0}) {
    for (unsigned order : {1u, 2u}) {
      const BiquadCoefficients c = lowPass(rate, 150, order);
      CHECK(20 * std::log10(magnitude(c, rate, 150)) == Approx(-3.01).margin(0.01));
      CHECK(magnitude(c, rate, 1) == Approx(1).margin(1e-3));
    }
  }
  // The figures of docs/develop/decisions/0900: on the whole chain it would take these off the bursts.
  const auto dB = [](unsigned order, double f) {
    return 20 * std::log10(magnitude(lowPass(48000, 150, order), 48000, f));
  };
  CHECK(dB(1, 200) == Approx(-4.4).margin(0.1));
  CHECK(dB(1, 390) == Approx(-8.9).margin(0.1));
  CHECK(dB(2, 200) == Approx(-6.2).margin(0.1));
  CHECK(dB(2, 390) == Approx(-16.7).margin(0.1));
  CHECK(dB(2, 410) == Approx(-17.6).margin(0.1));
}

TEST_CASE("biquad: after silence its state is exactly zero") {
  Biquad filter;
  filter.setCoefficients(lowPass(192000, 150, 2));
  std::vector<double> x(1000, 0.9);
  filter.process(x.data(), x.size());
  CHECK_FALSE(filter.silent());
  for (int i = 0; i < 200; ++i) {
    std::fill(x.begin(), x.end(), 0);
    filter.process(x.data(), x.size());
  }
  CHECK(filter.silent());
}

TEST_CASE("peaking: gain at its centre, none far away, identity beyond the rate") {
  const BiquadCoefficients c = peaking(48000, 390, 5, -12);
  CHECK(20 * std::log10(magnitude(c, 48000, 390)) == Approx(-12).margin(1e-6));
  CHECK(20 * std::log10(magnitude(c, 48000, 20)) == Approx(0).margin(0.05));
  CHECK(magnitude(peaking(8000, 3700, 5, -12), 8000, 1000) == 1);
}

TEST_CASE("limiter: never beyond the ceiling, transparent below it, silence for what is no number") {
  Limiter limiter;
  limiter.configure(0.9, 2400);
  std::vector<double> in;
  for (int i = 0; i < 5000; ++i) in.push_back(std::sin(i * 0.05) * (i > 1000 && i < 2000 ? 30 : 0.8));
  in[3000] = std::nan("");
  in[3001] = INFINITY;
  in[3002] = 1e300;
  std::vector<float> out(in.size());
  limiter.process(in.data(), out.data(), in.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    REQUIRE(std::fabs(out[i]) <= 0.9f);
    if (i < 1000) CHECK(out[i] == static_cast<float>(in[i]));
  }
  CHECK(out[3000] == 0);
  CHECK(out[3001] == 0);
  std::vector<double> quiet(4000, 0.5);
  std::vector<float> after(quiet.size());
  limiter.process(quiet.data(), after.data(), quiet.size());
  CHECK(after.back() == 0.5f);
  CHECK(limiter.idle());
}

TEST_CASE("rain: the requested level at every rate, rises slowly, covers the sound of a transducer") {
  for (const double rate : {8000.0, 44100.0, 48000.0, 192000.0}) {
    RainNoise rain(0.1);
    rain.setSampleRate(rate);
    std::vector<float> out(static_cast<std::size_t>(6 * rate));
    rain.render(out.data(), out.size());
    double early = 0, squares = 0, mean = 0, middle = 0, count = 0;
    Biquad above, below;
    above.setCoefficients(highPass(rate, 100));
    below.setCoefficients(lowPass(rate, 1000, 2));
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double v = static_cast<double>(out[i]);
      REQUIRE(std::fabs(v) <= 1);
      if (static_cast<double>(i) < 0.05 * rate) early = std::fmax(early, std::fabs(v));
      double band = v;
      above.process(&band, 1);
      below.process(&band, 1);
      if (static_cast<double>(i) < 1.5 * rate) continue;
      squares += v * v;
      middle += band * band;
      mean += v;
      ++count;
    }
    INFO(rate << " Hz");
    CHECK(std::sqrt(squares / count) == Approx(0.1).epsilon(0.1));
    CHECK(std::fabs(mean / count) < 1e-3);
    CHECK(early < 0.03);
    CHECK(middle > 0.2 * squares);
  }
  RainNoise none(0);
  CHECK_FALSE(none.audible());
}
