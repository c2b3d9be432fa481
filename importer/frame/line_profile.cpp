// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/line_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr double minLineContrast = 7;  // grey levels of a mean profile
constexpr int maxHalfWidth = 9;        // px; thicker lines are bars

struct Peak {
  double at = 0, width = 1, contrast = 0;
};

/// The ridge around sample k of a profile, down to its minimum on either side; centroid above the line
/// between these minima.
std::optional<Peak> peakAt(const std::vector<double>& p, int k) {
  const int n = static_cast<int>(p.size());
  const auto at = [&](int i) { return p[static_cast<std::size_t>(i)]; };
  const double top = at(k), ripple = 0.02 * top + 0.3;
  const auto baseline = [&](int step) {
    int i = k;
    while (i + step >= 0 && i + step < n && std::abs(i + step - k) <= maxHalfWidth &&
           at(i + step) < at(i) + ripple && at(i) > 0.004 * top + 0.4)
      i += step;
    return i;
  };
  const int l = baseline(-1), r = baseline(1);
  if (top - std::max(at(l), at(r)) < minLineContrast) return std::nullopt;
  double mass = 0, moment = 0;
  for (int i = l; i <= r; ++i) {
    const double base = r > l ? at(l) + (at(r) - at(l)) * (i - l) / (r - l) : 0;
    const double v = std::max(0.0, at(i) - base);
    mass += v;
    moment += v * i;
  }
  const double contrast = top - std::max(at(l), at(r));
  return Peak{moment / mass, mass / contrast, contrast};
}

/// Straight line through (along, across) points by consensus, then least squares over those within
/// `tolerance`.
std::optional<EdgeLine> consensusLine(const std::vector<Peak>& peaks, const std::vector<double>& along,
                                      double expected, double tolerance, std::size_t possible) {
  const std::size_t n = peaks.size();
  std::size_t bestCount = 0;
  double bestWorth = 0, bestMiss = 1e9, bestAt = 0, bestSlope = 0;
  const auto consider = [&](double at0, double slope, double mid) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) count += std::abs(peaks[i].at - at0 - slope * along[i]) <= tolerance;
    const double miss = std::abs(at0 + slope * mid - expected);
    // A tilted line must explain clearly more points than a level one, because a curve beside the edge
    // attracts some.
    const double worth = static_cast<double>(count) * (slope == 0 ? 1.2 : 1.0);
    if (worth > bestWorth || (worth == bestWorth && miss < bestMiss)) {
      bestWorth = worth;
      bestCount = count;
      bestMiss = miss;
      bestAt = at0;
      bestSlope = slope;
    }
  };
  const double mid = n ? along[n / 2] : 0;
  for (std::size_t i = 0; i < n; ++i) {
    consider(peaks[i].at, 0, mid);
    for (std::size_t j = i + 1; j < n; ++j) {
      if (along[j] - along[i] < 1) continue;
      const double slope = (peaks[j].at - peaks[i].at) / (along[j] - along[i]);
      if (std::abs(slope) <= 0.06) consider(peaks[i].at - slope * along[i], slope, mid);
    }
  }
  if (3 * bestCount < possible || bestCount == 0) return std::nullopt;
  double w = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, width = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(peaks[i].at - bestAt - bestSlope * along[i]) > tolerance) continue;
    w += 1;
    sx += along[i];
    sy += peaks[i].at;
    sxx += along[i] * along[i];
    sxy += along[i] * peaks[i].at;
    width += peaks[i].width;
  }
  const double det = w * sxx - sx * sx;
  EdgeLine edge;
  edge.slope = bestSlope != 0 && w >= 3 && det > 1e-9 ? (w * sxy - sx * sy) / det : 0;
  // A tilt within the points' noise counts as none.
  if (std::abs(edge.slope) * (along.back() - along.front()) < 0.35) edge.slope = 0;
  std::vector<double> level;
  for (std::size_t i = 0; i < n; ++i)
    if (std::abs(peaks[i].at - bestAt - bestSlope * along[i]) <= tolerance)
      level.push_back(peaks[i].at - edge.slope * along[i]);
  edge.at0 = medianOf(level);
  edge.width_px = width / w;
  edge.support = static_cast<double>(bestCount) / static_cast<double>(possible);
  return edge;
}

