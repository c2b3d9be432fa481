// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long a link takes from a question to its answer, measured before the loop begins.

#include <algorithm>
#include <array>
#include <cstddef>

#include "playback/device/steady_clock.h"

namespace detent::playback {

/// An answer that takes longer is none.
inline constexpr double slowestRoundTrip_s = 0.1;

/// Asks until it has seen enough, or a third of a second is over.
class RoundTrips {
 public:
  bool goOn() const { return count_ < all_s_.size() && (count_ < least || now_s() < end_s_); }
  void add(double roundTrip_s) { all_s_[count_++] = std::min(roundTrip_s, slowestRoundTrip_s); }
  /// Nine of ten take no longer.
  double usual_s() {
    const auto at = static_cast<std::ptrdiff_t>(count_ * 9 / 10);
    const auto end = all_s_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::nth_element(all_s_.begin(), all_s_.begin() + at, end);
    return all_s_[static_cast<std::size_t>(at)];
  }

 private:
  static constexpr std::size_t least = 2;
  double end_s_ = now_s() + 0.2;
  std::array<double, 40> all_s_{};
  std::size_t count_ = 0;
};

}  // namespace detent::playback
