// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button state as the simulated finger meets it: forces in tables of even steps, in metres, newtons and joules.

#include <vector>

#include "model/button.h"

namespace detent::playback {

/// Where the contact acts.
struct ContactPoints {
  double close_m = 0;  ///< going down
  double open_m = 0;   ///< going up, < close_m
};

/// Force of the button between its strokes: the mean of both has a potential, the rest is play (decision 1100) and can only
/// take energy. Immutable after its making; any thread.
class KeyTables {
 public:
  explicit KeyTables(const ButtonState& state);

  /// Mean of press and release, N; below 0 and beyond the end the stops are part of it.
  double mean_N(double depth_m) const;
  /// Energy stored since depth 0, J; the exact integral of mean_N.
  double stored_J(double depth_m) const;
  /// The constant force that does the work of mean_N between two depths.
  double meanBetween_N(double from_m, double to_m) const;
  /// Half the distance of press and release, N, >= 0.
  double halfWidth_N(double depth_m) const;
  /// The cap's own damper and the button's b(x), N·s/m.
  double damping_Ns_per_m(double depth_m) const;

 private:
  static constexpr int cells = 1024;
  struct Place {
    int cell = 0;
    double share = 0;
  };
  Place placeOf(double depth_m) const;
  double at(const std::vector<double>& values, double depth_m) const;

  double end_m_ = 0, cell_m_ = 0;
  std::vector<double> mean_N_, halfWidth_N_, damping_, stored_J_;
};

}  // namespace detent::playback
