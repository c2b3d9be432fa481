// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A force graph: a press curve and optionally a release curve. Exists only if valid.

#include <optional>

#include "model/stroke_curve.h"

namespace detent {

/// Press and release of one button state. Rules (checked on construction, named in the Failure):
/// - the press curve starts at 0 mm or later, forces within ±maxForce_N, travel within (0, maxTravel_mm];
/// - the release curve overlaps the press curve's displacement range.
/// Crossing strokes are allowed, because real measurements cross; validate() in validation.h warns about
/// them. Immutable; any thread.
class ForceGraph {
 public:
  static constexpr double maxForce_N = 1e7;
  static constexpr double maxTravel_mm = 1e5;

  static Result<ForceGraph> fromCurves(StrokeCurve press, std::optional<StrokeCurve> release);

  const StrokeCurve& press() const { return press_; }
  const std::optional<StrokeCurve>& release() const { return release_; }
  /// Returns the curve of a stroke; the press curve if no release is known.
  const StrokeCurve& curve(Stroke stroke) const {
    return stroke == Stroke::release && release_ ? *release_ : press_;
  }

  /// Full travel: the largest displacement of the press curve.
  double travel_mm() const { return press_.end_mm(); }

  friend bool operator==(const ForceGraph&, const ForceGraph&) = default;

 private:
  ForceGraph(StrokeCurve press, std::optional<StrokeCurve> release)
      : press_(std::move(press)), release_(std::move(release)) {}
  StrokeCurve press_;
  std::optional<StrokeCurve> release_;
};

}  // namespace detent
