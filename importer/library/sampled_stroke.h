// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke's samples together with the fitted curve: estimates the meter's noise and step size, and selects
// the samples around a place.

#include <vector>

#include "importer/library/local_models.h"
#include "model/stroke_curve.h"

namespace detent::importer {

class SampledStroke {
 public:
  /// `points`: of the stroke, in the order travelled, at least two.
  SampledStroke(const StrokeCurve& curve, const std::vector<CurvePoint>& points);

  double step_mm() const { return step_mm_; }  ///< median distance of neighbours
  double noise_N() const { return noise_N_; }  ///< standard deviation of a reading
  bool isEven() const {
    return even_;
    /// the displacement advances by one step with every reading, so neighbouring readings share one rounding
    /// error
  }
  const CurvePoint& first() const { return points_.front(); }
  const CurvePoint& last() const { return points_.back(); }

  /// Area by trapezia, from one displacement to another.
  double area_mJ(double from_mm, double to_mm) const;
  double areaVariance() const;
  /// Change of the area per mm by which the end of the travel moves. If readings are evenly spaced, an error
  /// of the end stretches all displacements.
  double areaPerEnd_N() const;

  /// Samples around an extremum (`sign` 1: a peak, -1: a valley) whose force differs from it by at most
  /// `depth_N`, between two displacements.
  LocalWindow around(double displacement_mm, double sign, double depth_N, double from_mm, double to_mm) const;
  LocalWindow between(double from_mm, double to_mm) const;
  /// Window from the first sample to where the force departs from the first force by more than noise, at most
  /// up to `to_mm`.
  LocalWindow atStart(double to_mm) const;

 private:
  void weighNoise();
  LocalWindow window(std::size_t from, std::size_t to) const;  ///< [from, to)

  const StrokeCurve& curve_;
  std::vector<CurvePoint> points_;
  double step_mm_ = 0, noise_N_ = 0;
  /// Variance of the part of the noise that a reading passes on to the next, and the share it passes on.
  double carried_N2_ = 0, share_ = 0;
  double together_ = 1;  ///< how many readings share one error
  bool even_ = false;
};

}  // namespace detent::importer
