// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Felt distance of two switches, by their curves, in units of the difference of two laboratories on one
// switch.

#include <limits>
#include <vector>

#include "importer/library/felt_shape.h"

namespace detent::importer {

/// Median distance between records of one switch from two laboratories, over the pairs of
/// docs/measurements/bench-library.md. Two records that are closer may be of one switch. `library_bench`
/// prints it.
inline constexpr double labNoise_gf = 3.2;

/// Two curves compared from a common point of contact on, over the middle of the displacements that both
/// have.
struct FeelDifference {
  double press_gf2 = 0, release_gf2 = 0;  ///< mean squares about the mean difference
  double slope_gf2_per_mm2 = 0;           ///< of the press, slopes held to +-60 gf/mm
  double level_gf = 0;                    ///< mean difference of both strokes
  double travel_mm = 0;                   ///< difference of the travels
  double shift_mm = 0;                    ///< of the second curve's contact against the first's
};

/// d^2 = press^2 + (release)^2 + (slope)^2 + (level)^2 + (travel)^2 + (shift)^2, each times its weight, at
/// the shift where d is least. The mean distance of release and press does not count, because laboratories
/// differ in it as much as switches do.
struct FeelWeights {
  double release = 1;     ///< gf per gf
  double slope_mm = 0.1;  ///< gf per gf/mm
  double level = 1.1;     ///< gf per gf
  double travel_gf_per_mm = 15;
  double shift_gf_per_mm = 10;
};

/// Compares one switch with many: keeps what does not depend on the other switch.
class FeelDistance {
 public:
  explicit FeelDistance(const FeltShape& wanted, const FeelWeights& weights = {});
  /// >= 0, in units of lab noise; 0 to itself. May return infinity for a shape that is farther than `atMost`.
  double to(const FeltShape& other, double atMost_labNoise = std::numeric_limits<double>::infinity()) const;
  /// Lower bound of the distance to any shape of this travel, in units of lab noise.
  double leastTo(double travel_mm) const;
  /// One difference for each shift of the contact, within 8 % of the wanted travel. Shifts are left out if
  /// some terms alone are farther than `atMost_gf`.
  std::vector<FeelDifference> differencesTo(const FeltShape& other,
                                            double atMost_gf = std::numeric_limits<double>::infinity()) const;

 private:
  double travel_mm_, step_mm_;
  std::vector<double> press_gf_, release_gf_;
  FeelWeights weights_;
};

/// Distance in gf at the shift where it is least; infinite without shifts.
double distance_gf(const std::vector<FeelDifference>& byShift, const FeelWeights& weights);

}  // namespace detent::importer
