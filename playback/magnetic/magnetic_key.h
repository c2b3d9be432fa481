// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A key of a magnetic keyboard as its firmware evaluates it: with fixed points, or with rapid trigger.

#include <optional>

namespace detent::playback {

/// Settings of one key. Displacements from rest.
struct MagneticKeySettings {
  double actuate_mm = 2, reset_mm = 1.8;  ///< the reset point lies above the actuation point
  /// rapid trigger: distance above the deepest point at which it opens, and below the highest at which it
  /// closes
  std::optional<double> rapid_mm;
  double scan_s = 0.001;  ///< > 0
};

/// One key, which receives its displacement once per scan. With rapid trigger it closes only below the
/// actuation point, and opens at the reset point at the latest.
class MagneticKey {
 public:
  explicit MagneticKey(const MagneticKeySettings& settings) : settings_(settings) {}

  /// Returns true if the key has just closed.
  bool follow(double displacement_mm);
  bool closed() const { return closed_; }

 private:
  bool shouldClose(double displacement_mm) const;
  bool shouldOpen(double displacement_mm) const;

  MagneticKeySettings settings_;
  bool closed_ = false;
  double turn_mm_ = -1e9;  ///< deepest since it closed, highest since it opened
};

}  // namespace detent::playback
