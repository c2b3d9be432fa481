// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "importer/axes/axis_labels.h"
#include "importer/axes/button_sizes.h"
#include "importer/axes/text_source.h"
#include "importer/lexicon/printed_unit.h"
#include "importer/lexicon/stroke_words.h"
#include "importer/page/polyline.h"
#include "importer/page/same_colour.h"
#include "importer/strokes/legend.h"
#include "importer/wider_frame.h"

namespace detent::importer {
namespace {

// Largest confidence of a doubted import. Below `confidenceBar`: refused unless the user lowers the bar;
// above: reported as a remark.
constexpr double contradicted = 0.2;  // the page contradicts the reading
constexpr double unconfirmed = 0.4;   // the page does not confirm the reading
constexpr double inPart = 0.6;        // the reading is right but incomplete: reported, not refused

constexpr std::size_t mostTactilePoints = 6;  // a camera shutter has two per stroke
constexpr double leastTurn = 0.06;            // share of the force span: a force meter's noise is smaller
// share of the stroke's span: the start of a trace is noisier than its middle
constexpr double negativeShare = 0.05;
constexpr double sameLineShare = 0.005, sameLineLength = 0.8;   // share of the span; share of the release
constexpr double alongAxisShare = 0.5, alongAxisWithin_px = 1;  // share of the stroke's length
constexpr double endFallShare = 0.4;                            // share of the force span
constexpr double startShare = 0.1;  // share of the travel: a force that is largest there pulls, like a magnet
constexpr double pictureEdge_px = 2.5;
constexpr double leastSharedTravel = 0.35;  // the release of a latching key has half of the press' travel
// A button that springs back does so to the end. A release that stops half-way, near the press, was traced
// incompletely. Share of the travel; share of the press' force there.
constexpr double wholeTravel = 0.7, forceLeftAtEnd = 0.75;
// The release of a self-locking button ends half-way without force, and the names in a drawing say so.
constexpr double atRest = 0.1;  // share of the press' force there

bool confirmedBySpec(const std::vector<SpecCheck>& checks, Axis axis) {
  return std::any_of(checks.begin(), checks.end(),
                     [&](const SpecCheck& c) { return c.spec.isForce() == (axis == Axis::y) && c.agrees; });
}

/// Smallest and largest of one coordinate.
struct Extent {
  double low = 0, high = 0;
  double span() const { return high - low; }
};

template <class Points, class Coordinate>
Extent extentOf(const Points& points, Coordinate of) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [&](const auto& a, const auto& b) { return of(a) < of(b); });
  return {of(*low), of(*high)};
}

Extent travelOf(const StrokePoints& s) {
  return extentOf(s.points, [](const CurvePoint& p) { return p.displacement_mm; });
}

Extent forceOf(const StrokePoints& s) {
  return extentOf(s.points, [](const CurvePoint& p) { return p.force_N; });
}

/// Returns true if a point lies on a polyline, within a distance.
bool liesOn(const Polyline& line, Point p, double within_px) {
  return !line.empty() && distance(nearestOn(line, p), p) <= within_px;
}

/// Share of a line that runs on another, checked at a few hundred points.
double shareOn(const std::vector<Point>& other, const std::vector<Point>& line, double within_px) {
  if (other.size() < 2 || line.empty()) return 0;
  const std::size_t step = std::max<std::size_t>(1, line.size() / 300);
  double near = 0, all = 0;
  for (std::size_t i = 0; i < line.size(); i += step, all += 1) near += liesOn(other, line[i], within_px);
  return near / all;
}

/// Share of a stroke that coincides with the other stroke; the larger of both shares. If the press is only
/// the fringe of the release's line, it covers a small part of the release.
double coincidingShare(const StrokePair& strokes, double within_px) {
  const auto &press = strokes.press.points_px, &release = strokes.release->points_px;
  return std::max(shareOn(press, release, within_px), shareOn(release, press, within_px));
}

/// Rows of a line at consecutive columns; NaN where the line does not run.
std::vector<double> rowsOf(const std::vector<Point>& line, int from, int columns) {
  std::vector<double> rows(static_cast<std::size_t>(columns), std::nan(""));
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto [a, b] = std::minmax(line[i - 1], line[i], [](Point p, Point q) { return p.x < q.x; });
    for (int x = std::max(from, static_cast<int>(std::ceil(a.x))); x <= std::min(from + columns - 1.0, b.x);
         ++x)
      rows[static_cast<std::size_t>(x - from)] = std::lerp(a.y, b.y, b.x > a.x ? (x - a.x) / (b.x - a.x) : 0);
  }
  return rows;
}

/// Steps of a stroke to the other stroke and back; limits in shares of the strokes' height and of the travel.
struct StepOver {
  double height, within;  ///< limits for each of the two steps
  double leastAlong;      ///< least length of the way along the other stroke
};

/// Number of times that the release and the press step over to the other stroke and back. `ofPress` and
/// `ofRelease`: their rows, column by column.
std::array<int, 2> timesOver(const std::vector<double>& ofPress, const std::vector<double>& ofRelease,
                             double height_px, const StepOver& least) {
  constexpr double together_px = 1.5;
  const auto columns = static_cast<double>(ofPress.size());
  const double aside = std::max(3.0, least.within * columns);
  const auto pressSteps = [&](std::size_t a, std::size_t b) {
    return std::abs(ofPress[a] - ofPress[b]) > std::abs(ofRelease[a] - ofRelease[b]);
  };
  // Back means to the side that it came from: a bottom-out in front of the other one lies on the other side.
  const auto onOneSide = [&](std::size_t a, std::size_t b) {
    return (ofPress[a] < ofRelease[a]) == (ofPress[b] < ofRelease[b]);
  };
  const auto between = [](std::size_t a, std::size_t b) { return static_cast<double>(b - a); };
  std::array<int, 2> times{};
  const std::size_t none = ofPress.size();
  std::size_t lastApart = none, first = none;  // column where they were apart; where they came together
  std::size_t last = 0;                        // where they were together
  for (std::size_t x = 0; x < ofPress.size(); ++x) {
    const double apart_px = std::abs(ofPress[x] - ofRelease[x]);
    if (std::isnan(apart_px)) lastApart = first = none;
    if (apart_px <= together_px) {
      if (first == none) first = x;
      last = x;
    }
    if (!(apart_px >= least.height * height_px)) continue;
    const bool isOver = lastApart != none && first != none && between(lastApart, first) <= aside &&
                        between(last, x) <= aside && between(first, last) >= least.leastAlong * columns;
    if (isOver && onOneSide(lastApart, x) && pressSteps(lastApart, first) == pressSteps(last, x))
      ++times[pressSteps(last, x) ? 1 : 0];
    lastApart = x;
    first = none;
  }
  return times;
}

/// Returns true if a stroke jumps to the other one, runs along it and jumps back: it was traced along the
/// wrong line where a third line covers its own, or in the gaps of its dashes. On a key that snaps each
/// stroke jumps only once.
bool stepsOverAndBack(const StrokePair& strokes) {
  constexpr StepOver onThirdLine{0.04, 0.03, 0.05}, inGap{0.02, 0.01, 0};
  constexpr int fewestGaps = 3;  // two lines that cross come together once or twice
  const auto &press = strokes.press.points_px, &release = strokes.release->points_px;
  if (press.size() < 2 || release.size() < 2) return false;
  const auto [left, right] = std::ranges::minmax(press, {}, &Point::x);
  const auto [top, lowest] = std::ranges::minmax(press, {}, &Point::y);
  const int from = static_cast<int>(left.x), columns = static_cast<int>(right.x) - from + 1;
  const double height_px = lowest.y - top.y;
  const std::vector<double> ofPress = rowsOf(press, from, columns),
                            ofRelease = rowsOf(release, from, columns);
  const auto most = [&](const StepOver& least) {
    return std::ranges::max(timesOver(ofPress, ofRelease, height_px, least));
  };
  return most(onThirdLine) >= 1 || most(inGap) >= fewestGaps;
}

