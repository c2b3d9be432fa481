// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/dash_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "importer/page/quantile.h"
#include "importer/trace/scatter.h"

namespace detent::importer::trace {

namespace {

constexpr std::size_t kFewestDashes = 4;      // dashes of a line
constexpr std::size_t kMostDashParts = 1500;  // pieces; more is noise
constexpr double kShortest = 1.6;             // thicknesses of a line, for a dash
constexpr double kLongest = 0.12;             // share of the area's diagonal
constexpr double kGapTimes = 2;               // times the shorter dash, plus two pixels
constexpr double kStraightOn = 0.8;           // cosine between a dash and the direction to the next
constexpr double kRegularDashShare = 0.7, kRegularDashWithin = 0.5,
                 kRegularDashWithin_px = 1.5;  // as in withDashesJoined

/// A straight piece: its two ends, each with the direction out of the piece.
struct Dash {
  std::array<Point, 2> ends, out;
  double length_px = 0;
};

/// End of a piece: the dash, and which of its ends.
struct EndOf {
  std::size_t dash = 0, end = 0;
};

/// Returns a piece as a dash if it is thin and straight.
std::optional<Dash> dashOf(const std::vector<Point>& pixels, double thickness_px, double longest_px) {
  const Scatter scatter(pixels);
  const Point mean = scatter.middle(), along = scatter.along();
  double first = 0, last = 0, across = 0;
  for (const Point& p : pixels) {
    const double t = dot(p - mean, along);
    first = std::min(first, t), last = std::max(last, t);
    across = std::max(across, std::abs(cross(along, p - mean)));
  }
  const double length_px = last - first + 1;
  if (length_px < kShortest * thickness_px || length_px > longest_px) return {};
  if (across > 0.8 * thickness_px + 1) return {};
  return Dash{{mean + first * along, mean + last * along}, {-1 * along, along}, length_px};
}

/// Distance between one end and another that continues it; infinite if it does not.
double gapOf(const Dash& a, std::size_t endOfA, const Dash& b, std::size_t endOfB, const BareAt& isBare) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Point gap = b.ends[endOfB] - a.ends[endOfA];
  const double gap_px = norm(gap);
  if (gap_px < 1.5 || gap_px > kGapTimes * std::min(a.length_px, b.length_px) + 2) return never;
  if (dot(a.out[endOfA], gap) < kStraightOn * gap_px || -dot(b.out[endOfB], gap) < kStraightOn * gap_px)
    return never;
  return isBare(a.ends[endOfA] + 0.5 * gap) ? gap_px : never;
}

/// For each end the end that continues it, or itself; both choose each other.
std::vector<std::array<EndOf, 2>> nextOf(const std::vector<Dash>& dashes, const BareAt& isBare,
                                         std::vector<std::array<double, 2>>& gaps) {
  std::vector<std::array<EndOf, 2>> next(dashes.size());
  gaps.assign(dashes.size(),
              {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()});
  for (std::size_t i = 0; i < dashes.size(); ++i)
    for (std::size_t e : {0U, 1U}) {
      next[i][e] = {i, e};
      for (std::size_t k = 0; k < dashes.size(); ++k)
        for (std::size_t f : {0U, 1U}) {
          if (k == i) continue;
          const double gap = gapOf(dashes[i], e, dashes[k], f, isBare);
          if (gap < gaps[i][e]) gaps[i][e] = gap, next[i][e] = {k, f};
        }
    }
  return next;
}

bool even(std::vector<double> lengths) {
  const double usual = medianOf(lengths);
  const auto regular = std::ranges::count_if(lengths, [&](double length) {
    return std::abs(length - usual) <= std::max(kRegularDashWithin_px, kRegularDashWithin * usual);
  });
  return static_cast<double>(regular) >= kRegularDashShare * static_cast<double>(lengths.size());
}

bool touches(const std::vector<Point>& piece, const cv::Mat& curves) {
  const cv::Rect whole(0, 0, curves.cols, curves.rows);
  return std::ranges::any_of(piece, [&](Point p) {
    const cv::Rect around(static_cast<int>(p.x) - 1, static_cast<int>(p.y) - 1, 3, 3);
    return cv::countNonZero(curves(around & whole)) > 0;
  });
}

std::vector<std::vector<Point>> piecesOf(const cv::Mat& marks) {
  cv::Mat labels;
  const int count = cv::connectedComponents(marks, labels, 8, CV_32S);
  std::vector<std::vector<Point>> pieces(static_cast<std::size_t>(std::max(0, count - 1)));
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (const int label = labels.at<int>(y, x); label > 0)
        pieces[static_cast<std::size_t>(label - 1)].push_back({double(x), double(y)});
  return pieces;
}

}  // namespace

