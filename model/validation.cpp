// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/validation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "model/speed_family.h"

namespace detent {
namespace {

// Allowed crossing of strokes by measurement noise; datasheet graphs show at most 2 % of the force range.
constexpr double crossingShare = 0.02;
// Ends of strokes closer than this share of the travel (a line's width) coincide.
constexpr double meetingShare = 0.02;
constexpr std::size_t handyKnots = 200;
constexpr double lowConfidenceBar = 0.5;

std::string shortNumber(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

std::string mm(double value) { return shortNumber(value) + " mm"; }
std::string newton(double value) { return shortNumber(value) + " N"; }

// Displacements for comparing two curves: all knots and turns of both, and points between.
std::vector<double> sampleDisplacements(const StrokeCurve& a, const StrokeCurve& b) {
  std::vector<double> xs;
  const double from = std::max(a.start_mm(), b.start_mm()), to = std::min(a.end_mm(), b.end_mm());
  for (const StrokeCurve* curve : {&a, &b}) {
    for (const MonotoneStretch& s : curve->monotoneStretches()) xs.push_back(s.to_mm);
    for (const Knot& k : curve->knots()) xs.push_back(k.displacement_mm);
  }
  for (int i = 0; i <= 512; ++i) xs.push_back(from + (to - from) * i / 512);
  std::erase_if(xs, [&](double x) { return x < from || x > to; });
  std::sort(xs.begin(), xs.end());
  return xs;
}

struct Findings {
  std::vector<Warning> warnings;
  std::string state;

  std::optional<std::size_t> index;  // index of the state

  void add(Rule rule, const std::string& place, WarningPlace spot, double value, std::string_view unit,
           std::string problem, double against = 0) {
    spot.state = spot.state ? spot.state : index;
    std::string where = state;
    if (!place.empty()) where += (where.empty() ? "" : ", ") + place;
    if (where.empty()) where = "button";
    warnings.push_back({rule, where, value, unit, std::move(problem), spot, against});
  }
};

// Displacement where the first of the two bottom-outs begins; infinity if neither stroke has one.
double firstBottomOut(const StrokeCurve& press, const StrokeCurve& release, const SectionSettings& settings) {
  double first = std::numeric_limits<double>::infinity();
  for (const StrokeCurve* curve : {&press, &release})
    if (const BottomOut bottomOut = bottomOutOf(*curve, settings); bottomOut.isSteep)
      first = std::min(first, bottomOut.displacement_mm);
  return first;
}

struct Crossing {
  double above_N = 0, at_mm = 0;
};

// Largest distance of a release above a press.
Crossing worstCrossing(const StrokeCurve& press, const StrokeCurve& release,
                       const SectionSettings& settings) {
  const double bottomOut_mm = firstBottomOut(press, release, settings);
  Crossing worst;
  for (double x : sampleDisplacements(press, release)) {
    if (x >= bottomOut_mm) break;  // in a bottom-out a tiny displacement changes the force by any amount
    const double above_N = std::max(release.force_N(x), release.forceBefore_N(x)) -
                           std::max(press.force_N(x), press.forceBefore_N(x));
    if (above_N > worst.above_N) worst = {above_N, x};
  }
  return worst;
}

// Reports the worst pair of speeds.
void checkSpeeds(Findings& out, const ButtonState& state, const SectionSettings& settings) {
  const std::vector<double> speeds = speedsOf(state);
  Crossing worst;
  std::size_t pressed = 0, released = 0;
  for (std::size_t p = 0; p < speeds.size(); ++p)
    for (std::size_t r = 0; r < speeds.size(); ++r) {
      if (p == r && speeds[p] == *state.speed_mm_per_s) continue;  // release-above-press reports this pair
      if (p != r && !state.graph.release()) continue;  // a press is used as the release of its own speed only
      const Crossing each =
          worstCrossing(graphAt(state, p).press(), graphAt(state, r).curve(Stroke::release), settings);
      if (each.above_N <= worst.above_N) continue;
      worst = each, pressed = p, released = r;
    }
  const auto [low_N, high_N] = state.graph.press().forceRange_N();
  if (worst.above_N <= crossingShare * (high_N - low_N)) return;
  const auto speed = [&](std::size_t i) { return shortNumber(speeds[i]) + " mm/s"; };
  out.add(Rule::speedsGiveEnergy, "release curve at " + speed(released) + ", " + mm(worst.at_mm),
          {{}, Stroke::release, worst.at_mm, speeds[released]}, worst.above_N, "N",
          "lies " + newton(worst.above_N) + " above the press curve at " + speed(pressed), speeds[pressed]);
}

void checkStrokes(Findings& out, const ForceGraph& graph, const SectionSettings& settings) {
  if (!graph.release()) {
    out.add(Rule::noRelease, "release curve", {}, 0, "", "is not known; the press curve stands in for it");
    return;
  }
  const StrokeCurve &press = graph.press(), &release = *graph.release();
  const auto [low, high] = press.forceRange_N();
  const auto [worst_N, worst_mm] = worstCrossing(press, release, settings);
  if (worst_N > crossingShare * (high - low))
    out.add(Rule::releaseAbovePress, "release curve, " + mm(worst_mm), {{}, Stroke::release, worst_mm},
            worst_N, "N", "lies " + newton(worst_N) + " above the press curve");
  const double gap = std::abs(press.end_mm() - release.end_mm());
  if (gap > meetingShare * press.travel_mm())
    out.add(Rule::strokesDoNotMeet, "release curve, " + mm(release.end_mm()),
            {{}, Stroke::release, release.end_mm()}, gap, "mm",
            "begins " + mm(gap) + " away from the end of the press curve at " + mm(press.end_mm()),
            press.end_mm());
}

void checkCurve(Findings& out, const StrokeCurve& curve, Stroke stroke, const SectionSettings& settings) {
  const std::string name = stroke == Stroke::press ? "press curve" : "release curve";
  const double low = curve.forceRange_N().first;
  if (low < 0) {
    const auto lowest = curve.displacementsAt(low);
    const double at_mm = lowest.empty() ? curve.start_mm() : lowest.front();
    out.add(Rule::negativeForce, name + ", " + mm(at_mm), {{}, stroke, at_mm}, low, "N",
            "falls to " + newton(low) + ": the button pulls");
  }
  const auto stretches = curve.monotoneStretches();
  if (stroke == Stroke::press && !stretches.empty() && stretches.front().direction < 0)
    out.add(Rule::fallsAtStart, name + ", " + mm(curve.start_mm()), {{}, stroke, curve.start_mm()},
            curve.knots().front().force_N, "N", "begins with a falling force");
  const auto sections = sectionsOf(curve, stroke, settings);
  for (const TactilePoint& point : tactilePoints(curve, stroke, settings)) {
    const bool inside = std::any_of(sections.begin(), sections.end(), [&](const Section& s) {
      const auto [from, to] = std::minmax(s.from_mm, s.to_mm);
      return s.kind == SectionKind::jump && point.displacement_mm > from && point.displacement_mm < to;
    });
    if (inside)
      out.add(Rule::hiddenTactilePoint, name + ", " + mm(point.displacement_mm),
              {{}, stroke, point.displacement_mm}, point.force_N, "N",
              "has a tactile point of " + newton(point.force_N) + " inside an earlier jump");
  }
  if (curve.knots().size() > handyKnots)
    out.add(Rule::manyKnots, name, {{}, stroke, {}}, static_cast<double>(curve.knots().size()), "",
            "has " + std::to_string(curve.knots().size()) + " knots, more than a hand can edit");
}

void checkState(Findings& out, const ButtonState& state, const SectionSettings& settings) {
  out.state = state.name.empty() ? "" : "state \"" + state.name + "\"";
  checkStrokes(out, state.graph, settings);
  checkCurve(out, state.graph.press(), Stroke::press, settings);
  if (state.graph.release()) checkCurve(out, *state.graph.release(), Stroke::release, settings);
  checkSpeeds(out, state, settings);
  if (state.operatingPoint_mm && state.resetPoint_mm && *state.resetPoint_mm > *state.operatingPoint_mm)
    out.add(Rule::resetBeyondOperating, "reset point", {{}, Stroke::release, *state.resetPoint_mm},
            *state.resetPoint_mm, "mm",
            "at " + mm(*state.resetPoint_mm) + " lies deeper than the operating point at " +
                mm(*state.operatingPoint_mm),
            *state.operatingPoint_mm);
  const double start =
      std::min(state.graph.press().start_mm(), state.graph.curve(Stroke::release).start_mm());
  for (const DampingPoint& p : state.damping)
    if (p.displacement_mm < start || p.displacement_mm > state.graph.travel_mm()) {
      out.add(Rule::dampingOutsideTravel, "damping, " + mm(p.displacement_mm), {{}, {}, p.displacement_mm},
              p.displacement_mm, "mm",
              "lies outside the travel of " + mm(start) + " to " + mm(state.graph.travel_mm()),
              state.graph.travel_mm());
      break;
    }
}

void checkStatesMeet(Findings& out, const Button& button) {
  const auto& states = button.states();
  for (std::size_t i = 0; states.size() > 1 && i < states.size(); ++i) {
    const ButtonState &from = states[i], &to = states[(i + 1) % states.size()];
    const double released = from.graph.curve(Stroke::release).start_mm(),
                 pressed = to.graph.press().start_mm();
    const double gap = std::abs(released - pressed);
    if (gap > meetingShare * from.graph.press().travel_mm())
      out.add(Rule::statesDoNotMeet, "state \"" + from.name + "\", release curve, " + mm(released),
              {i, Stroke::release, released}, gap, "mm",
              "ends " + mm(gap) + " away from where state \"" + to.name + "\" starts, " + mm(pressed),
              pressed);
  }
}

}  // namespace

std::string_view nameOf(Rule rule) {
  switch (rule) {
    case Rule::releaseAbovePress:
      return "release-above-press";
    case Rule::strokesDoNotMeet:
      return "strokes-do-not-meet";
    case Rule::noRelease:
      return "no-release";
    case Rule::negativeForce:
      return "negative-force";
    case Rule::fallsAtStart:
      return "falls-at-start";
    case Rule::hiddenTactilePoint:
      return "hidden-tactile-point";
    case Rule::resetBeyondOperating:
      return "reset-beyond-operating";
    case Rule::statesDoNotMeet:
      return "states-do-not-meet";
    case Rule::dampingOutsideTravel:
      return "damping-outside-travel";
    case Rule::manyKnots:
      return "many-knots";
    case Rule::lowConfidence:
      return "low-confidence";
    case Rule::speedsGiveEnergy:
      return "speeds-give-energy";
  }
  return "unknown";
}

std::vector<Warning> validate(const Button& button, const SectionSettings& settings) {
  Findings out;
  for (std::size_t i = 0; i < button.states().size(); ++i) {
    out.index = i;
    checkState(out, button.states()[i], settings);
  }
  out.state.clear();
  out.index.reset();
  checkStatesMeet(out, button);
  if (button.provenance() && button.provenance()->confidence < lowConfidenceBar)
    out.add(Rule::lowConfidence, "import of " + button.provenance()->sourceFile, {},
            button.provenance()->confidence, "",
            "has a confidence of " + shortNumber(button.provenance()->confidence) + " only");
  return std::move(out.warnings);
}

}  // namespace detent