/// Returns true if pixels of this colour occur in nearly every column beyond a frame's right side, apart from
/// the plot's own lines: the frame was cut too short. A thin line between two rows has its colour in about
/// every second column.
bool goesFarOn(const PlotFrame& frame, Rgb color, const Raster& picture) {
  constexpr double farShare = 0.04, nearlyAll = 0.9;  // share of the frame's width; share of the columns
  constexpr double apart_px = 3;                      // distance from a line of the plot
  const Box box = frame.box();
  const auto isLine = [&](int y) {
    return std::ranges::any_of(
        frame.yLines, [&](const GridLine& line) { return std::abs(line.position_px - y) < apart_px; });
  };
  int columns = 0, inked = 0;
  for (int x = static_cast<int>(box.x1 + apart_px); x < box.x1 + apart_px + farShare * box.width(); ++x) {
    bool any = false;
    for (int y = static_cast<int>(box.y0 + apart_px); y < box.y1 - apart_px && !any; ++y)
      any = !isLine(y) && (hasColour(picture, color, x, y) || hasColour(picture, color, x + 1, y) ||
                           hasColour(picture, color, x - 1, y));
    ++columns, inked += any ? 1 : 0;
  }
  return columns > 0 && inked >= nearlyAll * columns;
}

/// Share of a stroke's length that its longest straight section along one axis takes.
double shareAlongAnAxis(const std::vector<Point>& line) {
  const std::vector<double> at = arcOf(line);
  if (at.empty() || !(at.back() > 0)) return 0;
  const auto longest = [&](auto across) {
    double best = 0;
    for (std::size_t from = 0, to = 0; from < line.size(); ++from) {
      to = std::max(to, from);
      while (to + 1 < line.size() &&
             std::abs(across(line[to + 1]) - across(line[from])) <= alongAxisWithin_px)
        ++to;
      best = std::max(best, at[to] - at[from]);
    }
    return best;
  };
  return std::max(longest([](Point p) { return p.x; }), longest([](Point p) { return p.y; })) / at.back();
}

/// Drop of the force over the last stretch of travel, as a share of the stroke's span.
double fallAtEnd(const StrokePoints& press) {
  constexpr double lastShare = 0.03;  // share of the travel
  const Extent travel = travelOf(press), force = forceOf(press);
  double highest = press.points.back().force_N;
  for (const CurvePoint& p : press.points)
    if (p.displacement_mm > travel.high - lastShare * travel.span()) highest = std::max(highest, p.force_N);
  return force.span() > 0 ? (highest - press.points.back().force_N) / force.span() : 0;
}

/// The stroke without the bottom-out at its end.
StrokePoints withoutBottomOut(StrokePoints stroke) {
  constexpr double plumb = 0.004;  // share of the travel
  const double within_mm = plumb * travelOf(stroke).span(), end_mm = stroke.points.back().displacement_mm;
  const auto beside = std::find_if(stroke.points.rbegin(), stroke.points.rend(), [&](const CurvePoint& p) {
    return std::abs(p.displacement_mm - end_mm) > within_mm;
  });
  const auto lowest = std::min_element(beside.base(), stroke.points.end(),
                                       [](CurvePoint a, CurvePoint b) { return a.force_N < b.force_N; });
  if (lowest != stroke.points.end()) stroke.points.erase(lowest + 1, stroke.points.end());
  return stroke;
}

/// Returns true if the force is least at the stroke's end.
bool softestAtItsEnd(const StrokePoints& stroke) {
  constexpr double within = 0.03;  // share of the force span
  const Extent force = forceOf(stroke);
  return stroke.points.back().force_N <= force.low + within * force.span();
}

/// Returns true if the force falls from the start of the travel on, like that of a magnet over its gap: the
/// press is never stronger than at its start and ends far below.
bool fallsThroughout(const StrokePoints& press) {
  const Extent travel = travelOf(press), force = forceOf(press);
  const CurvePoint highest = *std::ranges::max_element(press.points, {}, &CurvePoint::force_N);
  return highest.displacement_mm < travel.low + startShare * travel.span() &&
         force.high - press.points.back().force_N > endFallShare * force.span();
}

/// Returns true if a press has its largest force at its start. The stroke of a key begins where the finger
/// meets it, so its force is small there.
bool hardestAtItsStart(const StrokePoints& press) {
  constexpr double ofHighest = 0.9;  // share of the largest force
  const Extent force = forceOf(press);
  return press.points.front().force_N >= ofHighest * force.high &&
         press.points.front().force_N - force.low > endFallShare * force.span();
}

/// Returns true if a press falls from its start, or towards its end although a support stops it there.
bool endsInAFall(const StrokePoints& press) {
  if (fallAtEnd(press) > endFallShare || fallsThroughout(press) || hardestAtItsStart(press)) return true;
  // An edge of the frame that was taken for a bottom-out is higher than the start.
  const StrokePoints curve = withoutBottomOut(press);
  return softestAtItsEnd(curve) && fallsThroughout(curve);
}

/// Sizes of a press that no known button has.
bool implausibleTravel(double travel_mm) { return travel_mm > mostTravel_mm || travel_mm < leastTravel_mm; }
bool implausibleForce(double force_N) { return force_N > mostForce_N || force_N < leastForce_N; }

/// Returns true if a press begins or pulls on the wrong side of zero, by more than noise.
bool wrongSide(const Extent& travel) { return travel.low < -negativeShare * travel.span(); }
bool pulls(const Extent& force) { return force.low < -2 * negativeShare * force.span(); }

std::size_t clearTactilePoints(const FittedStroke& fitted, const StrokePoints& stroke) {
  const double least_N = leastTurn * forceOf(stroke).span();
  return static_cast<std::size_t>(std::ranges::count_if(
      fitted.summary.tactilePoints,
      [&](const FittedTactilePoint& found) { return found.point.prominence_N >= least_N; }));
}

std::size_t mostTactilePointsOf(const FittedStrokes& fitted, const StrokePair& strokes) {
  const std::size_t press = clearTactilePoints(fitted.press, strokes.press);
  return fitted.release && strokes.release
             ? std::max(press, clearTactilePoints(*fitted.release, *strokes.release))
             : press;
}

bool touchesPictureEdge(const std::vector<Point>& line, const Raster& picture) {
  if (line.empty()) return false;
  const auto at = [&](Point p) {
    return p.x < pictureEdge_px || p.y < pictureEdge_px || p.x > picture.width_px - 1 - pictureEdge_px ||
           p.y > picture.height_px - 1 - pictureEdge_px;
  };
  return at(line.front()) || at(line.back());
}

/// Share of the travel covered by either stroke that both cover.
double sharedTravel(const StrokePair& strokes) {
  const Extent press = travelOf(strokes.press), release = travelOf(*strokes.release);
  const double either = std::max(press.high, release.high) - std::min(press.low, release.low);
  const double common = std::min(press.high, release.high) - std::max(press.low, release.low);
  return either > 0 ? std::max(0.0, common / either) : 1;
}