/// Position of a line from many short stretches; those with something beside the line appear wider and are
/// left out.
std::optional<Peak> cleanPeak(const cv::Mat& d, int l, int r, int y0, int y1) {
  const int reach = r - l + 4;
  const int w0 = std::max(0, l - reach), w1 = std::min(d.cols, r + reach + 1);
  const int chunks = std::clamp((y1 - y0) / 5, 8, 60);
  std::vector<Peak> peaks;
  for (int c = 0; c < chunks; ++c) {
    const auto profile =
        meanColumns(d, w0, w1, y0 + (y1 - y0) * c / chunks, y0 + (y1 - y0) * (c + 1) / chunks);
    int crest = l - w0;
    for (int x = l - w0; x <= r - w0; ++x)
      if (profile[static_cast<std::size_t>(x)] > profile[static_cast<std::size_t>(crest)]) crest = x;
    if (const auto peak = peakAt(profile, crest))
      peaks.push_back({peak->at + w0, peak->width, peak->contrast});
  }
  if (peaks.empty()) return std::nullopt;
  std::vector<double> widths;
  for (const auto& p : peaks) widths.push_back(p.width);
  std::sort(widths.begin(), widths.end());
  const double clean = 1.25 * widths[widths.size() / 4] + 0.2;
  std::vector<double> at;
  double width = 0, contrast = 0;
  for (const auto& p : peaks) {
    if (p.width > clean) continue;
    at.push_back(p.at);
    width += p.width;
    contrast += p.contrast;
  }
  const auto n = static_cast<double>(at.size());
  return Peak{medianOf(at), width / n, contrast / n};
}

/// Removes pale copies beside a line, made by sharpening resampling filters and JPEG.
std::vector<Peak> withoutRinging(const std::vector<Peak>& lines) {
  constexpr double paler = 0.15, withinWidths = 4;  // share of the other line's contrast; line widths
  std::vector<Peak> kept;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(kept), [&](const Peak& line) {
    return std::none_of(lines.begin(), lines.end(), [&](const Peak& other) {
      return line.contrast < paler * other.contrast &&
             std::abs(line.at - other.at) < withinWidths * other.width;
    });
  });
  return kept;
}

int clampedInt(double v, int lo, int hi) { return std::clamp(static_cast<int>(std::lround(v)), lo, hi); }

}  // namespace

std::vector<double> meanColumns(const cv::Mat& d, int x0, int x1, int y0, int y1) {
  std::vector<double> sum(static_cast<std::size_t>(x1 - x0), 0.0);
  for (int y = y0; y < y1; ++y) {
    const auto* row = d.ptr<std::uint8_t>(y);
    for (int x = x0; x < x1; ++x) sum[static_cast<std::size_t>(x - x0)] += row[x];
  }
  for (auto& s : sum) s /= std::max(1, y1 - y0);
  return sum;
}

std::optional<EdgeLine> locateColumnEdge(const cv::Mat& d, double across, double from, double to,
                                         double reach) {
  const int x0 = clampedInt(across - reach - 4, 0, d.cols), x1 = clampedInt(across + reach + 5, 0, d.cols);
  const int y0 = clampedInt(from, 0, d.rows), y1 = clampedInt(to + 1, 0, d.rows);
  if (x1 - x0 < 5 || y1 - y0 < 6) return std::nullopt;
  const int chunks = std::clamp((y1 - y0) / 6, 4, 40);
  std::vector<Peak> peaks;
  std::vector<double> along;
  for (int c = 0; c < chunks; ++c) {
    const int a = y0 + (y1 - y0) * c / chunks, b = y0 + (y1 - y0) * (c + 1) / chunks;
    const auto profile = meanColumns(d, x0, x1, a, b);
    for (int k = 0; k < x1 - x0; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const bool crest =
          (k == 0 || profile[i] >= profile[i - 1]) && (k + 1 == x1 - x0 || profile[i] > profile[i + 1]);
      if (!crest || std::abs(x0 + k - across) > reach + 0.5) continue;
      if (const auto peak = peakAt(profile, k)) {
        peaks.push_back({peak->at + x0, peak->width, peak->contrast});
        along.push_back(0.5 * (a + b - 1));
      }
    }
  }
  return consensusLine(peaks, along, across, 0.6, static_cast<std::size_t>(chunks));
}

