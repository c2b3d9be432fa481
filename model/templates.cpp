// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/templates.h"

#include <algorithm>

namespace detent {
namespace {

void appendBottomOut(std::vector<CurvePoint>& points, std::optional<double> bottomOutForce_N) {
  if (bottomOutForce_N) points.push_back({points.back().displacement_mm, *bottomOutForce_N});
}

Result<ForceGraph> graphFrom(const StrokeSketch& press, const StrokeSketch& release) {
  auto pressCurve = strokeFrom(press);
  if (!pressCurve) return pressCurve.failure();
  auto releaseCurve = strokeFrom(release);
  if (!releaseCurve) return releaseCurve.failure();
  return ForceGraph::fromCurves(*std::move(pressCurve), *std::move(releaseCurve));
}

Result<Button> momentary(std::string name, const StrokeSketch& press, const StrokeSketch& release,
                         std::optional<double> operatingPoint_mm, std::optional<double> resetPoint_mm) {
  auto graph = graphFrom(press, release);
  if (!graph) return graph.failure();
  return Button::fromStates(std::move(name),
                            {ButtonState{"", *std::move(graph), operatingPoint_mm, resetPoint_mm, {}}});
}

StrokeSketch pressSketch(const TactileTemplate& values) {
  StrokeSketch sketch{{{0, values.startForce_N}}, {}};
  for (const PressLevel& level : values.press) {
    sketch.points.push_back(level.tactile);
    sketch.points.push_back(level.valley);
  }
  sketch.points.push_back({values.travel_mm, values.endForce_N});
  appendBottomOut(sketch.points, values.bottomOutForce_N);
  return sketch;
}

StrokeSketch releaseSketch(const TactileTemplate& values) {
  StrokeSketch sketch{{{0, values.releaseStartForce_N}}, {}};
  for (auto level = values.release.rbegin(); level != values.release.rend(); ++level) {
    sketch.points.push_back(level->hump);
    sketch.points.push_back(level->tactile);
  }
  sketch.points.push_back({values.travel_mm, values.releaseEndForce_N});
  appendBottomOut(sketch.points, values.bottomOutForce_N);
  return sketch;
}

}  // namespace

Result<StrokeCurve> strokeFrom(const StrokeSketch& sketch) {
  auto smooth = StrokeCurve::throughPoints(sketch.points);
  if (!smooth || sketch.straight.empty()) return smooth;
  std::vector<Knot> knots = smooth->knots();
  for (std::size_t piece : sketch.straight) {
    if (piece + 1 >= knots.size())
      return Failure{
          FailureCode::wrongUsage, "stroke sketch", Message("piece %1", piece + 1),
          Message("there is no such piece, because the curve has only %1 pieces", knots.size() - 1),
          Message("Choose one of its pieces")};
    Knot &a = knots[piece], &b = knots[piece + 1];
    if (a.displacement_mm == b.displacement_mm) continue;
    a.slopeAfter_N_per_mm = b.slopeBefore_N_per_mm =
        (b.force_N - a.force_N) / (b.displacement_mm - a.displacement_mm);
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<Button> linearButton(const LinearTemplate& values) {
  StrokeSketch press{{{0, values.startForce_N}, {values.travel_mm, values.endForce_N}}, {0}};
  StrokeSketch release{{{0, values.startForce_N - values.hysteresis_N},
                        {values.travel_mm, values.endForce_N - values.hysteresis_N}},
                       {0}};
  appendBottomOut(press.points, values.bottomOutForce_N);
  appendBottomOut(release.points, values.bottomOutForce_N);
  return momentary(values.name, press, release, values.operatingPoint_mm, values.resetPoint_mm);
}

Result<Button> tactileButton(const TactileTemplate& values) {
  return momentary(values.name, pressSketch(values), releaseSketch(values), values.operatingPoint_mm,
                   values.resetPoint_mm);
}

Result<Button> clickyButton(const ClickyTemplate& values) {
  StrokeSketch press{{{0, values.startForce_N},
                      values.tactile,
                      {values.tactile.displacement_mm + values.collapse_mm, values.valleyForce_N},
                      {values.travel_mm, values.endForce_N}},
                     {0, 1, 2}};
  StrokeSketch release{
      {{0, values.releaseStartForce_N},
       {values.releaseTactile.displacement_mm - values.collapse_mm, values.releaseHumpForce_N},
       values.releaseTactile,
       {values.tactile.displacement_mm + values.collapse_mm,
        values.valleyForce_N - (values.endForce_N - values.releaseEndForce_N)},
       {values.travel_mm, values.releaseEndForce_N}},
      {0, 1, 3}};
  appendBottomOut(press.points, values.bottomOutForce_N);
  appendBottomOut(release.points, values.bottomOutForce_N);
  return momentary(values.name, press, release, values.operatingPoint_mm, values.resetPoint_mm);
}

TactileTemplate twoLevelValues() {
  TactileTemplate values;
  values.name = "two-level";
  values.travel_mm = 1.6;
  values.startForce_N = 0.20;
  values.press = {{{0.40, 0.80}, {0.60, 0.62}}, {{1.05, 1.90}, {1.25, 1.30}}};
  values.endForce_N = 2.00;
  values.releaseStartForce_N = 0.10;
  values.release = {{{1.15, 0.95}, {0.98, 1.30}}, {{0.50, 0.40}, {0.36, 0.55}}};
  values.releaseEndForce_N = 1.90;
  values.bottomOutForce_N = 4.0;
  values.operatingPoint_mm = 1.2;
  values.resetPoint_mm = 1.05;
  return values;
}

Result<Button> twoLevelButton() { return tactileButton(twoLevelValues()); }

Result<Button> selfLockingButton(const SelfLockingTemplate& values) {
  if (!(values.lock_mm > values.press.valley.displacement_mm && values.lock_mm < values.travel_mm))
    return Failure{FailureCode::wrongUsage, "self-locking button", Message("lock position"),
                   Message("the lock position does not lie between the valley and the end of the travel"),
                   Message("Move the lock position between the two")};
  StrokeSketch unlockedPress{{{0, values.startForce_N},
                              values.press.tactile,
                              values.press.valley,
                              {values.travel_mm, values.endForce_N}},
                             {}};
  StrokeSketch unlockedRelease{
      {{values.lock_mm, values.lockForce_N}, {values.travel_mm, values.endForce_N - values.hysteresis_N}},
      {0}};
  StrokeSketch lockedPress{{{values.lock_mm, values.lockForce_N},
                            {values.lock_mm, values.lockedStartForce_N},
                            {values.travel_mm, values.endForce_N}},
                           {1}};
  StrokeSketch lockedRelease{{{0, values.releaseStartForce_N},
                              values.release.hump,
                              values.release.tactile,
                              {values.travel_mm, values.endForce_N - values.hysteresis_N}},
                             {}};
  for (StrokeSketch* sketch : {&unlockedPress, &unlockedRelease, &lockedPress, &lockedRelease})
    appendBottomOut(sketch->points, values.bottomOutForce_N);
  auto unlocked = graphFrom(unlockedPress, unlockedRelease);
  if (!unlocked) return unlocked.failure();
  auto locked = graphFrom(lockedPress, lockedRelease);
  if (!locked) return locked.failure();
  // Both states latch between the lock and the end, where both release curves pass.
  const double latch_mm = 0.5 * (values.lock_mm + values.travel_mm);
  return Button::fromStates(values.name, {ButtonState{"unlocked", *std::move(unlocked), latch_mm, {}, {}},
                                          ButtonState{"locked", *std::move(locked), latch_mm, {}, {}}});
}

}  // namespace detent
