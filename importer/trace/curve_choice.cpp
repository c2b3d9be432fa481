// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/curve_choice.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "importer/page/pixel_components.h"
#include "importer/trace/colour_shades.h"
#include "importer/trace/dashes.h"
#include "importer/trace/error_bars.h"

namespace detent::importer::trace {

namespace {

constexpr float kGreyChroma = 26;  // colour levels between the largest and the smallest channel

double massOf(const Plane& plane) {
  double sum = 0;
  for (float v : plane.values) sum += static_cast<double>(v);
  return sum;
}

/// Calls `visit(x, y)` for every pixel within `reach` of a path; pixels may be visited several times.
template <class Visit>
void forPixelsNear(const Plane& plane, const std::vector<Point>& path, double reach, Visit visit) {
  const int r = static_cast<int>(std::ceil(reach));
  for (Point p : path) {
    const int cx = static_cast<int>(p.x), cy = static_cast<int>(p.y);
    for (int y = cy - r; y <= cy + r; ++y)
      for (int x = cx - r; x <= cx + r; ++x)
        if (plane.inside(x, y)) visit(x, y);
  }
}

/// Clears the coverage within `reach` of a path and returns its sum.
double eraseAlong(Plane& plane, const std::vector<Point>& path, double reach) {
  double erased = 0;
  forPixelsNear(plane, path, reach, [&](int x, int y) {
    erased += static_cast<double>(plane.at(x, y));
    plane.at(x, y) = 0;
  });
  return erased;
}

/// Clears coverage on letters; the mask is `pooling` times as fine as the plane.
void clearLetters(Plane& plane, const Mask& letters, int maskWidth, int pooling) {
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (!letters[i]) continue;
    const int x = static_cast<int>(i % static_cast<std::size_t>(maskWidth));
    const int y = static_cast<int>(i / static_cast<std::size_t>(maskWidth));
    plane.at(x / pooling, y / pooling) = 0;
  }
}

/// Number of columns with coverage.
double inkedColumns(const Plane& plane) {
  std::vector<char> inked(static_cast<std::size_t>(plane.width), 0);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x)
      if (plane.at(x, y) > 0.3F) inked[static_cast<std::size_t>(x)] = 1;
  return static_cast<double>(std::count(inked.begin(), inked.end(), 1));
}

/// Share of a curve's path that runs within some widths of another one's and some pooled pixels more.
double shareAlong(const PlotColours& plot, const CurveColour& curve, const CurveColour& other, double widths,
                  double more_px) {
  const Plane& area = plot.coverage.unknown;
  Plane near((area.width - 1) / curve.pooling + 1, (area.height - 1) / curve.pooling + 1);
  forPixelsNear(near, other.path.points, widths * other.thickness_px / other.pooling + more_px,
                [&](int x, int y) { near.at(x, y) = 1; });
  double inside = 0;
  for (Point p : curve.path.points)
    inside += static_cast<double>(near.at(static_cast<int>(p.x), static_cast<int>(p.y)));
  return inside / static_cast<double>(std::max<std::size_t>(1, curve.path.points.size()));
}

/// Returns true for a horizontal or vertical line: a marker line, an axis or a leader, never a force curve.
bool isAxisParallel(const CoarseCurve& path, double thickness) {
  return path.rise_px <= 1.5 * thickness + 1 || path.span_px <= 1.5 * thickness + 1;
}

/// Returns true if the path stays within a line's width of the chord between its ends.
bool isStraight(const CoarseCurve& path, double thickness) {
  const Point a = path.points.front(), b = path.points.back();
  const double length = std::max(1.0, distance(a, b));
  return std::all_of(path.points.begin(), path.points.end(),
                     [&](Point p) { return std::abs(cross(p - a, b - a)) / length <= thickness + 2; });
}

/// Rightmost point of the path, in the area's pixels.
Point tipOf(const CurveColour& curve) {
  return static_cast<double>(curve.pooling) * *std::ranges::max_element(curve.path.points, {}, &Point::x);
}

