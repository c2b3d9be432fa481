// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Records of presses whose k(x), b(x) and mass are known.

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "playback/identification/force_record.h"

namespace detent::test {

struct PressedRecord {
  std::vector<double> presses_s{
      0.1};              ///< one after the other, each with its own time; rests of 50 to 100 ms between
  double travel_mm = 4;  ///< and up to one step more
  std::function<double(double)> k = [](double) { return 0.3; };    ///< N/mm, of the place in mm
  std::function<double(double)> b = [](double) { return 0.003; };  ///< N·s/mm
  double offset_N = 0.2, mass_kg = 0;
  double friction_N = 0;  ///< Coulomb's, whole from a thousandth of a mm/s on
  double step_mm = 0.01, noise_N = 0.01, period_s = 0.001;
  double tremor_mm = 0;  ///< amplitude of each of two tremors of a finger, at 8.7 and 11.3 Hz
};

inline playback::ForceRecord recordOf(const PressedRecord& p, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<> noise_N(0, p.noise_N);
  // Positions of the encoder's steps, from the rest and from the bottom: no travel is a whole number of
  // steps.
  std::uniform_real_distribution<> step_mm(0, p.step_mm);
  const double shift_mm = step_mm(random), travel_mm = p.travel_mm + step_mm(random);
  const auto minimumJerk = [](double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return s * s * s * (10 + s * (6 * s - 15));
  };
  playback::ForceRecord record;
  double start_s = 0;
  for (const double press_s : p.presses_s) {
    const auto place_mm = [&](double t) {
      constexpr double turn = 2 * 3.14159265358979;
      const double tremor =
          std::sin(turn * 8.7 * (start_s + t)) + std::sin(turn * 11.3 * (start_s + t) + 1.0);
      return travel_mm * (minimumJerk((t - 0.05) / press_s) - minimumJerk((t - 0.1 - press_s) / press_s)) +
             p.tremor_mm * tremor;
    };
    for (double t = 0; t < 2 * press_s + 0.2; t += p.period_s) {
      constexpr double h = 1e-5;
      const double x = place_mm(t), v = (place_mm(t + h) - place_mm(t - h)) / (2 * h),
                   a = (place_mm(t + h) - 2 * x + place_mm(t - h)) / (h * h);
      record.time_s.push_back(start_s + t);
      record.displacement_mm.push_back(std::round((x + shift_mm) / p.step_mm) * p.step_mm - shift_mm);
      record.force_N.push_back(p.offset_N + p.k(x) * x + p.b(x) * v +
                               p.friction_N * std::clamp(1000 * v, -1.0, 1.0) + p.mass_kg * a / 1000 +
                               noise_N(random));
    }
    start_s = record.time_s.back() + p.period_s;
  }
  return record;
}

}  // namespace detent::test
