// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/figure_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace detent::importer {
namespace {

/// What a figure rests on, which says how far it may be off.
enum class Ground {
  curve,   ///< the fit at a place that the samples hold
  places,  ///< where the peak, the valley or the foot of the wall are, or what is made of these
  ends,    ///< where samples end or a contact closed: known to a step
  force,   ///< the force at a given place
  area     ///< all samples
};

Ground groundOf(KeyFigure figure) {
  switch (figure) {
    case KeyFigure::totalTravel:
    case KeyFigure::overTravel:
    case KeyFigure::preTravel:
      return Ground::ends;
    case KeyFigure::operatingForce:
    case KeyFigure::resetForce:
      return Ground::force;
    case KeyFigure::pressWork:
    case KeyFigure::hysteresis:
      return Ground::area;
    case KeyFigure::bottomOutForce:
    case KeyFigure::bottomOutTravel:
      return Ground::places;
    default:
      return figure >= KeyFigure::peakForce && figure <= KeyFigure::slopeToBottomOut ? Ground::places
                                                                                     : Ground::curve;
  }
}

bool isOfFoot(KeyFigure figure) {
  return figure == KeyFigure::bottomOutForce || figure == KeyFigure::bottomOutTravel ||
         figure == KeyFigure::slopeToBottomOut;
}

/// Of what noise does to the knots of a place that the samples' own models say: docs/decisions/0813.
double shareOfNoise(KeyFigure figure) {
  switch (figure) {
    case KeyFigure::bottomOutForce:
      return 0.65;
    case KeyFigure::bottomOutTravel:
    case KeyFigure::slopeToBottomOut:
      return 0.5;
    case KeyFigure::valleyForce:
    case KeyFigure::drop:
    case KeyFigure::snapRatio:
      return 0.8;
    case KeyFigure::peakForce:
      return 0.9;
    case KeyFigure::peakTravel:
      return 1.2;
    default:
      return 1;
  }
}
/// Of a misfit, what its correction leaves: of an extremum, and of a corner, which two bends say better than a polynomial a peak.
constexpr double leftOfExtremum = 0.2, leftOfFoot = 0.12;
/// Half of what holds 68 % of the values within a step, as a share of it.
constexpr double halfOfStep = 0.34;
/// Misfits come weighed for who does not correct them.
constexpr double misfitWeight = 1.15;

/// What the figures miss and how far they may be off, gathered way by way.
class Errors {
 public:
  explicit Errors(const KeyFigures& figures) : figures_(figures) {}

  /// The figures of a state one standard error, or one misfit, away. One that it does not have says nothing.
  void add(const KeyFigures& away, double weight, CurveDoubt doubt) {
    for (std::size_t i = 0; i < keyFigureCount; ++i) {
      const auto figure = static_cast<KeyFigure>(i);
      const Ground ground = groundOf(figure);
      if (!figures_.values[i] || !away.values[i]) continue;
      const double change = *away.values[i] - *figures_.values[i];
      if (doubt == CurveDoubt::places && ground == Ground::places) {
        misses_[i] += std::min(1.0, weight / misfitWeight) * change;
        variances_[i] += std::pow((isOfFoot(figure) ? leftOfFoot : leftOfExtremum) * change, 2);
      } else if (doubt == CurveDoubt::course && (ground == Ground::curve || ground == Ground::places)) {
        variances_[i] += weight * std::pow(shareOfNoise(figure) * change, 2);
      }
    }
  }
  void add(KeyFigure figure, double miss, double variance) {
    if (!figures_[figure]) return;
    misses_[static_cast<std::size_t>(figure)] += miss;
    variances_[static_cast<std::size_t>(figure)] += variance;
  }
  /// Every figure that a contact's place moves.
  void addContact(const KeyFigures& away) {
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (figures_.values[i] && away.values[i])
        variances_[i] += std::pow(*away.values[i] - *figures_.values[i], 2);
  }

  FigureErrors errors() const {
    FigureErrors errors;
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (figures_.values[i])
        errors.misses.values[i] = misses_[i], errors.sigmas.values[i] = std::sqrt(variances_[i]);
    return errors;
  }

