// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

#include "importer/axes/text_source.h"
#include "importer/page/polyline.h"
#include "importer/strokes/closed_loops.h"
#include "importer/strokes/legend.h"
#include "importer/strokes/stroke_pair.h"
#include "importer/strokes/switches.h"

namespace detent::importer {

namespace {

/// Evidence that the first of two traces is the press, in log-odds; negative: the second is.
struct Verdict {
  double logOdds = 0;
  std::vector<EvidenceItem> reasons;

  void add(double odds, EvidenceItem reason) {
    logOdds += odds;
    reasons.push_back(std::move(reason));
  }
  double confidence() const { return 1 / (1 + std::exp(-std::abs(logOdds))); }
};

/// The trace in mm and N by increasing displacement; a vertical line by increasing force.
StrokePoints inUnits(const CurveTrace& trace, const AxisCalibration& calibration) {
  StrokePoints stroke;
  stroke.fromVector = trace.fromVector;
  for (Point p : trace.points_px) {
    const Point q = calibration.toUnits(p);
    if (!std::isfinite(q.x) || !std::isfinite(q.y)) continue;
    stroke.points.push_back({q.x, q.y});
    stroke.points_px.push_back(p);
  }
  if (stroke.points.size() < 2) return stroke;
  const CurvePoint a = stroke.points.front(), b = stroke.points.back();
  const bool backwards =
      a.displacement_mm != b.displacement_mm ? a.displacement_mm > b.displacement_mm : a.force_N > b.force_N;
  if (backwards) {
    std::reverse(stroke.points.begin(), stroke.points.end());
    std::reverse(stroke.points_px.begin(), stroke.points_px.end());
  }
  return stroke;
}

StrokePoints travelledBack(StrokePoints stroke) {
  std::reverse(stroke.points.begin(), stroke.points.end());
  std::reverse(stroke.points_px.begin(), stroke.points_px.end());
  return stroke;
}

/// Mean force per cell of displacement; NaN where the stroke does not run.
std::vector<double> meanForces(const StrokePoints& stroke, double from_mm, double to_mm, std::size_t cells) {
  std::vector<double> sum(cells, 0), n(cells, 0);
  const auto cellOf = [&](double mm) {
    return (mm - from_mm) / (to_mm - from_mm) * static_cast<double>(cells);
  };
  for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
    const CurvePoint a = stroke.points[i], b = stroke.points[i + 1];
    const double ca = cellOf(a.displacement_mm), cb = cellOf(b.displacement_mm);
    // One sample per cell crossed, at least one per piece: sparse polylines fill every cell they pass.
    const int pieces = std::max(1, static_cast<int>(std::ceil(2 * std::abs(cb - ca))));
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, c = ca + t * (cb - ca);
      if (c < 0 || c >= static_cast<double>(cells)) continue;
      sum[static_cast<std::size_t>(c)] += a.force_N + t * (b.force_N - a.force_N);
      n[static_cast<std::size_t>(c)] += 1;
    }
  }
  for (std::size_t i = 0; i < cells; ++i) sum[i] = n[i] > 0 ? sum[i] / n[i] : NAN;
  return sum;
}

struct Comparison {
  double commonShare = 0;  ///< displacement that both cover, relative to that which either covers
  /// share of the common displacement where the first stroke lies clearly above the second
  double above = 0;
  double below = 0;
  double topDifference_N = 0;  ///< highest force of the first minus that of the second
};

/// Bottom-outs at the ends are left out, because there a small shift in displacement is a large difference in
/// force.
Comparison compare(const StrokePoints& a, const StrokePoints& b, double clear_N) {
  Comparison c;
  const auto span = [](const StrokePoints& s) {
    const auto [low, high] =
        std::minmax_element(s.points.begin(), s.points.end(),
                            [](CurvePoint p, CurvePoint q) { return p.displacement_mm < q.displacement_mm; });
    return std::pair(low->displacement_mm, high->displacement_mm);
  };
  const auto top = [](const StrokePoints& s) {
    return std::max_element(s.points.begin(), s.points.end(),
                            [](CurvePoint p, CurvePoint q) { return p.force_N < q.force_N; })
        ->force_N;
  };
  c.topDifference_N = top(a) - top(b);
  const auto [a0, a1] = span(a);
  const auto [b0, b1] = span(b);
  const double from = std::max(a0, b0), to = std::min(a1, b1);
  const double either = std::max(a1, b1) - std::min(a0, b0);
  c.commonShare = either > 0 ? std::max(0.0, to - from) / either : 0;
  if (!(to > from)) return c;
  constexpr std::size_t kCells = 200;
  const std::vector<double> forceA = meanForces(a, from, to, kCells),
                            forceB = meanForces(b, from, to, kCells);
  double n = 0;
  for (std::size_t i = kCells / 50; i < kCells - kCells / 50; ++i) {
    if (!std::isfinite(forceA[i]) || !std::isfinite(forceB[i])) continue;
    n += 1;
    if (forceA[i] - forceB[i] > clear_N) c.above += 1;
    if (forceB[i] - forceA[i] > clear_N) c.below += 1;
  }
  if (n > 0) {
    c.above /= n;
    c.below /= n;
  }
  return c;
}

