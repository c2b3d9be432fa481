// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/spectrogram.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace detent::playback;

namespace {

std::vector<float> sine(double rate_Hz, double frequency_Hz, double amplitude, double duration_s) {
  std::vector<float> samples(static_cast<std::size_t>(rate_Hz * duration_s));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] =
        static_cast<float>(amplitude * std::sin(2 * M_PI * frequency_Hz * static_cast<double>(i) / rate_Hz));
  return samples;
}

std::size_t strongestRow(const Spectrogram& s, std::size_t column) {
  std::size_t best = 0;
  for (std::size_t row = 0; row < s.rows; ++row)
    if (s.at(column, row) > s.at(column, best)) best = row;
  return best;
}

std::size_t columnAt(const Spectrogram& s, double time_s) {
  return static_cast<std::size_t>(std::lround(time_s / s.hop_s));
}

}  // namespace

TEST_CASE("spectrogram: a sine stands at its frequency and level, at every sample rate") {
  const double rate_Hz = GENERATE(8000, 44100, 48000, 192000);
  const double frequency_Hz = GENERATE(150, 390, 970);
  const Spectrogram s = spectrogramOf(sine(rate_Hz, frequency_Hz, 0.5, 0.5), rate_Hz);
  REQUIRE(s.columns > 300);
  CHECK(static_cast<double>(s.rows - 1) * s.row_Hz == Approx(1000).margin(s.row_Hz));
  const std::size_t middle = columnAt(s, 0.25);
  const std::size_t row = strongestRow(s, middle);
  CHECK(static_cast<double>(row) * s.row_Hz == Approx(frequency_Hz).margin(s.row_Hz));
  CHECK(static_cast<double>(s.at(middle, row)) == Approx(-6.02).margin(0.25));  // between two bins
  for (std::size_t r = 0; r < s.rows; ++r) {
    if (std::fabs(static_cast<double>(r) * s.row_Hz - frequency_Hz) < 200) continue;
    CHECK(s.at(middle, r) < -56);
  }
}

TEST_CASE("spectrogram: a chirp's ridge follows its frequency") {
  const double rate_Hz = 48000, duration_s = 0.8;
  std::vector<float> samples(static_cast<std::size_t>(rate_Hz * duration_s));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / rate_Hz;
    samples[i] = static_cast<float>(std::sin(2 * M_PI * (100 * t + 0.5 * 1000 * t * t)));  // 1000 Hz/s
  }
  const Spectrogram s = spectrogramOf(samples, rate_Hz);
  for (double t = 0.1; t < 0.7; t += 0.05) {
    const std::size_t column = columnAt(s, t);
    const double expected_Hz = 100 + 1000 * static_cast<double>(column) * s.hop_s;
    CHECK(static_cast<double>(strongestRow(s, column)) * s.row_Hz == Approx(expected_Hz).margin(15));
  }
}

TEST_CASE("spectrogram: the three tones of a button are distinguished") {
  std::vector<float> samples = sine(48000, 150, 0.3, 0.5);
  const std::vector<float> second = sine(48000, 390, 0.3, 0.5);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += second[i];
  const Spectrogram s = spectrogramOf(samples, 48000);
  const auto level = [&](double f) {
    return s.at(columnAt(s, 0.25), static_cast<std::size_t>(std::lround(f / s.row_Hz)));
  };
  CHECK(level(150) > level(270) + 30);
  CHECK(level(390) > level(270) + 30);
}

TEST_CASE("spectrogram: a burst stands at its time, what is too high does not come back as an alias") {
  std::vector<float> samples(24000, 0);
  const std::vector<float> burst = sine(48000, 390, 1, 0.01);
  std::copy(burst.begin(), burst.end(), samples.begin() + 9600);
  const Spectrogram s = spectrogramOf(samples, 48000);
  const auto row = static_cast<std::size_t>(std::lround(390 / s.row_Hz));
  std::size_t best = 0;
  for (std::size_t c = 0; c < s.columns; ++c)
    if (s.at(c, row) > s.at(best, row)) best = c;
  CHECK(static_cast<double>(best) * s.hop_s == Approx(0.205).margin(0.002));

  for (const double high_Hz : {1900.0, 2500.0, 4000.0, 9000.0}) {
    const Spectrogram aliased = spectrogramOf(sine(48000, high_Hz, 1, 0.3), 48000);
    const std::size_t column = columnAt(aliased, 0.15);
    CHECK(aliased.at(column, strongestRow(aliased, column)) < -70);
  }
}

TEST_CASE("spectrogram: nothing, one sample and silence") {
  CHECK(spectrogramOf({}, 48000).columns == 0);
  const Spectrogram one = spectrogramOf({0.5F}, 48000);
  CHECK(one.columns == 1);
  CHECK(one.level_dB.size() == one.rows);
  const Spectrogram silence = spectrogramOf(std::vector<float>(4800, 0), 48000);
  CHECK(*std::max_element(silence.level_dB.begin(), silence.level_dB.end()) == lowestLevel_dB);
}
