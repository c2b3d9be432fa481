// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/key_figures.h"

#include "model/metrics.h"

namespace detent {
namespace {

// Marks a term for translation.
constexpr const char* words(const char* term) { return term; }

/// Returns the tactile point of the press with the largest drop; null without tactile points.
const TactileEvent* mainEvent(const StrokeMetrics& press) {
  const TactileEvent* best = nullptr;
  double largest_N = 0;
  for (const TactileEvent& event : press.tactile) {
    if (!event.following) continue;
    const double drop_N = event.point.force_N - event.following->force_N;
    if (best && drop_N <= largest_N) continue;
    best = &event;
    largest_N = drop_N;
  }
  return best;
}

/// nullopt if both points have one displacement.
std::optional<double> meanSlope(const CurvePoint& from, const CurvePoint& to) {
  const double run_mm = to.displacement_mm - from.displacement_mm;
  if (!(run_mm > 0)) return {};
  return (to.force_N - from.force_N) / run_mm;
}

void fillContacts(KeyFigures& figures, const StateMetrics& state) {
  if (const auto& operating = state.operatingPoint) {
    figures[KeyFigure::preTravel] = operating->displacement_mm;
    figures[KeyFigure::operatingForce] = operating->force_N;
    figures[KeyFigure::overTravel] = state.travel_mm - operating->displacement_mm;
    if (state.resetPoint)
      figures[KeyFigure::differentialTravel] = operating->displacement_mm - state.resetPoint->displacement_mm;
  }
  if (const auto& reset = state.resetPoint) {
    figures[KeyFigure::resetTravel] = reset->displacement_mm;
    figures[KeyFigure::resetForce] = reset->force_N;
  }
}

/// Returns start, peak, valley and start of the bottom-out of a press.
ShapePlaces placesOf(const StrokeMetrics& press, const CurvePoint& start) {
  ShapePlaces positions{start, {}, {}, {press.bottomOut.displacement_mm, press.bottomOut.force_N}};
  if (const TactileEvent* event = mainEvent(press)) {
    positions.peak = {event->point.displacement_mm, event->point.force_N};
    positions.valley = *event->following;
  }
  return positions;
}

CurvePoint startOf(const ButtonState& state) {
  const Knot& first = state.graph.press().knots().front();
  return {first.displacement_mm, first.force_N};
}

}  // namespace

ShapePlaces shapePlacesOf(const ButtonState& state, const SectionSettings& settings) {
  return placesOf(metricsOf(state.graph.press(), Stroke::press, settings), startOf(state));
}

void fillShape(KeyFigures& figures, const ShapePlaces& positions) {
  figures[KeyFigure::bottomOutForce] = positions.bottom.force_N;
  figures[KeyFigure::bottomOutTravel] = positions.bottom.displacement_mm;
  if (!positions.peak) {
    figures[KeyFigure::slopeToPeak] = meanSlope(positions.start, positions.bottom);
    return;
  }
  const CurvePoint &peak = *positions.peak, &valley = *positions.valley;
  figures[KeyFigure::peakForce] = peak.force_N;
  figures[KeyFigure::peakTravel] = peak.displacement_mm;
  figures[KeyFigure::valleyForce] = valley.force_N;
  figures[KeyFigure::valleyTravel] = valley.displacement_mm;
  figures[KeyFigure::drop] = peak.force_N - valley.force_N;
  if (peak.force_N > 0) figures[KeyFigure::snapRatio] = (peak.force_N - valley.force_N) / peak.force_N;
  figures[KeyFigure::slopeToPeak] = meanSlope(positions.start, peak);
  figures[KeyFigure::slopeOfDrop] = meanSlope(peak, valley);
  figures[KeyFigure::slopeToBottomOut] = meanSlope(valley, positions.bottom);
}

const std::array<KeyFigureName, keyFigureCount>& keyFigureNames() {
  using enum KeyFigure;
  static const std::array<KeyFigureName, keyFigureCount> names{{
      {initialForce, FigureUnit::N, "initial_force_N", words("Initial force")},
      {preTravel, FigureUnit::mm, "pre_travel_mm", words("Pre-travel")},
      {operatingForce, FigureUnit::N, "operating_force_N", words("Operating force")},
      {peakForce, FigureUnit::N, "peak_force_N", words("Peak force")},
      {peakTravel, FigureUnit::mm, "peak_travel_mm", words("Peak travel")},
      {valleyForce, FigureUnit::N, "valley_force_N", words("Valley force")},
      {valleyTravel, FigureUnit::mm, "valley_travel_mm", words("Valley travel")},
      {drop, FigureUnit::N, "drop_N", words("Tactile drop")},
      {snapRatio, FigureUnit::share, "snap_ratio", words("Snap ratio")},
      {slopeToPeak, FigureUnit::N_per_mm, "slope_to_peak_N_per_mm", words("Spring rate to the peak")},
      {slopeOfDrop, FigureUnit::N_per_mm, "slope_of_drop_N_per_mm", words("Spring rate of the drop")},
      {slopeToBottomOut, FigureUnit::N_per_mm, "slope_to_bottom_out_N_per_mm",
       words("Spring rate to the bottom-out")},
      {resetTravel, FigureUnit::mm, "reset_travel_mm", words("Reset point")},
      {resetForce, FigureUnit::N, "reset_force_N", words("Reset force")},
      {differentialTravel, FigureUnit::mm, "differential_travel_mm", words("Differential travel")},
      {overTravel, FigureUnit::mm, "over_travel_mm", words("Over-travel")},
      {bottomOutForce, FigureUnit::N, "bottom_out_force_N", words("Bottom-out force")},
      {bottomOutTravel, FigureUnit::mm, "bottom_out_travel_mm", words("Bottom-out travel")},
      {totalTravel, FigureUnit::mm, "total_travel_mm", words("Total travel")},
      {endForce, FigureUnit::N, "end_force_N", words("Force at the end")},
      {pressWork, FigureUnit::mJ, "press_work_mJ", words("Work of a press")},
      {hysteresis, FigureUnit::mJ, "hysteresis_mJ", words("Hysteresis")},
  }};
  return names;
}

KeyFigures keyFiguresOf(const ButtonState& state, const SectionSettings& settings) {
  const StateMetrics metrics = metricsOf(state, settings);
  KeyFigures figures;
  figures[KeyFigure::initialForce] = metrics.press.startForce_N;
  figures[KeyFigure::endForce] = metrics.press.endForce_N;
  figures[KeyFigure::totalTravel] = metrics.travel_mm;
  figures[KeyFigure::pressWork] = metrics.press.work_mJ;
  figures[KeyFigure::hysteresis] = metrics.hysteresisArea_mJ;
  fillShape(figures, placesOf(metrics.press, startOf(state)));
  fillContacts(figures, metrics);
  return figures;
}

}  // namespace detent
