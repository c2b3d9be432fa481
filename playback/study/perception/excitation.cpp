// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/excitation.h"

#include <algorithm>
#include <cmath>

#include "playback/realtime/felt_meter.h"

namespace detent::playback {

namespace {

constexpr std::array<double, channelCount> best_Hz{40, pacinianBest_Hz};
constexpr std::array<double, channelCount> bandQ{0.7, pacinianQ};
constexpr double smoothing_s = 0.004;
constexpr double unmaskable_dB = 1;  // a masker this faint masks nothing

/// Mean power of a channel's band in each frame; a sine of amplitude 1 has power 1.
std::vector<double> powersOf(const std::vector<float>& samples, std::size_t channel) {
  std::vector<double> band(samples.begin(), samples.end());
  for (std::size_t s = 0; s < pacinianSections; ++s) {
    Biquad section;
    section.setCoefficients(bandPass(perceptionRate_Hz, best_Hz[channel], bandQ[channel]));
    section.process(band.data(), band.size());
  }
  constexpr auto perFrame = static_cast<std::size_t>(frame_s * perceptionRate_Hz);
  const double keep = std::exp(-1 / (smoothing_s * perceptionRate_Hz));
  std::vector<double> powers;
  double smooth = 0, sum = 0;
  for (std::size_t i = 0; i < band.size(); ++i) {
    smooth = keep * smooth + (1 - keep) * 2 * band[i] * band[i];
    sum += smooth;
    if ((i + 1) % perFrame != 0) continue;
    powers.push_back(sum / static_cast<double>(perFrame));
    sum = 0;
  }
  return powers;
}

}  // namespace

Excitation excitationOf(const std::vector<float>& samples, const ThresholdSettings& thresholds) {
  const std::array<double, channelCount> threshold_dB{thresholds.rapidlyAdapting_dB, thresholds.pacinian_dB};
  Excitation excitation;
  for (std::size_t c = 0; c < channelCount; ++c) {
    const std::vector<double> powers = powersOf(samples, c);
    excitation.level_dB.resize(powers.size());
    for (std::size_t i = 0; i < powers.size(); ++i) {
      const double level_dB = powers[i] > 0 ? 10 * std::log10(powers[i]) - threshold_dB[c] : 0;
      excitation.level_dB[i][c] = std::max(level_dB, 0.0);
    }
  }
  return excitation;
}

Excitation masked(const Excitation& excitation, const MaskingSettings& settings) {
  const auto& in = excitation.level_dB;
  Excitation out = excitation;
  for (std::size_t c = 0; c < channelCount; ++c) {
    const double keep = std::exp(-frame_s / settings.decay_s[c]);
    std::vector<double> hidden(in.size(), 0);
    double forward = 0, backward = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
      hidden[i] = std::max(hidden[i], forward);
      forward = std::max(forward * keep, settings.slope * std::max(in[i][c] - unmaskable_dB, 0.0));
    }
    for (std::size_t i = in.size(); i-- > 0;) {
      hidden[i] = std::max(hidden[i], backward);
      backward = std::max(backward * keep,
                          settings.slope * settings.backwardShare * std::max(in[i][c] - unmaskable_dB, 0.0));
    }
    for (std::size_t i = 0; i < in.size(); ++i) {
      // A level clearly above the masked threshold keeps its loudness; a level near it is reduced
      // (recruitment).
      const double above = in[i][c] - hidden[i];
      out.level_dB[i][c] = above <= 0 ? 0 : std::min(in[i][c], 2 * above);
    }
  }
  return out;
}

}  // namespace detent::playback