/// Confidence from a trace's own confidence: 0 for no curve, 1 from 0.7 on.
double credit(double traceConfidence) { return std::clamp(0.2 + 1.15 * traceConfidence, 0.0, 1.0); }

/// The strokes of one switch run over the same travel; leaders, markers and curves of two switches need not.
double creditOfTravel(const Comparison& c) { return std::clamp((c.commonShare - 0.2) / 0.4, 0.0, 1.0); }

/// Returns true if the legend calls one trace the press and the other the release, so that they belong
/// together. The release of a key that stays locked has half the travel.
bool namedAsPair(const CurveTrace& first, const CurveTrace& second) {
  const auto a = strokeNamedBy(first.label), b = strokeNamedBy(second.label);
  return a && b && *a != *b;
}

/// Decides which of two traces is the press.
Verdict judge(const CurveTrace& first, const CurveTrace& second, const Comparison& c, double newtonPerPx) {
  Verdict verdict;
  const auto vote = [&](std::optional<Stroke> ofFirst, std::optional<Stroke> ofSecond, double odds,
                        EvidenceCode source) {
    if (ofFirst == ofSecond) return;  // no text names a stroke, or both name the same one
    const bool firstIsPress = ofFirst ? *ofFirst == Stroke::press : *ofSecond == Stroke::release;
    verdict.add(firstIsPress ? odds : -odds, {source});
  };
  vote(first.stroke, second.stroke, 5, EvidenceCode::distinguishedByPath);
  vote(strokeNamedBy(first.label), strokeNamedBy(second.label), 5, EvidenceCode::namedByLegend);
  const double apart = c.above + c.below;
  if (apart > 0.02) {
    const double lead = (c.above - c.below) / apart;
    verdict.add(4 * lead * std::min(1.0, apart / 0.1),
                {EvidenceCode::pressAboveRelease, {{std::max(c.above, c.below) / apart, Measure::share}}});
  }
  if (std::abs(c.topDifference_N) > 3 * newtonPerPx)
    verdict.add(c.topDifference_N > 0 ? 0.7 : -0.7, {EvidenceCode::oneHigherForce});
  return verdict;
}

/// Remedies: curves in two colours are separated by naming the colours; curves in one colour must be
/// separated by hand.
Remedies remediesFor(bool oneColour, const Message& with) {
  if (oneColour)
    return {{RemedyKind::addMask, "over the curves of other switches"}, {RemedyKind::drawPress, {}}};
  return {{RemedyKind::pickPress, {}}, {RemedyKind::pickRelease, with}};
}

Failure tooMany(const std::vector<CurveTrace>& traces) {
  std::string colors;
  for (const CurveTrace& trace : traces) {
    colors += (colors.empty() ? "" : ", ") + nameOf(trace.color);
    if (!trace.label.empty()) colors += " (" + trace.label + ")";
  }
  const bool oneColour = std::ranges::all_of(
      traces, [&](const CurveTrace& trace) { return trace.color == traces.front().color; });
  return failureOf(
      {DoubtCode::tooManyCurves, {traces.size(), colors}, remediesFor(oneColour, "with two of these")},
      "plot frame");
}

