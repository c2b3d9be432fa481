// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/record_velocity.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace detent::playback {

namespace {

constexpr std::size_t narrowestHalf = 4, widestHalf = 60;  // samples on each side

/// The recording's step: smallest change that is more than rounding.
double stepOf(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double rounding = 1e-9 * std::max(1e-6, *high - *low);
  double step = *high - *low;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = std::abs(values[i] - values[i - 1]);
    if (change > rounding) step = std::min(step, change);
  }
  return step;
}

std::size_t halfWindow(const std::vector<double>& x, std::size_t at, double way_mm) {
  const std::size_t most = std::min({widestHalf, at, x.size() - 1 - at});
  std::size_t half = std::min(narrowestHalf, most);
  while (half < most && std::abs(x[at + half] - x[at - half]) < way_mm) ++half;
  return half;
}

}  // namespace

RecordMotion motionOf(const ForceRecord& record, double lowestQuanta) {
  const std::vector<double>&t = record.time_s, &x = record.displacement_mm;
  RecordMotion motion;
  motion.step_mm = stepOf(x);
  motion.velocity_mm_per_s.assign(t.size(), 0);
  motion.acceleration_mm_per_s2.assign(t.size(), 0);
  motion.inside.assign(t.size(), false);
  for (std::size_t i = narrowestHalf; i + narrowestHalf < t.size(); ++i) {
    const std::size_t half = halfWindow(x, i, lowestQuanta * motion.step_mm);
    const double scale_s = std::max(t[i + half] - t[i], t[i] - t[i - half]);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t j = i - half; j <= i + half; ++j) {
      const double u = (t[j] - t[i]) / scale_s;
      const Eigen::Vector4d row(1, u, u * u, u * u * u);
      normal += row * row.transpose();
      right += row * (x[j] - x[i]);
    }
    const Eigen::Vector4d cubic = normal.ldlt().solve(right);
    motion.velocity_mm_per_s[i] = cubic[1] / scale_s;
    motion.acceleration_mm_per_s2[i] = 2 * cubic[2] / (scale_s * scale_s);
    motion.inside[i] = true;
  }
  return motion;
}

}  // namespace detent::playback
