// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/explanation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "importer/page/polyline.h"
#include "importer/page/quantile.h"
#include "importer/trace/bottom_outs.h"
#include "importer/trace/colour_coverage.h"
#include "importer/trace/colour_shades.h"
#include "importer/trace/dash_chains.h"
#include "importer/trace/follow_curve.h"
#include "importer/trace/mark_chains.h"
#include "importer/trace/plot_lines.h"
#include "importer/trace/plot_scene.h"
#include "importer/trace/scatter.h"

namespace detent::importer {
namespace {

using namespace trace;

constexpr float kLineCoverage = 0.5F;   // coverage
constexpr double kBesideLine_px = 1.5;  // allowed error of a line's edge
constexpr int kJoined_px = 2;           // pieces closer than this are joined
constexpr std::size_t kMostPoints = 400;

/// One traced curve on the area.
struct Drawn {
  std::vector<Point> points;
  double thickness_px = 1;     ///< a pixel at least
  double colourAcross_px = 1;  ///< pixels of full colour across, at most one pixel
  Rgb color;
  bool fromVector = false;
};

void draw(cv::Mat& mask, const std::vector<Point>& points, double thickness_px) {
  const int width = std::max(1, static_cast<int>(std::ceil(thickness_px)));
  const auto whole = [](Point p) {
    return cv::Point(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
  };
  for (std::size_t i = 1; i < points.size(); ++i)
    cv::line(mask, whole(points[i - 1]), whole(points[i]), cv::Scalar(255), width);
}

void fillExplained(cv::Mat& mask, const Box& box, double grown_px) {
  const Box b = box.grown(grown_px, grown_px);
  const cv::Rect whole(static_cast<int>(b.x0), static_cast<int>(b.y0), static_cast<int>(b.width()) + 1,
                       static_cast<int>(b.height()) + 1);
  const cv::Rect seen = whole & cv::Rect(0, 0, mask.cols, mask.rows);
  if (seen.area() > 0) mask(seen).setTo(255);
}

/// The plot of one result with everything that explains its pixels.
class ExplainedPlot {
 public:
  ExplainedPlot(const PlotScene& scene, const std::vector<CurveTrace>& curves)
      : scene_(scene), area_(scene.area()) {
    if (scene.empty()) return;
    for (const CurveTrace& curve : curves) {
      if (curve.points_px.size() < 2) continue;
      Drawn drawn{{}, 1, 1, curve.color, curve.fromVector};
      for (const Point& p : curve.points_px) drawn.points.push_back(area_.fromView(p));
      // A straight stretch of a document has only two points.
      const double seen = scene.coverageOf(curve.color).thicknessAlong(densified(drawn.points, 1));
      drawn.thickness_px = std::max(1.0, seen);
      drawn.colourAcross_px = std::min(1.0, seen);
      drawn_.push_back(std::move(drawn));
    }
  }

  bool empty() const { return drawn_.empty(); }
  const PlotArea& area() const { return area_; }
  const std::vector<Drawn>& drawn() const { return drawn_; }

  double thickness() const {
    std::vector<double> all;
    for (const Drawn& each : drawn_) all.push_back(each.thickness_px);
    return quantileOf(all, 0.5);
  }

  /// 255 where a curve runs, with its drawn width.
  cv::Mat curves() const {
    cv::Mat mask(area_.raster.height_px, area_.raster.width_px, CV_8U, cv::Scalar(0));
    for (const Drawn& each : drawn_) draw(mask, each.points, each.thickness_px + 2 * kBesideLine_px);
    return mask;
  }

  /// 255 where curves, words, masks and the plot's own lines explain what is drawn.
  cv::Mat explained() const {
    cv::Mat mask = curves();
    for (const Box& word : area_.words) fillExplained(mask, word, 2);
    const Mask& letters = scene_.lettering().mask;
    for (std::size_t i = 0; i < letters.size(); ++i)
      if (letters[i] || (!area_.masked.empty() && area_.masked[i])) mask.data[i] = 255;
    return mask;
  }

  /// Returns true under or close to a word.
  bool mayBeHidden(Point p) const {
    return std::ranges::any_of(area_.words, [&](const Box& word) { return word.grown(4, 4).contains(p); });
  }

  /// Returns true if neither a mark nor a word that could hide one is near.
  bool isBare(Point p) const {
    constexpr int reach = 2;
    constexpr float asPaper = 40;  // colour levels
    if (mayBeHidden(p)) return false;
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    for (int v = y - reach; v <= y + reach; ++v)
      for (int u = x - reach; u <= x + reach; ++u)
        if (!isInside(u, v) || apartFromPaper(u, v) > asPaper) return false;
    return true;
  }

  /// Returns true if a solid curve is missing at a place, as between two dashes at least two pixels apart.
  bool isGap(Point p, const Drawn& curve) const {
    constexpr double reach_px = 0.6, mostOfColour = 0.4;  // px; share of the line's own colour levels
    if (mayBeHidden(p)) return false;
    const double colourLevels = norm(color3Of(curve.color) - scene_.paper());
    for (const Point off : {Point{0, 0}, {reach_px, 0}, {-reach_px, 0}, {0, reach_px}, {0, -reach_px}})
      if (drawnAt(p + off) > mostOfColour * colourLevels) return false;
    // A line thinner than a pixel is paler between two pixels; between dashes there is nothing in either
    // direction.
    return std::min(drawnAcross(p, {1, 0}), drawnAcross(p, {0, 1})) <=
           mostOfColour * colourLevels * curve.colourAcross_px;
  }

  /// 255 where a colour is not explained, without the plot's own lines.
  cv::Mat inked(Rgb color, const cv::Mat& explained) const {
    const ColourOnArea& coverage = scene_.coverageOf(color);
    cv::Mat mask(area_.raster.height_px, area_.raster.width_px, CV_8U, cv::Scalar(0));
    if (!coverage.distinct()) return mask;
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x)
        if (!explained.at<std::uint8_t>(y, x) && coverage.at(x, y) > kLineCoverage)
          mask.at<std::uint8_t>(y, x) = 255;
    for (const double column : area_.columns_px) takeLine(mask, coverage, column, true);
    for (const double row : area_.rows_px) takeLine(mask, coverage, row, false);
    for (const PixelAt p : dottedLines(coverage, scene_)) mask.at<std::uint8_t>(p.y, p.x) = 0;
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x)
        if (mask.at<std::uint8_t>(y, x) && scene_.onLine(x, y) &&
            norm(scene_.pixel(x, y) - scene_.behind(x, y)) < 60)
          mask.at<std::uint8_t>(y, x) = 0;
    return mask;
  }