/// Returns true if the press begins far to the right of the release's end, and not near zero force. A press
/// must start near zero force; otherwise its beginning was not traced.
bool pressBeginsLate(const StrokePair& strokes) {
  constexpr double late = 0.1, nothing = 0.25;  // share of the travel; share of the press' largest force
  constexpr double plumb = 0.01;  // share of the travel: the press of a locked key rises vertically
  const Extent press = travelOf(strokes.press), release = travelOf(*strokes.release);
  const double travel_mm = press.high - release.low;
  double begin_N = std::numeric_limits<double>::max();
  for (const CurvePoint& p : strokes.press.points)
    if (p.displacement_mm <= press.low + plumb * travel_mm) begin_N = std::min(begin_N, p.force_N);
  return press.low - release.low > late * travel_mm && begin_N > nothing * forceOf(strokes.press).high;
}

/// Returns true if the release begins at a displacement short of the press' largest one, and well below the
/// force there. A key turns round where it was pressed to; otherwise the release's beginning was not traced.
bool releaseStartsShort(const StrokePair& strokes) {
  constexpr double shortBy = 0.02, whole = 0.75;  // shares of the travel and of the force at the press' end
  const Extent press = travelOf(strokes.press), release = travelOf(*strokes.release);
  const double gap_mm = shortBy * (press.high - press.low);
  const auto forceAtEnd = [&](const std::vector<CurvePoint>& points, double end_mm) {
    double most_N = std::numeric_limits<double>::lowest();
    for (const CurvePoint& p : points)
      if (p.displacement_mm >= end_mm - gap_mm) most_N = std::max(most_N, p.force_N);
    return most_N;
  };
  return press.high - release.high > gap_mm && forceAtEnd(strokes.release->points, release.high) <
                                                   whole * forceAtEnd(strokes.press.points, press.high);
}

/// Share of the press' force that the release still has at its end; nullopt if the press does not cover that
/// displacement.
std::optional<double> forceLeft(const StrokePair& strokes) {
  const auto earlier = [](CurvePoint a, CurvePoint b) { return a.displacement_mm < b.displacement_mm; };
  const auto& release = strokes.release->points;
  const CurvePoint end = *std::min_element(release.begin(), release.end(), earlier);
  const auto& press = strokes.press.points;
  const auto across = std::adjacent_find(press.begin(), press.end(), [&](CurvePoint a, CurvePoint b) {
    return a.displacement_mm <= end.displacement_mm && end.displacement_mm < b.displacement_mm;
  });
  if (across == press.end()) return {};
  const double share =
      (end.displacement_mm - across->displacement_mm) / (across[1].displacement_mm - across->displacement_mm);
  const double force_N = std::lerp(across->force_N, across[1].force_N, share);
  return force_N > 0 ? std::optional(end.force_N / force_N) : std::nullopt;
}

/// Returns true if the points fall monotonically from left to right.
bool pixelsFall(const std::vector<Point>& pixels) {
  constexpr std::size_t parts = 10;
  constexpr double unevenness_px = 2;
  const auto [left, right] = std::ranges::minmax(pixels, {}, &Point::x);
  std::vector<double> sums(parts, 0), counts(parts, 0), rows;
  for (const Point p : pixels) {
    const auto part =
        static_cast<std::size_t>(std::lround((p.x - left.x) / std::max(1.0, right.x - left.x) * (parts - 1)));
    sums[part] += p.y, counts[part] += 1;
  }
  for (std::size_t k = 0; k < parts; ++k)
    if (counts[k] > 0) rows.push_back(sums[k] / counts[k]);
  const auto rises = [&](double a, double b) { return b < a - unevenness_px; };
  return rows.size() > 1 && rows.back() > rows.front() &&
         std::ranges::adjacent_find(rows, rises) == rows.end();
}

class Doubts {
 public:
  Doubts(const GraphFindings& findings, const std::vector<SpecCheck>& checks, const ImportHints& hints)
      : findings_(findings), checks_(checks), hints_(hints) {}

  std::vector<WeighedDoubt> all() {
    units();
    givenAgainstLabels("x", axes().x);
    givenAgainstLabels("y", axes().y);
    sizes();
    signs();
    shapes();
    leftOver();
    otherLine();
    ownColourBeside();
    givenAgainstLegend();
    releaseNotGiven();
    namedAlone();
    otherNamed();
    assumed();
    place();
    pageClass();
    for (WeighedDoubt& each : doubts_) each.doubt.remedies = leftToTry(each.doubt.remedies, hints_);
    return std::move(doubts_);
  }

 private:
  void add(DoubtCode code, double confidence, std::vector<MessageValue> values, Remedies remedies) {
    doubts_.push_back({{code, std::move(values), std::move(remedies)}, confidence});
  }

  bool isGiven(Stroke stroke) const { return strokeIsGiven(hints_, stroke); }
  /// Returns true if nothing about the choice of the curves is left to be found.
  bool isSettled() const { return isGiven(Stroke::press) && isGiven(Stroke::release); }

  void units() {
    const AxisCalibration& axes = findings_.graph.axes.calibration.value;
    for (Doubt& other : otherQuantitiesOf(axes)) doubts_.push_back({std::move(other), contradicted});
    if (!hints_.axes.xUnit) unit(axes.x, Axis::x);
    if (!hints_.axes.yUnit) unit(axes.y, Axis::y);
    factor(axes.x, Axis::x);
    factor(axes.y, Axis::y);
    // A given unit does not resolve whether "," is a decimal or a thousands separator.
    if (axes.x.thousandsUnclear) add(DoubtCode::thousandsUnclear, unconfirmed, {"x"}, RemedyKind::giveXAxis);
    if (axes.y.thousandsUnclear) add(DoubtCode::thousandsUnclear, unconfirmed, {"y"}, RemedyKind::giveYAxis);
  }

  /// Doubts the unit of an axis for which the user gave none.
  void unit(const AxisReading& axis, Axis which) {
    if (!axis.otherQuantity.empty() || axis.unitFound || confirmedBySpec(checks_, which)) return;
    const bool isX = which == Axis::x;
    add(DoubtCode::unitMissing, unconfirmed,
        {isX ? "x" : "y", axis.unit, isX ? Message("lengths") : Message("forces")},
        isX ? RemedyKind::giveXUnit : RemedyKind::giveYUnit);
  }

  /// Doubts the factor that an axis' title prints: titles mean by it that the numbers are to be multiplied, or
  /// that they have been. Without a unit or ends from the user the import does not rest on it, and never on
  /// one that cannot be read.
  void factor(const AxisReading& axis, Axis which) {
    const bool isX = which == Axis::x;
    if (confirmedBySpec(checks_, which)) return;
    if (axis.factorUnread) {
      Remedies helps{
          {isX ? RemedyKind::giveXAxis : RemedyKind::giveYAxis, "with the numbers multiplied by it"}};
      if (isX ? hints_.axes.xMin && hints_.axes.xMax : hints_.axes.yMin && hints_.axes.yMax)
        helps = Message("Multiply the given values by it");
      add(DoubtCode::factorUnread, unconfirmed, {isX ? "x" : "y"}, std::move(helps));
    }
    if (axis.factor == 1) return;
    const bool given = isX ? hints_.axes.xMin || hints_.axes.xMax || hints_.axes.xUnit
                           : hints_.axes.yMin || hints_.axes.yMax || hints_.axes.yUnit;
    add(DoubtCode::factorPrinted, given ? inPart : unconfirmed,
        {isX ? "x" : "y", axis.factor,
         axis.multiplied ? Message("the numbers along the axis were multiplied by it")
                         : Message("the given values were not multiplied by it")},
        {{isX ? RemedyKind::giveXUnit : RemedyKind::giveYUnit, "if that is right"},
         {isX ? RemedyKind::giveXAxis : RemedyKind::giveYAxis, "if it is wrong"}});
  }

