// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A finger's presses of one duration and lift as a function of their amplitude: a few are simulated, the
// others interpolated linearly.

#include <cstddef>
#include <optional>
#include <vector>

#include "playback/performance/press_plant.h"

namespace detent::playback {

/// One press, by its amplitude. Times in s from the command; for a press that does not activate, those of the
/// contact are 0.
struct ResponsePoint {
  double amplitude_N = 0;
  double peak_N = 0, impulse_Ns = 0, deepest_m = 0;
  double touch_s = 0, activation_s = 0, peak_s = 0, cycle_s = 0, held_s = 0, rapidHeld_s = 0;
  double doubled = 0, rapidDoubled = 0;  ///< 1: the contact closed more than once
};

/// Immutable; any thread.
class PressResponse {
 public:
  /// Empty if no amplitude up to mostAmplitude_N closes the contact.
  static std::optional<PressResponse> measure(const KeyTables& key, const ContactPoints& contact,
                                              const Finger& finger, double duration_s, double lift_s);

  /// The least amplitude that closes the contact, to 0.1 %.
  double least_N() const { return least_N_; }
  /// The least amplitude that reaches this depth; the largest simulated one if none does.
  double leastReaching_N(double depth_m) const;
  /// Interpolates between simulated presses, but never between one that activates and one that does not.
  /// Outside of them returns the nearest. `place`: 0 at first; keeps the position of the last amplitude for
  /// calls with increasing amplitudes.
  ResponsePoint at(double amplitude_N, std::size_t& place) const;

 private:
  std::vector<ResponsePoint> points_;  // by increasing amplitude, > 0
  double least_N_ = 0;
};

}  // namespace detent::playback