 private:
  const KeyFigures& figures_;
  std::array<double, keyFigureCount> misses_{}, variances_{};
};

StrokeCurve shifted(const StrokeCurve& curve, double by_mm) {
  std::vector<Knot> knots = curve.knots();
  for (Knot& knot : knots) knot.displacement_mm += by_mm;
  return *StrokeCurve::fromKnots(std::move(knots));
}

/// The figures with other strokes; nothing where they make no graph. A press may begin before 0, where no graph does: it is looked at
/// further on.
std::optional<KeyFigures> figuresWith(const ButtonState& state, const StrokeCurve& press,
                                      const std::optional<StrokeCurve>& release) {
  const double on_mm = std::max(0.0, -press.start_mm());
  auto graph = ForceGraph::fromCurves(shifted(press, on_mm),
                                      release ? std::optional(shifted(*release, on_mm)) : std::nullopt);
  if (!graph) return {};
  ButtonState other = state;
  other.graph = *std::move(graph);
  for (std::optional<double>* contact_mm : {&other.operatingPoint_mm, &other.resetPoint_mm})
    if (*contact_mm) **contact_mm += on_mm;
  KeyFigures figures = keyFiguresOf(other);
  for (const KeyFigure place :
       {KeyFigure::peakTravel, KeyFigure::valleyTravel, KeyFigure::resetTravel, KeyFigure::bottomOutTravel})
    if (figures[place]) *figures[place] -= on_mm;
  return figures;
}

/// Median distance of neighbours along the travel.
double step_mm(const std::vector<CurvePoint>& points) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = std::abs(points[i].displacement_mm - points[i - 1].displacement_mm);
    if (step > 0) steps.push_back(step);
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// A stroke's samples beside its curve.
class Sampled {
 public:
  Sampled(const StrokeCurve& curve, const std::vector<CurvePoint>& points) : step_mm_(step_mm(points)) {
    points_ = points;
    if (points_.front().displacement_mm > points_.back().displacement_mm) std::ranges::reverse(points_);
    for (const CurvePoint& p : points_)
      residuals_N_.push_back(p.force_N -
                             curve.force_N(std::clamp(p.displacement_mm, curve.start_mm(), curve.end_mm())));
    weighNoise();
  }

  double step() const { return step_mm_; }
  double first_mm() const { return points_.front().displacement_mm; }
  double last_mm() const { return points_.back().displacement_mm; }
  double lastForce_N() const { return points_.back().force_N; }

  /// By trapezia, from one displacement to another.
  double area_mJ(double from_mm, double to_mm) const {
    double area = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const double a = std::clamp(points_[i - 1].displacement_mm, from_mm, to_mm);
      const double b = std::clamp(points_[i].displacement_mm, from_mm, to_mm);
      area += 0.5 * (b - a) * (points_[i - 1].force_N + points_[i].force_N);
    }
    return area;
  }
  double areaVariance() const {
    double squares = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      squares += std::pow(points_[i].displacement_mm - points_[i - 1].displacement_mm, 2);
    return noise_N_ * noise_N_ * together_ * squares;
  }
  /// The largest force that the travel's last step may add to the area: where the readings go on by one step each, what the end is off
  /// is spread over the way.
  double forceAtEnd_N() const {
    const double travel = last_mm() - first_mm();
    const auto steps = static_cast<double>(points_.size() - 1);
    const bool even = std::abs(steps * step_mm_ - travel) < 0.05 * travel;
    return even ? area_mJ(first_mm(), last_mm()) / travel : lastForce_N();
  }

  /// Mean residual around a place, with its variance; nothing where too few samples lie there.
  std::optional<std::pair<double, double>> missAt(double displacement_mm) const {
    constexpr double window = 0.025;  // of the travel
    constexpr double fewest = 8;      // samples: below, their mean is no better than the curve
    const double reach_mm = window * (last_mm() - first_mm());
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (std::abs(points_[i].displacement_mm - displacement_mm) < reach_mm) sum += residuals_N_[i], ++count;
    if (count < fewest) return {};
    return std::pair(sum / count, noise_N_ * noise_N_ * together_ / count);
  }

 private:
  /// Noise by the median of the residuals, which steps and corners do not move, where the curve is not so steep that they are of the
  /// displacement's steps; how many samples share one error by their autocorrelation (Newey and West 1987).
  void weighNoise() {
    constexpr double perMedian = 1.4826, farthest = 3;  // standard deviations of normal noise
    constexpr std::size_t lags = 20;
    const std::vector<double> residuals_N = withoutMisfit();
    const auto isFlat = [&](std::size_t i, double noise_N) {
      if (i == 0 || i + 1 == points_.size()) return false;
      const double rise_N =
          (points_[i + 1].force_N - residuals_N_[i + 1]) - (points_[i - 1].force_N - residuals_N_[i - 1]);
      return std::abs(rise_N) < farthest * noise_N;
    };
    const auto noiseWhere = [&](const auto& isTaken) {
      std::vector<double> sizes;
      for (std::size_t i = 0; i < residuals_N.size(); ++i)
        if (isTaken(i)) sizes.push_back(std::abs(residuals_N[i]));
      if (sizes.empty()) return 0.0;
      const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
      std::ranges::nth_element(sizes, middle);
      return perMedian * *middle;
    };
    const double rough_N = noiseWhere([](std::size_t) { return true; });
    noise_N_ = noiseWhere([&](std::size_t i) { return isFlat(i, rough_N); });
    if (noise_N_ == 0) noise_N_ = rough_N;
    std::vector<double> held(residuals_N.size(), 0);
    for (std::size_t i = 0; i < held.size(); ++i)
      if (isFlat(i, noise_N_))
        held[i] = std::clamp(residuals_N[i], -farthest * noise_N_, farthest * noise_N_);
    double own = 0, shared = 0;
    for (std::size_t i = 0; i < held.size(); ++i) {
      own += held[i] * held[i];
      for (std::size_t k = 1; k <= lags && i + k < held.size(); ++k)
        shared += 2 * (1 - double(k) / double(lags + 1)) * held[i] * held[i + k];
    }
    if (own > 0) together_ = std::max(1.0, 1 + shared / own);
  }