/// Returns true if a short curve ends where a long one does, like the release of a latching key. On a
/// bottom-out, ends lie where a covering line leaves them visible. Leaders are straight.
bool leadsBackFrom(const CurveColour& press, const CurveColour& other, const Box& frame) {
  constexpr double near_px = 4, alongBottomOut = 0.08;  // of the frame's height
  const Point apart = tipOf(press) - tipOf(other);
  const double within_px = near_px + press.thickness_px + other.thickness_px;
  return std::abs(apart.x) <= within_px && std::abs(apart.y) <= within_px + alongBottomOut * frame.height() &&
         !isStraight(other.path, other.thickness_px / other.pooling + 1);
}

Box scaled(const Box& box, double by) { return {box.x0 * by, box.y0 * by, box.x1 * by, box.y1 * by}; }

/// Line thickness on the planes of the path search; pooling by maxima widens lines.
double pooledThickness(const CurveColour& curve) {
  return curve.thickness_px / curve.pooling + (curve.pooling > 1 ? 1 : 0);
}

CurveField pooledField(const CurveField& field, int factor) {
  if (factor == 1) return field;
  CurveField out{
      pooled(field.own, factor), pooled(field.otherCurves, factor), pooled(field.clutter, factor), {}};
  for (const Box& box : field.opaque) out.opaque.push_back(scaled(box, 1.0 / factor));
  return out;
}

/// Returns true if a line is long, visible and curved enough to be a force curve. `explained`: share of the
/// colour's pixels on the line; the colour of text and frame draws other things too, often dashed, unless
/// most of it is this line.
bool isCurve(const CoarseCurve& path, const Box& frame, double thickness, bool neutral, double explained,
             const CurveChoiceOptions& options) {
  if (!path.found() || path.span_px < options.minSpan * frame.width() ||
      path.gain_px < options.minSpan * frame.width())
    return false;
  const bool drawsOthers = neutral && explained < options.minOwnShare;
  if (path.coveredShare < (drawsOthers ? options.minCoveredShareNeutral : options.minCoveredShare))
    return false;
  if (path.coveredColumns_px < options.minOwnColumns * path.span_px) return false;
  return !isAxisParallel(path, thickness) && !(neutral && isStraight(path, thickness));
}

/// The best line on `search`, with its second strand measured on `full`; `explained`: share of the colour's
/// pixels of both.
void followColour(CurveColour& curve, const CurveField& search, const CurveField& full,
                  const PlotColours& plot, double& explained) {
  const Box frame = scaled(plot.area().frame, 1.0 / curve.pooling);
  FollowOptions options;
  options.thickness_px = curve.thickness_px;  // pooling by maxima keeps full coverage on a ridge
  curve.path = followCurve(pooledField(search, curve.pooling), frame, options);
  Plane own = pooled(full.own, curve.pooling);
  const double thickness = pooledThickness(curve), mass = massOf(own);
  double accounted = eraseAlong(own, curve.path.points, thickness + 2);
  // Coverage close to the line is markers, spikes and its own edges; coverage far from it is another line.
  Plane rest = own;
  clearLetters(rest, plot.scene.lettering().mask, full.own.width, curve.pooling);
  eraseAlong(rest, curve.path.points, std::max(thickness + 2, plot.options.strandsApart * frame.height()));
  curve.secondStrand = inkedColumns(rest) / std::max(1.0, curve.path.coveredColumns_px);
  if (curve.secondStrand > plot.options.secondStrand) accounted += massOf(own);
  explained = mass > 0 ? accounted / mass : 0;
}

/// The best line in a colour. Pieces are joined as dashes if the joined line then holds most of the colour.
CurveColour bestLine(const PlotColours& plot, int index, bool neutral, double& explained) {
  std::vector<int> others;
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k)
    if (k != index) others.push_back(k);
  CurveColour curve;
  curve.entryIndex = index;
  curve.neutral = neutral;
  curve.pooling = std::max(1, static_cast<int>(plot.area().frame.width() / 260));
  const CurveField full = fieldOf(plot, index, others);
  curve.thickness_px = lineThickness(full.own);
  followColour(curve, full, full, plot, explained);
  if (curve.path.coveredShare >= plot.options.solidColour) return curve;
  const std::optional<CurveField> joined = dashesJoined(full);
  if (!joined) return curve;
  CurveColour dashed = curve;
  double ofDashes = 0;
  followColour(dashed, *joined, full, plot, ofDashes);
  if (ofDashes < plot.options.minOwnShare || dashed.secondStrand > plot.options.secondStrand) return curve;
  dashed.dashed = true;
  explained = ofDashes;
  return dashed;
}