/// Returns true if a text names a point in its legend that would be a stroke in another legend: one entry
/// names the press by an unambiguous word, and another one names the point of the press ("downstroke",
/// "actuation", "release").
bool namesPointInLegend(const SeenText& text, const std::vector<SeenText>& texts) {
  if (!mayNameAPoint(text.utf8)) return false;
  const auto isBeside = [&](bool point) {
    return std::ranges::any_of(texts, [&](const SeenText& other) {
      return other.box.inLineWith(text.box) && mayNameAPoint(other.utf8) == point &&
             strokeNamedBy(other.utf8, sourceOf(other)) == Stroke::press;
    });
  };
  return isBeside(true) && isBeside(false);
}

/// The legend's name of the release that belongs to a named press; none if the legend has no such entry.
std::optional<std::string> releaseNamedBeside(const CurveTrace& press, const std::vector<SeenText>& texts) {
  if (press.labelBox_px.empty()) return {};
  const auto named = std::ranges::find_if(texts, [&](const SeenText& text) {
    return strokeNamedBy(text.utf8, sourceOf(text)) == Stroke::release && !namesPointInLegend(text, texts) &&
           namesOnePair(press.label, text.utf8) && text.box.inLineWith(press.labelBox_px);
  });
  return named == texts.end() ? std::nullopt : std::optional(named->utf8);
}

/// Words that name a release and nothing else, in a legend or a callout. If they occur, a release is drawn.
std::optional<std::string> releaseNamedAnywhere(const std::vector<SeenText>& texts) {
  const auto named = std::ranges::find_if(texts, [&](const SeenText& text) {
    return namesNothingButRelease(text.utf8, sourceOf(text)) && !namesPointInLegend(text, texts);
  });
  return named == texts.end() ? std::nullopt : std::optional(named->utf8);
}

Result<Found<StrokePair>> pressAlone(const CurveTrace& trace, const AxesFound& axes) {
  Found<StrokePair> found;
  found.value.press = inUnits(trace, axes.calibration.value);
  if (found.value.press.points.size() < 2)
    return Failure{FailureCode::noForceGraph,
                   "plot frame",
                   "",
                   Message("the curve has fewer than two points"),
                   {{RemedyKind::pickPress, "with the curve's colour"}}};
  const bool namedRelease = trace.stroke == Stroke::release || strokeNamedBy(trace.label) == Stroke::release;
  auto notSeen = releaseNamedBeside(trace, axes.texts);
  // A title may have become the curve's name, and in a loop of one colour it may be the word for the release.
  if (!notSeen) notSeen = releaseNamedAnywhere(axes.texts);
  // Confidences of a single trace, by the stroke that its name gives.
  constexpr double ofOneNamed = 0.9, ofRelease = 0.5, ofBoth = 0.4;
  const bool bothNamed = namesBothStrokes(trace.label) || notSeen;
  found.confidence = (bothNamed ? ofBoth : namedRelease ? ofRelease : ofOneNamed) * credit(trace.confidence);
  if (notSeen)
    found.evidence = {{EvidenceCode::releaseNamedNotSeen, {*notSeen}}};
  else
    found.evidence = {{namedRelease ? EvidenceCode::pressAloneThoughNamedRelease : EvidenceCode::pressAlone}};
  return found;
}

/// A key returns no more energy than was put into it. A curve above the press over a noticeable share of the
/// travel is therefore a callout's box or another switch's curve. Colours given by the user are accepted.
std::optional<Failure> releaseAbove(const StrokePoints& press, const StrokePoints& release) {
  // share of the press force; share of the shared travel
  constexpr double clearShare = 0.05, leastTravel = 0.15;
  const auto [low, high] =
      std::minmax_element(press.points.begin(), press.points.end(),
                          [](CurvePoint p, CurvePoint q) { return p.force_N < q.force_N; });
  const double share = compare(press, release, clearShare * (high->force_N - low->force_N)).below;
  if (share < leastTravel) return {};
  return failureOf({DoubtCode::releaseAbovePress,
                    {{share, Measure::share}},
                    {{RemedyKind::addMask, "over what is not a curve"},
                     {RemedyKind::pickPress, {}},
                     {RemedyKind::pickRelease, {}}}},
                   "plot frame");
}

/// A stroke's largest drop of force over increasing displacement.
struct Drop {
  double force_N = 0;
  /// displacement at which most of the drop has happened: on the flat floor of a valley, noise decides which
  /// point is lowest
  double valley_mm = 0;
};