  /// Residuals about their mean over so many samples to either side: what changes more slowly is the fit's.
  std::vector<double> withoutMisfit() const {
    constexpr std::size_t reach = 40;
    std::vector<double> sums{0};
    for (const double each : residuals_N_) sums.push_back(sums.back() + each);
    std::vector<double> rest;
    for (std::size_t i = 0; i < residuals_N_.size(); ++i) {
      const std::size_t from = i > reach ? i - reach : 0, to = std::min(i + reach + 1, residuals_N_.size());
      rest.push_back(residuals_N_[i] - (sums[to] - sums[from]) / double(to - from));
    }
    return rest;
  }

  double step_mm_;
  std::vector<CurvePoint> points_;
  std::vector<double> residuals_N_;
  double noise_N_ = 0, together_ = 1;
};

}  // namespace

FigureErrors figureErrorsOf(const ImportReport& report) {
  const ButtonState& state = report.button.states().front();
  const KeyFigures figures = keyFiguresOf(state);
  Errors errors(figures);
  const StrokeCurve& press = state.graph.press();
  const std::optional<StrokeCurve>& release = state.graph.release();
  const auto take = [&](const StrokeCurve& pressAway, const std::optional<StrokeCurve>& releaseAway,
                        const CurveAway& way) {
    if (const auto away = figuresWith(state, pressAway, releaseAway))
      errors.add(*away, way.weight, way.doubt);
  };
  for (const CurveAway& way : report.press.fit.oneSigmaAway) take(way.curve, release, way);

  const Sampled down(press, report.strokes.press.points);
  const auto up = release && report.strokes.release
                      ? std::optional<Sampled>(std::in_place, *release, report.strokes.release->points)
                      : std::nullopt;
  // The fit's ends keep the force of the last samples in a wall, and the displacement elsewhere.
  const double deeper_mm = down.last_mm() - press.end_mm(), end_mm = halfOfStep * down.step();
  const double earlier_mm = press.start_mm() - std::max(0.0, down.first_mm());
  errors.add(KeyFigure::totalTravel, deeper_mm + earlier_mm, end_mm * end_mm);
  errors.add(KeyFigure::overTravel, deeper_mm, end_mm * end_mm);
  errors.add(KeyFigure::preTravel, earlier_mm, 0);
  const double from_mm = std::max(0.0, down.first_mm());
  if (figures[KeyFigure::pressWork])
    errors.add(KeyFigure::pressWork, down.area_mJ(from_mm, down.last_mm()) - *figures[KeyFigure::pressWork],
               down.areaVariance() + std::pow(end_mm * down.forceAtEnd_N(), 2));
  if (up && figures[KeyFigure::hysteresis]) {
    const double bothFrom_mm = std::max(from_mm, up->first_mm());
    const double bothTo_mm = std::min(down.last_mm(), up->last_mm());
    errors.add(KeyFigure::hysteresis,
               down.area_mJ(bothFrom_mm, bothTo_mm) - up->area_mJ(bothFrom_mm, bothTo_mm) -
                   *figures[KeyFigure::hysteresis],
               down.areaVariance() + up->areaVariance());
  }
  // A contact closes somewhere between two samples.
  const auto takeContact = [&](std::optional<double> ButtonState::*contact_mm, const Sampled& samples,
                               KeyFigure force) {
    if (!(state.*contact_mm)) return;
    if (const auto miss = samples.missAt(*(state.*contact_mm))) errors.add(force, miss->first, miss->second);
    ButtonState away = state;
    *(away.*contact_mm) += halfOfStep * samples.step();
    errors.addContact(keyFiguresOf(away));
  };
  takeContact(&ButtonState::operatingPoint_mm, down, KeyFigure::operatingForce);
  takeContact(&ButtonState::resetPoint_mm, up ? *up : down, KeyFigure::resetForce);
  return errors.errors();
}

}  // namespace detent::importer
