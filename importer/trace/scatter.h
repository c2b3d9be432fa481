// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Spread of points around their mean.

#include <algorithm>
#include <cmath>
#include <span>

#include "importer/page/raster.h"

namespace detent::importer {

/// Mean and second moments of points.
class Scatter {
 public:
  /// At least one point.
  explicit Scatter(std::span<const Point> points) : count_(static_cast<double>(points.size())) {
    for (const Point& p : points) middle_ = middle_ + (1 / count_) * p;
    for (const Point& p : points) {
      const Point off = p - middle_;
      xx_ += off.x * off.x, xy_ += off.x * off.y, yy_ += off.y * off.y;
    }
  }

  Point middle() const { return middle_; }
  /// Unit vector of the best line through the points; either sign.
  Point along() const {
    const double angle = 0.5 * std::atan2(2 * xy_, xx_ - yy_);
    return {std::cos(angle), std::sin(angle)};
  }
  /// Rms distance of the points from the line in the direction along() through their mean.
  double across() const {
    const double half = 0.5 * (xx_ + yy_), root = std::hypot(0.5 * (xx_ - yy_), xy_);
    return std::sqrt(std::max(0.0, half - root) / count_);
  }

 private:
  double count_;
  Point middle_{};
  double xx_ = 0, xy_ = 0, yy_ = 0;
};

}  // namespace detent::importer