Drop largestDrop(const StrokePoints& stroke) {
  constexpr double over = 0.95;  // share of the drop
  Drop largest;
  auto peak = stroke.points.begin(), from = peak;
  for (auto p = stroke.points.begin(); p != stroke.points.end(); ++p) {
    if (p->force_N > peak->force_N) peak = p;
    if (peak->force_N - p->force_N > largest.force_N)
      largest.force_N = peak->force_N - p->force_N, from = peak;
  }
  const auto valley = std::find_if(from, stroke.points.end(), [&](CurvePoint p) {
    return from->force_N - p.force_N >= over * largest.force_N;
  });
  if (valley != stroke.points.end()) largest.valley_mm = valley->displacement_mm;
  return largest;
}

double topOf(const StrokePoints& stroke, double CurvePoint::*coordinate) {
  return (*std::ranges::max_element(stroke.points, {}, coordinate)).*coordinate;
}

/// Returns true if both strokes drop so much that position and shape of the drops distinguish them.
bool bothDrop(const StrokePoints& press, const StrokePoints& release) {
  constexpr double leastDrop = 0.05;  // share of the press' highest force
  const double highest_N = topOf(press, &CurvePoint::force_N);
  return std::min(largestDrop(press).force_N, largestDrop(release).force_N) > leastDrop * highest_N;
}

/// Returns true if the release drops at larger displacement than the press. Friction delays a switch, so its
/// release drops at less displacement; otherwise it is another switch's. Both by increasing displacement
/// (docs/develop/decisions/0809-several-curves-in-one-colour.md).
bool dropsLater(const StrokePoints& press, const StrokePoints& release) {
  constexpr double late = 0.05;  // share of the travel; 192 pairs have 0.035 at most, a named dome more
  const double travel_mm = press.points.back().displacement_mm - press.points.front().displacement_mm;
  return bothDrop(press, release) &&
         largestDrop(release).valley_mm - largestDrop(press).valley_mm > late * travel_mm;
}

/// Span of both strokes together.
double spanOfBoth(const StrokePoints& first, const StrokePoints& second, double CurvePoint::*coordinate) {
  const double low = (*std::ranges::min_element(first.points, {}, coordinate)).*coordinate,
               otherLow = (*std::ranges::min_element(second.points, {}, coordinate)).*coordinate;
  return std::max(topOf(first, coordinate), topOf(second, coordinate)) - std::min(low, otherLow);
}

/// Difference of the first's largest value and the second's, as a share of their common span.
double topsApart(const StrokePoints& first, const StrokePoints& second, double CurvePoint::*coordinate) {
  return (topOf(first, coordinate) - topOf(second, coordinate)) / spanOfBoth(first, second, coordinate);
}

/// Returns true if a release ends clearly before the end of the press. It starts where the press ended, so it
/// was traced incompletely or is another switch's press.
bool reachApart(const StrokePoints& first, const StrokePoints& second) {
  constexpr double clear = 0.1;  // share of both strokes' travel
  return std::abs(topsApart(first, second, &CurvePoint::displacement_mm)) > clear;
}

/// Distance in force between the lines where both end, as a share of their span, if neither is steep there:
/// the loop is open, as between curves of two switches. On a bottom-out the strokes of one button may be cut
/// at different heights.
double openAtTheEnd(const StrokePoints& first, const StrokePoints& second) {
  // share of the travel; share of the span, over that stretch
  constexpr double lastShare = 0.03, steep = 0.1;
  constexpr std::size_t columns = 200;
  const double least_mm = lastShare * spanOfBoth(first, second, &CurvePoint::displacement_mm),
               span_N = spanOfBoth(first, second, &CurvePoint::force_N);
  struct Tip {
    double rise_N = 0, force_N = 0;
  };
  const auto tipOf = [&](const StrokePoints& stroke) {
    const double end_mm = topOf(stroke, &CurvePoint::displacement_mm);
    std::vector<double> forces = meanForces(stroke, end_mm - least_mm, end_mm, columns);
    std::erase_if(forces, [](double force_N) { return !std::isfinite(force_N); });
    if (forces.empty()) return Tip{};
    const auto [low, high] = std::ranges::minmax_element(forces);
    return Tip{*high - *low, forces.back()};
  };
  const Tip a = tipOf(first), b = tipOf(second);
  if (!(span_N > 0) || std::max(a.rise_N, b.rise_N) > steep * span_N) return 0;
  return std::abs(a.force_N - b.force_N) / span_N;
}