std::optional<RimCover> rimCover(const cv::Mat& d, double across, double from, double to) {
  const int x = static_cast<int>(std::lround(across));
  const int y0 = clampedInt(from, 0, d.rows), y1 = clampedInt(to, 0, d.rows);
  if (x < 2 || x + 2 >= d.cols || y1 - y0 < 16 || std::abs(across - x) > 0.1) return std::nullopt;
  std::vector<double> left, right, beyond;
  for (int y = y0; y < y1; ++y) {
    const auto* row = d.ptr<std::uint8_t>(y);
    if (row[x] < 40) continue;
    left.push_back(row[x - 1] / static_cast<double>(row[x]));
    right.push_back(row[x + 1] / static_cast<double>(row[x]));
    beyond.push_back(std::max(row[x - 2], row[x + 2]) / static_cast<double>(row[x]));
  }
  if (left.size() < 16) return std::nullopt;
  return RimCover{medianOf(left), medianOf(right), medianOf(beyond)};
}

std::vector<GridLine> columnLines(const cv::Mat& d, double left, double right, double top, double bottom) {
  const int x0 = clampedInt(left - 4, 0, d.cols), x1 = clampedInt(right + 5, 0, d.cols);
  const int y0 = clampedInt(top + 2, 0, d.rows), y1 = clampedInt(bottom - 1, 0, d.rows);
  constexpr int bands = 8;
  if (x1 - x0 < 9 || y1 - y0 < 3 * bands) return {};
  const auto width = static_cast<std::size_t>(x1 - x0);
  // A pixel votes for a line if it is darker than both sides, at three distances for thin, medium and thick
  // lines.
  std::vector<std::array<int, bands>> votes(width, std::array<int, bands>{});
  for (int y = y0; y < y1; ++y) {
    const auto* row = d.ptr<std::uint8_t>(y);
    const auto band = static_cast<std::size_t>((y - y0) * bands / (y1 - y0));
    for (int x = x0 + 2; x < x1 - 2; ++x) {
      const auto rises = [&](int far) {
        const int l = std::max(x - far, 0), r = std::min(x + far, d.cols - 1);
        return row[x] - std::max(row[l], row[r]) >= 6;
      };
      if (rises(2) || rises(4) || rises(8)) ++votes[static_cast<std::size_t>(x - x0)][band];
    }
  }
  const double rows = static_cast<double>(y1 - y0) / bands;
  std::vector<double> share(width, 0.0);
  for (std::size_t k = 0; k < width; ++k) {
    auto v = votes[k];
    std::sort(v.begin(), v.end());
    double sum = 0;
    for (const int c : v) sum += c;
    // Text may hide a line in two of its eight parts; a steep curve is visible in few of them.
    share[k] = v[2] >= 0.12 * rows ? sum / (rows * bands) : 0;
  }
  std::vector<Peak> peaks;
  for (int k = 2; k + 2 < static_cast<int>(width); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (share[i] < 0.16 || share[i] < share[i - 1] || share[i] <= share[i + 1]) continue;
    int l = k, r = k;
    while (l > 0 && share[static_cast<std::size_t>(l - 1)] > 0.5 * share[i]) --l;
    while (r + 1 < static_cast<int>(width) && share[static_cast<std::size_t>(r + 1)] > 0.5 * share[i]) ++r;
    if (const auto peak = cleanPeak(d, x0 + l, x0 + r, y0, y1)) {
      if (peak->at >= left - 2.5 && peak->at <= right + 2.5 &&
          (peaks.empty() || peak->at - peaks.back().at > 1.6))
        peaks.push_back(*peak);
    }
    k = r;
  }
  std::vector<GridLine> lines;
  for (const Peak& peak : withoutRinging(peaks)) lines.push_back({peak.at, peak.width, true});
  return lines;
}

std::vector<GridLine> columnTicks(const cv::Mat& d, double left, double right, double stripTop,
                                  double stripBottom) {
  const int x0 = clampedInt(left - 6, 0, d.cols), x1 = clampedInt(right + 7, 0, d.cols);
  const int y0 = clampedInt(stripTop, 0, d.rows), y1 = clampedInt(stripBottom + 1, 0, d.rows);
  std::vector<GridLine> ticks;
  if (x1 - x0 < 9 || y1 <= y0) return ticks;
  const auto profile = meanColumns(d, x0, x1, y0, y1);
  for (int k = 1; k + 1 < x1 - x0; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (profile[i] < profile[i - 1] || profile[i] <= profile[i + 1]) continue;
    const auto peak = peakAt(profile, k);
    if (!peak || peak->contrast < 12) continue;
    const double at = peak->at + x0;
    if (at >= left - 2.5 && at <= right + 2.5 && (ticks.empty() || at - ticks.back().position_px > 1.6))
      ticks.push_back({at, peak->width, false});
  }
  return ticks;
}

}  // namespace detent::importer