  const AxisCalibration& axes() const { return findings_.graph.axes.calibration.value; }

  /// Reports given ends that contradict printed numbers which would be believed without them. The given ends
  /// are used nevertheless.
  void givenAgainstLabels(const char* name, const AxisReading& axis) {
    if (axis.contradicting.empty() || axis.contradictedBy < confidenceBar) return;
    std::string labels;
    for (const std::string& each : axis.contradicting) labels += (labels.empty() ? "" : ", ") + each;
    add(DoubtCode::givenAgainstLabels, inPart, {name, labels},
        {{RemedyKind::advice,
          Message("Correct the given values, or remove them so that the printed numbers are used")}});
  }

  void sizes() {
    const double travel_mm = travelOf(findings_.strokes.value.press).high;
    const double force_N = forceOf(findings_.strokes.value.press).high;
    if (implausibleTravel(travel_mm) && !confirmedBySpec(checks_, Axis::x))
      add(DoubtCode::implausibleTravel, ofSize(Axis::x), {shownTravel(axes().x, travel_mm)},
          {{RemedyKind::giveXUnit, "if it is another"}, {RemedyKind::giveXAxis, "if it is"}});
    if (implausibleForce(force_N) && !confirmedBySpec(checks_, Axis::y))
      add(DoubtCode::implausibleForce, ofSize(Axis::y), {shownForce(axes().y, force_N)},
          {{RemedyKind::giveYUnit, "if it is another"}, {RemedyKind::giveYAxis, "if it is"}});
  }

  bool endsGiven(Axis axis) const {
    const AxisHints& given = hints_.axes;
    return axis == Axis::x ? given.xMin && given.xMax : given.yMin && given.yMax;
  }

  /// Confidence in a size that no known button has. Given ends that the printed numbers have as well say
  /// nothing new: a chart of something else is typed as it is printed, and so is a point that parts
  /// thousands.
  double ofSize(Axis axis) const {
    const AxisReading& reading = axis == Axis::x ? axes().x : axes().y;
    return endsGiven(axis) && !reading.repeated ? inPart : unconfirmed;
  }

  void signs() {
    const Extent travel = travelOf(findings_.strokes.value.press),
                 force = forceOf(findings_.strokes.value.press);
    if (wrongSide(travel))
      add(DoubtCode::negativeTravel, contradicted, {shownTravel(axes().x, travel.low)},
          {{RemedyKind::giveXAxis, "if the axis was misread"}});
    if (pulls(force))
      add(DoubtCode::negativeForce, contradicted, {shownForce(axes().y, force.low)},
          {{RemedyKind::giveYAxis, "if the axis was misread"}});
  }

  void shapes() {
    const Remedies helps{{RemedyKind::addMask, "over what is not a curve"},
                         {RemedyKind::pickPress, {}},
                         {RemedyKind::pickRelease, {}},
                         {RemedyKind::noRelease, {}}};
    const StrokePair& strokes = findings_.strokes.value;
    const Box frame = findings_.graph.frame.value.box();
    if (strokes.release) {
      const double within_px = std::max(0.6, sameLineShare * std::min(frame.width(), frame.height()));
      if ((!drawnAndNamedApart() && coincidingShare(strokes, within_px) > sameLineLength) ||
          stepsOverAndBack(strokes))
        add(DoubtCode::strokesCoincide, unconfirmed, {}, helps);
      const double shared = sharedTravel(strokes);
      const std::optional<double> left = forceLeft(strokes);
      const bool locks = left && *left < atRest && namedApart();
      if ((shared < leastSharedTravel && !locks) ||
          (shared < wholeTravel && left && *left > forceLeftAtEnd) || pressBeginsLate(strokes))
        add(DoubtCode::strokeInPart, unconfirmed, {{shared, Measure::share}}, helps);
      else if (hints_.drawn.release.empty() && releaseStartsShort(strokes))
        add(DoubtCode::releaseStartsShort, unconfirmed,
            {shownTravel(axes().x, travelOf(*strokes.release).high),
             shownTravel(axes().x, travelOf(strokes.press).high)},
            RemedyKind::drawRelease);
    }
    double along = shareAlongAnAxis(strokes.press.points_px);
    if (strokes.release) along = std::max(along, shareAlongAnAxis(strokes.release->points_px));
    if (along > alongAxisShare) add(DoubtCode::alongAnAxis, unconfirmed, {}, helps);
    if (endsInAFall(strokes.press)) add(DoubtCode::endsInAFall, unconfirmed, {}, helps);
    const std::size_t points = mostTactilePointsOf(findings_.fitted, strokes);
    if (points > mostTactilePoints) add(DoubtCode::manyTactilePoints, unconfirmed, {points}, helps);
  }

  /// Returns true if both strokes are paths of a drawing that its legend names press and release. Such
  /// strokes may coincide, because drawings show buttons without hysteresis.
  bool drawnAndNamedApart() const {
    const StrokePair& strokes = findings_.strokes.value;
    return strokes.press.fromVector && strokes.release->fromVector && namedApart();
  }

  /// Returns true if the legend names one of the curves press and the other release.
  bool namedApart() const {
    return std::ranges::any_of(findings_.strokes.evidence, [](const EvidenceItem& item) {
      return item.code == EvidenceCode::namedByLegend;
    });
  }

  void sayAt(Point at_px, DoubtCode code, double share) {
    const Point at = findings_.graph.axes.calibration.value.toUnits(at_px);
    add(code, share, {shownTravel(axes().x, at.x), shownForce(axes().y, at.y)},
        {{RemedyKind::addMask, "over what is not a curve"}, {RemedyKind::drawPress, {}}});
  }

  /// Doubts an import whose plot contains another long line, straight or not: a loop of another state, as a
  /// self-locking button has, or of another switch. Guides are horizontal or vertical, and leaders are short.
  /// No doubt if the person chose a switch or both strokes.
  void otherLine() {
    constexpr double leastWidth = 0.3, leastHeight = 0.2;  // shares of the frame's sides
    constexpr double mostThickness =
        8;  // in thicknesses of the curves: not a filled patch, but at most three lines that meet
    if (isSettled() || !hints_.strokes.curve.empty()) return;
    const Box frame = findings_.graph.frame.value.box();
    const auto& left = findings_.explanation.left;
    const auto line = std::ranges::find_if(left, [&](const Remainder& each) {
      return isOfAStroke(each) && !isMark(each) && each.thickness < mostThickness &&
             each.box_px.width() >= leastWidth * frame.width() &&
             each.box_px.height() >= leastHeight * frame.height() && !outlinesABox(each) && liesApart(each);
    });
    if (line != left.end()) sayAt(line->box_px.middle(), DoubtCode::curveLeftOver, unconfirmed);
  }

