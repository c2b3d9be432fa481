// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/played_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace detent::playback {

namespace {

constexpr double briefest_s =
    1e-9;  // closer points are a step, because a rise within 1e-320 s would be infinite

double valueAt(WaveShape shape, double cycles) {
  const double share = cycles - std::floor(cycles);
  switch (shape) {
    case WaveShape::sine:
      break;
    case WaveShape::square:
      return share < 0.5 ? 1 : -1;
    case WaveShape::triangle:
      return share < 0.25 ? 4 * share : share < 0.75 ? 2 - 4 * share : 4 * share - 4;
    case WaveShape::sawtoothUp:
      return share < 0.5 ? 2 * share : 2 * share - 2;
    case WaveShape::sawtoothDown:
      return share < 0.5 ? -2 * share : 2 - 2 * share;
    case WaveShape::constant:
      return 1;
  }
  return std::sin(2 * std::numbers::pi * cycles);
}

/// Adds the samples from one point to the next, excluding the end; returns the phase reached, in cycles.
double addSegment(std::vector<double>& samples, const WavePoint& from, const WavePoint& to, WaveShape shape,
                  double phase, double sampleRate_Hz) {
  const double lasts_s = to.time_s - from.time_s;
  if (!(lasts_s > briefest_s)) return phase;
  const double rise = (to.frequency_Hz - from.frequency_Hz) / lasts_s;
  const auto phaseAfter = [&](double t) { return phase + t * (from.frequency_Hz + rise * t / 2); };
  // A time that is a whole sample except for rounding is treated as whole.
  const auto frameAt = [&](double time_s) { return std::ceil(std::fmax(0, time_s * sampleRate_Hz - 1e-6)); };
  const double end = std::fmin(frameAt(to.time_s), static_cast<double>(samples.size()));
  for (double frame = frameAt(from.time_s); frame < end; ++frame) {
    const double t = frame / sampleRate_Hz - from.time_s;
    const double amplitude = from.amplitude + (to.amplitude - from.amplitude) * t / lasts_s;
    samples[static_cast<std::size_t>(frame)] += amplitude * valueAt(shape, phaseAfter(t));
  }
  return phaseAfter(lasts_s);
}

}  // namespace

void addTo(std::vector<double>& samples, const std::vector<PlayedWave>& waves, double sampleRate_Hz) {
  for (const PlayedWave& wave : waves) {
    double phase = wave.phase_cycles;
    for (std::size_t i = 1; i < wave.points.size(); ++i)
      phase = addSegment(samples, wave.points[i - 1], wave.points[i], wave.shape, phase, sampleRate_Hz);
  }
}

}  // namespace detent::playback