/// Returns true if one of two lines in different colours reaches farther and the other higher: they belong to
/// two switches. A release that ends below the press reaches less in both directions.
bool tipsCrossed(const StrokePoints& first, const StrokePoints& second) {
  constexpr double clearForce = 0.1;    // share of both strokes' span; 123 drawn pairs have 0.013 at most
  constexpr double clearTravel = 0.02;  // share of both strokes' span; 0 in those pairs
  const double higher = topsApart(first, second, &CurvePoint::force_N),
               further = topsApart(first, second, &CurvePoint::displacement_mm);
  return higher * further < 0 && std::abs(higher) > clearForce && std::abs(further) > clearTravel;
}

/// A stroke's points with each coordinate as a share of `span`.
Polyline inShares(const StrokePoints& stroke, CurvePoint span) {
  Polyline shares;
  shares.reserve(stroke.points.size());
  for (const CurvePoint& p : stroke.points)
    shares.push_back({p.displacement_mm / span.displacement_mm, p.force_N / span.force_N});
  return shares;
}

/// Smaller distance of a far end from the other line, as a share of their common span.
double gapOfStrokes(const StrokePoints& first, const StrokePoints& second) {
  const CurvePoint span{spanOfBoth(first, second, &CurvePoint::displacement_mm),
                        spanOfBoth(first, second, &CurvePoint::force_N)};
  if (!(span.displacement_mm > 0 && span.force_N > 0)) return 0;
  const Polyline a = inShares(first, span), b = inShares(second, span);
  const auto farEnd = [](const Polyline& line) { return *std::ranges::max_element(line, {}, &Point::x); };
  return gapAtTheEnds(a, farEnd(a), b, farEnd(b));
}

/// Returns true if two lines in different colours end at different heights, with the lower end beside the
/// other line and not on it: two presses, each with its own bottom-out. A release that is cut lower on the
/// bottom-out begins on the press.
bool bottomOutsApart(const StrokePoints& first, const StrokePoints& second) {
  constexpr double clearForce = 0.12;  // share of both strokes' span
  // share of both spans; 449 drawn pairs of measured switches have 0.005 at most
  constexpr double beside = 0.01;
  return std::abs(topsApart(first, second, &CurvePoint::force_N)) > clearForce &&
         gapOfStrokes(first, second) > beside;
}

/// Share of the mean square difference between two strokes, over their common travel, that vanishes if one is
/// scaled in force and shifted along the travel: 1 for two samples of one shape.
double sharedShape(const StrokePoints& first, const StrokePoints& second) {
  constexpr int cells = 200, mostMoved = 20;
  const double from_mm =
      std::max(first.points.front().displacement_mm, second.points.front().displacement_mm);
  const double to_mm =
      std::min(topOf(first, &CurvePoint::displacement_mm), topOf(second, &CurvePoint::displacement_mm));
  if (!(to_mm > from_mm)) return 0;
  const std::vector<double> a = meanForces(first, from_mm, to_mm, cells),
                            b = meanForces(second, from_mm, to_mm, cells);
  const auto meanSquare = [&](int moved, std::optional<double> scale) {
    double aa = 0, ab = 0, bb = 0, n = 0;
    for (int i = std::max(0, -moved); i < cells - std::max(0, moved); ++i) {
      const double x = a[static_cast<std::size_t>(i + moved)], y = b[static_cast<std::size_t>(i)];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      aa += x * x, ab += x * y, bb += y * y, n += 1;
    }
    if (!(aa > 0)) return std::numeric_limits<double>::infinity();
    const double k = scale.value_or(ab / aa);
    return std::max(0.0, bb - 2 * k * ab + k * k * aa) / n;
  };
  const double apart = meanSquare(0, 1);
  double left = apart;
  for (int moved = -mostMoved; moved <= mostMoved; ++moved) left = std::min(left, meanSquare(moved, {}));
  return apart > 0 ? 1 - left / apart : 0;
}

/// Returns true for two presses, of two samples or states: one is a scaled copy of the other, which friction
/// cannot cause, and the loop stays open.
bool twoOfOneShape(const StrokePoints& first, const StrokePoints& second) {
  constexpr double open = 0.015;  // pairs of one shape have at most 0.007, more with a stepped bottom-out
  constexpr double alike = 0.9;   // pairs that stay open have 0.84 at most
  return bothDrop(first, second) && gapOfStrokes(first, second) > open && sharedShape(first, second) > alike;
}

