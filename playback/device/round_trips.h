// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measures the time from a question to its answer on a link, before the loop begins.

#include <algorithm>
#include <array>
#include <cstddef>

#include "playback/device/steady_clock.h"

namespace detent::playback {

/// Priority of a thread that exchanges forces: above the audio callback (JACK: 65), because a late force is
/// felt, a late sample heard.
inline constexpr int forcePriority = 70;

/// Longest wait for an answer, as a share of the period. The force computed from it is sent with the next
/// period in any case; the rest of the period is for the law and for a late wake-up.
inline constexpr double answerWaitOfPeriod = 0.85;

/// A slower answer counts as missing.
inline constexpr double slowestRoundTrip_s = 0.1;

/// Sends questions until enough answers are in, or for a third of a second. Runs with the priority that the
/// loop will have; otherwise a busy computer would be mistaken for a slow device.
class RoundTrips {
 public:
  bool goOn() const { return count_ < all_s_.size() && (count_ < least || now_s() < end_s_); }
  void add(double roundTrip_s) { all_s_[count_++] = std::min(roundTrip_s, slowestRoundTrip_s); }
  /// Time within which nine of ten answers arrive, plus a quarter of their scatter: the time that a steady
  /// link is expected to keep.
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
