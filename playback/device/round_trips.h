// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long a link takes from a question to its answer, measured before the loop begins.

#include <algorithm>
#include <array>
#include <cstddef>

#include "playback/device/steady_clock.h"

namespace detent::playback {

/// Priority of a thread that exchanges forces: above the audio callback (JACK: 65), because a late force is felt, a late sample heard.
inline constexpr int forcePriority = 70;

/// How long an answer is waited for, as a share of the period. The force that follows from it is sent with the next period, however early it
/// came; what is left is for the law and for a late wake-up.
inline constexpr double answerWaitOfPeriod = 0.85;

/// An answer that takes longer is none.
inline constexpr double slowestRoundTrip_s = 0.1;

/// Asks until it has seen enough, or a third of a second is over; with the priority that the loop will have, or a busy computer would pass
/// for a slow device.
class RoundTrips {
 public:
  bool goOn() const { return count_ < all_s_.size() && (count_ < least || now_s() < end_s_); }
  void add(double roundTrip_s) { all_s_[count_++] = std::min(roundTrip_s, slowestRoundTrip_s); }
  /// Nine of ten take no longer, with a quarter of their scatter on top: what a steady link is expected to keep.
  double usual_s() {
    std::sort(all_s_.begin(), all_s_.begin() + static_cast<std::ptrdiff_t>(count_));
    const double most_s = all_s_[count_ * 9 / 10];
    return std::min(most_s + (most_s - all_s_[count_ / 10]) / 4, slowestRoundTrip_s);
  }

 private:
  static constexpr std::size_t least = 2;
  RealtimeWhile realtime_{forcePriority};
  double end_s_ = now_s() + 0.2;
  std::array<double, 40> all_s_{};
  std::size_t count_ = 0;
};

}  // namespace detent::playback
