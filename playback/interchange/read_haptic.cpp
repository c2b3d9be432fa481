// SPDX-License-Identifier: GPL-3.0-or-later
// Reads .haptic, version 1, of Lofelt and Meta. It is played as in their own conversion to AHAP
// (NiceVibrations): intensity is the square root of an amplitude, sharpness the square root of a frequency;
// during an emphasis the envelope is lowered and a transient is added.

#include <cmath>

#include "playback/interchange/reference_signal.h"
#include "playback/interchange/reference_waves.h"

namespace detent::playback {

namespace {

constexpr double ducked = 0.8;  // factor of the intensity during an emphasis

struct Breakpoint {
  double time_s = 0, value = 0;
};

/// Requires times that do not decrease and values within 0..1, like the format's own reader.
Breakpoint breakpointOf(const JsonPlace& entry, const char* value, const std::vector<Breakpoint>& before) {
  const Breakpoint point{entry.at("time").number(0, longestReference_s), entry.at(value).number(0, 1)};
  if (!before.empty() && point.time_s < before.back().time_s)
    entry.at("time").refuse(Message("this point lies before the previous one"),
                            Message("Sort the points by time"));
  return point;
}

double straight(const std::vector<Breakpoint>& points, std::size_t next, double time_s) {
  if (next == 0) return points.front().value;
  if (next == points.size()) return points.back().value;
  const Breakpoint &a = points[next - 1], &b = points[next];
  return b.time_s > a.time_s ? a.value + (b.value - a.value) * (time_s - a.time_s) / (b.time_s - a.time_s)
                             : b.value;
}

/// Both envelopes over a common list of times. A step (two points at one time) remains a step.
std::vector<WavePoint> merged(const std::vector<Breakpoint>& amplitudes,
                              const std::vector<Breakpoint>& frequencies) {
  std::vector<WavePoint> points;
  std::size_t a = 0, f = 0;
  while (a < amplitudes.size()) {
    const bool amplitudeNext = f == frequencies.size() || amplitudes[a].time_s <= frequencies[f].time_s;
    const double time_s = amplitudeNext ? amplitudes[a].time_s : frequencies[f].time_s;
    const double level = amplitudeNext ? amplitudes[a].value : straight(amplitudes, a, time_s);
    const bool together = amplitudeNext && f < frequencies.size() && frequencies[f].time_s == time_s;
    const double frequency = frequencies.empty()          ? 0
                             : !amplitudeNext || together ? frequencies[f].value
                                                          : straight(frequencies, f, time_s);
    // Nothing sounds before the envelope begins.
    if (amplitudeNext || a > 0) points.push_back({time_s, level, frequencyOf(frequency)});
    if (amplitudeNext) ++a;
    if (!amplitudeNext || together) ++f;
  }
  return points;
}

void refuseOtherVersions(const JsonPlace& version) {
  const double major = version.at("major").number(0, 1e9);
  if (major != 1)
    version.refuse(Message("the version is %1, but only version 1 of .haptic can be read", major),
                   Message("Export the file again as version 1"));
}

}  // namespace

ReferenceWaves hapticWaves(const JsonPlace& file) {
  refuseOtherVersions(file.at("version"));
  const JsonPlace envelopes = file.at("signals").at("continuous").at("envelopes");
  ReferenceWaves result;
  std::vector<Breakpoint> amplitudes, frequencies;
  for (const JsonPlace& entry : envelopes.at("amplitude").elements()) {
    Breakpoint point = breakpointOf(entry, "amplitude", amplitudes);
    if (entry.has("emphasis")) {
      const JsonPlace emphasis = entry.at("emphasis");
      const double amplitude = emphasis.at("amplitude").number(0, 1);
      const double frequency_Hz = frequencyOf(emphasis.at("frequency").number(0, 1));
      if (amplitude < point.value)
        emphasis.refuse(Message("the emphasis is weaker than the point that it emphasizes"),
                        Message("Give the emphasis at least the amplitude of this point"));
      result.waves.push_back(
          {{{point.time_s, amplitude, frequency_Hz}, {point.time_s + transient_s, 0, frequency_Hz}}});
      point.value *= ducked * ducked;
    }
    amplitudes.push_back(point);
  }
  if (amplitudes.empty())
    envelopes.at("amplitude").refuse(Message("the list holds no point"), Message("Give at least one point"));
  if (envelopes.has("frequency"))
    for (const JsonPlace& entry : envelopes.at("frequency").elements()) {
      // Linear between the square roots, like AHAP's curves.
      frequencies.push_back(breakpointOf(entry, "frequency", frequencies));
      frequencies.back().value = std::sqrt(frequencies.back().value);
    }
  result.events = amplitudes.size();
  result.waves.insert(result.waves.begin(), PlayedWave{merged(amplitudes, frequencies)});
  return result;
}

}  // namespace detent::playback