/// Returns true for the release of a key that locks: both lines end together, and the one that starts at
/// larger displacement reaches the force at rest from which the other starts, below it along the whole way.
/// Both by increasing displacement.
bool locksAtBaseline(const StrokePoints& press, const StrokePoints& release, double below) {
  constexpr double farther = 0.15, together = 0.015, atRest = 0.1;  // of the span of both
  constexpr double mostBelow = 0.02;                                // share of the shared travel
  const double span_mm = spanOfBoth(press, release, &CurvePoint::displacement_mm),
               rest_N = atRest * spanOfBoth(press, release, &CurvePoint::force_N);
  const CurvePoint from = press.points.front(), to = release.points.front();
  return to.displacement_mm - from.displacement_mm > farther * span_mm && below <= mostBelow &&
         std::max(std::abs(from.force_N), std::abs(to.force_N)) < rest_N && !reachApart(press, release) &&
         gapOfStrokes(press, release) < together;
}

/// Press and release of one switch.
Result<Found<StrokePair>> pairOf(const CurveTrace& first, const CurveTrace& second, const AxesFound& axes,
                                 bool swap) {
  const AxisCalibration& calibration = axes.calibration.value;
  StrokePoints a = inUnits(first, calibration), b = inUnits(second, calibration);
  if (a.points.size() < 2 || b.points.size() < 2)
    return pressAlone(a.points.size() < 2 ? second : first, axes);
  const double newtonPerPx = std::abs(calibration.newtonPerPx());
  const Comparison compared = compare(a, b, 0.6 * newtonPerPx);
  const Verdict verdict = judge(first, second, compared, newtonPerPx);
  Found<StrokePair> found;
  // Two tints that the legend names separately but the tracer saw as one colour: which line has which tint is
  // unknown.
  constexpr double ofMergedTints = 0.45;
  // largest confidence from the common travel of two curves whose ends lie apart
  constexpr double ofApart = 0.45;
  const bool byHand = swap || (first.stroke && second.stroke && first.color != second.color);
  const bool merged = first.color == second.color && namesBothStrokes(first.label);
  const bool paired = namedAsPair(first, second);
  // share of the force span; 327 drawn or measured buttons have 0.13 at most
  constexpr double mostOpen = 0.16;
  const bool apart = !byHand && !paired &&
                     (reachApart(a, b) || openAtTheEnd(a, b) > mostOpen || twoOfOneShape(a, b) ||
                      (first.color != second.color && (tipsCrossed(a, b) || bottomOutsApart(a, b))));
  const bool locks =
      verdict.logOdds < 0 ? locksAtBaseline(b, a, compared.above) : locksAtBaseline(a, b, compared.below);
  const double shared = locks ? 1 : creditOfTravel(compared);
  const double travel = apart ? std::min(ofApart, shared) : shared;
  const double together = merged ? ofMergedTints : paired ? 1 : travel;
  found.confidence = verdict.confidence() * credit(std::min(first.confidence, second.confidence)) * together;
  found.evidence = verdict.reasons;
  if (apart) found.evidence.push_back({EvidenceCode::endsApart});
  bool firstIsPress = verdict.logOdds >= 0;
  if (swap) {
    firstIsPress = !firstIsPress;
    found.by = DecidedBy::given;
    found.confidence = 1;
    found.evidence = {{EvidenceCode::exchangedByHand}};
  } else if (std::abs(verdict.logOdds) < 0.4) {
    return failureOf({DoubtCode::strokesAlike,
                      {nameOf(first.color), nameOf(second.color)},
                      remediesFor(first.color == second.color, {})},
                     "plot frame");
  }
  if (!firstIsPress) std::swap(a, b);
  if (!byHand) {
    if (auto above = releaseAbove(a, b)) return std::move(*above);
    if (!paired && dropsLater(a, b)) return tooMany({first, second});
  }
  found.value.press = std::move(a);
  found.value.release = travelledBack(std::move(b));
  return found;
}

/// Orders a trace from left to right.
void orient(CurveTrace& trace) {
  if (trace.points_px.front().x <= trace.points_px.back().x) return;
  std::ranges::reverse(trace.points_px);
  std::ranges::reverse(trace.width_px);
}

