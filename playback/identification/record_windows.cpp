// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/record_windows.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace detent::playback {

namespace {

// Samples on each side of a window's middle. With fewer, the rounding of positions dominates the curvature
// (decision 1108).
constexpr std::size_t narrowestHalf = 8, widestHalf = 60;

/// The recording's step: the smallest change that exceeds numerical rounding.
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

/// Half the time between a sample's neighbours: its weight in an integral.
double duration_s(const std::vector<double>& t, std::size_t at) {
  const std::size_t before = at == 0 ? 0 : at - 1, after = std::min(at + 1, t.size() - 1);
  return 0.5 * (t[after] - t[before]);
}

/// (1 - u²)³ with its first and second derivatives: it vanishes smoothly at -1 and 1.
SampleShare bumpAt(double u) {
  const double rest = 1 - u * u;
  if (rest <= 0) return {};
  return {rest * rest * rest, 6 * u * rest * rest, 6 * rest * (5 * u * u - 1)};
}

}  // namespace

RecordWindows::RecordWindows(const ForceRecord& record, double lowestQuanta)
    : record_(record), step_mm_(stepOf(record.displacement_mm)), half_(record.time_s.size(), 0) {
  for (std::size_t i = narrowestHalf; i + narrowestHalf < half_.size(); ++i) {
    half_[i] = halfWindow(record.displacement_mm, i, lowestQuanta * step_mm_);
  }
}

// Sums over samples approximate integrals. Their errors for uneven times are corrected, so that constants and
// straight lines are exact.
void RecordWindows::shares(std::size_t at, std::vector<SampleShare>& out) const {
  const std::vector<double>& t = record_.time_s;
  const std::size_t half = half_[at], begin = first(at);
  const double wider = static_cast<double>(half + 1) / static_cast<double>(half);
  const double scale_s = wider * std::min(t[at + half] - t[at], t[at] - t[begin]);
  const auto time_s = [&](std::size_t i) { return t[begin + i] - t[at]; };
  out.assign(2 * half + 1, {});
  SampleShare sum;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double duration = duration_s(t, begin + i);
    const SampleShare bump = bumpAt(time_s(i) / scale_s);
    out[i] = {bump.mean * duration, bump.perS * duration, bump.perS2 * duration};
    sum.mean += out[i].mean, sum.perS += out[i].perS, sum.perS2 += out[i].perS2;
  }
  out[half].perS -= sum.perS;
  out[half].perS2 -= sum.perS2;
  double slope = 0, bend = 0;
  for (std::size_t i = 0; i < out.size(); ++i) slope += out[i].perS * time_s(i);
  for (SampleShare& share : out) share.mean /= sum.mean, share.perS /= slope;
  double tilt = 0;
  for (std::size_t i = 0; i < out.size(); ++i) tilt += out[i].perS2 * time_s(i);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].perS2 -= tilt * out[i].perS;
    bend += 0.5 * out[i].perS2 * time_s(i) * time_s(i);
  }
  for (SampleShare& share : out) share.perS2 /= bend;
}

Stays staysOf(const std::vector<double>& x) {
  Stays stays;
  stays.level.assign(x.size(), Stays::moving);
  std::map<double, std::size_t> levels;
  for (std::size_t begin = 0; begin < x.size();) {
    std::size_t end = begin;
    while (end < x.size() && x[end] == x[begin]) ++end;
    const bool passes = begin > 0 && end < x.size() && (x[begin] > x[begin - 1]) == (x[end] > x[begin]);
    if (!passes) {
      const std::size_t level = levels.try_emplace(x[begin], levels.size()).first->second;
      std::fill(stays.level.begin() + static_cast<std::ptrdiff_t>(begin),
                stays.level.begin() + static_cast<std::ptrdiff_t>(end), level);
    }
    begin = end;
  }
  stays.levels = levels.size();
  return stays;
}

}  // namespace detent::playback