/// Returns true if the coverage is wider than any line: a tolerance band, or the area under a curve. A marker
/// is as wide, but shorter.
bool isFilledArea(const PlotColours& plot, int index) {
  constexpr float kInked = 0.4F;  // coverage
  constexpr int kLeastWidth_px = 7;
  constexpr double kMarker = 0.08;  // share of the frame's smaller side, at most
  const Plane& own = plot.coverage.planes[static_cast<std::size_t>(index)];
  const double side_px = std::min(plot.area().frame.width(), plot.area().frame.height());
  const int width_px = std::max(kLeastWidth_px, static_cast<int>(plot.options.fillWidth * side_px));
  const cv::Mat inked = matOf(own) > kInked;
  cv::Mat dilated, labels, stats, centroids;
  cv::morphologyEx(inked, dilated, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_RECT, {width_px, width_px}));
  const int count = cv::connectedComponentsWithStats(dilated, labels, stats, centroids, 8, CV_32S);
  double filled = 0;
  for (int i = 1; i < count; ++i)
    if (std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) >
        kMarker * side_px)
      filled += stats.at<int>(i, cv::CC_STAT_AREA);
  return filled > plot.options.fillShare * cv::countNonZero(inked);
}

std::optional<CurveColour> curveOf(const PlotColours& plot, int index, bool neutral) {
  if (plot.entry(index).mass_px < 0.5 * plot.options.minSpan * plot.area().frame.width()) return {};
  if (isFilledArea(plot, index)) return {};
  double explained = 0;
  CurveColour curve = bestLine(plot, index, neutral, explained);
  const Box frame = scaled(plot.area().frame, 1.0 / curve.pooling);
  if (!isCurve(curve.path, frame, pooledThickness(curve), neutral, explained, plot.options) ||
      explained < plot.options.minExplained)
    return {};
  return curve;
}

float hueCosine(const PlotColours& plot, const CurveColour& a, const CurveColour& b) {
  return dot(plot.entry(a.entryIndex).direction, plot.entry(b.entryIndex).direction);
}

constexpr float kSameHue = 0.95F;  // cosine between differences to the paper

/// Share of the path over which two colours of one hue draw one line: shades of compressed colour, markers, a
/// shadow; 0 otherwise.
double sharedAsShades(const PlotColours& plot, const CurveColour& one, const CurveColour& other) {
  if (hueCosine(plot, one, other) <= kSameHue) return 0;
  const double along = shareAlong(plot, one, other, 0.5, 1);
  return along > plot.options.haloAlong ? along : 0;
}

/// Merges shades of one line among more than two curves. Two curves are kept: strokes close together may
/// share a hue.
void joinShades(const PlotColours& plot, std::vector<CurveColour>& curves) {
  while (curves.size() > 2) {
    std::size_t from = 0, to = 0;
    double most = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (std::size_t k = 0; k < curves.size(); ++k)
        if (plot.entry(curves[i].entryIndex).strength < plot.entry(curves[k].entryIndex).strength)
          if (const double shared = sharedAsShades(plot, curves[i], curves[k]); shared > most)
            most = shared, from = i, to = k;
    if (most <= 0) return;
    CurveColour &shade = curves[from], &line = curves[to];
    line.shades.insert(line.shades.end(), shade.shades.begin(), shade.shades.end());
    line.shades.push_back(shade.entryIndex);
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(from));
  }
}

