// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/dashed_beside.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace detent::importer::trace {

namespace {

/// Clears a line and its soft edges; corners between points are rounded.
void clearLine(Plane& plane, const CurveTrace& trace, const PlotArea& area, double thickness_px) {
  constexpr double edge_px = 3;  // of both sides together
  std::vector<cv::Point> line;
  for (const Point& p : trace.points_px) {
    const Point q = area.fromView(p);
    line.emplace_back(static_cast<int>(std::lround(q.x)), static_cast<int>(std::lround(q.y)));
  }
  cv::polylines(matOf(plane), line, false, 0, static_cast<int>(std::ceil(thickness_px + edge_px)));
}

void clearBox(Plane& plane, const Box& box) {
  const cv::Rect whole(0, 0, plane.width, plane.height);
  const cv::Rect within(cv::Point(static_cast<int>(box.x0), static_cast<int>(box.y0)),
                        cv::Point(static_cast<int>(box.x1) + 1, static_cast<int>(box.y1) + 1));
  matOf(plane)(within & whole).setTo(0);
}

/// Share of the coverage on a path.
double shareAt(const CoarseCurve& path, const Plane& own, double within_px) {
  cv::Mat near(own.height, own.width, CV_8U, cv::Scalar(0));
  for (const Point& p : path.points)
    cv::circle(near, {static_cast<int>(p.x), static_cast<int>(p.y)}, static_cast<int>(std::ceil(within_px)),
               255, cv::FILLED);
  const cv::Mat marks = matOf(own);
  const double all = cv::sum(marks)[0];
  cv::Mat at = cv::Mat::zeros(marks.size(), marks.type());
  marks.copyTo(at, near);
  return all > 0 ? cv::sum(at)[0] / all : 0;
}

}  // namespace

std::optional<DashedPath> dashedBeside(const CurveTrace& solid, const CurveColour& curve,
                                       const std::vector<int>& curveColours, const PlotColours& plot) {
  constexpr double leastTravel = 0.5;  // share of the solid line's travel
  // share of the remaining coverage; rims of markers lie on both sides of their line
  constexpr double ownColourShare = 0.6;
  if (curve.dashed || solid.points_px.size() < 2) return {};
  DashedPath found{fieldOf(plot, curve.entryIndex, curveColours), {}};
  clearLine(found.field.own, solid, plot.area(), curve.thickness_px);
  for (const Box& box : found.field.opaque) clearBox(found.field.own, box);
  const std::optional<CurveField> joined = dashesJoined(found.field);
  if (!joined) return {};
  FollowOptions follow;
  follow.thickness_px = curve.thickness_px;
  found.path = followCurve(*joined, plot.area().frame, follow);
  const auto [left, right] = std::ranges::minmax(solid.points_px, {}, &Point::x);
  const double travel_px = plot.area().fromView(right).x - plot.area().fromView(left).x;
  if (!found.path.found() || found.path.span_px < leastTravel * travel_px) return {};
  if (found.path.rise_px <= 2 * curve.thickness_px) return {};  // a marker line along the travel
  if (shareAt(found.path, found.field.own, curve.thickness_px + 1) < ownColourShare) return {};
  found.field = besideDashesOnly(found.field);
  return found;
}

}  // namespace detent::importer::trace