  /// Doubts a press that was traced alone for a switch chosen among several, if pixels of its colour continue
  /// above or below it over much of its travel: its release, or the real press, is another line.
  void ownColourBeside() {
    constexpr double mostShare = 0.25;  // share of its columns; a legend key takes less
    constexpr double apart_px = 4;      // distance from pixels that are explained
    const StrokePair& strokes = findings_.strokes.value;
    if (hints_.strokes.curve.empty() || hints_.strokes.noRelease || strokes.release ||
        findings_.graph.view.raster.rgb.empty())
      return;
    const Box frame = findings_.graph.frame.value.box();
    const Rgb color = colorOf(strokes.press);
    const auto [first, last] = std::ranges::minmax(strokes.press.points_px, {}, &Point::x);
    const int from = static_cast<int>(first.x), columns = static_cast<int>(last.x) - from + 1;
    std::vector<std::vector<Extent>> explained(static_cast<std::size_t>(std::max(0, columns)));
    const auto explain = [&](Point p, Point q) {  // explained rows, by columns
      for (int x = std::max(from, static_cast<int>(std::min(p.x, q.x) - apart_px));
           x <= std::min(from + columns - 1.0, std::max(p.x, q.x) + apart_px); ++x) {
        const double share = q.x == p.x ? 0 : std::clamp((x - p.x) / (q.x - p.x), 0.0, 1.0);
        const double reach =
            apart_px +
            (std::abs(q.x - p.x) > 1 ? std::abs((q.y - p.y) / (q.x - p.x)) * apart_px : std::abs(q.y - p.y));
        const double y = std::lerp(p.y, q.y, share);
        explained[static_cast<std::size_t>(x - from)].push_back({y - reach, y + reach});
      }
    };
    for (const CurveTrace& trace : findings_.traces)
      for (std::size_t i = 1; i < trace.points_px.size(); ++i)
        explain(trace.points_px[i - 1], trace.points_px[i]);
    std::vector<Point> beside;
    for (int x = from; x < from + columns; ++x)
      for (int y = static_cast<int>(frame.y0 + apart_px); y < frame.y1 - apart_px; ++y) {
        const auto isThere = [&](const Extent& rows) { return y >= rows.low && y <= rows.high; };
        if (!hasColour(findings_.graph.view.raster, color, x, y) ||
            std::ranges::any_of(explained[static_cast<std::size_t>(x - from)], isThere))
          continue;
        beside.push_back({static_cast<double>(x), static_cast<double>(y)});
        break;
      }
    if (static_cast<double>(beside.size()) > mostShare * columns)
      sayAt(beside[beside.size() / 2], DoubtCode::curveLeftOver, unconfirmed);
  }

  /// Reports that a colour was given for one stroke although the legend calls its curve the other stroke. The
  /// given choice is followed.
  void givenAgainstLegend() {
    const TraceHints& given = hints_.trace;
    if (hints_.strokes.swap || (!given.pressColor && !given.releaseColor)) return;
    const auto contradicts = [](const CurveTrace& trace) {
      return trace.stroke && strokeNamedBy(trace.label).value_or(*trace.stroke) != *trace.stroke;
    };
    const auto other = std::ranges::find_if(findings_.traces, contradicts);
    if (other == findings_.traces.end()) return;
    const auto& givenColour = other->stroke == Stroke::press ? given.pressColor : given.releaseColor;
    if (givenColour)
      add(DoubtCode::givenAgainstLegend, inPart, {nameOf(*givenColour), other->label},
          {{RemedyKind::swapStrokes, {}}});
  }

  /// Reports that only the press was given and that no release was found beside it.
  void releaseNotGiven() {
    if (isGiven(Stroke::press) && !isGiven(Stroke::release) && !findings_.strokes.value.release)
      add(DoubtCode::releaseNotGiven, inPart, {},
          {{RemedyKind::pickRelease, {}}, {RemedyKind::noRelease, {}}});
  }

  /// Doubts two curves of which one has a name that is no stroke's, while the other's name could not be read:
  /// they may belong to two switches. If both have such names, their paths alone tell press from release.
  void namedAlone() {
    const std::vector<CurveTrace>& traces = findings_.traces;
    if (isSettled() || !findings_.strokes.value.release || traces.size() != 2) return;
    const CurveTrace& named = traces[0].label.empty() ? traces[1] : traces[0];
    const CurveTrace& other = &named == &traces[0] ? traces[1] : traces[0];
    if (named.color == other.color || !namesNoStroke(named.label)) return;
    const Remedies byColour{
        {RemedyKind::pickPress, {}}, {RemedyKind::pickRelease, {}}, {RemedyKind::noRelease, {}}};
    if (other.label.empty())
      add(DoubtCode::namesNoStroke, inPart, {named.label}, byColour);
    else if (namesNoStroke(other.label))
      byPath(traces, byColour);
  }

  void byPath(const std::vector<CurveTrace>& traces, const Remedies& byColour) {
    const std::size_t press = traceOf(findings_.strokes.value.press) == &traces[1] ? 1 : 0;
    add(DoubtCode::assumed, unconfirmed,
        {Message("\"%1\" and \"%2\" are taken as press and release, because they end at the same point",
                 traces[press].label, traces[1 - press].label)},
        byColour);
  }

  /// Doubts an import whose legend also names strokes of another switch: the curves of that switch are on the
  /// plot too, in whatever colour.
  void otherNamed() {
    const CurveTrace* const press = traceOf(findings_.strokes.value.press);
    if (!press || isSettled() || !hints_.strokes.curve.empty()) return;
    if (isGiven(Stroke::press) && !findings_.strokes.value.release) return;
    const std::string ownSwitch = folded(switchNamedBy(press->label));
    if (ownSwitch.empty()) return;
    const std::vector<SeenText>& texts = findings_.graph.axes.texts;
    for (const SeenText& text : texts) {
      if (strokeNamedBy(text.utf8, sourceOf(text)) != Stroke::press) continue;
      const std::string other = switchNamedBy(text.utf8, sourceOf(text));
      const auto isPartner = [&](const SeenText& each) { return namesOnePair(text.utf8, each.utf8); };
      if (countsOnly(other) || folded(other) == ownSwitch || isTraced(other) ||
          std::ranges::none_of(texts, isPartner))
        continue;
      add(DoubtCode::otherSwitchNamed, unconfirmed, {other},
          {{RemedyKind::pickPress, {}}, {RemedyKind::pickRelease, {}}});
      return;
    }
  }
  /// Returns true for a name like "Press 2": another run of the same switch, whose curve may be hidden on the
  /// page.
  static bool countsOnly(std::string_view name) {
    return name.find_first_not_of("0123456789 .#()") == std::string_view::npos;
  }
  bool isTraced(const std::string& switchName) const {
    return std::ranges::any_of(findings_.traces, [&](const CurveTrace& trace) {
      return folded(switchNamedBy(trace.label)) == folded(switchName);
    });
  }

  /// Returns true if most of a remainder has no stroke above or below it, so it is not the rim of a stroke's
  /// own line.
  bool liesApart(const Remainder& left) const {
    const StrokePair& strokes = findings_.strokes.value;
    const auto along = std::ranges::count_if(left.pixels_px, [&](Point at) {
      return runsAlong(strokes.press, at) || (strokes.release && runsAlong(*strokes.release, at));
    });
    return 2 * static_cast<std::size_t>(along) <= left.pixels_px.size();
  }

