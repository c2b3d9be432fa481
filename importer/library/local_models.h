// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A place on a stroke and its force, from the samples around it: several models of the window, each as likely
// as its evidence says (Burnham & Anderson 2002), with the errors of each and what they differ by
// (docs/develop/decisions/0813).

#include <optional>
#include <vector>

#include "model/stroke_curve.h"

namespace detent::importer {

/// A displacement and the force there, with the variances and the covariance of their errors.
struct LocalPlace {
  double displacement_mm = 0, force_N = 0;
  double variance_mm2 = 0, variance_N2 = 0, covariance_mmN = 0;
};

/// Samples side by side, in the order of their displacements.
struct LocalWindow {
  std::vector<CurvePoint> points;
  // Variances of the noise, up to a common factor:
  std::vector<double> own;  ///< of each reading's own, > 0
  double carried = 0;       ///< of what each reading carries on to the next by a share
  double share = 0;         ///< [0, 1)
};

/// The extremum of the window's models: a peak for a `sign` of 1, a valley for -1. nullopt if no model has
/// one, or if there are too few samples. Any thread.
std::optional<LocalPlace> extremumIn(const LocalWindow& window, double sign);

/// Start of a bottom-out, above a gentler slope; `near_mm`: its approximate displacement.
std::optional<LocalPlace> cornerIn(const LocalWindow& window, double near_mm);

/// The force at a displacement of the window, of which nothing is unknown.
std::optional<LocalPlace> forceAt(const LocalWindow& window, double displacement_mm);

/// Likewise at the window's first displacement, before a contact or not.
std::optional<LocalPlace> beginningOf(const LocalWindow& window);

}  // namespace detent::importer
