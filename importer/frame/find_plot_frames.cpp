#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "importer/frame/label_rows.h"
#include "importer/frame/plot_frame.h"
#include "importer/frame/plot_rectangles.h"
#include "importer/frame/straight_lines.h"

namespace detent::importer {
namespace {

/// Everything seen on the overview that a decision needs.
struct Overview {
  cv::Mat darkness;
  double shrink = 1;  ///< overview pixels per pixel of this plane
  std::vector<Box> glyphs;
};

constexpr int maxSide_px =
    2600;  // larger pictures are searched at half or quarter size; locating is done in full

Overview seen(const Page& page) {
  Overview o;
  o.darkness = darknessOf(page.overview);
  while (std::max(o.darkness.cols, o.darkness.rows) > maxSide_px) {
    cv::Mat even = o.darkness(cv::Rect(0, 0, o.darkness.cols / 2 * 2, o.darkness.rows / 2 * 2)), half;
    cv::resize(even, half, cv::Size(even.cols / 2, even.rows / 2), 0, 0, cv::INTER_AREA);
    o.darkness = half;
    o.shrink *= 2;
  }
  return o;
}

/// Which way up, told by the two sides that carry numbers.
struct Orientation {
  int quarterTurns = 0;
  int below = 0, left = 0;  ///< regular labels on either axis
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

Orientation orientationOf(const PlotRectangle& r, const std::vector<Box>& glyphs) {
  std::vector<Box> near;
  const double mx = 0.4 * r.box.width(), my = 0.4 * r.box.height();
  const double largest = 0.15 * std::min(r.box.width(), r.box.height()) + 8;
  for (const auto& g : glyphs)
    if (g.x1 > r.box.x0 - mx && g.x0 < r.box.x1 + mx && g.y1 > r.box.y0 - my && g.y0 < r.box.y1 + my &&
        std::max(g.width(), g.height()) <= largest)
      near.push_back(g);
  Orientation best;
  for (int turns = 0; turns < 4; ++turns) {
    std::vector<Box> upright;
    for (const auto& g : near) upright.push_back(turned(g, turns));
    const auto words = wordBoxes(std::move(upright), 0.45);
    const Box box = turned(r.box, turns);
    const int below = labelsBelow(words, box, turnedPositions(r, turns, true)).regular;
    const int left = labelsLeft(words, box, turnedPositions(r, turns, false)).regular;
    // Upright graphs are the rule: another way up needs clearly more labels.
    const int bias = best.quarterTurns == 0 && turns > 0 ? 1 : 0;
    if (std::min(below, left) > std::min(best.below, best.left) + bias ||
        (std::min(below, left) >= std::min(best.below, best.left) &&
         below + left > best.below + best.left + 2 * bias))
      best = {turns, below, left};
  }
  return best;
}

Box scaledToPage(const Box& b, double shrink, const Affine& toPage) {
  const double shift = 0.5 * (shrink - 1);
  const Point p = toPage({b.x0 * shrink + shift, b.y0 * shrink + shift}),
              q = toPage({b.x1 * shrink + shift, b.y1 * shrink + shift});
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

Box pageBounds(const Page& page) {
  return page.unit == PageUnit::pixel ? Box{-0.5, -0.5, page.width - 0.5, page.height - 0.5}
                                      : Box{0, 0, page.width, page.height};
}

Box clipped(const Box& b, const Box& to) {
  return {std::max(b.x0, to.x0), std::max(b.y0, to.y0), std::min(b.x1, to.x1), std::min(b.y1, to.y1)};
}

/// Room for tick labels, titles and a legend, in the graph's own upright sense.
Box regionAround(const Box& frame, int turns, const Box& page) {
  const Box up = turned(frame, turns);
  const double w = up.width(), h = up.height();
  return clipped(turned({up.x0 - 0.45 * w, up.y0 - 0.4 * h, up.x1 + 0.5 * w, up.y1 + 0.45 * h}, 4 - turns),
                 page);
}

double overlapShare(const Box& a, const Box& b) {
  const Box c = clipped(a, b);
  return c.empty() ? 0 : c.width() * c.height() / std::min(a.width() * a.height(), b.width() * b.height());
}

struct Scored {
  Found<FrameCandidate> candidate;
  double score = 0;
};

std::vector<Scored> withoutOverlaps(std::vector<Scored> all) {
  std::sort(all.begin(), all.end(), [](const Scored& a, const Scored& b) { return a.score > b.score; });
  std::vector<Scored> kept;
  for (auto& s : all) {
    const bool taken = std::any_of(kept.begin(), kept.end(), [&](const Scored& k) {
      return overlapShare(k.candidate.value.pageBox, s.candidate.value.pageBox) > 0.3;
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

std::vector<Found<FrameCandidate>> findPlotFrames(const Page& page, const Document&,
                                                  const Progress& progress) {
  if (page.overview.width_px < 32 || page.overview.height_px < 32) return {};
  Overview o = seen(page);
  const bool picture = page.unit == PageUnit::pixel;
  const double side = std::max(o.darkness.cols, o.darkness.rows);
  const double minSide = std::max(36.0, (picture ? 0.1 : 0.04) * side);
  const auto lines = findStraightLines(o.darkness, std::max(16.0, 0.35 * minSide), 4);
  if (progress.isCancelled()) return {};
  auto rectangles = findPlotRectangles(lines, minSide, 0.7 * minSide);
  if (rectangles.empty()) return {};
  o.glyphs = glyphBoxes(o.darkness, 3, 0.12 * side);

  std::vector<Scored> all;
  for (const auto& r : rectangles) {
    const auto way = orientationOf(r, o.glyphs);
    const int fewer = std::min(way.below, way.left);
    if (fewer < 3) continue;
    Scored s;
    auto& c = s.candidate.value;
    c.pageBox = scaledToPage(r.box, o.shrink, page.overviewToPage);
    c.quarterTurns = way.quarterTurns;
    c.regionBox = regionAround(c.pageBox, way.quarterTurns, pageBounds(page));
    s.score = r.score + 0.5 * std::min(12, way.below + way.left);
    s.candidate.confidence = std::clamp(0.5 + 0.1 * (fewer - 2) + 0.05 * (r.score - 5), 0.2, 1.0);
    s.candidate.evidence = std::to_string(way.below) + " labels below and " + std::to_string(way.left) +
                           " beside a rectangle of lines";
    all.push_back(std::move(s));
  }
  all = withoutOverlaps(std::move(all));
  if (picture && all.size() == 1) all.front().candidate.value.regionBox = pageBounds(page);
  std::sort(all.begin(), all.end(), readsBefore);
  std::vector<Found<FrameCandidate>> found;
  for (auto& s : all) found.push_back(std::move(s.candidate));
  return found;
}

}  // namespace detent::importer