  /// Contrast of unexplained pixels to paper and gridlines, of any colour, relative to a curve's strength.
  Plane standingOut(const cv::Mat& explained, const Drawn& curve) const {
    Plane out(area_.raster.width_px, area_.raster.height_px);
    const float full = std::max(1.0F, norm(color3Of(curve.color) - scene_.paper()));
    for (int y = 0; y < out.height; ++y)
      for (int x = 0; x < out.width; ++x) {
        if (explained.at<std::uint8_t>(y, x) || scene_.onLine(x, y)) continue;
        const float apart = norm(scene_.pixel(x, y) - scene_.behind(x, y));
        if (apart >= scene_.coverageThreshold()) out.at(x, y) = std::min(1.0F, apart / full);
      }
    for (const PixelAt p : dottedLines(ColourOnArea(out, full), scene_)) out.at(p.x, p.y) = 0;
    return out;
  }

 private:
  bool isInside(int x, int y) const {
    return x >= 0 && y >= 0 && x < area_.raster.width_px && y < area_.raster.height_px;
  }
  /// Colour levels.
  float apartFromPaper(int x, int y) const { return norm(scene_.pixel(x, y) - scene_.paperAt(x, y)); }
  /// Colour levels, summed over three pixels: p and its neighbours at -step and +step.
  double drawnAcross(Point p, Point step) const { return drawnAt(p - step) + drawnAt(p) + drawnAt(p + step); }
  /// Colour levels, interpolated; infinite outside.
  double drawnAt(Point p) const {
    const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
    if (!isInside(x, y) || !isInside(x + 1, y + 1)) return std::numeric_limits<double>::infinity();
    const double u = p.x - x, v = p.y - y;
    return std::lerp(std::lerp(apartFromPaper(x, y), apartFromPaper(x + 1, y), u),
                     std::lerp(apartFromPaper(x, y + 1), apartFromPaper(x + 1, y + 1), u), v);
  }