/// Returns true for a seam: edge pixels between two touching lines, whose path never leaves these lines, or
/// the pale halo of half-resolution colour, which is as long as its line.
bool isSeam(const PlotColours& plot, const CurveColour& curve, const std::vector<CurveColour>& stronger) {
  const auto strengthOf = [&](const CurveColour& c) {
    return static_cast<double>(plot.entry(c.entryIndex).strength);
  };
  return std::any_of(stronger.begin(), stronger.end(), [&](const CurveColour& other) {
    const double along = shareAlong(plot, curve, other, 1, 2);
    const bool shorter = curve.path.gain_px < 0.6 * other.path.gain_px;
    const bool tint = hueCosine(plot, curve, other) > kSameHue;
    const double most = tint ? plot.options.tintStrength : plot.options.haloStrength;
    const bool paler = strengthOf(curve) < most * strengthOf(other);
    return (shorter && along > 0.75) || (paler && along > plot.options.haloAlong);
  });
}

/// Returns true if a direction lies between two others (within a few degrees), like edges of overlapping
/// lines.
bool isMixtureOf(Color3 direction, Color3 u, Color3 v) {
  const float uv = dot(u, v), du = dot(direction, u), dv = dot(direction, v), determinant = 1 - uv * uv;
  if (determinant < 1e-4F) return true;
  const float a = (du - dv * uv) / determinant, b = (dv - du * uv) / determinant;
  if (a < 0 || b < 0) return false;
  return norm(direction - (a * u + b * v)) < 0.12F;
}

/// Returns true if each curve ends elsewhere than all others, unlike the strokes of one switch.
bool endApart(const std::vector<CurveColour>& curves) {
  constexpr double clear = 0.1;  // share of the longest one's travel
  double travel_px = 0;
  for (const CurveColour& curve : curves) travel_px = std::max(travel_px, curve.pooling * curve.path.span_px);
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(tipOf(curves[i]).x - tipOf(curves[j]).x) <= clear * travel_px) return false;
  return true;
}

/// Returns true if the legend has a key of this colour.
bool hasSample(const PlotColours& plot, int index) {
  return std::ranges::any_of(plot.samples,
                             [&](const LegendSample& sample) { return sample.entryIndex == index; });
}

/// Returns true if a path ends higher than it begins, like a press.
bool rises(const CurveColour& curve) {
  const auto [left, right] = std::ranges::minmax(curve.path.points, {}, &Point::x);
  return right.y < left.y;
}

/// Returns true if a curve is long compared to the best one; leaders and callouts are much shorter.
bool isLongBeside(const CurveColour& best, const CurveColour& curve) {
  return curve.path.span_px >= 0.5 * best.path.span_px && curve.path.gain_px >= 0.4 * best.path.gain_px;
}

/// Returns true if a rising line in the colour of frame and text is one more curve beside others.
bool isOneMore(const PlotColours& plot, const std::vector<CurveColour>& curves, const CurveColour& curve) {
  return isLongBeside(curves.front(), curve) && rises(curve) && !isSeam(plot, curve, curves);
}

/// Returns true if a solid line in its colour runs from the rest position of the other curves as far as they
/// do: another switch. Gridlines, bands and marks of that colour begin elsewhere or leave more beside the
/// line.
bool isLineFromRest(const PlotColours& plot, const std::vector<CurveColour>& curves,
                    const CurveColour& line) {
  // share of the frame, each way; share of the travel of the longest
  constexpr double near = 0.03, leastTravel = 0.9;
  const Box& frame = plot.area().frame;
  const auto startOf = [](const CurveColour& curve) {
    return static_cast<double>(curve.pooling) * *std::ranges::min_element(curve.path.points, {}, &Point::x);
  };
  const Point start = startOf(line);
  double longest_px = 0;
  bool startsThere = false;
  for (const CurveColour& curve : curves) {
    const Point off = startOf(curve) - start;
    startsThere =
        startsThere || (std::abs(off.x) <= near * frame.width() && std::abs(off.y) <= near * frame.height());
    longest_px = std::max(longest_px, curve.pooling * curve.path.span_px);
  }
  return startsThere && line.path.coveredShare >= plot.options.solidColour &&
         line.secondStrand <= plot.options.secondStrand &&
         line.pooling * line.path.span_px >= leastTravel * longest_px;
}

