// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The reverse function, force -> displacement, with memory: a jump makes it multi-valued, so the answer
// depends on the way one came (Kim & Lee 2013, Figure 2b).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/force_graph.h"
#include "model/sections.h"

namespace detent {

/// Where the finger is on the force graph.
struct TrackedPosition {
  double displacement_mm = 0;
  Stroke stroke = Stroke::press;
  bool jumped = false;  ///< this step crossed a jump's tactile point
  friend bool operator==(const TrackedPosition&, const TrackedPosition&) = default;
};

struct TrackerSettings {
  double hysteresis_N = 0;  ///< force must turn back *more than* this before the stroke changes; >= 0, finite
  SectionSettings sections;  ///< what counts as a jump for `TrackedPosition::jumped`
};

/// Follows a force signal along a graph. With x the present displacement:
///  - press:   x becomes the nearest displacement at or beyond x where the press curve carries the force;
///  - release: x becomes the nearest displacement at or before x where the release curve is no stronger than
///             the force;
/// so x never goes backwards within one stroke, rests at a tactile point as long as its force is not exceeded
/// and then passes the whole jump at once, stays put on a wall, and waits between the two curves after a turn
/// (hysteresis). The stroke changes when force has turned back from its extreme since the last change by more
/// than the hysteresis. Below everything on the release curve: its start (a locked button does not come back
/// to 0); beyond everything on the press curve: the end of the travel. Outside a curve its nearest end's
/// force counts. Forces that are not finite are counted and change nothing. Any thread; one owner.
class DisplacementTracker {
 public:
  explicit DisplacementTracker(ForceGraph graph, TrackerSettings settings = {});

  TrackedPosition update(double force_N);
  TrackedPosition position() const { return position_; }
  std::uint64_t rejectedSamples() const { return rejected_; }

  /// Back to the start of the press stroke, untouched. The count of rejected samples starts again.
  void reset();

  /// Goes on from the present displacement, stroke and force on another graph (a self-locking button's other
  /// state).
  void continueOn(ForceGraph graph);

 private:
  void turnIfDue(double force_N);
  double pressedTo(double force_N) const;
  double releasedTo(double force_N) const;
  bool crossesJump(double from_mm, double to_mm) const;
  void readGraph();

  ForceGraph graph_;
  std::optional<ForceGraph> nextGraph_;
  TrackerSettings settings_;
  std::vector<MonotoneStretch> pressStretches_, releaseStretches_;
  std::vector<double> pressJumps_mm_, releaseJumps_mm_;  // tactile points that begin a jump
  TrackedPosition position_;
  double turningForce_N_ = 0;  // largest force of this press, smallest of this release
  bool touched_ = false;       // a force has been seen since reset
  std::uint64_t rejected_ = 0;
};

}  // namespace detent