  /// Returns true if a stroke runs just above or below a point, or through it.
  bool runsAlong(const StrokePoints& stroke, Point at) const {
    const double apart_px = std::max(4.0, 0.01 * findings_.graph.frame.value.box().height());
    return std::adjacent_find(stroke.points_px.begin(), stroke.points_px.end(), [&](Point a, Point b) {
             if (at.x < std::min(a.x, b.x) - apart_px || at.x > std::max(a.x, b.x) + apart_px) return false;
             if (std::abs(b.x - a.x) < apart_px)
               return at.y > std::min(a.y, b.y) - apart_px && at.y < std::max(a.y, b.y) + apart_px;
             const double share = std::clamp((at.x - a.x) / (b.x - a.x), 0.0, 1.0);
             return std::abs(at.y - std::lerp(a.y, b.y, share)) < apart_px;
           }) != stroke.points_px.end();
  }

  /// Returns true if most of a remainder lies along a stroke, which was drawn by hand.
  bool isOfALine(const Remainder& left) const { return !left.pixels_px.empty() && !liesApart(left); }

  /// Returns true if a jump is not one of the strokes, because a line was drawn in place of its trace.
  bool isOfALine(const TraceJump& jump) const {
    constexpr double on_px = 1.5;
    const auto isOn = [&](const StrokePoints& stroke) {
      return liesOn(stroke.points_px, jump.from_px, on_px) && liesOn(stroke.points_px, jump.to_px, on_px);
    };
    const StrokePair& strokes = findings_.strokes.value;
    const bool press = hints_.drawn.press.empty() && isOn(strokes.press);
    const bool release = hints_.drawn.release.empty() && strokes.release && isOn(*strokes.release);
    return !press && !release;
  }

  /// Returns true for a legend's box: most of the pixels lie on the edges of their bounding box.
  static bool outlinesABox(const Remainder& left) {
    constexpr double nearShare = 0.05, most = 0.5;  // share of the box; share of the pixels
    const Box& box = left.box_px;
    const auto onEdge = std::ranges::count_if(left.pixels_px, [&](Point p) {
      return std::min(p.x - box.x0, box.x1 - p.x) < nearShare * box.width() ||
             std::min(p.y - box.y0, box.y1 - p.y) < nearShare * box.height();
    });
    return static_cast<double>(onEdge) > most * static_cast<double>(left.pixels_px.size());
  }

  /// Doubts pixels of a curve's colour that neither the curves nor the plot's lines and words explain, and
  /// curves without pixels.
  void leftOver() {
    constexpr double likeACurve = 0.5;  // likeness 0..1, docs/develop/decisions/0810
    const bool byLine = !hints_.drawn.press.empty() || !hints_.drawn.release.empty();
    if (byLine && isSettled()) return;
    const auto& [left, jumps, patches, beside] = findings_.explanation;
    // A drawn line replaces a trace and explains the pixels along it.
    const auto ofAStroke = [&](const auto& each) {
      return isOfAStroke(each) && !(byLine && isOfALine(each));
    };
    const auto most = std::ranges::find_if(left, ofAStroke);
    if (most != left.end() && most->likeness >= likeACurve)
      // A continuing curve was traced incompletely and is refused; an isolated mark may be something else on
      // the page and is only reported.
      sayAt(most->box_px.middle(), DoubtCode::curveLeftOver,
            most->atAnEnd || most->dashed ? unconfirmed : inPart);
    constexpr double mostPatches =
        0.1;  // share of the curves' pixels; 0 on charts with markers and fills, 0.21 along a filled band
    // share of the travel of a curve that was traced alone; a dotted line has half
    constexpr double mostBeside = 0.4;
    if (!byLine && patches.share > mostPatches) sayAt(patches.at_px, DoubtCode::curveLeftOver, unconfirmed);
    if (!byLine && beside.share > mostBeside) sayAt(beside.at_px, DoubtCode::curveLeftOver, unconfirmed);
    if (const auto jump = std::ranges::find_if(jumps, ofAStroke); jump != jumps.end())
      sayAt(0.5 * (jump->from_px + jump->to_px), DoubtCode::curveOverPaper, unconfirmed);
  }

  /// Reports assumptions of a step that the page does not confirm.
  void assumed() {
    for (const EvidenceItem& item : findings_.strokes.evidence)
      if (item.code == EvidenceCode::nameNearly)
        add(DoubtCode::assumed, inPart, {messageOf(item)}, {{RemedyKind::chooseSwitch, {}}});
      else if (item.code == EvidenceCode::startUnderAnother)
        add(DoubtCode::assumed, inPart, {messageOf(item)}, {{RemedyKind::drawPress, {}}});
    for (const EvidenceItem& item : findings_.graph.axes.calibration.evidence)
      if (item.code == EvidenceCode::unitsOfHeading)
        add(DoubtCode::assumed, inPart, {messageOf(item)},
            {{RemedyKind::giveXUnit, {}}, {RemedyKind::giveYUnit, {}}});
  }

  void place() {
    const StrokePair& strokes = findings_.strokes.value;
    const Raster& picture = findings_.graph.view.raster;
    const bool cut = touchesPictureEdge(strokes.press.points_px, picture) ||
                     (strokes.release && touchesPictureEdge(strokes.release->points_px, picture));
    if (cut && hints_.frame.empty())
      add(DoubtCode::cutAtPictureEdge, unconfirmed, {},
          {{RemedyKind::advice, Message("Import the whole picture")},
           {RemedyKind::giveFrame, "if the curve ends there"}});
    edges(strokes.press);
    if (strokes.release) edges(*strokes.release);
    // The second scale may be that of a release which nobody gave.
    const bool curvesChosen = isGiven(Stroke::press) && (isGiven(Stroke::release) || !strokes.release);
    // On a plot with two scales of force, a curve's colour does not show to which scale it belongs.
    const RightScale right = findings_.graph.axes.rightScale;
    const bool settled =
        curvesChosen && !(right == RightScale::otherForces && findings_.strokes.value.release);
    if (right != RightScale::none && !settled && !otherScaleHasItsCurve())
      add(DoubtCode::otherScale, unconfirmed, {measureOfRightScale()},
          curvesChosen ? graphWithOneScale() : ofLeftScale());
  }

  static Remedies ofLeftScale() {
    return {{RemedyKind::pickPress, {}},
            {RemedyKind::pickRelease, "with the colours of the left scale's curves"},
            {RemedyKind::noRelease, {}}};
  }

  /// Says what the second scale measures, to follow its subject in a message: the quantity that the scale's
  /// title names, if any.
  Message measureOfRightScale() const {
    const LocatedGraph& graph = findings_.graph;
    if (graph.axes.rightScale == RightScale::otherForces) return Message("it also measures forces");
    const Box frame = graph.frame.value.box();
    for (const SeenText& text : graph.axes.texts) {
      const Point middle = text.box.middle();
      if (text.box.x0 < frame.x1 || middle.y < frame.y0 || middle.y > frame.y1) continue;
      if (const std::string name = otherQuantityIn(text.utf8, sourceOf(text)); !name.empty())
        return Message("it measures \"%1\"", name);
    }
    return Message("it names no unit of force");
  }

  /// Returns true if another curve was excluded that belongs to the second scale: the legend names it after
  /// that scale's quantity, or names press and release beside it.
  bool otherScaleHasItsCurve() const {
    const StrokePair& strokes = findings_.strokes.value;
    const bool named = isNamed(strokes.press, Stroke::press) && strokes.release &&
                       isNamed(*strokes.release, Stroke::release);
    return strokes.release && std::ranges::any_of(findings_.traces, [&](const CurveTrace& trace) {
             return trace.points_px.size() >= 2 && !isOfAStroke(trace.color) &&
                    (named || !otherQuantityIn(trace.label).empty());
           });
  }

