// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/straight_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <opencv2/imgproc.hpp>

#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr int lineMinContrast =
    8;  // grey levels; JPEG ripple is below, the lightest grids of plotting programs above
constexpr double maxSlope = 0.052;  // 3°; sheets with more tilt are photographs
constexpr double maxResidual_px = 0.75;

/// Pixels on the crest of a horizontal ridge: darker than both sides two pixels away. Lines up to 3 px wide.
cv::Mat horizontalCrests(const cv::Mat& darkness) {
  cv::Mat smooth;
  cv::blur(darkness, smooth, cv::Size(1, 3), cv::Point(-1, -1), cv::BORDER_REPLICATE);
  cv::Mat crests = cv::Mat::zeros(darkness.size(), CV_8U);
  for (int y = 3; y < darkness.rows - 3; ++y) {
    const auto* c = smooth.ptr<std::uint8_t>(y);
    const auto* above = smooth.ptr<std::uint8_t>(y - 1);
    const auto* below = smooth.ptr<std::uint8_t>(y + 1);
    const auto* farAbove = smooth.ptr<std::uint8_t>(y - 3);
    const auto* farBelow = smooth.ptr<std::uint8_t>(y + 3);
    auto* out = crests.ptr<std::uint8_t>(y);
    for (int x = 0; x < darkness.cols; ++x) {
      const int rise = c[x] - std::max(farAbove[x], farBelow[x]);
      out[x] = static_cast<std::uint8_t>(3 * rise >= lineMinContrast && c[x] >= above[x] && c[x] > below[x]);
    }
  }
  return crests;
}

/// A run of crest pixels in one row.
struct Run {
  int y = 0, from = 0, to = 0, lineDarkness = 0;
};

/// Number of zeros at the beginning. Nearly all of a page is blank, so eight bytes are compared at once.
int blanksAt(const std::uint8_t* bytes, int count) {
  int n = 0;
  for (std::uint64_t eight = 0; n + 8 <= count; n += 8) {
    std::memcpy(&eight, bytes + n, 8);
    if (eight != 0) break;
  }
  while (n < count && bytes[n] == 0) ++n;
  return n;
}

std::vector<Run> runsIn(const cv::Mat& crests, int minLength, int maxGap) {
  std::vector<Run> runs;
  for (int y = 0; y < crests.rows; ++y) {
    const auto* row = crests.ptr<std::uint8_t>(y);
    Run run{y, -1, -1, 0};
    const auto close = [&] {
      if (run.from >= 0 && run.to - run.from + 1 >= minLength &&
          2 * run.lineDarkness >= run.to - run.from + 1)
        runs.push_back(run);
    };
    for (int x = 0; x < crests.cols; ++x) {
      x += blanksAt(row + x, crests.cols - x);
      if (x == crests.cols) break;
      if (run.from >= 0 && x - run.to <= maxGap + 1) {
        run.to = x;
        ++run.lineDarkness;
      } else {
        close();
        run = Run{y, x, x, 1};
      }
    }
    close();
  }
  return runs;
}

/// Runs joined end to end: a line that changes its row now and then.
struct Chain {
  std::vector<Run> runs;
  double lineDarkness = 0;
  int from() const { return runs.front().from; }
  int to = 0;
};

std::vector<Chain> chainsOf(std::vector<Run> runs, int maxGap) {
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.from != b.from ? a.from < b.from : a.y < b.y; });
  int rows = 0;
  for (const auto& run : runs) rows = std::max(rows, run.y + 1);
  std::vector<Chain> chains;
  // index of the chain whose last run ends in each row; -1: none
  std::vector<int> lastInRow(static_cast<std::size_t>(rows), -1);
  for (const auto& run : runs) {
    int best = -1;
    for (int dy : {0, -1, 1}) {
      const int y = run.y + dy;
      if (y < 0 || y >= rows) continue;
      const int k = lastInRow[static_cast<std::size_t>(y)];
      if (k < 0) continue;
      const auto& chain = chains[static_cast<std::size_t>(k)];
      const auto& tail = chain.runs.back();
      const int overlap = std::min({4 + maxGap, (tail.to - tail.from) / 2 + 1, (run.to - run.from) / 2 + 1});
      if (tail.y == y && run.from - chain.to <= maxGap + 1 && run.from >= chain.to - overlap &&
          run.to > chain.to) {
        best = k;
        break;
      }
    }
    if (best < 0) {
      best = static_cast<int>(chains.size());
      chains.push_back({});
    }
    auto& chain = chains[static_cast<std::size_t>(best)];
    chain.runs.push_back(run);
    chain.lineDarkness += run.lineDarkness;
    chain.to = std::max(chain.to, run.to);
    lastInRow[static_cast<std::size_t>(run.y)] = best;
  }
  return chains;
}

