// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/limiter_gains.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::playback {

namespace {

struct Range {
  double low, high;
};

/// Range of gains that turn `whole` into `limited`, within the tolerance.
Range gainsOf(double whole, double limited, double tolerance) {
  const double level = std::fabs(whole), wanted = whole < 0 ? -limited : limited;
  if (level <= tolerance) return {0, 1};  // the signal is so small that any gain is acceptable
  return {std::clamp((wanted - tolerance) / level, 0.0, 1.0),
          std::clamp((wanted + tolerance) / level, 0.0, 1.0)};
}

/// Slopes of all straight lines from one point through the ranges behind it.
class Cone {
 public:
  explicit Cone(GainPoint from) : from_(from) {}

  /// Returns false, without a change, if no line also meets this range.
  bool narrow(std::int64_t frame, const Range& gains) {
    const auto far = static_cast<double>(frame - from_.frame);
    const double low = std::max(low_, (gains.low - from_.gain) / far);
    const double high = std::min(high_, (gains.high - from_.gain) / far);
    if (low > high) return false;
    low_ = low;
    high_ = high;
    return true;
  }

  /// Point on the flattest of the possible lines.
  GainPoint at(std::int64_t frame) const {
    const double slope = std::clamp(0.0, low_, high_);
    return {frame, std::clamp(from_.gain + slope * static_cast<double>(frame - from_.frame), 0.0, 1.0)};
  }

 private:
  GainPoint from_;
  double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<GainPoint> limiterGains(const std::vector<float>& whole, const std::vector<float>& limited,
                                    double tolerance) {
  std::vector<GainPoint> gainPoints;
  const auto count = static_cast<std::int64_t>(std::min(whole.size(), limited.size()));
  const auto gainsAt = [&](std::int64_t frame) {
    const auto i = static_cast<std::size_t>(frame);
    return gainsOf(static_cast<double>(whole[i]), static_cast<double>(limited[i]), tolerance);
  };
  if (count == 0) return gainPoints;
  gainPoints.push_back({0, gainsAt(0).high});
  Cone cone(gainPoints.back());
  for (std::int64_t frame = 1; frame < count; ++frame) {
    const Range gains = gainsAt(frame);
    if (cone.narrow(frame, gains)) continue;
    gainPoints.push_back(cone.at(frame - 1));
    cone = Cone(gainPoints.back());
    cone.narrow(frame, gains);
  }
  if (count > 1) gainPoints.push_back(cone.at(count - 1));
  return gainPoints;
}

}  // namespace detent::playback
