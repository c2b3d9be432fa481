// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_confidence.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace detent::importer::trace {

namespace {

/// Columns passed by both paths as a share of those passed by either. Leaders and latch branches stand side
/// by side; strokes of one switch run over the same travel.
double sharedTravel(const std::vector<Point>& a, const std::vector<Point>& b) {
  const double common = std::min(a.back().x, b.back().x) - std::max(a.front().x, b.front().x);
  const double either = std::max(a.back().x, b.back().x) - std::min(a.front().x, b.front().x);
  return either > 0 ? std::max(0.0, common / either) : 0;
}

/// Linear ramp: 0 at `bad`, 1 at `good`.
double confidenceRamp(double value, double bad, double good) {
  return std::clamp((value - bad) / (good - bad), 0.0, 1.0);
}

double shareOnCurve(const std::vector<Point>& path, const Structure& s, float gap_px) {
  int on = 0;
  for (const Point& p : path) {
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    float best = 0;
    for (int v = y - 1; v <= y + 1; ++v) {
      for (int u = x - 1; u <= x + 1; ++u) {
        if (!s.remainingCoverage.inside(u, v)) continue;
        const bool line = s.isOnLine(u, v);
        best = std::max({best, s.remainingCoverage.at(u, v), line ? 0.5F : 0.0F});
      }
    }
    const bool inGap = s.gapDistance.inside(x, y) && s.gapDistance.at(x, y) <= gap_px;
    if (best > 0.35F || inGap) ++on;
  }
  return path.empty() ? 0 : double(on) / double(path.size());
}

/// Share of the path along a straight line of the plot instead of on own pixels.
double shareAlongLines(const std::vector<Point>& path, const Structure& s) {
  int along = 0;
  for (const Point& p : path) {
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    if (!s.remainingCoverage.inside(x, y)) continue;
    if (s.isOnLine(x, y) && s.remainingCoverage.at(x, y) < 0.35F) ++along;
  }
  return path.empty() ? 0 : double(along) / double(path.size());
}

/// Pixels, and those of them on no stroke.
struct Share {
  double all = 0, left = 0;
  void add(bool isLeft) {
    all += 1;
    left += isLeft ? 1 : 0;
  }
  double explained() const { return all > 0 ? 1 - left / all : 0; }
};

double shareExplained(const PlanePair& pair, const Structure& s, const WorkPlane& plane) {
  cv::Mat free(s.remainingCoverage.height, s.remainingCoverage.width, CV_8U, cv::Scalar(1));
  for (const std::vector<Point>* path : {&pair.press, &pair.release}) {
    for (const Point& p : *path) {
      cv::circle(free, cv::Point(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))),
                 static_cast<int>(std::ceil(s.strokeWidth_px / 2)) + 1, cv::Scalar(0), -1);
    }
  }
  const cv::Mat strong = matOf(s.remainingCoverage) > 0.5F;
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(strong, labels, stats, centroids, 8, CV_32S);
  const double longEnough = 0.08 * plane.frame.width();
  Share longOnes, every;
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      const int i = labels.at<int>(y, x);
      if (i == 0 || i >= count) continue;
      const bool left = free.at<unsigned char>(y, x) != 0;
      every.add(left);
      const int extent = std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
      if (extent >= longEnough) longOnes.add(left);
    }
  }
  // Short pieces are mostly remains of letters. But a fine grid cuts the curves themselves, and without a
  // second stroke short pieces may be its dashes.
  const bool shortCounts = pair.release.empty() || longOnes.all < 0.3 * every.all;
  return (shortCounts ? every : longOnes).explained();
}

/// Sum of absolute turns along the path, radian, over steps longer than pixel noise.
double turning(const std::vector<Point>& path) {
  constexpr std::size_t kStep = 6;
  double sum = 0;
  for (std::size_t i = kStep; i + kStep < path.size(); i += kStep) {
    const Point a = path[i] - path[i - kStep], b = path[i + kStep] - path[i];
    sum += std::abs(std::atan2(cross(a, b), dot(a, b)));
  }
  return sum;
}

double meanTrust(const RefinedStroke& stroke) {
  double sum = 0;
  for (double t : stroke.trust) sum += t;
  return stroke.trust.empty() ? 0 : sum / double(stroke.trust.size());
}

}  // namespace

double LoopEvidence::confidence() const {
  return confidenceRamp(onCurve, 0.75, 0.95) * confidenceRamp(explained, 0.25, 0.6) *
         (0.3 + 0.7 * confidenceRamp(fit, 0.15, 0.5)) * steadiness * reach * thinness * together;
}

LoopEvidence judge(const PlanePair& pair, const RefinedPair& refined, const Structure& structure,
                   const WorkPlane& plane) {
  LoopEvidence e;
  const float gap_px = pair.dashed ? 6.0F : 0.5F;  // half a gap between dashes
  const bool hasRelease = !pair.release.empty();
  const auto worse = [&](auto&& of) {
    return hasRelease ? std::min(of(pair.press), of(pair.release)) : of(pair.press);
  };
  e.onCurve = worse([&](const std::vector<Point>& p) { return shareOnCurve(p, structure, gap_px); }) -
              0.5 * (1 - worse([&](const std::vector<Point>& p) {
                       return 1 - std::max(0.0, shareAlongLines(p, structure) - 0.15);
                     }));
  e.explained = shareExplained(pair, structure, plane);
  e.fit =
      hasRelease ? std::min(meanTrust(refined.press), meanTrust(refined.release)) : meanTrust(refined.press);
  e.steadiness = worse([&](const std::vector<Point>& p) { return 1 - confidenceRamp(turning(p), 18, 45); });
  const auto reachOf = [&](const std::vector<Point>& p) {
    return confidenceRamp((p.back().x - p.front().x) / plane.frame.width(), 0.15, 0.55);
  };
  e.reach = pair.locked ? reachOf(pair.press) : worse(reachOf);
  const double side_px = std::min(plane.frame.width(), plane.frame.height()) * plane.scale;
  const double width_px =
      hasRelease ? std::max(refined.press.width_px, refined.release.width_px) : refined.press.width_px;
  e.thinness = 1 - confidenceRamp(width_px / side_px, 0.025, 0.035);
  e.together =
      hasRelease && !pair.locked ? confidenceRamp(sharedTravel(pair.press, pair.release), 0.3, 0.7) : 1;
  return e;
}

}  // namespace detent::importer::trace
