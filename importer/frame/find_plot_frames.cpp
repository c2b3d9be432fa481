// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "importer/frame/label_rows.h"
#include "importer/frame/labelled_plots.h"
#include "importer/frame/lean.h"
#include "importer/frame/plot_frame.h"
#include "importer/frame/plot_rectangles.h"
#include "importer/frame/straight_lines.h"

namespace detent::importer {
namespace {

/// Properties of the overview that decisions need.
struct Overview {
  cv::Mat darkness;
  double shrink = 1;       ///< overview pixels per pixel of this plane
  Homography levelToPage;  ///< the plane shows the levelled page
  Point origin;            ///< origin of the levelled page, in this plane's pixels

  /// The box on the levelled page.
  Box onLevel(const Box& b, const Affine& overviewToPage) const {
    const double shift = 0.5 * (shrink - 1);
    const auto along = [&](double plane, double from) { return (plane + from) * shrink + shift; };
    return overviewToPage.boxOf(
        {along(b.x0, origin.x), along(b.y0, origin.y), along(b.x1, origin.x), along(b.y1, origin.y)});
  }
};

/// Rotates the plane so that its lines are horizontal and vertical; areas outside the page stay empty.
void standUpright(Overview& o, const Page& page) {
  if (o.levelToPage == Homography{}) return;
  const double s = o.shrink, shift = 0.5 * (s - 1);
  const Affine toPage = page.overviewToPage.after({s, 0, 0, s, shift, shift});
  Homography toPlane = Homography(toPage.inverse()).after(o.levelToPage.after(toPage));
  const Box all = toPlane.inverse().boxOf({0, 0, o.darkness.cols - 1.0, o.darkness.rows - 1.0});
  o.origin = {std::floor(all.x0), std::floor(all.y0)};
  toPlane = toPlane.after(Affine{1, 0, 0, 1, o.origin.x, o.origin.y});
  cv::Mat level;
  cv::warpPerspective(o.darkness, level, cv::Matx33d(toPlane.m.data()),
                      {static_cast<int>(std::ceil(all.x1) - o.origin.x) + 1,
                       static_cast<int>(std::ceil(all.y1) - o.origin.y) + 1},
                      cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar(0));
  o.darkness = level;
}

/// Map from a page scaled by `factor` to the page, between pixel centres.
Affine reducedBy(double factor) {
  const double s = 1 / factor, shift = 0.5 * (s - 1);
  return {s, 0, 0, s, shift, shift};
}

// px; larger pictures are searched at half or quarter size, and frames are then located at full size
constexpr int maxSide_px = 2600;

Overview seen(const Page& page, const FrameSearch& search) {
  Overview o;
  o.darkness = darknessOf(page.overview, search.paper);
  while (std::max(o.darkness.cols, o.darkness.rows) > maxSide_px) {
    cv::Mat even = o.darkness(cv::Rect(0, 0, o.darkness.cols / 2 * 2, o.darkness.rows / 2 * 2)), half;
    cv::resize(even, half, cv::Size(even.cols / 2, even.rows / 2), 0, 0, cv::INTER_AREA);
    o.darkness = half;
    o.shrink *= 2;
  }
  if (page.unit != PageUnit::pixel) return o;
  o.levelToPage = search.levelToPage.value_or(turnedToPage(page, leanOf(o.darkness)));
  if (search.magnification != 1) o.levelToPage = o.levelToPage.after(reducedBy(search.magnification));
  standUpright(o, page);
  return o;
}

/// Orientation of a graph, by the two sides with tick labels.
struct Orientation {
  int quarterTurns = 0;
  int below = 0, left = 0;  ///< regularly spaced labels on either axis
  double worth = 0;
  bool asTurned = false;  ///< labels above or at the right, where those of a rotated page are
};

std::vector<double> turnedPositions(const PlotRectangle& r, int turns, bool alongX) {
  const bool swap = (turns & 1) != 0;
  std::vector<double> out;
  for (const double at : (alongX != swap) ? r.xLines : r.yLines) {
    const Box spot = (alongX != swap) ? Box{at, 0, at, 0} : Box{0, at, 0, at};
    const Box t = turned(spot, turns);
    out.push_back(alongX ? t.x0 : t.y0);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Share of a graph's label glyphs that are taller than wide. If most are, the graph is read along x.
double uprightShare(const LabelRow& a, const LabelRow& b, const std::vector<Box>& glyphs) {
  const auto in = [](const LabelRow& row, Point p) {
    return std::any_of(row.words.begin(), row.words.end(), [&](const Box& w) { return w.contains(p); });
  };
  std::vector<Box> members;
  for (const auto& g : glyphs) {
    const Point middle = g.middle();
    const bool tiny = g.height() < 0.5 * a.height_px || g.height() < 0.5 * b.height_px;  // points, ticks
    if (!tiny && (in(a, middle) || in(b, middle))) members.push_back(g);
  }
  // Touching digits make wide blobs, so only the smaller half of the blobs counts.
  const auto size = [](const Box& g) { return std::max(g.width(), g.height()); };
  std::sort(members.begin(), members.end(), [&](const Box& p, const Box& q) { return size(p) < size(q); });
  members.resize((members.size() + 1) / 2);
  double tall = 0;
  for (const auto& g : members) tall += g.height() > 1.05 * g.width();
  return members.empty() ? 0 : tall / static_cast<double>(members.size());
}

/// Returns true if the labels of both axes have about the same height.
bool sameSize(const LabelRow& a, const LabelRow& b) {
  return a.height_px <= 1.7 * b.height_px + 1 && b.height_px <= 1.7 * a.height_px + 1;
}

/// Glyphs around a rectangle, in the plane's pixels, without its own grid and curves.
std::vector<Box> glyphsAround(const PlotRectangle& r, const cv::Mat& marks) {
  const double mx = 0.4 * r.box.width() + 8, my = 0.4 * r.box.height() + 8;
  const int x0 = std::max(0, static_cast<int>(r.box.x0 - mx)),
            x1 = std::min(marks.cols, static_cast<int>(r.box.x1 + mx) + 1);
  const int y0 = std::max(0, static_cast<int>(r.box.y0 - my)),
            y1 = std::min(marks.rows, static_cast<int>(r.box.y1 + my) + 1);
  const auto shifted = [](std::vector<double> positions, int by) {
    for (auto& p : positions) p -= by;
    return positions;
  };
  const Box inside{r.box.x0 - x0, r.box.y0 - y0, r.box.x1 - x0, r.box.y1 - y0};
  const cv::Mat around = withoutFrameMarks(marks(cv::Rect(x0, y0, x1 - x0, y1 - y0)), inside,
                                           shifted(r.xLines, x0), shifted(r.yLines, y0));
  auto glyphs = glyphBoxes(around, 2, 0.15 * std::min(r.box.width(), r.box.height()) + 8);
  for (auto& g : glyphs) g = {g.x0 + x0, g.y0 + y0, g.x1 + x0, g.y1 + y0};
  return glyphs;
}

/// Possible orientations by the surroundings, likeliest first; empty if it is no graph.
std::vector<Orientation> orientationsOf(const PlotRectangle& r, const cv::Mat& marks) {
  const auto near = glyphsAround(r, marks);
  std::vector<Orientation> ways;
  for (int turns = 0; turns < 4; ++turns) {
    std::vector<Box> upright;
    for (const auto& g : near) upright.push_back(turned(g, turns));
    const auto words = numberBoxes(upright);
    const Box box = turned(r.box, turns);
    auto below = labelsBelow(words, box, turnedPositions(r, turns, true));
    auto left = labelsLeft(words, box, turnedPositions(r, turns, false));
    // The labels of the travel axis may stand above the plot only.
    const bool atTop = turns == 0 && below.regular < 3;
    if (atTop) below = labelsAbove(words, box, turnedPositions(r, turns, true));
    if (below.regular >= 3 && (left.regular < 3 || !sameSize(below, left)))
      left = labelsUpwards(words, box, turnedPositions(r, turns, false));
    // The labels of the force axis may stand at the right only.
    const bool atRight = turns == 0 && below.regular >= 3 && left.regular < 3;
    if (atRight) left = labelsRight(words, box, turnedPositions(r, turns, false));
    // Labels beside the plot may be rotated; their digits then say nothing about the labels below.
    const double share = std::max(uprightShare(below, left, upright), uprightShare(below, below, upright));
    if (std::min(below.regular, left.regular) < 3 || !sameSize(below, left) || share < 0.3) continue;
    // Graphs are upright, rotated on sideways sheets, and hardly ever upside down. One with labels at the top
    // and right counts as upside down until they are read.
    const int handicap = atTop && atRight ? 13 : turns == 0 ? 0 : turns == 2 ? 12 : 4;
    const double worth =
        (0.3 + share) * (2 * std::min(below.regular, left.regular) + below.regular + left.regular - handicap);
    ways.push_back({turns, below.regular, left.regular, worth, atTop || atRight});
  }
  std::sort(ways.begin(), ways.end(),
            [](const Orientation& a, const Orientation& b) { return a.worth > b.worth; });
  // Reading the labels decides about a rotated orientation, so the upright one stays a candidate. The reverse
  // holds for an upright one whose labels stand where those of a rotated page do.
  const auto isTurned = [](const Orientation& w) { return w.quarterTurns != 0; };
  const auto likeliest = std::ranges::find_if(ways, isTurned);
  if (likeliest == ways.end()) return ways;
  if (!isTurned(ways.front()) && !ways.front().asTurned) return {ways.front()};
  const int turns = likeliest->quarterTurns;
  std::erase_if(ways, [&](const Orientation& w) { return isTurned(w) && w.quarterTurns != turns; });
  return ways;
}

/// Bounds of the whole levelled page.
Box pageBounds(const Page& page, const Homography& levelToPage) {
  const Box bounds = page.unit == PageUnit::pixel ? Box{-0.5, -0.5, page.width - 0.5, page.height - 0.5}
                                                  : Box{0, 0, page.width, page.height};
  return levelToPage.inverse().boxOf(bounds);
}

/// A candidate at a place of the plane.
FrameCandidate candidateAt(const Box& place, const Overview& o, const Page& page, int turns, PaperBy paper) {
  FrameCandidate c;
  c.levelToPage = o.levelToPage;
  c.uprightBox = o.onLevel(place, page.overviewToPage);
  c.pageBox = o.levelToPage.boxOf(c.uprightBox);
  c.quarterTurns = turns;
  c.paper = paper;
  return c;
}

/// Region with room for tick labels, titles and a legend, relative to the upright graph.
Box regionAround(const Box& frame, int turns, const Box& page) {
  const Box up = turned(frame, turns);
  const double w = up.width(), h = up.height();
  return turned({up.x0 - 0.45 * w, up.y0 - 0.6 * h, up.x1 + 0.5 * w, up.y1 + 0.45 * h}, 4 - turns)
      .common(page);
}

double overlapShare(const Box& a, const Box& b) {
  const Box common = a.common(b);
  return common.empty() ? 0 : common.area() / std::min(a.area(), b.area());
}

struct Scored {
  Found<FrameCandidate> candidate;
  double score = 0;
  double rectangleScore = 0;
};

/// Returns true if `outer` leaves room on all sides. Parts of a grid share an edge with it.
bool surrounds(const Box& outer, const Box& inner) {
  const double mx = 0.03 * outer.width(), my = 0.03 * outer.height();
  return inner.x0 > outer.x0 + mx && inner.x1 < outer.x1 - mx && inner.y0 > outer.y0 + my &&
         inner.y1 < outer.y1 - my;
}

/// Removes borders of the sheet: a candidate that surrounds another one of about the same score.
void dropBorders(std::vector<Scored>& all) {
  std::vector<bool> border;
  for (const auto& outer : all)
    border.push_back(std::any_of(all.begin(), all.end(), [&](const Scored& inner) {
      return surrounds(outer.candidate.value.pageBox, inner.candidate.value.pageBox) &&
             inner.rectangleScore > outer.rectangleScore - 1.5;
    }));
  std::size_t k = 0;
  std::erase_if(all, [&](const Scored&) { return border[k++]; });
}

std::vector<Scored> withoutOverlaps(std::vector<Scored> all) {
  dropBorders(all);
  std::sort(all.begin(), all.end(), [](const Scored& a, const Scored& b) { return a.score > b.score; });
  std::vector<Scored> kept;
  for (auto& s : all) {
    const bool taken = std::any_of(kept.begin(), kept.end(), [&](const Scored& k) {
      const bool otherWayUp = k.candidate.value.pageBox == s.candidate.value.pageBox;
      return !otherWayUp && overlapShare(k.candidate.value.pageBox, s.candidate.value.pageBox) > 0.3;
    });
    if (!taken) kept.push_back(std::move(s));
  }
  return kept;
}

bool readsBefore(const Scored& a, const Scored& b) {
  const Box &p = a.candidate.value.pageBox, &q = b.candidate.value.pageBox;
  if (std::abs(p.y0 - q.y0) > 0.5 * std::min(p.height(), q.height())) return p.y0 < q.y0;
  return p.x0 < q.x0;
}

}  // namespace

Box PlotFrame::box() const {
  Box b{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
  for (const auto& c : corners)
    b = {std::min(b.x0, c.x), std::min(b.y0, c.y), std::max(b.x1, c.x), std::max(b.y1, c.y)};
  return b;
}

std::vector<Found<FrameCandidate>> findPlotFrames(const Page& page, const FrameSearch& search,
                                                  const Progress& progress) {
  if (page.overview.width_px < 32 || page.overview.height_px < 32) return {};
  const Overview o = seen(page, search);
  const bool picture = page.unit == PageUnit::pixel;
  const double side = std::max(o.darkness.cols, o.darkness.rows);
  const double minSide = std::max(36.0, (picture ? 0.1 : 0.04) * side);
  const auto lines = findStraightLines(o.darkness, std::max(16.0, 0.35 * minSide), 4);
  if (progress.isCancelled()) return {};
  auto rectangles = findPlotRectangles(lines, minSide, 0.7 * minSide);
  if (rectangles.empty()) return {};

  const cv::Mat marks = darkMaskOf(o.darkness);
  std::vector<Scored> all;
  for (const auto& r : rectangles)
    for (const auto& way : orientationsOf(r, marks)) {
      Scored s;
      auto& c = s.candidate.value;
      c = candidateAt(r.box, o, page, way.quarterTurns, search.paper);
      c.regionBox = regionAround(c.uprightBox, way.quarterTurns, pageBounds(page, o.levelToPage));
      s.rectangleScore = r.score;
      s.score = r.score + 0.5 * std::min(12, way.below + way.left);
      s.candidate.confidence =
          std::clamp(0.5 + 0.1 * (std::min(way.below, way.left) - 2) + 0.05 * (r.score - 5), 0.2, 1.0);
      s.candidate.evidence = {{EvidenceCode::labelsAroundBox, {way.below, way.left}}};
      all.push_back(std::move(s));
    }
  all = withoutOverlaps(std::move(all));
  if (picture && all.size() == 1) all.front().candidate.value.regionBox = pageBounds(page, o.levelToPage);
  std::sort(all.begin(), all.end(), readsBefore);
  std::vector<Found<FrameCandidate>> found;
  for (auto& s : all) found.push_back(std::move(s.candidate));
  return found;
}

std::vector<Found<FrameCandidate>> findPlotsByNumbers(const Page& page, const FrameSearch& search,
                                                      const Progress& progress) {
  if (page.overview.width_px < 32 || page.overview.height_px < 32) return {};
  const Overview o = seen(page, {PaperBy::region, search.levelToPage, search.magnification});
  if (progress.isCancelled()) return {};
  const double minSide = std::max(36.0, 0.1 * std::max(o.darkness.cols, o.darkness.rows));
  const auto plots = findLabelledPlots(darkMaskOf(o.darkness), minSide, 0.7 * minSide);
  std::vector<Found<FrameCandidate>> found;
  for (const LabelledPlot& plot : plots) {
    Found<FrameCandidate> candidate;
    auto& c = candidate.value;
    c = candidateAt(plot.box, o, page, 0, PaperBy::region);
    const Box bounds = pageBounds(page, o.levelToPage);
    c.regionBox =
        plots.size() == 1 && page.unit == PageUnit::pixel ? bounds : regionAround(c.uprightBox, 0, bounds);
    c.byNumbers = true;
    candidate.confidence = std::clamp(0.45 + 0.1 * (std::min(plot.below, plot.left) - 2), 0.2, 0.95);
    candidate.evidence = {{EvidenceCode::numbersAlone, {plot.below, plot.left}}};
    found.push_back(std::move(candidate));
  }
  return found;
}

FrameCandidate magnified(FrameCandidate candidate, double magnification) {
  const Affine reduced = reducedBy(magnification), enlarged = reduced.inverse();
  candidate.levelToPage = candidate.levelToPage.after(reduced);
  candidate.uprightBox = enlarged.boxOf(candidate.uprightBox);
  candidate.regionBox = enlarged.boxOf(candidate.regionBox);
  return candidate;
}

}  // namespace detent::importer
