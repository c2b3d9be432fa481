// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A key of a magnetic keyboard as firmware keeps it: fixed points, or rapid trigger.

#include <optional>

namespace detent::playback {

/// Settings of one key. Displacements from rest.
struct MagneticKeySettings {
  double actuate_mm = 2, reset_mm = 1.8;  ///< reset below actuate
  std::optional<double>
      rapid_mm;  ///< rapid trigger: opens so far above the deepest place, closes so far below the highest
  double scan_s = 0.001;  ///< > 0
};

/// One key, which gets its displacement once per scan. With rapid trigger it closes below the actuation point
/// only, and opens at the reset point at the latest.
class MagneticKey {
 public:
  explicit MagneticKey(const MagneticKeySettings& settings) : settings_(settings) {}

  /// True where the key has just closed.
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
