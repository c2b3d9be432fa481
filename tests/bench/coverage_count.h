// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Share of truths within a stated error, with the interval of the count.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "playback/study/statistics/binomial.h"

namespace detent::test {

/// Counts estimates against their truth. A standard error promises 68.3 % within one and 95.0 % within 1.96
/// of it.
class CoverageCount {
 public:
  void add(double value, double sigma, double truth) {
    const double off = std::abs(value - truth);
    add(off <= sigma, off <= 1.959964 * sigma);
    squares_ += off * off / std::max(truth * truth, 1e-300);
    worst_ = std::max(worst_, off / std::max(std::abs(truth), 1e-300));
  }
  void add(bool within68, bool within95) {
    within68_ += within68 ? 1 : 0;
    within95_ += within95 ? 1 : 0;
    ++count_;
  }
  std::size_t count() const { return count_; }
  double rms() const { return std::sqrt(squares_ / static_cast<double>(std::max<std::size_t>(1, count_))); }
  double worst() const { return worst_; }
  /// "68.1 (65.1–71.0) | 95.2 (93.6–96.4)": per cent, with Wilson's 95 % interval of the count.
  std::string text95() const { return share(within95_); }
  std::string text() const { return share(within68_) + " | " + share(within95_); }

 private:
  std::string share(std::size_t inside) const {
    const playback::Interval interval = playback::wilson({inside, count_});
    char text[64];
    std::snprintf(text, sizeof text, "%.1f (%.1f–%.1f)", 100 * playback::rateOf({inside, count_}),
                  100 * interval.low, 100 * interval.high);
    return text;
  }
  std::size_t within68_ = 0, within95_ = 0, count_ = 0;
  double squares_ = 0, worst_ = 0;
};

}  // namespace detent::test
