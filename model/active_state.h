// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which state of a button is active: self-locking buttons alternate at each actuation (Kim & Lee 2013,
// buttons E and F).

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/button.h"
#include "model/displacement_tracker.h"

namespace detent {

/// Counts actuations and says which state's force graph is felt. A press that passes the active state's
/// operating point actuates; the other state takes over once the following release has passed the reset
/// point, so one stroke never changes its curve. A momentary button counts, but stays in its state. Where the
/// button does not state them: the operating point is the first tactile point of the press, else the
/// bottom-out; the reset point lies a tenth of the way from the release's end to the operating point.
/// Plain value, any thread.
class ActiveState {
 public:
  explicit ActiveState(const Button& button);

  /// Takes one tracked position; true if another state became active with it.
  bool update(const TrackedPosition& position);

  std::size_t index() const { return index_; }  ///< into Button::states()
  bool actuated() const { return actuated_; }   ///< pressed beyond the operating point, not yet reset
  std::size_t actuations() const { return actuations_; }  ///< since construction

 private:
  struct Thresholds {
    double operating_mm, reset_mm;
  };
  std::vector<Thresholds> states_;
  std::size_t index_ = 0, actuations_ = 0;
  bool actuated_ = false;
};

/// What a force did to a whole button.
struct ButtonPosition {
  TrackedPosition position;
  std::size_t state = 0;      ///< the state the position belongs to
  bool stateChanged = false;  ///< the next press is felt on another state
};

/// DisplacementTracker over all states of a button. Any thread; one owner.
class ButtonTracker {
 public:
  explicit ButtonTracker(const Button& button, TrackerSettings settings = {});
  ButtonPosition update(double force_N);
  const ActiveState& activeState() const { return active_; }
  std::uint64_t rejectedSamples() const { return tracker_.rejectedSamples(); }

 private:
  std::vector<ForceGraph> graphs_;
  std::size_t felt_ = 0;
  ActiveState active_;
  DisplacementTracker tracker_;
};

}  // namespace detent