/// Discards faint colour at the edges of letters (sub-pixel rendering) in favour of the text's colour.
void disbelieveFringes(const PlotColours& plot, int index, const std::vector<int>& curveColours,
                       CurveField& field) {
  constexpr int kReach = 2;
  constexpr float kSolid = 0.6F, kBelieved = 0.85F;  // coverages
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    const bool isCurve =
        k == index || std::find(curveColours.begin(), curveColours.end(), k) != curveColours.end();
    if (isCurve || !isNeutral(plot, k)) continue;
    const Plane& text = plot.coverage.planes[static_cast<std::size_t>(k)];
    for (int y = 0; y < text.height; ++y)
      for (int x = 0; x < text.width; ++x) {
        if (text.at(x, y) < kSolid) continue;
        for (int i = std::max(0, x - kReach); i <= std::min(text.width - 1, x + kReach); ++i)
          if (field.own.at(i, y) < kBelieved) field.own.at(i, y) = 0;
      }
  }
}

std::vector<LegendSample> findLegendSamples(const Coverage& coverage, const PlotScene& scene) {
  std::vector<LegendSample> samples;
  const Lettering& text = scene.lettering();
  if (text.rows.empty()) return samples;
  const Raster& r = scene.area().raster;
  Mask inked(text.mask.size());
  for (std::size_t k = 0; k < coverage.planes.size(); ++k) {
    std::transform(
        coverage.planes[k].values.begin(), coverage.planes[k].values.end(), text.mask.begin(), inked.begin(),
        [](float ownCoverage, std::uint8_t letter) { return ownCoverage > 0.25F && letter == 0 ? 1 : 0; });
    const auto width = static_cast<std::size_t>(r.width_px);
    for (const PixelComponent& piece : pixelComponentsOf(inked.data(), r.width_px, r.height_px, width).all) {
      const Box& box = piece.box;
      if (box.width() > 0.25 * scene.area().frame.width() || piece.area_px < 4) continue;
      for (const Box& row : text.rows) {
        const double height = row.height();
        const double gap = std::max(box.x0 - row.x1, row.x0 - box.x1);
        const bool level = std::abs(box.middle().y - row.middle().y) <= 0.4 * height;
        const bool shaped =
            box.height() <= 1.1 * height && box.width() >= 1.5 * box.height() && box.width() >= 0.6 * height;
        if (level && shaped && gap > -1 && gap <= 1.8 * height) {
          samples.push_back({box, static_cast<int>(k), row});
          break;
        }
      }
    }
  }
  return samples;
}

/// Boxes of legends from their keys and texts; drawn over curves they hide them.
std::vector<Box> legendBoxes(const std::vector<LegendSample>& samples) {
  std::vector<Box> boxes;
  for (const LegendSample& sample : samples) {
    // Entries are about two letter heights apart; the box has a margin around them.
    const double margin = 0.9 * sample.text.height();
    const Box entry = sample.box.joined(sample.text);
    const Box grown = entry.grown(margin, margin);
    const auto home =
        std::find_if(boxes.begin(), boxes.end(), [&](const Box& box) { return box.touches(grown); });
    if (home == boxes.end())
      boxes.push_back(grown);
    else
      *home = home->joined(grown);
  }
  return boxes;
}

}  // namespace

namespace {

std::size_t eraseAllErrorBars(std::vector<Plane>& planes) {
  std::size_t bars = 0;
  for (Plane& plane : planes) bars += eraseErrorBars(plane);
  return bars;
}

}  // namespace

PlotColours::PlotColours(const PlotScene& itsScene, std::vector<PaletteColour> itsPalette)
    : scene(itsScene),
      palette(std::move(itsPalette)),
      coverage(unmix(scene, palette)),
      errorBars(eraseAllErrorBars(coverage.planes)),
      samples(findLegendSamples(coverage, scene)) {
  clearPlotLines(coverage.planes, palette, scene, legendBoxes(samples));
}

