// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/measured_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "importer/library/sampled_stroke.h"

namespace detent::importer {
namespace {

/// Half the width that holds 68.3 % of the sums of one normal error and two errors distributed evenly between
/// plus and minus their bounds.
double halfOf68(double variance, double a, double b) {
  constexpr double share = 0.682689;  // share of a normal error within one standard error
  constexpr double coarse = 1e-2;     // of the other errors: a smaller bound is treated as normal
  if (a < b) std::swap(a, b);
  for (double* bound : {&b, &a})
    if (*bound * *bound < coarse * coarse * variance) variance += *bound * *bound / 3, *bound = 0;
  if (a == 0) return std::sqrt(variance);
  if (b < coarse * a) variance += b * b / 3, b = 0;
  const double s = std::max(std::sqrt(variance), 1e-3 * a);
  // Integrals of the normal distribution, once and twice.
  const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi); };
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
  const auto once = [&](double z) { return z * below(z) + density(z); };
  const auto twice = [&](double z) { return 0.5 * ((z * z + 1) * below(z) + z * density(z)); };
  const auto within = [&](double x) {
    const double up = b == 0 ? s / (2 * a) * (once((x + a) / s) - once((x - a) / s))
                             : s * s / (4 * a * b) *
                                   (twice((x + a + b) / s) - twice((x + a - b) / s) - twice((x - a + b) / s) +
                                    twice((x - a - b) / s));
    return 2 * up - 1;
  };
  double low = 0, high = a + b + 3 * s;
  for (int i = 0; i < 60; ++i) (within(0.5 * (low + high)) < share ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// Error of one figure.
struct Error {
  bool isReported = true;
  double variance = 0;
  std::array<double, 2> bounds{};  ///< of errors distributed evenly within one step

  void addBound(double bound) {
    double& free = bounds[0] == 0 ? bounds[0] : bounds[1];
    free = free == 0 ? std::abs(bound) : std::hypot(free, bound);
  }
};

class Measured {
 public:
  explicit Measured(const ImportReport& report)
      : state_(report.button.states().front()),
        fitted_(keyFiguresOf(state_)),
        figures_(fitted_),
        down_(state_.graph.press(), report.strokes.press.points),
        halfStep_mm_(0.5 * down_.step_mm()) {
    if (state_.graph.release() && report.strokes.release)
      up_.emplace(*state_.graph.release(), report.strokes.release->points);
    measurePlaces();
    measureEnds();
    measureAreas();
    measureContact(state_.operatingPoint_mm, down_, KeyFigure::operatingForce);
    measureContact(state_.resetPoint_mm, up_ ? *up_ : down_, KeyFigure::resetForce);
  }

  MeasuredFigures all() const {
    MeasuredFigures measured{figures_, {}};
    for (std::size_t i = 0; i < keyFigureCount; ++i) {
      const double sigma = halfOf68(errors_[i].variance, errors_[i].bounds[0], errors_[i].bounds[1]);
      if (figures_.values[i] && errors_[i].isReported && sigma > 0) measured.sigmas.values[i] = sigma;
    }
    return measured;
  }

 private:
  Error& errorOf(KeyFigure figure) { return errors_[static_cast<std::size_t>(figure)]; }

  /// Measures start, peak, valley and start of the bottom-out by the models of the samples around each, and
  /// derives the other figures.
  void measurePlaces() {
    constexpr double depth = 0.25;           // share of an extremum's prominence within which samples count
    constexpr double leastNoises = 3;        // least depth in noises that its samples must reach
    constexpr double bottomOutReach = 0.12;  // share of the travel, below a bottom-out
    const StrokeCurve& press = state_.graph.press();
    const double end_mm = down_.last().displacement_mm;
    const BottomOut bottom = bottomOutOf(press);
    ShapePlaces shape = shapePlacesOf(state_);
    std::array<std::optional<LocalPlace>, 4> found;
    const auto depthOf = [&](double height_N) {
      return std::max(depth * height_N, leastNoises * down_.noise_N());
    };
    const auto startsWindow_mm = shape.peak ? shape.peak->displacement_mm : bottom.displacement_mm;
    found[0] = beginningOf(down_.atStart(0.5 * (down_.first().displacement_mm + startsWindow_mm)));
    double gentleFrom_mm = down_.first().displacement_mm;
    if (shape.peak) {
      const CurvePoint peak = *shape.peak, valley = *shape.valley;
      const double drop_N = peak.force_N - valley.force_N;
      found[1] = extremumIn(
          down_.around(peak.displacement_mm, 1, depthOf(std::min(drop_N, peak.force_N - shape.start.force_N)),
                       down_.first().displacement_mm, valley.displacement_mm),
          1);
      if (valley.displacement_mm < press.end_mm())
        found[2] = extremumIn(down_.around(valley.displacement_mm, -1,
                                           depthOf(std::min(drop_N, bottom.force_N - valley.force_N)),
                                           peak.displacement_mm, bottom.displacement_mm),
                              -1);
      gentleFrom_mm = valley.displacement_mm;
    }
    if (bottom.isSteep)
      found[3] = cornerIn(
          down_.between(std::max(gentleFrom_mm, bottom.displacement_mm - bottomOutReach * press.travel_mm()),
                        end_mm),
          bottom.displacement_mm);
    else
      found[3] = LocalPlace{end_mm, down_.last().force_N, 0, std::pow(down_.noise_N(), 2), 0};
    for (std::size_t i = 0; i < found.size(); ++i)
      if (CurvePoint* place = placeOf(shape, i); place && found[i])
        *place = {i == 0 ? place->displacement_mm : found[i]->displacement_mm, found[i]->force_N};
    if (shape.valley && !(shape.peak->force_N > shape.valley->force_N)) return tellNothing();
    fillShape(figures_, shape);
    figures_[KeyFigure::initialForce] = shape.start.force_N;
    errorOf(KeyFigure::initialForce).variance = found[0] ? found[0]->variance_N2 : 0;
    for (std::size_t i = 0; i < found.size(); ++i) addPlace(shape, i, found[i]);
    // If readings are evenly spaced, rounding of one displacement shifts its neighbours too; the end of the
    // travel is rounded separately.
    if (down_.isEven() || !bottom.isSteep) {
      ShapePlaces away = shape;
      for (std::size_t i = 1; i < found.size(); ++i)
        if (CurvePoint* place = placeOf(away, i)) place->displacement_mm += halfStep_mm_;
      const KeyFigures moved = shapeWith(away);
      for (std::size_t i = 0; i < keyFigureCount; ++i)
        if (moved.values[i] && figures_.values[i] && *moved.values[i] != *figures_.values[i])
          errors_[i].addBound(*moved.values[i] - *figures_.values[i]);
    }
  }

  static CurvePoint* placeOf(ShapePlaces& shape, std::size_t i) {
    switch (i) {
      case 0:
        return &shape.start;
      case 1:
        return shape.peak ? &*shape.peak : nullptr;
      case 2:
        return shape.valley ? &*shape.valley : nullptr;
      default:
        return &shape.bottom;
    }
  }

  KeyFigures shapeWith(const ShapePlaces& shape) const {
    KeyFigures moved = figures_;
    fillShape(moved, shape);
    return moved;
  }

  /// Adds the effect of one displacement's errors to every figure. If the displacement was not found, its
  /// figures get no error.
  void addPlace(const ShapePlaces& shape, std::size_t which, const std::optional<LocalPlace>& found) {
    constexpr double tiny_mm = 1e-6, tiny_N = 1e-6;
    ShapePlaces deeper = shape, harder = shape;
    if (!placeOf(deeper, which)) return;
    placeOf(deeper, which)->displacement_mm += tiny_mm;
    placeOf(harder, which)->force_N += tiny_N;
    const KeyFigures ofTravel = shapeWith(deeper), ofForce = shapeWith(harder);
    for (std::size_t i = 0; i < keyFigureCount; ++i) {
      if (!figures_.values[i] || !ofTravel.values[i] || !ofForce.values[i]) continue;
      const double per_mm = (*ofTravel.values[i] - *figures_.values[i]) / tiny_mm;
      const double per_N = (*ofForce.values[i] - *figures_.values[i]) / tiny_N;
      if (per_mm == 0 && per_N == 0) continue;
      if (found)
        errors_[i].variance += per_mm * per_mm * found->variance_mm2 + per_N * per_N * found->variance_N2 +
                               2 * per_mm * per_N * found->covariance_mmN;
      else
        errors_[i].isReported = false;
    }
  }

  void tellNothing() {
    for (int i = 0; i <= static_cast<int>(KeyFigure::slopeToBottomOut); ++i)
      if (const auto figure = static_cast<KeyFigure>(i);
          figure != KeyFigure::preTravel && figure != KeyFigure::operatingForce)
        errorOf(figure).isReported = false;
    errorOf(KeyFigure::bottomOutForce).isReported = errorOf(KeyFigure::bottomOutTravel).isReported = false;
  }

  /// The travel ends somewhere within one step, at the force that was read there.
  void measureEnds() {
    figures_[KeyFigure::totalTravel] = down_.last().displacement_mm;
    errorOf(KeyFigure::totalTravel).addBound(halfStep_mm_);
    figures_[KeyFigure::endForce] = down_.last().force_N;
    errorOf(KeyFigure::endForce).variance = std::pow(down_.noise_N(), 2);
    if (const auto& operating_mm = state_.operatingPoint_mm) {
      figures_[KeyFigure::preTravel] = *operating_mm;
      figures_[KeyFigure::overTravel] = down_.last().displacement_mm - *operating_mm;
      errorOf(KeyFigure::overTravel).addBound(halfStep_mm_);
    }
  }

  void measureAreas() {
    const double from_mm = std::max(0.0, down_.first().displacement_mm), to_mm = down_.last().displacement_mm;
    figures_[KeyFigure::pressWork] = down_.area_mJ(from_mm, to_mm);
    errorOf(KeyFigure::pressWork).variance = down_.areaVariance();
    errorOf(KeyFigure::pressWork).addBound(halfStep_mm_ * down_.areaPerEnd_N());
    if (!up_ || !figures_[KeyFigure::hysteresis]) return;
    const double bothFrom_mm = std::max(from_mm, up_->first().displacement_mm);
    const double bothTo_mm = std::min(to_mm, up_->last().displacement_mm);
    figures_[KeyFigure::hysteresis] =
        down_.area_mJ(bothFrom_mm, bothTo_mm) - up_->area_mJ(bothFrom_mm, bothTo_mm);
    errorOf(KeyFigure::hysteresis).variance = down_.areaVariance() + up_->areaVariance();
  }

  /// The contact closes somewhere between two samples.
  void measureContact(std::optional<double> contact_mm, const SampledStroke& samples, KeyFigure force) {
    if (!contact_mm) return;
    constexpr double reach = 0.04;  // share of the travel, on either side
    const double reach_mm = reach * (samples.last().displacement_mm - samples.first().displacement_mm);
    if (const auto found =
            forceAt(samples.between(*contact_mm - reach_mm, *contact_mm + reach_mm), *contact_mm)) {
      figures_[force] = found->force_N;
      errorOf(force).variance = found->variance_N2;
    } else {
      errorOf(force).isReported = false;
    }
    ButtonState away = state_;
    std::optional<double>& moved_mm =
        force == KeyFigure::operatingForce ? away.operatingPoint_mm : away.resetPoint_mm;
    *moved_mm += 0.5 * samples.step_mm();
    const KeyFigures there = keyFiguresOf(away);
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (fitted_.values[i] && there.values[i] && *fitted_.values[i] != *there.values[i])
        errors_[i].addBound(*there.values[i] - *fitted_.values[i]);
  }

  const ButtonState& state_;
  const KeyFigures fitted_;  ///< figures of the fit
  KeyFigures figures_;
  SampledStroke down_;
  std::optional<SampledStroke> up_;
  double halfStep_mm_;
  std::array<Error, keyFigureCount> errors_{};
};

}  // namespace

MeasuredFigures measuredFiguresOf(const ImportReport& report) { return Measured(report).all(); }

}  // namespace detent::importer