  /// Clears a line of the plot where it is not thicker than usual.
  void takeLine(cv::Mat& mask, const ColourOnArea& coverage, double at, bool plumb) const {
    const std::vector<double> runs = runsAlong(coverage, area_, at, plumb);
    const double usual = quantileOf(runs, 0.3), most = kLineTimes * std::max(usual, 0.35) + 0.4;
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (runs[i] <= most)
        forPixelsAcross(area_, static_cast<int>(i), at, most, plumb,
                        [&](int x, int y) { mask.at<std::uint8_t>(y, x) = 0; });
  }

  const PlotScene& scene_;
  const PlotArea& area_;
  std::vector<Drawn> drawn_;
};

/// Linear ramp: 0 at `bad`, 1 at `good`.
double ramp(double value, double bad, double good) {
  return std::clamp((value - bad) / (good - bad), 0.0, 1.0);
}

/// End of a curve and the direction out of it.
struct End {
  Point at, ahead;
  double thickness_px = 1;
};

std::vector<End> endsOf(const std::vector<Drawn>& drawn) {
  std::vector<End> ends;
  for (const Drawn& each : drawn) {
    const auto add = [&](bool last) {
      const std::size_t n = each.points.size();
      const auto point = [&](std::size_t i) { return each.points[last ? n - 1 - i : i]; };
      std::size_t i = 1;
      while (i + 1 < n && distance(point(0), point(i)) < 3 * each.thickness_px + 4) ++i;
      const Point along = point(0) - point(i);
      if (norm(along) > 0) ends.push_back({point(0), (1 / norm(along)) * along, each.thickness_px});
    };
    add(false), add(true);
  }
  return ends;
}

/// Returns true for the end at rest, from which a curve rises to the right.
bool isStart(const End& end) { return end.ahead.x < 0 && end.ahead.y > 0; }

/// Returns true if a piece begins at a curve's end and leads away from it, forwards or up like a bottom-out.
bool beginsAt(const std::vector<Point>& pixels, const End& end) {
  constexpr double backwards = -0.2;  // cosine with the curve's direction
  const auto [near, far] = std::ranges::minmax(pixels, {}, [&](Point p) { return distance(p, end.at); });
  const double reach_px = 2 * end.thickness_px + 4;
  if (distance(near, end.at) > reach_px) return false;
  const Point away = far - end.at;
  return dot(away, end.ahead) > backwards * norm(away);
}

Remainder remainderOf(const std::vector<Point>& pixels, const ExplainedPlot& plot,
                      const std::vector<End>& ends) {
  const Box& frame = plot.area().frame;
  const Box box = boundsOf(pixels);
  Remainder r;
  const double extent_px = std::hypot(box.width(), box.height());
  r.box_px = plot.area().toView.boxOf(box);
  r.length = extent_px / std::hypot(frame.width(), frame.height());
  r.width = box.width() / frame.width();
  r.thickness = static_cast<double>(pixels.size()) / std::max(1.0, extent_px) / plot.thickness();
  r.straight = Scatter(pixels).across() < 0.6 * plot.thickness() + 0.8;
  r.atAnEnd = std::ranges::any_of(ends, [&](const End& end) { return beginsAt(pixels, end); });
  const double thin = ramp(r.thickness, 3.5, 2.2) * ramp(r.thickness, 0.2, 0.45);
  const double bent = r.straight ? 0 : ramp(r.width, 0.1, 0.3) * ramp(r.length, 0.12, 0.25);
  const double onwards = r.atAnEnd ? ramp(r.length, 0.03, 0.08) : 0;
  r.likeness = thin * std::max(bent, onwards);
  const std::size_t step = std::max<std::size_t>(1, pixels.size() / kMostPoints);
  for (std::size_t i = 0; i < pixels.size(); i += step) r.pixels_px.push_back(plot.area().toView(pixels[i]));
  return r;
}

/// An isolated dashed line. Those along an axis are marker lines.
Remainder remainderOfDashes(const std::vector<Point>& pixels, const ExplainedPlot& plot,
                            const std::vector<End>& ends) {
  constexpr double alongAxis = 0.05;  // share of the longer side
  Remainder r = remainderOf(pixels, plot, ends);
  const Box box = boundsOf(pixels);
  const bool guide = std::min(box.width(), box.height()) <
                     alongAxis * std::max(box.width(), box.height()) + 2 * plot.thickness();
  r.dashed = true;
  r.likeness = guide ? 0 : r.atAnEnd ? ramp(r.length, 0.03, 0.06) : ramp(r.length, 0.06, 0.14);
  return r;
}

/// Markers above a curve's end that continue it, also vertically.
Remainder remainderOfMarks(const std::vector<Point>& pixels, const ExplainedPlot& plot, const End& end) {
  Remainder r = remainderOf(pixels, plot, {end});
  r.dashed = r.atAnEnd = true;
  r.likeness = ramp(r.length, 0.03, 0.06);
  return r;
}

/// A line above a curve's end that may be its bottom-out.
Remainder remainderOfRise(const UnprovenBottomOut& rise, const ExplainedPlot& plot) {
  std::vector<Point> points;
  for (double y = rise.from.y; y >= rise.to.y; y -= 1) points.push_back({rise.from.x, y});
  Remainder r = remainderOf(points, plot, {});
  r.thickness = rise.thickness_px / plot.thickness();
  r.straight = r.atAnEnd = true;
  r.likeness = 1;
  return r;
}

/// Returns true if the pixels form many similar pieces: dots, joined across gaps of their own size.
bool isDotted(const std::vector<Point>& pixels, const cv::Mat& pieces) {
  constexpr std::size_t fewest = 8;
  constexpr double within = 0.35, most = 0.75;  // of the usual area; share of the pieces
  std::map<int, double> areas;
  for (const Point& p : pixels) areas[pieces.at<int>(static_cast<int>(p.y), static_cast<int>(p.x))] += 1;
  std::vector<double> sizes;
  for (const auto& [piece, area] : areas) sizes.push_back(area);
  const double usual = medianOf(sizes);
  const auto alike =
      std::ranges::count_if(sizes, [&](double area) { return std::abs(area - usual) <= within * usual; });
  return sizes.size() >= fewest && static_cast<double>(alike) >= most * static_cast<double>(sizes.size());
}

std::vector<Rgb> colorsOf(const std::vector<Drawn>& drawn) {
  std::vector<Rgb> colors;
  for (const Drawn& each : drawn)
    if (std::ranges::find(colors, each.color) == colors.end()) colors.push_back(each.color);
  return colors;
}

/// 255 where the curves' colours remain unexplained.
cv::Mat leftOver(const ExplainedPlot& plot) {
  const cv::Mat explained = plot.explained();
  cv::Mat left(explained.size(), CV_8U, cv::Scalar(0));
  for (const Rgb color : colorsOf(plot.drawn())) left |= plot.inked(color, explained);
  return left;
}

Patches patchesOf(const ExplainedPlot& plot, const cv::Mat& left) {
  constexpr int leastSide_px = 5;
  constexpr double timesALine = 1.5;  // thicknesses
  // A drawing's own paths are no rims.
  if (std::ranges::all_of(plot.drawn(), &Drawn::fromVector)) return {};
  double curves_px = 0;
  for (const Drawn& each : plot.drawn()) curves_px += lengthOf(each.points) * each.thickness_px;
  const int side_px = std::max(leastSide_px, static_cast<int>(std::ceil(timesALine * plot.thickness())));
  cv::Mat insides;
  cv::erode(left, insides, cv::getStructuringElement(cv::MORPH_RECT, {side_px, side_px}));
  std::vector<cv::Point> at;
  cv::findNonZero(insides, at);
  if (at.empty() || !(curves_px > 0)) return {};
  const cv::Point middle = at[at.size() / 2];
  return {static_cast<double>(at.size()) / curves_px,
          plot.area().toView(Point{static_cast<double>(middle.x), static_cast<double>(middle.y)})};
}

std::vector<Remainder> remaindersOf(const ExplainedPlot& plot, const cv::Mat& left) {
  constexpr double kLeastLength = 0.03;  // share of the diagonal
  cv::Mat joined, labels, stats, centroids, pieces;
  cv::connectedComponents(left, pieces, 8, CV_32S);
  cv::dilate(left, joined,
             cv::getStructuringElement(cv::MORPH_RECT, {2 * kJoined_px + 1, 2 * kJoined_px + 1}));
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centroids, 8, CV_32S);
  const Box& frame = plot.area().frame;
  const double least_px = kLeastLength * std::hypot(frame.width(), frame.height());
  std::vector<std::vector<Point>> pixelSets(static_cast<std::size_t>(count));
  for (int y = 0; y < left.rows; ++y)
    for (int x = 0; x < left.cols; ++x)
      if (left.at<std::uint8_t>(y, x))
        pixelSets[static_cast<std::size_t>(labels.at<int>(y, x))].push_back({double(x), double(y)});
  const std::vector<End> ends = endsOf(plot.drawn());
  std::vector<Remainder> all;
  for (const std::vector<Point>& pixels : pixelSets) {
    if (pixels.size() < 4) continue;
    const Box box = boundsOf(pixels);
    if (std::hypot(box.width(), box.height()) < least_px) continue;
    all.push_back(remainderOf(pixels, plot, ends));
    all.back().dashed = isDotted(pixels, pieces);
  }
  const auto isGap = [&](Point p) { return plot.isGap(p, plot.drawn().front()); };
  const cv::Mat curves = plot.curves();
  for (const std::vector<Point>& chain : dashChains(left, curves, plot.thickness(), isGap))
    all.push_back(remainderOfDashes(chain, plot, ends));
  std::vector<End> tops;
  std::ranges::remove_copy_if(ends, std::back_inserter(tops), isStart);
  std::vector<Point> positions;
  for (const End& top : tops) positions.push_back(top.at);
  const std::vector<std::vector<Point>> marks = marksUpFrom(positions, left, curves);
  for (std::size_t i = 0; i < tops.size(); ++i)
    if (!marks[i].empty()) all.push_back(remainderOfMarks(marks[i], plot, tops[i]));
  // Connected dashes appear twice; as a dashed line first.
  std::ranges::sort(all, std::greater<>{},
                    [](const Remainder& r) { return std::pair(r.likeness, r.dashed); });
  return all;
}