std::vector<std::vector<Point>> dashChains(const cv::Mat& marks, const cv::Mat& curves, double thickness_px,
                                           const BareAt& isBare) {
  const double longest_px = kLongest * std::hypot(marks.cols, marks.rows);
  std::vector<std::vector<Point>> pieces = piecesOf(marks), kept;
  if (pieces.size() > kMostDashParts) return {};
  std::vector<Dash> dashes;
  for (std::vector<Point>& piece : pieces)
    if (const auto dash = dashOf(piece, thickness_px, longest_px); dash && !touches(piece, curves)) {
      dashes.push_back(*dash);
      kept.push_back(std::move(piece));
    }
  std::vector<std::array<double, 2>> gaps;
  const auto next = nextOf(dashes, isBare, gaps);
  const auto mutual = [&](std::size_t i, std::size_t e) {
    const EndOf to = next[i][e], back = next[to.dash][to.end];
    return to.dash != i && back.dash == i && back.end == e;
  };
  std::vector<std::vector<Point>> chains;
  std::vector<char> seen(dashes.size(), 0);
  for (std::size_t start = 0; start < dashes.size(); ++start) {
    if (seen[start]) continue;
    std::vector<Point> chain;
    std::vector<double> lengths;
    std::size_t members = 0;
    // Follows both ends of the first; a closed line ends at a dash seen before.
    const auto follow = [&](std::size_t i, std::size_t e) {
      while (mutual(i, e) && !seen[next[i][e].dash]) {
        lengths.push_back(gaps[i][e]);
        const EndOf to = next[i][e];
        i = to.dash, e = 1 - to.end;
        seen[i] = 1, members += 1;
        chain.insert(chain.end(), kept[i].begin(), kept[i].end());
      }
    };
    seen[start] = 1, members = 1;
    chain = kept[start];
    follow(start, 0), follow(start, 1);
    if (members >= kFewestDashes && even(lengths)) chains.push_back(std::move(chain));
  }
  return chains;
}

std::vector<Stretch> dashedStretches(const std::vector<Point>& points, double thickness_px,
                                     const BareAt& isBare) {
  constexpr double longestGap = 8, longestPace = 24;  // thicknesses
  std::vector<std::size_t> starts, ends;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isBare(points[i])) continue;
    std::size_t to = i;
    while (to + 1 < points.size() && isBare(points[to + 1])) ++to;
    if (static_cast<double>(to - i + 1) <= longestGap * std::max(1.5, thickness_px))
      starts.push_back(i), ends.push_back(to);
    i = to;
  }
  std::vector<Stretch> stretches;
  for (std::size_t from = 0; from < starts.size();) {
    std::size_t to = from;
    std::vector<double> paces;
    while (to + 1 < starts.size() &&
           static_cast<double>(starts[to + 1] - starts[to]) <= longestPace * std::max(1.5, thickness_px)) {
      paces.push_back(static_cast<double>(starts[to + 1] - starts[to]));
      ++to;
    }
    if (paces.size() >= kFewestDashes && even(paces))
      stretches.push_back({starts[from], ends[to], medianOf(paces)});
    from = to + 1;
  }
  return stretches;
}

}  // namespace detent::importer::trace