/// Least squares line through runs weighted by length, and the distance of the worst run.
StraightLine leastSquares(const std::vector<Run>& runs, double& worst) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  StraightLine line;
  line.from = runs.front().from;
  line.to = runs.front().to;
  for (const auto& run : runs) {
    const double len = run.to - run.from + 1, mid = 0.5 * (run.from + run.to);
    n += len;
    sx += len * mid;
    sy += len * run.y;
    sxx += len * (mid * mid + len * len / 12);
    sxy += len * mid * run.y;
    line.from = std::min<double>(line.from, run.from);
    line.to = std::max<double>(line.to, run.to);
  }
  const double det = n * sxx - sx * sx;
  const double slope = det > 0 ? (n * sxy - sx * sy) / det : 0;
  const double mean = sx / n, level = sy / n;
  worst = 0;
  for (const auto& run : runs)
    worst = std::max(worst, std::abs(run.y - (level + slope * (0.5 * (run.from + run.to) - mean))));
  line.acrossFrom = level + slope * (line.from - mean);
  line.acrossTo = level + slope * (line.to - mean);
  return line;
}

/// The straight part of a chain, without letters and curves that touch its ends, if most of it remains. Fill
/// 0 if it bends.
StraightLine straightened(const Chain& chain) {
  auto runs = chain.runs;
  double lineDarkness = chain.lineDarkness, worst = 0;
  auto line = leastSquares(runs, worst);
  while (worst > maxResidual_px && runs.size() > 1 && lineDarkness > 0.6 * chain.lineDarkness) {
    const auto drop = runs.front().lineDarkness < runs.back().lineDarkness ? runs.begin() : runs.end() - 1;
    lineDarkness -= drop->lineDarkness;
    runs.erase(drop);
    line = leastSquares(runs, worst);
  }
  line.fill = worst <= maxResidual_px && std::abs(line.slope()) <= maxSlope
                  ? std::min(1.0, lineDarkness / (line.length() + 1))
                  : 0;
  return line;
}

/// Moves a line found on one row of its crest to the middle of its thickness.
void centreOnLine(const cv::Mat& d, StraightLine& line) {
  constexpr int reach = 4, samples = 31;
  std::vector<double> offsets;
  for (int k = 0; k < samples; ++k) {
    const int x = static_cast<int>(std::lround(line.from + line.length() * (k + 0.5) / samples));
    const double at = line.acrossAt(x);
    const int y = static_cast<int>(std::lround(at));
    if (x < 0 || x >= d.cols || y < reach || y + reach >= d.rows) continue;
    int base = 255;
    for (const int dy : {-reach, reach}) base = std::min<int>(base, d.at<std::uint8_t>(y + dy, x));
    double mass = 0, moment = 0;
    for (int dy = -reach; dy <= reach; ++dy) {
      const double v = std::max(0, d.at<std::uint8_t>(y + dy, x) - base);
      mass += v;
      moment += v * dy;
    }
    if (mass >= lineMinContrast) offsets.push_back(y + moment / mass - at);
  }
  if (offsets.size() < samples / 3) return;
  const double middle = medianOf(std::move(offsets));
  if (std::abs(middle) > 2) return;
  line.acrossFrom += middle;
  line.acrossTo += middle;
}

/// Darkness of a line at one position: the darkest of three pixels across.
int darknessAt(const cv::Mat& d, const StraightLine& line, int along) {
  const int y = std::clamp(static_cast<int>(std::lround(line.acrossAt(along))), 1, d.rows - 2);
  return std::max(
      {d.at<std::uint8_t>(y - 1, along), d.at<std::uint8_t>(y, along), d.at<std::uint8_t>(y + 1, along)});
}

/// Extends a line beyond places where another line runs close beside it, as long as one side stays lighter.
void followLine(const cv::Mat& d, StraightLine& line) {
  std::vector<int> colours;
  for (int x = static_cast<int>(line.from); x <= static_cast<int>(line.to); x += 2)
    colours.push_back(darknessAt(d, line, x));
  const int usual = medianOf(std::move(colours));
  const auto goesOn = [&](int x) {
    const int y = static_cast<int>(std::lround(line.acrossAt(x)));
    if (y < 4 || y + 4 >= d.rows || 3 * darknessAt(d, line, x) < 2 * usual) return false;
    return 2 * std::min(d.at<std::uint8_t>(y - 4, x), d.at<std::uint8_t>(y + 4, x)) < usual;
  };
  const int farthest = static_cast<int>(0.25 * line.length());  // a longer extension is another line
  const auto follow = [&](int x, int step) {
    for (int n = 0; n < farthest && x + step >= 0 && x + step < d.cols && goesOn(x + step); ++n) x += step;
    return x;
  };
  const StraightLine seen = line;
  const int from = follow(static_cast<int>(std::lround(seen.from)), -1),
            to = follow(static_cast<int>(std::lround(seen.to)), 1);
  line.from = std::min<double>(seen.from, from);
  line.to = std::max<double>(seen.to, to);
  line.acrossFrom = seen.acrossAt(line.from);
  line.acrossTo = seen.acrossAt(line.to);
}

