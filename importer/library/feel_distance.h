// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Felt distance of two switches, by their curves, in units of the difference of two laboratories on one
// switch.

#include <limits>
#include <vector>

#include "importer/library/felt_shape.h"

namespace detent::importer {

/// Median distance between the records of one switch in two laboratories, over the pairs of
/// docs/measurements/bench-library.md. Below it nobody can say that two records are of different switches.
/// `library_bench` prints it.
inline constexpr double labNoise_gf = 3.2;

/// Two curves laid on one another with one place of contact, over the middle of the displacements both have.
struct FeelDifference {
  double press_gf2 = 0, release_gf2 = 0;  ///< mean squares about the mean difference
  double slope_gf2_per_mm2 = 0;           ///< of the press, slopes held to +-60 gf/mm
  double level_gf = 0;                    ///< mean difference of both strokes
  double travel_mm = 0;                   ///< difference of the travels
  double shift_mm = 0;                    ///< of the second curve's contact against the first's
};

/// d^2 = press^2 + (release)^2 + (slope)^2 + (level)^2 + (travel)^2 + (shift)^2, each times its weight, at
/// the shift where d is least. By how much the release lies below the press does not count: laboratories
/// differ by that as much as switches do.
struct FeelWeights {
  double release = 1;     ///< gf per gf
  double slope_mm = 0.1;  ///< gf per gf/mm
  double level = 1.1;     ///< gf per gf
  double travel_gf_per_mm = 15;
  double shift_gf_per_mm = 10;
};

/// One side of many comparisons: what does not depend on the other.
class FeelDistance {
 public:
  explicit FeelDistance(const FeltShape& wanted, const FeelWeights& weights = {});
  /// >= 0, in units of lab noise; 0 to itself. What is farther than `atMost` is infinitely far where that is
  /// found out early.
  double to(const FeltShape& other, double atMost_labNoise = std::numeric_limits<double>::infinity()) const;
  /// Lower bound of the distance to any shape of this travel, in units of lab noise.
  double leastTo(double travel_mm) const;
  /// One for every shift of the contact, within 8 % of the wanted travel, but for shifts of which some terms
  /// alone are farther than `atMost_gf`.
  std::vector<FeelDifference> differencesTo(const FeltShape& other,
                                            double atMost_gf = std::numeric_limits<double>::infinity()) const;

 private:
  double travel_mm_, step_mm_;
  std::vector<double> press_gf_, release_gf_;
  FeelWeights weights_;
};

/// Distance at the shift where it is least, in gf; of no shift infinite.
double distance_gf(const std::vector<FeelDifference>& byShift, const FeelWeights& weights);

}  // namespace detent::importer