CurveField fieldOf(const PlotColours& plot, int index, const std::vector<int>& curveColours) {
  const Plane& own = plot.coverage.planes[static_cast<std::size_t>(index)];
  CurveField field{own, Plane(own.width, own.height), plot.coverage.unknown, legendBoxes(plot.samples)};
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    if (k == index) continue;
    const bool isCurve = std::find(curveColours.begin(), curveColours.end(), k) != curveColours.end();
    Plane& target = isCurve ? field.otherCurves : field.clutter;
    const Plane& source = plot.coverage.planes[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < source.values.size(); ++i)
      target.values[i] = std::min(1.0F, target.values[i] + source.values[i]);
  }
  const Mask& letters = plot.scene.lettering().mask;
  for (std::size_t i = 0; i < letters.size(); ++i)
    if (letters[i]) {
      // Edges of letters may have any colour (sub-pixel rendering), so only pixels of full coverage count.
      if (field.own.values[i] < 0.85F) field.own.values[i] = 0;
      field.otherCurves.values[i] = 0;
      field.clutter.values[i] = 1 - std::min(1.0F, field.own.values[i]);
    }
  disbelieveFringes(plot, index, curveColours, field);
  for (const LegendSample& sample : plot.samples)
    for (int y = static_cast<int>(sample.box.y0) - 1; y <= static_cast<int>(sample.box.y1); ++y)
      for (int x = static_cast<int>(sample.box.x0) - 1; x <= static_cast<int>(sample.box.x1); ++x)
        if (field.own.inside(x, y)) field.own.at(x, y) = 0;
  const Mask& masked = plot.area().masked;
  for (std::size_t i = 0; i < masked.size(); ++i)
    if (masked[i]) field.own.values[i] = field.otherCurves.values[i] = 0;
  return field;
}

std::optional<CurveField> dashesJoined(const CurveField& field) {
  std::optional<Plane> own = withDashesJoined(field.own);
  if (!own) return {};
  CurveField joined = field;
  joined.own = std::move(*own);
  return joined;
}

CurveField besideDashesOnly(const CurveField& field) {
  constexpr float kDash = 0.3F;  // coverage
  constexpr int kReach_px = 2;   // from a dash, over its neighbour
  const cv::Mat own = matOf(field.own);
  cv::Mat near;
  cv::dilate(own > kDash, near,
             cv::getStructuringElement(cv::MORPH_RECT, {2 * kReach_px + 1, 2 * kReach_px + 1}));
  CurveField alone = field;
  cv::Mat others = matOf(alone.otherCurves);
  others.setTo(0, near == 0);
  return alone;
}

bool isNeutral(const PlotColours& plot, int index) {
  const PaletteColour& colour = plot.entry(index);
  const Color3 full = plot.scene.paper() + colour.difference();
  const float chroma = std::max({full.r, full.g, full.b}) - std::min({full.r, full.g, full.b});
  return chroma <= kGreyChroma || dot(colour.direction, plot.scene.lineDirection()) > 0.985F;
}

std::vector<PaletteColour> reducedPalette(const PlotColours& plot, std::vector<CurveColour>& curves) {
  std::vector<PaletteColour> palette;
  std::vector<int> shades;
  for (CurveColour& curve : curves) {
    palette.push_back(plot.entry(curve.entryIndex));
    palette.back().isCurve = true;
    shades.insert(shades.end(), curve.shades.begin(), curve.shades.end());
    curve.entryIndex = static_cast<int>(palette.size()) - 1;
  }
  const std::size_t n = palette.size();
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    const PaletteColour& colour = plot.entry(k);
    const bool chosen =
        std::any_of(palette.begin(), palette.begin() + static_cast<std::ptrdiff_t>(n),
                    [&](const PaletteColour& c) { return dot(c.direction, colour.direction) > 0.999F; });
    bool mixture = false;
    for (std::size_t i = 0; i < n && !mixture && !isNeutral(plot, k); ++i)
      for (std::size_t j = 0; j < i && !mixture; ++j)
        mixture = isMixtureOf(colour.direction, palette[i].direction, palette[j].direction);
    const bool shade = std::ranges::find(shades, k) != shades.end();
    if (!chosen && !mixture && !shade) palette.push_back(colour);
  }
  return palette;
}

