#pragma once
// The reverse function, force -> displacement, with memory: a jump makes it multi-valued, so the answer
// depends on the way one came (Kim & Lee 2013, Figure 2b).

#include <cstdint>

#include "model/force_graph.h"

namespace detent {

/// Where the finger is on the force graph.
struct TrackedPosition {
  double displacement_mm = 0;
  Stroke stroke = Stroke::press;
  bool jumped = false;  ///< this step crossed a jump
};

struct TrackerSettings {
  double hysteresis_N =
      0;  ///< force must turn back this far before the stroke changes; >= 0, at least one sensor LSB
};

/// Follows a force signal along a graph: on the press curve while force rises, on the release curve after it
/// has turned back by the hysteresis, never backwards within one stroke, through a jump at its tactile point.
/// Not finite forces are counted and ignored. Any thread; one owner.
class DisplacementTracker {
 public:
  explicit DisplacementTracker(ForceGraph graph, TrackerSettings settings = {});

  TrackedPosition update(double force_N);
  TrackedPosition position() const { return position_; }
  std::uint64_t rejectedSamples() const { return rejected_; }
  void reset();

 private:
  ForceGraph graph_;
  TrackerSettings settings_;
  TrackedPosition position_;
  double turningForce_N_ = 0;
  std::uint64_t rejected_ = 0;
};

}  // namespace detent