/// Returns true if the way between two points turns sharply out of the curve before it, or into the curve
/// behind it. Points are a pixel apart; the line's own rim on either side still has the direction of the
/// jump.
bool turnsSharply(const std::vector<Point>& points, std::size_t from, std::size_t to, double thickness_px) {
  constexpr double mostCosine = 0.5;  // turned by 60 degrees
  const auto rim = static_cast<std::size_t>(thickness_px + 4), farRim = 3 * rim;
  const Point across = points[to] - points[from];
  const auto turned = [&](Point along) {
    return norm(along) > 0 && dot(along, across) < mostCosine * norm(along) * norm(across);
  };
  const auto before = [&](std::size_t by) { return points[from > by ? from - by : 0]; };
  const auto behind = [&](std::size_t by) { return points[std::min(to + by, points.size() - 1)]; };
  return turned(before(rim) - before(farRim)) || turned(behind(farRim) - behind(rim));
}

/// Returns true if a curve is solid over a good part of its path where no other runs and no word hides it:
/// over more than a few dashes at once, because there are no more between the last dash and an end.
bool drawnThroughAlone(const ExplainedPlot& plot, const Drawn& curve, const std::vector<Point>& points,
                       const std::vector<Stretch>& dashed, const BareAt& isGap) {
  constexpr double leastShare = 0.1;  // share of the points
  constexpr double fewPaces = 2;      // from one gap to the next
  const double few_px = fewPaces * std::ranges::min(dashed, {}, &Stretch::pace_px).pace_px;
  double alone = 0, run = 0;
  const auto endRun = [&] {
    if (run > few_px) alone += run;
    run = 0;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isDashed =
        std::ranges::any_of(dashed, [&](const Stretch& s) { return s.from <= i && i <= s.to; });
    if (isDashed || isGap(points[i])) {
      endRun();
      continue;
    }
    if (plot.mayBeHidden(points[i])) continue;
    const bool shared = std::ranges::any_of(plot.drawn(), [&](const Drawn& other) {
      return &other != &curve &&
             distance(nearestOn(other.points, points[i]), points[i]) < 2 * curve.thickness_px + 2;
    });
    run += shared ? 0 : 1;
  }
  endRun();
  return alone > leastShare * static_cast<double>(points.size());
}

