// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rate-independent memory of a direction: the play (backlash) operator. Choosing press or release by the sign
// of the velocity would chatter under a resting finger (docs/develop/decisions/1100-force-between-curves.md).

#include <algorithm>

namespace detent::playback {

/// A centre that a position drags along once it is `radius` away from it.
class PlayOperator {
 public:
  /// Restarts with a press share of 0..1, as `pressShare` returns it.
  void restart(double position_mm, double radius_mm, double share) {
    centre_mm_ = position_mm + radius_mm * (1 - 2 * share);
  }
  double update(double position_mm, double radius_mm) {
    centre_mm_ = std::max(position_mm - radius_mm, std::min(position_mm + radius_mm, centre_mm_));
    return centre_mm_;
  }
  /// Sets the state after a long movement inwards.
  void setPressing(double position_mm, double radius_mm) { centre_mm_ = position_mm - radius_mm; }
  /// 0 after a long movement outwards, 1 after one inwards, linear between.
  double pressShare(double position_mm, double radius_mm) const {
    return 0.5 * (1 + (position_mm - centre_mm_) / radius_mm);
  }
  double centre_mm() const { return centre_mm_; }

 private:
  double centre_mm_ = 0;
};

}  // namespace detent::playback