std::vector<StraightLine> horizontalLines(const cv::Mat& darkness, double minLength, double maxGap) {
  const int gap = static_cast<int>(std::lround(maxGap));
  const int minRun = std::max(6, std::min(12, static_cast<int>(minLength / 2)));
  std::vector<StraightLine> lines;
  for (const auto& chain : chainsOf(runsIn(horizontalCrests(darkness), minRun, gap), gap)) {
    if (chain.to - chain.from() + 1 < minLength) continue;
    auto line = straightened(chain);
    if (line.fill <= 0) continue;
    followLine(darkness, line);
    centreOnLine(darkness, line);
    lines.push_back(line);
  }
  return lines;
}

/// Removes duplicates found at two scales, or as two rims of a thick line; the better filled, longer one
/// stays.
std::vector<StraightLine> withoutDoubles(std::vector<StraightLine> lines, double apart) {
  std::sort(lines.begin(), lines.end(), [](const StraightLine& a, const StraightLine& b) {
    return a.length() * a.fill > b.length() * b.fill;
  });
  std::vector<StraightLine> kept;
  for (const auto& line : lines) {
    const bool seen = std::any_of(kept.begin(), kept.end(), [&](const StraightLine& k) {
      const double overlap = std::min(k.to, line.to) - std::max(k.from, line.from);
      const double mid = 0.5 * (line.from + line.to);
      return overlap > 0.5 * line.length() && std::abs(k.acrossAt(mid) - line.acrossAt(mid)) <= apart;
    });
    if (!seen) kept.push_back(line);
  }
  return kept;
}

void append(std::vector<StraightLine>& lines, const std::vector<StraightLine>& more, double scale) {
  const double shift = 0.5 * (scale - 1);  // offset of the coarse plane's pixel centres in the fine plane
  for (auto line : more) {
    line.from = line.from * scale;
    line.to = line.to * scale + 2 * shift;
    line.acrossFrom = line.acrossFrom * scale + shift;
    line.acrossTo = line.acrossTo * scale + shift;
    lines.push_back(line);
  }
}

/// Removes lines whose tilt differs from most lines: flat stretches of curves, not frame lines.
void keepCommonDirection(std::vector<StraightLine>& lines) {
  if (lines.empty()) return;
  std::vector<std::pair<double, double>> slopes;
  double total = 0;
  for (const auto& line : lines) {
    slopes.emplace_back(line.slope(), line.length());
    total += line.length();
  }
  std::sort(slopes.begin(), slopes.end());
  double sum = 0, median = 0;
  for (const auto& [slope, length] : slopes) {
    median = slope;
    if ((sum += length) >= 0.5 * total) break;
  }
  std::erase_if(lines, [&](const StraightLine& line) {
    return std::abs(line.slope() - median) > 0.008 + 1.5 / line.length();
  });
}

}  // namespace

LineSet findStraightLines(const cv::Mat& darkness, double minLength_px, double maxGap_px) {
  LineSet lines;
  if (darkness.rows < 8 || darkness.cols < 8) return lines;
  cv::Mat half;
  const cv::Mat even = darkness(cv::Rect(0, 0, darkness.cols / 2 * 2, darkness.rows / 2 * 2));
  cv::resize(even, half, cv::Size(darkness.cols / 2, darkness.rows / 2), 0, 0, cv::INTER_AREA);
  const auto combined = [&](const cv::Mat& fine, const cv::Mat& coarse) {
    std::vector<StraightLine> found;
    append(found, horizontalLines(fine, minLength_px, maxGap_px), 1);
    append(found, horizontalLines(coarse, minLength_px / 2, maxGap_px / 2), 2);
    found = withoutDoubles(std::move(found), 3);
    keepCommonDirection(found);
    return found;
  };
  lines.horizontal = combined(darkness, half);
  lines.vertical = combined(darkness.t(), half.t());
  return lines;
}

}  // namespace detent::importer
