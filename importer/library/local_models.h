// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Estimates a place on a stroke and its force from the samples around it. Several models of the window are
// weighted by their evidence (Burnham & Anderson 2002); the error includes the difference between the models
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
  std::vector<double> own;  ///< of the independent part of each reading, > 0
  double carried = 0;       ///< of the part that each reading passes on to the next, multiplied by `share`
  double share = 0;         ///< [0, 1)
};

/// The extremum of the window's models: a peak for a `sign` of 1, a valley for -1. nullopt if no model has
/// one, or if there are too few samples. Any thread.
std::optional<LocalPlace> extremumIn(const LocalWindow& window, double sign);

/// Start of a bottom-out, above a gentler slope; `near_mm`: its approximate displacement.
std::optional<LocalPlace> cornerIn(const LocalWindow& window, double near_mm);

/// The force at a given displacement of the window; its displacement has no error.
std::optional<LocalPlace> forceAt(const LocalWindow& window, double displacement_mm);

/// The same at the window's first displacement, whether or not the switch is touched there.
std::optional<LocalPlace> beginningOf(const LocalWindow& window);

}  // namespace detent::importer