std::vector<CurveColour> chooseCurveColours(const PlotColours& plot) {
  std::vector<CurveColour> found;
  std::vector<int> neutral;
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    if (isNeutral(plot, k)) {
      neutral.push_back(k);
    } else if (auto curve = curveOf(plot, k, false)) {
      found.push_back(std::move(*curve));
    }
  }
  std::sort(found.begin(), found.end(),
            [](const CurveColour& a, const CurveColour& b) { return a.path.gain_px > b.path.gain_px; });
  const auto strength = [&](const CurveColour& curve) {
    return static_cast<double>(plot.entry(curve.entryIndex).strength);
  };
  std::vector<CurveColour> curves;
  for (CurveColour& curve : found) {
    const bool faint =
        !curves.empty() && strength(curve) < plot.options.minStrength * strength(curves.front());
    if (faint) continue;  // shading of uneven paper
    const bool restOfSomething =
        !curves.empty() && curve.path.gain_px < plot.options.minOfBest * curves.front().path.gain_px;
    if (restOfSomething && (curves.size() > 1 || !leadsBackFrom(curves.front(), curve, plot.area().frame)))
      continue;
    if (!isSeam(plot, curve, curves)) curves.push_back(std::move(curve));
  }
  joinShades(plot, curves);
  const auto isLoop = [&](const CurveColour& curve) {
    return curve.secondStrand > plot.options.secondStrand;
  };
  const bool lone = curves.size() == 1 && !isLoop(curves.front());
  // Loops are separate switches; one more may have the colour of the frame.
  const bool several = curves.size() > 1 && std::ranges::all_of(curves, isLoop);
  for (int k : neutral) {
    // More than two coloured curves are several switches already; beside two, only a line that starts with
    // them is another one.
    const bool expected = lone || several || curves.size() > 2 ||
                          (curves.size() > 1 && (endApart(curves) || hasSample(plot, k)));
    if (!expected && curves.size() < 2) continue;
    auto curve = curveOf(plot, k, true);
    if (!curve || !(expected || isLineFromRest(plot, curves, *curve))) continue;
    // A single coloured curve may have its partner in the colour of the frame.
    if (lone
            ? isLongBeside(curves.front(), *curve) || leadsBackFrom(curves.front(), *curve, plot.area().frame)
            : isOneMore(plot, curves, *curve)) {
      curves.push_back(std::move(*curve));
      break;
    }
  }
  return curves;
}

std::vector<CurveColour> curvesInShades(const PlotColours& plot, int stronger, int paler) {
  const bool neutral = isNeutral(plot, stronger);
  auto strong = curveOf(plot, stronger, neutral), pale = curveOf(plot, paler, neutral);
  const auto isLoop = [&](const CurveColour& curve) {
    return curve.secondStrand > plot.options.secondStrand;
  };
  if (!strong || !pale || isLoop(*strong) || isLoop(*pale)) return {};
  if (!isLongBeside(*strong, *pale) || isSeam(plot, *pale, {*strong})) return {};
  return {std::move(*strong), std::move(*pale)};
}

std::optional<CurveColour> neutralCurveBeside(const PlotColours& plot, const CurveColour& loop) {
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    if (k == loop.entryIndex || !isNeutral(plot, k)) continue;
    auto curve = curveOf(plot, k, true);
    if (curve && isOneMore(plot, {loop}, *curve)) return curve;
  }
  return {};
}

std::vector<CurveColour> curvesOfColours(const PlotColours& plot, const std::vector<int>& colours) {
  std::vector<CurveColour> curves;
  for (int colour : colours) {
    const bool known = std::any_of(curves.begin(), curves.end(),
                                   [&](const CurveColour& c) { return c.entryIndex == colour; });
    if (colour < 0 || known) continue;
    double explained = 0;
    CurveColour curve = bestLine(plot, colour, isNeutral(plot, colour), explained);
    if (curve.path.found()) curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace detent::importer::trace