/// Stretches on which a solid curve runs along a dashed line.
std::vector<TraceJump> overDashes(const ExplainedPlot& plot) {
  constexpr double leastShare = 0.08;  // share of the diagonal
  const Box& frame = plot.area().frame;
  const double diagonal_px = std::hypot(frame.width(), frame.height());
  std::vector<TraceJump> jumps;
  for (const Drawn& each : plot.drawn()) {
    if (each.fromVector) continue;  // pieces of vector paths already show which dashes belong together
    const std::vector<Point> points = densified(each.points, 1);
    const auto isGap = [&](Point p) { return plot.isGap(p, each); };
    std::vector<Stretch> dashed = dashedStretches(points, each.thickness_px, isGap);
    if (dashed.empty() || !drawnThroughAlone(plot, each, points, dashed, isGap)) continue;
    for (const Stretch& s : dashed)
      if (const double length_px = distance(points[s.from], points[s.to]);
          length_px > leastShare * diagonal_px)
        jumps.push_back(
            {plot.area().toView(points[s.from]), plot.area().toView(points[s.to]), length_px / diagonal_px});
  }
  return jumps;
}

std::vector<TraceJump> jumpsOf(const ExplainedPlot& plot) {
  constexpr double kLeastThicknesses = 2, kLeastHeight = 0.03;  // of the frame's
  const Box& frame = plot.area().frame;
  std::vector<TraceJump> jumps = overDashes(plot);
  for (const Drawn& each : plot.drawn()) {
    const std::vector<Point> points = densified(each.points, 1);
    const double least_px = std::max(kLeastThicknesses * each.thickness_px, kLeastHeight * frame.height());
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (!plot.isBare(points[i])) continue;
      std::size_t to = i;
      while (to + 1 < points.size() && plot.isBare(points[to])) ++to;
      const double length_px = distance(points[i - 1], points[to]);
      if (length_px >= least_px && turnsSharply(points, i - 1, to, each.thickness_px))
        jumps.push_back({plot.area().toView(points[i - 1]), plot.area().toView(points[to]),
                         length_px / std::hypot(frame.width(), frame.height())});
      i = to;
    }
  }
  std::ranges::sort(jumps, std::greater<>{}, &TraceJump::length);
  return jumps;
}

