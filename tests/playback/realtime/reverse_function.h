// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The reference of stroke_tracker_oracle_test.cpp: the reverse function, force -> displacement, written a
// second time and by another way than playback/realtime/stroke_tracker.h. It uses the curve's monotone
// stretches where the tracker follows the vertices of a table, knows neither time nor crossings, and is slow
// and plain.

#include <vector>

#include "model/force_graph.h"

namespace detent::test {

/// Follows a force signal along a graph. With x the present displacement:
/// - press: x becomes the nearest displacement at or beyond x where the press curve carries the force;
/// - release: x becomes the nearest displacement at or before x where the release curve is no stronger than
///   the force;
/// so x never goes backwards within one stroke, rests at a tactile point as long as its force is not exceeded
/// and then passes the whole jump at once, stays put on a vertical rise, and waits between the two curves
/// after a turn (hysteresis). The stroke changes when force has turned back from its extreme since the last
/// change by more than the hysteresis. Outside a curve its nearest end's force counts. Forces must be finite.
class ReverseFunction {
 public:
  /// `hysteresis_N` >= 0. Begins at the start of the press stroke, at force 0.
  ReverseFunction(ForceGraph graph, double hysteresis_N);

  void update(double force_N);
  double displacement_mm() const { return displacement_mm_; }
  bool releasing() const { return stroke_ == Stroke::release; }

 private:
  void turnIfDue(double force_N);
  double pressedTo(double force_N) const;
  double releasedTo(double force_N) const;

  ForceGraph graph_;
  double hysteresis_N_;
  std::vector<MonotoneStretch> pressStretches_, releaseStretches_;
  double displacement_mm_;
  Stroke stroke_ = Stroke::press;
  double turningForce_N_ = 0;  // largest force of this press, smallest of this release
};

}  // namespace detent::test
