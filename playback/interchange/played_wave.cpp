// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/played_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace detent::playback {

namespace {

/// From one point to the next, the end left out; gives the phase reached, in cycles.
double addSegment(std::vector<double>& samples, const WavePoint& from, const WavePoint& to, double phase,
                  double sampleRate_Hz) {
  const double lasts_s = to.time_s - from.time_s;
  if (!(lasts_s > 0)) return phase;
  const double rise = (to.frequency_Hz - from.frequency_Hz) / lasts_s;
  const auto phaseAfter = [&](double t) { return phase + t * (from.frequency_Hz + rise * t / 2); };
  // Times that are whole samples but for rounding stay whole.
  const auto frameAt = [&](double time_s) { return std::ceil(std::fmax(0, time_s * sampleRate_Hz - 1e-6)); };
  const double end = std::fmin(frameAt(to.time_s), static_cast<double>(samples.size()));
  for (double frame = frameAt(from.time_s); frame < end; ++frame) {
    const double t = frame / sampleRate_Hz - from.time_s;
    const double amplitude = from.amplitude + (to.amplitude - from.amplitude) * t / lasts_s;
    samples[static_cast<std::size_t>(frame)] += amplitude * std::sin(2 * std::numbers::pi * phaseAfter(t));
  }
  return phaseAfter(lasts_s);
}

}  // namespace

void addTo(std::vector<double>& samples, const std::vector<PlayedWave>& waves, double sampleRate_Hz) {
  for (const PlayedWave& wave : waves) {
    double phase = wave.phase_cycles;
    for (std::size_t i = 1; i < wave.points.size(); ++i)
      phase = addSegment(samples, wave.points[i - 1], wave.points[i], phase, sampleRate_Hz);
  }
}

}  // namespace detent::playback