  /// Lowers the confidence on pages that come from paper, where steps are right less often, unless a person
  /// gave frame and axes.
  void pageClass() {
    const bool scan = findings_.pageClass == PageClass::scan;
    const AxisHints& axes = hints_.axes;
    const bool given = !hints_.frame.empty() && axes.xMin && axes.xMax && axes.yMin && axes.yMax;
    if (given || (!scan && findings_.pageClass != PageClass::photo)) return;
    const double worth = worthOf(findings_.pageClass);
    for (WeighedDoubt& each : doubts_) each.confidence *= worth;
    const double steps = std::min(findings_.graph.confidence(), findings_.strokes.confidence);
    add(scan ? DoubtCode::pageIsScan : DoubtCode::pageIsPhoto, steps * worth, {},
        {{RemedyKind::giveFrame, "with its four corners"},
         {RemedyKind::giveXAxis, {}},
         {RemedyKind::giveYAxis, "(values at the frame's edges)"}});
  }

  /// Doubts curves of which the plot shows only a part.
  void edges(const StrokePoints& stroke) {
    constexpr double atEdge_px = 2;
    constexpr double nearShare = 0.02;  // share of the frame's height, by which a scale may be off
    constexpr double plumbShare = 0.02;
    std::vector<Point> line = stroke.points_px;
    if (line.empty()) return;
    if (line.front().x > line.back().x) std::reverse(line.begin(), line.end());
    const auto& [topLeft, topRight, bottomRight, bottomLeft] = findings_.graph.frame.value.corners;
    const Raster& picture = findings_.graph.view.raster;
    const Rgb color = colorOf(stroke);
    const Point end = line.back(), towards = end - line[line.size() - std::min<std::size_t>(line.size(), 13)];
    // A bottom-out on the frame's side runs along it, so it leaves the plot only at the top.
    const bool sidewards = std::abs(towards.x) > plumbShare * std::abs(towards.y);
    const bool atRight = sidewards && end.x > std::min(topRight.x, bottomRight.x) - atEdge_px;
    const bool atEdge = atRight || end.y < std::max(topLeft.y, topRight.y) + atEdge_px;
    // If a frame cuts its curves and a label contradicts its scale, it is part of a larger frame. Across a
    // broken axis no curve continues, and the label lies beyond the break.
    const bool nearTop =
        end.y < std::max(topLeft.y, topRight.y) + nearShare * (bottomLeft.y - topLeft.y) + atEdge_px;
    const bool broken = nearTop && (labelAbove(topLeft) || (!drawnAtTop() && numberAbove(topLeft)));
    if (broken || (atEdge && goesOnBeyond(line, color, picture))) {
      // A person who gives the frame decides where the plot ends. That the curve continues there is still
      // reported.
      const bool cutShort =
          broken || labelContradicts() || (atRight && goesFarOn(findings_.graph.frame.value, color, picture));
      add(DoubtCode::leavesThePlot, cutShort && hints_.frame.empty() ? unconfirmed : inPart,
          {shownForce(axes().y, forceAtRight(stroke))},
          {{RemedyKind::giveFrame, "with the whole curve in it"}});
    }

    belowTheAxis(line);
  }

  /// Doubts a curve (from left to right) of which an axis that begins above zero hides a part: before its
  /// start and where it dips.
  void belowTheAxis(const std::vector<Point>& line) {
    constexpr double onBaseline_px = 2, above_px = 4;  // half a line's width above, where it starts steeply
    constexpr double noticeable = 0.03;                // share of the axis' range, or of the travel
    constexpr std::ptrdiff_t fewest = 3;  // points along the lower edge where a curve dips below it
    constexpr double mostHidden = 0.15;   // share of the travel: with more, the button would feel different
    const AxisCalibration& axes = findings_.graph.axes.calibration.value;
    const auto& corners = findings_.graph.frame.value.corners;
    const Point lowest = axes.toUnits(corners[3]);
    const double top_N = axes.toUnits(corners[0]).y;
    if (lowest.y <= noticeable * (top_N - lowest.y)) return;
    const auto isWithin = [&](Point p, double px) {
      return axes.toUnits(p).y < lowest.y + px * std::abs(axes.newtonPerPx());
    };
    const auto isOnBaseline = [&](Point p) { return isWithin(p, onBaseline_px); };
    const double from_mm = std::max(0.0, lowest.x), start_mm = axes.toUnits(line.front()).x,
                 travel_mm = axes.toUnits(line.back()).x - from_mm;
    const bool startsThere = isOnBaseline(line.front()) || (isWithin(line.front(), above_px) &&
                                                            start_mm - from_mm > noticeable * travel_mm);
    if (!startsThere && std::ranges::count_if(line, isOnBaseline) < fewest) return;
    double hidden_mm = startsThere ? start_mm - from_mm : 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      if (isOnBaseline(line[i - 1]) && isOnBaseline(line[i]))
        hidden_mm += axes.toUnits(line[i]).x - axes.toUnits(line[i - 1]).x;
    const bool longWayHidden = !hints_.axes.yMin && hidden_mm > mostHidden * travel_mm;
    add(DoubtCode::belowTheAxis, longWayHidden ? unconfirmed : inPart, {shownForce(axes.y, lowest.y)},
        {{RemedyKind::giveYAxis, "if the axis was misread"}});
  }

  /// Returns true if a label that was read with certainty stands at a wrong place of the scale, and only few
  /// others support the scale.
  bool labelContradicts() const {
    constexpr auto borne = 5;  // agreeing labels needed for each contradicting one
    const auto few = [](const AxisReading& axis) {
      const auto used = std::ranges::count_if(axis.ticks, [](const TickLabel& tick) { return tick.used; });
      return borne * (std::ssize(axis.ticks) - used) >= used;
    };
    const AxisCalibration& axes = findings_.graph.axes.calibration.value;
    return (few(axes.x) || few(axes.y)) &&
           std::ranges::any_of(findings_.graph.axes.remarks, [](const Remark& remark) {
             return remark.code == RemarkCode::labelContradicts;
           });
  }

  /// Returns true if a line of the plot is drawn along its upper edge. Without one, nothing cuts the curve
  /// there.
  bool drawnAtTop() const {
    constexpr double near_px = 3;
    const PlotFrame& frame = findings_.graph.frame.value;
    return std::ranges::any_of(frame.yLines, [&](const GridLine& line) {
      return line.spansFrame && std::abs(line.position_px - frame.corners.front().y) < near_px;
    });
  }

  /// Returns true if a number of the force axis stands above the frame, but not where the others would place
  /// it.
  bool labelAbove(Point topLeft) const {
    return std::ranges::any_of(findings_.graph.axes.calibration.value.y.ticks, [&](const TickLabel& tick) {
      return !tick.used && tick.box.middle().y < topLeft.y;
    });
  }

  /// Returns true if another number stands above those of the force axis, beyond the frame: it belongs to the
  /// other part of a broken axis.
  bool numberAbove(Point topLeft) const {
    const AxesFound& axes = findings_.graph.axes;
    const auto isNumber = [](const std::string& text) {
      return !text.empty() && text.find_first_not_of("0123456789.,") == std::string::npos;
    };
    const auto inLine = [&](const Box& box) {
      return std::ranges::any_of(axes.calibration.value.y.ticks, [&](const TickLabel& tick) {
        return tick.used && box.x0 < tick.box.x1 && box.x1 > tick.box.x0;
      });
    };
    return std::ranges::any_of(axes.texts, [&](const SeenText& text) {
      return isNumber(text.utf8) && text.box.y1 < topLeft.y && inLine(text.box);
    });
  }

