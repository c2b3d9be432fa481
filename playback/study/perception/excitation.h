// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Excitation of a fingertip by a vibration: two channels, in steps of 1.25 ms, in dB above their thresholds.
// docs/reference/predicted-confusion.md has the sources of every number.

#include <array>
#include <cstddef>
#include <vector>

namespace detent::playback {

/// The channels of the fingertip that follow vibration: [0] RA (Meissner), best at about 40 Hz; [1] P
/// (Pacinian), best at about 250 Hz.
inline constexpr std::size_t channelCount = 2;

inline constexpr double perceptionRate_Hz = 8000;  ///< sample rate of the samples
inline constexpr double frame_s = 0.00125;

/// Levels over time. Silence and everything below the threshold is 0 dB.
struct Excitation {
  /// One row per frame of frame_s; [channel], dB above the channel's threshold, >= 0.
  std::vector<std::array<double, channelCount>> level_dB;

  double duration_s() const { return frame_s * static_cast<double>(level_dB.size()); }
};

/// Level of a just noticeable sine at the channel's best frequency, below full scale.
struct ThresholdSettings {
  double rapidlyAdapting_dB = -42;
  double pacinian_dB = -45;  ///< MPEG's reference model: -45 dB at 250 Hz
};

/// `samples` at perceptionRate_Hz, full scale 1; they are taken as the acceleration of the surface.
Excitation excitationOf(const std::vector<float>& samples, const ThresholdSettings& thresholds = {});

struct MaskingSettings {
  /// dB by which the threshold rises per dB of a masker just before (1 dB per 5 dB); [0, 1]
  double slope = 0.2;
  double backwardShare = 0.5;  ///< share of `slope` for a masker that follows; [0, 1]
  std::array<double, channelCount> decay_s{0.100, 0.040};
};

/// Excitation after temporal masking: each channel's threshold rises before and after a strong vibration, and
/// decays exponentially. Channels do not mask each other.
Excitation masked(const Excitation& excitation, const MaskingSettings& settings = {});

}  // namespace detent::playback
