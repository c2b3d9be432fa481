// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke's samples beside the curve that was fitted to them: what the meter's noise and steps are, and the
// windows of samples around a place.

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
  }  ///< every reading is one step on: neighbours share what is rounded off their places
  const CurvePoint& first() const { return points_.front(); }
  const CurvePoint& last() const { return points_.back(); }

  /// Area by trapezia, from one displacement to another.
  double area_mJ(double from_mm, double to_mm) const;
  double areaVariance() const;
  /// Growth of the area per mm that the travel ends later: if the readings are evenly spaced, an error of the
  /// end is spread over the way.
  double areaPerEnd_N() const;

  /// Samples around an extremum (`sign` 1: a peak, -1: a valley), down to `depth_N` from it, between two
  /// displacements.
  LocalWindow around(double displacement_mm, double sign, double depth_N, double from_mm, double to_mm) const;
  LocalWindow between(double from_mm, double to_mm) const;
  /// Window from the first sample to where the force leaves it by more than noise, at most up to `to_mm`.
  LocalWindow atStart(double to_mm) const;

 private:
  void weighNoise();
  LocalWindow window(std::size_t from, std::size_t to) const;  ///< [from, to)

  const StrokeCurve& curve_;
  std::vector<CurvePoint> points_;
  double step_mm_ = 0, noise_N_ = 0;
  double carried_N2_ = 0,
         share_ = 0;     ///< of the noise, what a reading carries on to the next, and by what share
  double together_ = 1;  ///< how many readings share one error
  bool even_ = false;
};

}  // namespace detent::importer