  double forceAtRight(const StrokePoints& stroke) const {
    const bool backwards = stroke.points_px.front().x > stroke.points_px.back().x;
    return (backwards ? stroke.points.front() : stroke.points.back()).force_N;
  }

  /// The trace from which the stroke was taken; null if that trace was split.
  const CurveTrace* traceOf(const StrokePoints& stroke) const {
    const auto hasEnd = [](const CurveTrace& trace, Point end) {
      return !trace.points_px.empty() && (trace.points_px.front() == end || trace.points_px.back() == end);
    };
    const Point first = stroke.points_px.front(), last = stroke.points_px.back();
    const auto whole = std::ranges::find_if(findings_.traces, [&](const CurveTrace& trace) {
      return hasEnd(trace, first) && hasEnd(trace, last);
    });
    if (whole != findings_.traces.end()) return &*whole;
    // The lower end may belong to another curve that covers the stroke's own, so the upper end is more
    // reliable.
    const bool backwards = first.x > last.x;
    for (const Point end : {backwards ? first : last, backwards ? last : first}) {
      const auto from =
          std::ranges::find_if(findings_.traces, [&](const CurveTrace& trace) { return hasEnd(trace, end); });
      if (from != findings_.traces.end()) return &*from;
    }
    return nullptr;
  }
  std::optional<Rgb> traceColorOf(const StrokePoints& stroke) const {
    const CurveTrace* const from = traceOf(stroke);
    return from ? std::optional(from->color) : std::nullopt;
  }
  bool isNamed(const StrokePoints& stroke, Stroke as) const {
    const CurveTrace* const from = traceOf(stroke);
    return from && strokeNamedBy(from->label) == as;
  }
  Rgb colorOf(const StrokePoints& stroke) const { return traceColorOf(stroke).value_or(Rgb{}); }

  /// Returns true if this colour is, or may be, that of a stroke.
  bool isOfAStroke(Rgb color) const {
    const StrokePair& strokes = findings_.strokes.value;
    const auto press = traceColorOf(strokes.press);
    const auto release = strokes.release ? traceColorOf(*strokes.release) : press;
    return !press || !release || isSameColour(color, *press) || isSameColour(color, *release);
  }

  /// Number of a remainder's pixels that have a colour.
  std::size_t shownOf(const Remainder& left, Rgb color) const {
    const Raster& picture = findings_.graph.view.raster;
    if (picture.empty()) return 0;
    return static_cast<std::size_t>(std::ranges::count_if(left.pixels_px, [&](Point p) {
      return hasColour(picture, color, static_cast<int>(std::lround(p.x)),
                       static_cast<int>(std::lround(p.y)));
    }));
  }

  /// Returns true if a remainder may belong to a stroke. If it shows the colour of an excluded curve more
  /// than that of any stroke, it belongs to that curve.
  bool isOfAStroke(const Remainder& left) const {
    std::size_t ofStrokes = 0, ofOthers = 0;
    for (const CurveTrace& trace : findings_.traces) {
      std::size_t& most = isOfAStroke(trace.color) ? ofStrokes : ofOthers;
      most = std::max(most, shownOf(left, trace.color));
    }
    return ofStrokes >= ofOthers;
  }

  /// Attributes a jump of the trace to the curve it lies on.
  bool isOfAStroke(const TraceJump& jump) const {
    constexpr double on_px = 1.5;
    bool ofOthers = false;
    for (const CurveTrace& trace : findings_.traces) {
      if (!liesOn(trace.points_px, jump.from_px, on_px) || !liesOn(trace.points_px, jump.to_px, on_px))
        continue;
      // a stroke that strayed onto another curve has a jump there too
      if (isOfAStroke(trace.color)) return true;
      ofOthers = true;
    }
    return !ofOthers;
  }

  /// Returns true if a line falls monotonically from left to right and has hardly any stroke's colour: an
  /// arrow or a leader. No stroke falls so.
  bool isMark(const Remainder& left) const {
    constexpr double mostOfStrokes = 0.4;  // share of its pixels: smoothed rims have any colour
    const AxisCalibration& axes = findings_.graph.axes.calibration.value;
    const Point low = axes.toUnits({left.box_px.x0, left.box_px.y1}),
                high = axes.toUnits({left.box_px.x1, left.box_px.y0});
    // on a falling axis the strokes fall as well
    if (!((high.x - low.x) * (high.y - low.y) > 0)) return false;
    std::size_t ofStrokes = 0;
    for (const CurveTrace& trace : findings_.traces)
      ofStrokes = std::max(ofStrokes, shownOf(left, trace.color));
    return !left.pixels_px.empty() && !findings_.graph.view.raster.empty() && pixelsFall(left.pixels_px) &&
           static_cast<double>(ofStrokes) < mostOfStrokes * static_cast<double>(left.pixels_px.size());
  }

  const GraphFindings& findings_;
  const std::vector<SpecCheck>& checks_;
  const ImportHints& hints_;
  std::vector<WeighedDoubt> doubts_;
};

}  // namespace

Remedies graphWithOneScale() {
  return Message("Import a graph on which press and release have the same force scale");
}

double worthOf(PageClass pageClass) {
  constexpr double onScans = 0.88, onPhotos = 0.66;  // factors of the confidence
  return pageClass == PageClass::scan ? onScans : pageClass == PageClass::photo ? onPhotos : 1;
}

std::vector<WeighedDoubt> doubtsOf(const GraphFindings& findings, const std::vector<SpecCheck>& checks,
                                   const ImportHints& hints) {
  return Doubts(findings, checks, hints).all();
}

std::vector<WeighedDoubt> doubtsOfLog(const StrokePair& strokes, const FittedStrokes& fitted,
                                      const ImportHints& hints) {
  std::vector<WeighedDoubt> doubts;
  const auto add = [&](DoubtCode code, double confidence, std::vector<MessageValue> values,
                       const Remedies& helps) {
    doubts.push_back({{code, std::move(values), leftToTry(helps, hints)}, confidence});
  };
  const Remedies takeOut(Message("Remove from the file all values that the sensor did not measure"));
  const Extent travel = travelOf(strokes.press), force = forceOf(strokes.press);
  if (implausibleTravel(travel.span()) && !hints.axes.xUnit)
    add(DoubtCode::implausibleTravel, unconfirmed, {{travel.span(), Measure::displacement_mm}},
        {{RemedyKind::giveXUnit, "if it is"}});
  if (implausibleForce(force.high) && !hints.axes.yUnit)
    add(DoubtCode::implausibleForce, unconfirmed, {{force.high, Measure::force_N}},
        {{RemedyKind::giveYUnit, "if it is"}});
  if (wrongSide(travel))
    add(DoubtCode::negativeTravel, contradicted, {{travel.low, Measure::displacement_mm}}, takeOut);
  if (pulls(force)) add(DoubtCode::negativeForce, contradicted, {{force.low, Measure::force_N}}, takeOut);
  if (endsInAFall(strokes.press)) add(DoubtCode::endsInAFall, unconfirmed, {}, takeOut);
  if (const std::size_t points = mostTactilePointsOf(fitted, strokes); points > mostTactilePoints)
    add(DoubtCode::manyTactilePoints, unconfirmed, {points}, takeOut);
  return doubts;
}

}  // namespace detent::importer