/// Returns true for a legend key: horizontal, beside a curve's name, in its row.
bool isSampleOf(const CurveTrace& curve, const Remainder& left) {
  constexpr double farthest = 2.5, longest = 8;  // name heights
  const Box& name = curve.labelBox_px;
  if (!(name.height() > 0)) return false;
  const double gap_px = std::max(name.x0 - left.box_px.x1, left.box_px.x0 - name.x1);
  const double row = left.box_px.middle().y;
  return row > name.y0 && row < name.y1 && left.box_px.height() <= name.height() && gap_px >= 0 &&
         gap_px <= farthest * name.height() && left.box_px.width() <= longest * name.height();
}

/// Clears places that are wide in every direction.
void clearAreas(Plane& plane, int least_px) {
  cv::Mat values = matOf(plane);
  cv::Mat dilated;
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {least_px, least_px});
  cv::morphologyEx(values > 0, dilated, cv::MORPH_OPEN, window);
  cv::dilate(dilated, dilated, window);
  values.setTo(0, dilated);
}

LineBeside lineBeside(const ExplainedPlot& plot) {
  constexpr int blur_px = 2;           // blur of the curve's own edge
  constexpr double mostThickness = 2;  // times the curve's; wider in every direction is an area
  constexpr double columns = 260;      // width to which the plot is pooled, as in the search for curves
  const Drawn& curve = plot.drawn().front();
  cv::Mat explained = plot.explained();
  cv::dilate(explained, explained,
             cv::getStructuringElement(cv::MORPH_RECT, {2 * blur_px + 1, 2 * blur_px + 1}));
  CurveField field{plot.standingOut(explained, curve), {}, {}, {}};
  clearAreas(field.own, static_cast<int>(mostThickness * curve.thickness_px) + blur_px);
  clearStrongLines(field.own);
  const double level = ridgeLevel(field.own);
  if (!(level > 0)) return {};
  for (float& v : field.own.values) v = std::min(1.0F, v / static_cast<float>(level));
  const int pooling = std::max(1, static_cast<int>(plot.area().frame.width() / columns));
  field.own = pooled(field.own, pooling);
  field.otherCurves = field.clutter = Plane(field.own.width, field.own.height);
  const Box& frame = plot.area().frame;
  const CoarseCurve path = followCurve(
      field, {frame.x0 / pooling, frame.y0 / pooling, frame.x1 / pooling, frame.y1 / pooling}, {});
  if (!path.found()) return {};
  const Box travel = boundsOf(curve.points);
  return {path.coveredColumns_px * pooling / std::max(1.0, travel.width()),
          plot.area().toView(static_cast<double>(pooling) * path.points[path.points.size() / 2])};
}

}  // namespace

Explanation explain(const PlotScene& scene, const std::vector<CurveTrace>& curves) {
  const ExplainedPlot plot(scene, curves);
  if (plot.empty()) return {};
  const cv::Mat left = leftOver(plot);
  std::vector<Remainder> remainders = remaindersOf(plot, left);
  for (const UnprovenBottomOut& rise : unprovenBottomOuts(curves, scene))
    // Behind dashes and ends that go on, which are doubted as well; before what is only remarked.
    remainders.insert(
        std::ranges::find_if(remainders,
                             [](const Remainder& r) { return r.likeness < 1 || !(r.dashed || r.atAnEnd); }),
        remainderOfRise(rise, plot));
  std::erase_if(remainders, [&](const Remainder& each) {
    return std::ranges::any_of(curves, [&](const CurveTrace& curve) { return isSampleOf(curve, each); });
  });
  return {std::move(remainders), jumpsOf(plot), patchesOf(plot, left),
          plot.drawn().size() == 1 ? lineBeside(plot) : LineBeside{}};
}

}  // namespace detent::importer
