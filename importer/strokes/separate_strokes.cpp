// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>

#include "importer/axes/text_source.h"
#include "importer/page/polyline.h"
#include "importer/strokes/legend.h"
#include "importer/strokes/pair_shape.h"
#include "importer/strokes/pairings.h"
#include "importer/strokes/stroke_pair.h"
#include "importer/strokes/switches.h"

namespace detent::importer {

namespace {

bool isFinite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

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
    if (!isFinite(q)) continue;
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

/// Confidence from a trace's own confidence: 0 for no curve, 1 from 0.7 on.
double credit(double traceConfidence) { return std::clamp(0.2 + 1.15 * traceConfidence, 0.0, 1.0); }

/// Decides which of two traces is the press.
Verdict judge(const CurveTrace& first, const CurveTrace& second, const PairShape& shape) {
  Verdict verdict;
  const auto vote = [&](std::optional<Stroke> ofFirst, std::optional<Stroke> ofSecond, double odds,
                        EvidenceCode source) {
    if (ofFirst == ofSecond) return;  // no text names a stroke, or both name the same one
    const bool firstIsPress = ofFirst ? *ofFirst == Stroke::press : *ofSecond == Stroke::release;
    verdict.add(firstIsPress ? odds : -odds, {source});
  };
  // The tracer separates curves of one colour; of two colours a person said which is which.
  vote(first.stroke, second.stroke, 5,
       first.color == second.color ? EvidenceCode::distinguishedByPath : EvidenceCode::distinguishedByHand);
  vote(strokeNamedBy(first.label), strokeNamedBy(second.label), 5, EvidenceCode::namedByLegend);
  const double apart = shape.above + shape.below;
  if (apart > 0.02) {
    const double lead = (shape.above - shape.below) / apart;
    verdict.add(
        4 * lead * std::min(1.0, apart / 0.1),
        {EvidenceCode::pressAboveRelease, {{std::max(shape.above, shape.below) / apart, Measure::share}}});
  }
  if (std::abs(shape.topsApart) > 0.01)
    verdict.add(shape.topsApart > 0 ? 0.7 : -0.7, {EvidenceCode::oneHigherForce});
  return verdict;
}

/// Remedies: curves in two colours are separated by naming the colours; curves in one colour must be
/// separated by hand.
Remedies remediesFor(bool oneColour, const Message& with) {
  if (oneColour)
    return {{RemedyKind::addMask, "over the curves of other switches"}, {RemedyKind::drawPress, {}}};
  return {{RemedyKind::pickPress, {}}, {RemedyKind::pickRelease, with}};
}

/// The only curve that was named the press, by hand or by the tracer; null if there is none or several.
const CurveTrace* onlyPress(const std::vector<CurveTrace>& traces) {
  const auto isPress = [](const CurveTrace& trace) {
    return trace.stroke == Stroke::press && trace.points_px.size() >= 2;
  };
  const auto press = std::ranges::find_if(traces, isPress);
  return std::ranges::count_if(traces, isPress) == 1 ? &*press : nullptr;
}

Failure tooMany(const std::vector<CurveTrace>& traces) {
  std::string colors;
  for (const CurveTrace& trace : traces) {
    colors += (colors.empty() ? "" : ", ") + nameOf(trace.color);
    if (!trace.label.empty()) colors += " (" + trace.label + ")";
  }
  const bool oneColour = std::ranges::all_of(
      traces, [&](const CurveTrace& trace) { return trace.color == traces.front().color; });
  // Beside a known press the others may be all but its release.
  const Remedies remedies =
      !oneColour && onlyPress(traces)
          ? Remedies{{RemedyKind::pickRelease, "with one of these"}, {RemedyKind::noRelease, {}}}
          : remediesFor(oneColour, "with two of these");
  return failureOf({DoubtCode::tooManyCurves, {traces.size(), colors}, remedies}, "plot frame");
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

/// Press and release of one switch. `sure`: confidence in that.
Result<Found<StrokePair>> pairOf(const CurveTrace& first, const CurveTrace& second, const AxesFound& axes,
                                 bool swap, double sure) {
  StrokePoints a = inUnits(first, axes.calibration.value), b = inUnits(second, axes.calibration.value);
  if (a.points.size() < 2 || b.points.size() < 2)
    return pressAlone(a.points.size() < 2 ? second : first, axes);
  const PairShape shape = shapeOf(CurvePath(first), CurvePath(second));
  const Verdict verdict = judge(first, second, shape);
  Found<StrokePair> found;
  // Two tints that the legend names separately but the tracer saw as one colour: which line has which tint is
  // unknown.
  constexpr double ofMergedTints = 0.45;
  const bool merged = first.color == second.color && namesBothStrokes(first.label);
  found.confidence = verdict.confidence() * credit(std::min(first.confidence, second.confidence)) *
                     (merged ? ofMergedTints : sure);
  found.evidence = verdict.reasons;
  if (sure < leastSure) found.evidence.push_back({EvidenceCode::endsApart});
  const bool firstIsPress = (verdict.logOdds >= 0) != swap;
  if (swap) {
    found.by = DecidedBy::given;
    found.confidence = 1;
    found.evidence = {{EvidenceCode::exchangedByHand}};
  } else if (std::abs(verdict.logOdds) < 0.4) {
    return failureOf({DoubtCode::strokesAlike,
                      {nameOf(first.color), nameOf(second.color)},
                      remediesFor(first.color == second.color, {})},
                     "plot frame");
  }
  // A key returns no more energy than was put into it. A curve above the press over a noticeable share of the
  // travel is therefore a callout's box or another switch's curve. Colours given by the user are accepted.
  constexpr double leastTravel = 0.28;  // share of the common travel; keys with two snaps have 0.23 at most
  const double above = firstIsPress ? shape.farBelow : shape.farAbove;
  const bool byHand = swap || (first.stroke && second.stroke && first.color != second.color);
  if (!byHand && above >= leastTravel)
    return failureOf({DoubtCode::releaseAbovePress,
                      {{above, Measure::share}},
                      {{RemedyKind::addMask, "over what is not a curve"},
                       {RemedyKind::pickPress, {}},
                       {RemedyKind::pickRelease, {}},
                       {RemedyKind::noRelease, {}}}},
                     "plot frame");
  if (!firstIsPress) std::swap(a, b);
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

/// A press of which a person says that it has no release. What its names say about one is settled.
Result<Found<StrokePair>> pressWithoutRelease(const CurveTrace& trace, const AxesFound& axes) {
  auto found = pressAlone(trace, axes);
  if (found) found->confidence = credit(trace.confidence), found->evidence.clear();
  return found;
}

Failure hiddenEnd() {
  return {FailureCode::notCertain, "plot frame", "",
          Message("the curve ends where the curve of another switch covers it"), RemedyKind::drawPress};
}

}  // namespace

StrokePoints strokeOf(const CurveTrace& trace, Stroke stroke, const AxisCalibration& calibration) {
  StrokePoints points = inUnits(trace, calibration);
  return stroke == Stroke::press ? points : travelledBack(std::move(points));
}

Result<Found<StrokePair>> separateStrokes(const std::vector<CurveTrace>& traces, const AxesFound& axes,
                                          const StrokeHints& hints) {
  const auto hasNumbers = [](const CurveTrace& trace) {
    return std::ranges::all_of(trace.points_px, isFinite);
  };
  if (!std::ranges::all_of(traces, hasNumbers)) {
    std::vector<CurveTrace> finite = traces;
    for (CurveTrace& trace : finite) std::erase_if(trace.points_px, std::not_fn(isFinite));
    return separateStrokes(finite, axes, hints);
  }
  const bool any = std::any_of(traces.begin(), traces.end(),
                               [](const CurveTrace& trace) { return trace.points_px.size() >= 2; });
  if (!any)
    return Failure{FailureCode::noForceGraph,
                   "plot frame",
                   "",
                   Message("there is no curve in the plot frame"),
                   {{RemedyKind::giveFrame, "if the plot stands elsewhere"},
                    {RemedyKind::pickPress, "with the curve's colour"}}};
  if (const CurveTrace* const press = hints.noRelease ? onlyPress(traces) : nullptr)
    return pressWithoutRelease(*press, axes);
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
  const double sure = switches[*chosen].sure;
  auto found = chosenTraces.size() > 1 ? pairOf(strokes[0], strokes[1], axes, hints.swap, sure)
               : hints.noRelease       ? pressWithoutRelease(strokes.front(), axes)
                                       : pressAlone(strokes.front(), axes);
  if (!found) return found;
  if (chosenTraces.size() == 1) found->confidence *= sure;
  if (hints.noRelease) found->value.release.reset();
  // One of several switches that no legend distinguishes: its release may lie under another one.
  constexpr double ofOneOfSeveral = 0.6;
  if (!hints.noRelease && chosenTraces.size() == 1 && switches.size() > 1 &&
      traces[chosenTraces.front()].label.empty())
    found->confidence = std::min(found->confidence, ofOneOfSeveral);
  std::ranges::move(assumed, std::back_inserter(found->evidence));
  return found;
}

}  // namespace detent::importer