/// A stroke begins at rest, at the baseline. If its beginning lies under another curve, it is extended
/// downwards along that one. Returns true if it was.
bool leadDownUnder(CurveTrace& own, CurveTrace other) {
  // the second of the other's height, the third of its width
  constexpr double touching_px = 3, least = 0.05, most = 0.05;
  if (own.fromVector || own.points_px.size() < 2 || other.points_px.size() < 2) return false;
  orient(own), orient(other);
  const auto [top, lowest] = std::ranges::minmax(own.points_px, {}, &Point::y);
  const Point left = own.points_px.front();
  const auto near = std::ranges::min_element(other.points_px, {}, [&](Point p) { return distance(p, left); });
  const double width_px = own.points_px.back().x - left.x, from_px = left.x - most * width_px;
  const bool rising = std::all_of(other.points_px.begin(), near, [&](Point p) {
    return p.x >= from_px && p.x <= left.x + touching_px && p.y >= left.y - touching_px;
  });
  if (!rising || distance(*near, left) > touching_px) return false;
  if (other.points_px.front().y - left.y <= least * (lowest.y - top.y)) return false;
  own.points_px.insert(own.points_px.begin(), other.points_px.begin(), near);
  if (!own.width_px.empty())
    own.width_px.insert(own.width_px.begin(), static_cast<std::size_t>(near - other.points_px.begin()),
                        own.width_px.front());
  return true;
}

/// Extends `own` along `other` to the end of the travel. A release begins where the press ends, so a stroke
/// that stops under the other one, shortly before that one ends, is hidden by it. `cover`: largest distance
/// between their middles, as a share of their width. Returns true if it was extended.
bool leadUpUnder(CurveTrace& own, CurveTrace other, double cover) {
  constexpr double least = 0.05,
                   most = 0.1;     // smallest and largest hidden part: of the other's height; of its width
  constexpr double onwards = 0.7;  // cosine
  constexpr std::size_t stepsBack = 8;  // points
  if (own.fromVector || own.points_px.size() <= stepsBack || other.points_px.size() <= stepsBack)
    return false;
  orient(own), orient(other);
  const auto [top, lowest] = std::ranges::minmax(own.points_px, {}, &Point::y);
  const Point end = own.points_px.back(), tip = other.points_px.back();
  const auto near = std::ranges::min_element(other.points_px, {}, [&](Point p) { return distance(p, end); });
  const auto widthOf = [](const CurveTrace& t) { return t.width_px.empty() ? 1 : t.width_px.back(); };
  if (distance(*near, end) > cover * 0.5 * (widthOf(own) + widthOf(other)) + 0.5) return false;
  if (near + 1 >= other.points_px.end() || end.y - tip.y <= least * (lowest.y - top.y)) return false;
  if (tip.x - end.x > most * (end.x - own.points_px.front().x)) return false;
  const auto at = static_cast<std::size_t>(near - other.points_px.begin());
  const Point ownStep = end - own.points_px[own.points_px.size() - 1 - stepsBack],
              others = other.points_px[std::min(at + stepsBack, other.points_px.size() - 1)] - *near;
  if (dot(ownStep, others) < onwards * norm(ownStep) * norm(others)) return false;
  // The tip itself is left out, so that each trace keeps an end of its own by which its stroke is identified.
  own.points_px.insert(own.points_px.end(), near + 1, other.points_px.end() - 1);
  if (!own.width_px.empty()) own.width_px.resize(own.points_px.size(), own.width_px.back());
  return true;
}

/// Returns true if `other` continues from one end of `own` in the same direction: the rest of `own` is hidden
/// under it. A line that only crosses the end hides nothing.
bool hidesAnEndOf(CurveTrace own, CurveTrace other) {
  constexpr double goesOnShare = 0.05, sameWay = 0.7;  // share of the height that `own` spans; cosine
  constexpr std::size_t stepsBack = 8;                 // points to either side
  constexpr double most_px = 3;                        // between the middles of both lines
  orient(own), orient(other);
  const auto [top, lowest] = std::ranges::minmax(own.points_px, {}, &Point::y);
  const auto [otherTop, otherLowest] = std::ranges::minmax(other.points_px, {}, &Point::y);
  const double further_px = goesOnShare * (lowest.y - top.y);
  const auto widthOf = [](const CurveTrace& t) { return t.width_px.empty() ? most_px : t.width_px.back(); };
  const double touching_px = std::min(most_px, 0.5 * (widthOf(own) + widthOf(other) + 1));
  const auto wayAt = [&](const Polyline& points, Polyline::const_iterator at) {
    const auto i = static_cast<std::size_t>(at - points.begin());
    return points[std::min(i + stepsBack, points.size() - 1)] - points[i - std::min(i, stepsBack)];
  };
  const auto covers = [&](Polyline::const_iterator end) {
    const auto near =
        std::ranges::min_element(other.points_px, {}, [&](Point p) { return distance(p, *end); });
    const Point ownStep = wayAt(own.points_px, end), others = wayAt(other.points_px, near);
    return distance(*near, *end) <= touching_px &&
           dot(ownStep, others) >= sameWay * norm(ownStep) * norm(others);
  };
  return (own.points_px.back().y - otherTop.y > further_px && covers(std::prev(own.points_px.end()))) ||
         (otherLowest.y - own.points_px.front().y > further_px && covers(own.points_px.begin()));
}

