// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "importer/frame/darkness.h"
#include "importer/frame/line_profile.h"
#include "importer/frame/plot_frame.h"

namespace detent::importer {
namespace {

constexpr double alignedWithin_px = 0.6;  // px over the whole side: a frame with less tilt is upright

/// View pixels per pixel of the overview the candidate was found in.
double viewPerOverview(const PageView& view, const Page& page) {
  const Point middle{0.5 * view.raster.width_px, 0.5 * view.raster.height_px};
  return Homography(page.overviewToPage).scaleAt({}) / std::max(1e-6, view.viewToPage.scaleAt(middle));
}

struct Edges {
  EdgeLine left, top, right, bottom;
  int drawn = 0;
};

Edges locateEdges(const cv::Mat& d, const cv::Mat& turnedD, const Box& box, double reach) {
  Edges e;
  const auto edge = [&](const cv::Mat& plane, double at, double from, double to) {
    if (auto line = locateColumnEdge(plane, at, from, to, reach)) {
      ++e.drawn;
      return *line;
    }
    EdgeLine guess;
    guess.at0 = at;
    return guess;
  };
  e.left = edge(d, box.x0, box.y0, box.y1);
  e.right = edge(d, box.x1, box.y0, box.y1);
  e.top = edge(turnedD, box.y0, box.x0, box.x1);
  e.bottom = edge(turnedD, box.y1, box.x0, box.x1);
  return e;
}

/// An edge that is not drawn has the tilt of the opposite one.
void leanTogether(EdgeLine& a, EdgeLine& b, double mid) {
  const auto lean = [mid](EdgeLine& blank, const EdgeLine& drawn) {
    blank.at0 = blank.across(mid) - drawn.slope * mid;
    blank.slope = drawn.slope;
  };
  if (a.support == 0 && b.support > 0) lean(a, b);
  if (b.support == 0 && a.support > 0) lean(b, a);
}

Point crossing(const EdgeLine& column, const EdgeLine& row) {
  // x = c0 + cs·y, y = r0 + rs·x
  const double x = (column.at0 + column.slope * row.at0) / (1 - column.slope * row.slope);
  return {x, row.across(x)};
}

std::vector<GridLine> merged(std::vector<GridLine> lines, const std::vector<GridLine>& ticks, double apart) {
  for (const auto& tick : ticks) {
    const bool known = std::any_of(lines.begin(), lines.end(), [&](const GridLine& l) {
      return std::abs(l.position_px - tick.position_px) <= apart;
    });
    if (!known) lines.push_back(tick);
  }
  std::sort(lines.begin(), lines.end(),
            [](const GridLine& a, const GridLine& b) { return a.position_px < b.position_px; });
  return lines;
}

struct UprightBox {
  double left = 0, top = 0, right = 0, bottom = 0;
  double leftWidth = 1, bottomWidth = 1;
};

/// Gridlines and ticks of the horizontal axis of an upright plane.
std::vector<GridLine> linesAlongX(const cv::Mat& d, double left, double right, double top, double bottom,
                                  double axisWidth) {
  const double half = 0.5 * axisWidth;
  const double depth = std::clamp(0.008 * (bottom - top), 2.0, 8.0);
  auto lines = columnLines(d, left, right, top, bottom);
  lines = merged(std::move(lines), columnTicks(d, left, right, bottom + half + 1, bottom + half + depth), 2);
  return merged(std::move(lines), columnTicks(d, left, right, bottom - half - depth, bottom - half - 1), 2);
}

/// The same for the vertical axis, on the transposed plane; top to bottom.
std::vector<GridLine> linesAlongY(const cv::Mat& transposed, const UprightBox& b) {
  const double half = 0.5 * b.leftWidth;
  const double depth = std::clamp(0.008 * (b.right - b.left), 2.0, 8.0);
  auto lines = columnLines(transposed, b.top, b.bottom, b.left, b.right);
  lines = merged(std::move(lines),
                 columnTicks(transposed, b.top, b.bottom, b.left - half - depth, b.left - half - 1), 2);
  return merged(std::move(lines),
                columnTicks(transposed, b.top, b.bottom, b.left + half + 1, b.left + half + depth), 2);
}

/// An edge that is not drawn is set to the tick next to the ends of the lines.
void settleOpenEdges(PlotFrame& frame, const Edges& e) {
  auto& c = frame.corners;
  const auto nearest = [](const std::vector<GridLine>& lines, double at, double within) {
    double best = at, off = within;
    for (const auto& line : lines)
      if (std::abs(line.position_px - at) <= off) {
        off = std::abs(line.position_px - at);
        best = line.position_px;
      }
    return best;
  };
  const double acrossX = std::max(4.0, 0.01 * (c[2].x - c[3].x)),
               acrossY = std::max(4.0, 0.01 * (c[3].y - c[0].y));
  if (e.left.support == 0) c[0].x = c[3].x = nearest(frame.xLines, c[3].x, acrossX);
  if (e.right.support == 0) c[1].x = c[2].x = nearest(frame.xLines, c[2].x, acrossX);
  if (e.top.support == 0) c[0].y = c[1].y = nearest(frame.yLines, c[0].y, acrossY);
  if (e.bottom.support == 0) c[2].y = c[3].y = nearest(frame.yLines, c[3].y, acrossY);
}

void findLinesUpright(const cv::Mat& d, PlotFrame& frame, const Edges& e) {
  const UprightBox b{frame.corners[0].x, frame.corners[0].y, frame.corners[2].x,
                     frame.corners[2].y, e.left.width_px,    e.bottom.width_px};
  frame.xLines = linesAlongX(d, b.left, b.right, b.top, b.bottom, b.bottomWidth);
  frame.yLines = linesAlongY(d.t(), b);
}

/// Finds lines of a tilted frame through the map that makes its corners upright; positions are mapped back.
void findLinesLeaning(const cv::Mat& d, PlotFrame& frame, const Edges& e) {
  const auto& c = frame.corners;
  const double w = distance(c[2], c[3]), h = distance(c[0], c[3]);
  const double margin = 16;
  const UprightBox b{margin, margin, margin + w, margin + h, e.left.width_px, e.bottom.width_px};
  std::vector<cv::Point2f> from, to{{static_cast<float>(b.left), static_cast<float>(b.top)},
                                    {static_cast<float>(b.right), static_cast<float>(b.top)},
                                    {static_cast<float>(b.right), static_cast<float>(b.bottom)},
                                    {static_cast<float>(b.left), static_cast<float>(b.bottom)}};
  for (const auto& p : c) from.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  const cv::Matx33d upright = cv::getPerspectiveTransform(from, to), inverse = upright.inv();
  Homography back;
  std::copy(inverse.val, inverse.val + 9, back.m.begin());
  cv::Mat plane;
  cv::warpPerspective(d, plane, upright,
                      cv::Size(static_cast<int>(w + 2 * margin), static_cast<int>(h + 2 * margin)),
                      cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  frame.xLines = linesAlongX(plane, b.left, b.right, b.top, b.bottom, b.bottomWidth);
  frame.yLines = linesAlongY(plane.t(), b);
  for (auto& line : frame.xLines) line.position_px = back({line.position_px, b.bottom}).x;
  for (auto& line : frame.yLines) line.position_px = back({b.left, line.position_px}).y;
}

/// Returns true if Agg (matplotlib) rounded the lines. It moves axis-parallel lines of odd rounded width to
/// floor(x + 1/2) + 1/2, half a pixel right and down on average, but keeps their true width: a whole-pixel
/// crest with equal thin rims on every edge. Other programs smooth lines in place, or round the width too.
bool roundedByAgg(const cv::Mat& d, const cv::Mat& turnedD, const Edges& e, const Box& box) {
  std::vector<RimCover> rims;
  const auto add = [&](const cv::Mat& plane, const EdgeLine& edge, double from, double to) {
    if (edge.support == 0 || edge.slope != 0) return;
    if (const auto rim = rimCover(plane, edge.at0, from, to)) rims.push_back(*rim);
  };
  add(d, e.left, box.y0, box.y1);
  add(d, e.right, box.y0, box.y1);
  add(turnedD, e.top, box.x0, box.x1);
  add(turnedD, e.bottom, box.x0, box.x1);
  if (rims.size() < 2) return false;
  constexpr double same = 0.012;  // share of the picture's width
  const double rim = rims.front().left;
  return rim >= 0.02 && rim <= 0.24 && std::all_of(rims.begin(), rims.end(), [&](const RimCover& r) {
           return std::abs(r.left - rim) <= same && std::abs(r.right - rim) <= same && r.beyond <= same;
         });
}

bool isUpright(const PlotFrame& f) {
  const auto& c = f.corners;
  return std::abs(c[0].x - c[3].x) <= alignedWithin_px && std::abs(c[1].x - c[2].x) <= alignedWithin_px &&
         std::abs(c[0].y - c[1].y) <= alignedWithin_px && std::abs(c[3].y - c[2].y) <= alignedWithin_px;
}

/// Corners given by hand stay; only the thickness of the lines there is measured.
PlotFrame givenFrame(const PageView& view, const std::vector<Point>& corners) {
  const Homography toView = view.viewToPage.inverse();
  PlotFrame frame;
  for (std::size_t k = 0; k < 4; ++k) frame.corners[k] = toView(corners[k]);
  return frame;
}

PlotFrame foundFrame(const Edges& e) {
  PlotFrame frame;
  frame.corners = {crossing(e.left, e.top), crossing(e.right, e.top), crossing(e.right, e.bottom),
                   crossing(e.left, e.bottom)};
  return frame;
}

}  // namespace

Result<Found<PlotFrame>> locatePlotFrame(const PageView& view, const Page& page,
                                         const FrameCandidate& candidate, const Progress& progress) {
  const Homography toView = view.viewToPage.inverse().after(candidate.levelToPage);
  const Box box = toView.boxOf(candidate.uprightBox);
  if (view.raster.empty() || box.width() < 16 || box.height() < 16)
    return Failure{FailureCode::noForceGraph,
                   page.source,
                   Message("page %1", page.number),
                   Message("the plot frame is smaller than 16 pixels"),
                   {{RemedyKind::giveFrame, "of a larger region"}}};
  if (progress.isCancelled()) return Failure::cancelled(page.source);
  const bool given = candidate.givenCorners.size() == 4;
  const cv::Mat d = darknessOf(view.raster, candidate.paper);
  const double reach =
      std::clamp(4 * viewPerOverview(view, page), 3.0, 0.02 * std::min(box.width(), box.height()) + 3);
  Edges e = locateEdges(d, d.t(), box, reach);
  leanTogether(e.left, e.right, 0.5 * (box.y0 + box.y1));
  leanTogether(e.top, e.bottom, 0.5 * (box.x0 + box.x1));
  Found<PlotFrame> found;
  auto& frame = found.value;
  frame = given ? givenFrame(view, candidate.givenCorners) : foundFrame(e);
  frame.paper = candidate.paper;
  if (isUpright(frame)) {
    findLinesUpright(d, frame, e);
    if (!given) settleOpenEdges(frame, e);
    if (view.nativePixels && roundedByAgg(d, d.t(), e, frame.box())) frame.drawnOffset_px = {0.5, 0.5};
  } else {
    findLinesLeaning(d, frame, e);
  }
  if (given) {
    found.by = DecidedBy::given;
    found.confidence = 1;
    found.evidence = {{EvidenceCode::frameGiven}};
    return found;
  }
  found.confidence = std::min(1.0, (candidate.byNumbers ? 0.7 : 0.4) + 0.15 * e.drawn);
  found.evidence = {{EvidenceCode::edgesDrawn, {e.drawn, frame.xLines.size(), frame.yLines.size()}}};
  return found;
}

}  // namespace detent::importer