Failure hiddenEnd() {
  return {FailureCode::notCertain, "plot frame", "",
          Message("the curve ends where the curve of another switch covers it"), RemedyKind::drawPress};
}

}  // namespace

Result<Found<StrokePair>> separateStrokes(const std::vector<CurveTrace>& traces, const AxesFound& axes,
                                          const StrokeHints& hints) {
  const bool any = std::any_of(traces.begin(), traces.end(),
                               [](const CurveTrace& trace) { return trace.points_px.size() >= 2; });
  if (!any)
    return Failure{FailureCode::noForceGraph,
                   "plot frame",
                   "",
                   Message("there is no curve in the plot frame"),
                   {{RemedyKind::giveFrame, "if the plot stands elsewhere"},
                    {RemedyKind::pickPress, "with the curve's colour"}}};
  const std::vector<PlotSwitch> switches = switchesAmong(traces);
  if (switches.empty()) return tooMany(traces);
  const auto chosen = chosenSwitch(switches, traces, hints.curve);
  if (!chosen) return chosen.failure();
  const std::vector<std::size_t>& chosenTraces = switches[*chosen].traces;
  std::vector<CurveTrace> strokes;
  for (const std::size_t t : chosenTraces) strokes.push_back(traces[t]);
  std::vector<EvidenceItem> assumed;
  if (!hints.curve.empty() && !isNamed(switches, *chosen, traces, hints.curve))
    assumed.push_back({EvidenceCode::nameNearly, {hints.curve, switches[*chosen].name}});
  bool led = false;
  for (const PlotSwitch& other : switches)
    for (const std::size_t t : other.traces)
      for (CurveTrace& stroke : strokes)
        if (&other != &switches[*chosen]) led = leadDownUnder(stroke, traces[t]) || led;
  if (led) assumed.push_back({EvidenceCode::startUnderAnother});
  // A press whose end touches its release reaches the force from which that comes back. A release farther
  // from the press's middle is seen to its end (docs/develop/decisions/0509-bottom-outs-on-lines.md).
  constexpr double ofPress = 1, ofRelease = 0.2;
  if (strokes.size() == 2 && strokes[0].color != strokes[1].color &&
      !leadUpUnder(strokes[0], strokes[1], ofPress))
    leadUpUnder(strokes[1], strokes[0], ofRelease);
  for (const PlotSwitch& other : switches)
    for (const std::size_t t : other.traces)
      if (&other != &switches[*chosen] && hidesAnEndOf(strokes.front(), traces[t])) return hiddenEnd();
  // Two legend entries of one colour belong to two strokes that were not separated.
  if (chosenTraces.size() == 1 && switches.size() > 1 && !strokes.front().stroke &&
      strokes.front().label.find(kLabelParting) != std::string::npos)
    return tooMany(traces);
  auto found = chosenTraces.size() == 1 ? pressAlone(strokes.front(), axes)
                                        : pairOf(strokes[0], strokes[1], axes, hints.swap);
  if (!found) return found;
  // One of several switches that no legend distinguishes: its release may lie under another one.
  constexpr double ofOneOfSeveral = 0.6;
  if (chosenTraces.size() == 1 && switches.size() > 1 && traces[chosenTraces.front()].label.empty())
    found->confidence = std::min(found->confidence, ofOneOfSeveral);
  std::ranges::move(assumed, std::back_inserter(found->evidence));
  return found;
}

}  // namespace detent::importer
