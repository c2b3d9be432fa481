// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/blend.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "model/damping.h"
#include "model/key_figures.h"

namespace detent {
namespace {

/// Features closer than this share of the travel are treated as one, because the stretch between them has no
/// finite scale.
constexpr double leastGapOfTravel = 1e-3;

/// Knots of two curves closer than this share of a stretch are the same knot (rounding).
constexpr double samePlace = 1e-9;

/// Displacements of features, most significant first; nullopt if a curve lacks the feature.
using Features = std::vector<std::optional<double>>;

Features featuresOf(const ButtonState& state, Stroke stroke, const SectionSettings& settings) {
  if (stroke == Stroke::press) {
    const KeyFigures figures = keyFiguresOf(state, settings);
    return {bottomOutOf(state.graph.press(), settings).displacement_mm, figures[KeyFigure::peakTravel],
            figures[KeyFigure::valleyTravel], state.operatingPoint_mm};
  }
  const StrokeCurve& release = *state.graph.release();
  Features features{bottomOutOf(release, settings).displacement_mm, {}, {}, state.resetPoint_mm};
  const std::vector<TactilePoint> points = tactilePoints(release, Stroke::release, settings);
  const auto deepest = std::ranges::max_element(points, {}, &TactilePoint::prominence_N);
  if (deepest == points.end()) return features;
  features[2] = deepest->displacement_mm;
  CurvePoint hump{release.start_mm(), release.force_N(release.start_mm())};
  for (const CurvePoint& top : release.localMaxima())
    if (top.displacement_mm < deepest->displacement_mm && top.force_N > hump.force_N) hump = top;
  features[1] = hump.displacement_mm;
  return features;
}

/// One curve with the displacements of the features that all curves share, increasing, including both ends.
struct AlignedCurve {
  const StrokeCurve* curve = nullptr;
  std::vector<double> marks_mm;

  double length_mm(std::size_t interval) const { return marks_mm[interval + 1] - marks_mm[interval]; }
  std::size_t lastInterval() const { return marks_mm.size() - 2; }

  /// Number of passed features plus the share of the way to the next.
  double placeOf(double displacement_mm) const {
    const auto above = std::ranges::upper_bound(marks_mm, displacement_mm);
    const auto passed = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - marks_mm.begin() - 1, 0));
    if (passed > lastInterval()) return static_cast<double>(marks_mm.size() - 1);
    return static_cast<double>(passed) + (displacement_mm - marks_mm[passed]) / length_mm(passed);
  }
  double displacementAt(double place) const {
    const auto interval = std::min(static_cast<std::size_t>(place), lastInterval());
    return marks_mm[interval] + (place - static_cast<double>(interval)) * length_mm(interval);
  }
};

/// Adds a feature to the aligned features of all curves if every curve has it at the same position in the
/// order.
void align(std::vector<AlignedCurve>& curves, const std::vector<Features>& features, std::size_t feature) {
  std::optional<std::ptrdiff_t> place;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& at_mm = features[i][feature];
    const std::vector<double>& marks = curves[i].marks_mm;
    if (!at_mm || *at_mm <= marks.front() || *at_mm >= marks.back()) return;
    const auto above = std::ranges::upper_bound(marks, *at_mm);
    const double gap_mm = leastGapOfTravel * (marks.back() - marks.front());
    if (*above - *at_mm < gap_mm || *at_mm - *(above - 1) < gap_mm) return;
    if (place && *place != above - marks.begin()) return;
    place = above - marks.begin();
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
    curves[i].marks_mm.insert(curves[i].marks_mm.begin() + *place, *features[i][feature]);
}

std::vector<AlignedCurve> aligned(const std::vector<const StrokeCurve*>& curves,
                                  const std::vector<Features>& features) {
  std::vector<AlignedCurve> all;
  for (const StrokeCurve* curve : curves) all.push_back({curve, {curve->start_mm(), curve->end_mm()}});
  for (std::size_t feature = 0; feature < features.front().size(); ++feature) align(all, features, feature);
  return all;
}

/// A place where at least one of the curves has a knot.
struct Joint {
  double place = 0;
  std::vector<std::optional<double>> own_mm;  ///< per curve: displacement of its knot there, if any
  bool isVertical = false;                    ///< one of the curves has two knots here
};

/// Returns the knots of all curves, with those at one place merged.
std::vector<Joint> jointsOf(const std::vector<AlignedCurve>& curves) {
  struct Placed {
    double place;
    std::size_t curve;
    double displacement_mm;
  };
  std::vector<Placed> all;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const Knot& knot : curves[i].curve->knots())
      all.push_back({curves[i].placeOf(knot.displacement_mm), i, knot.displacement_mm});
    for (const double mark_mm : curves[i].marks_mm)
      if (std::ranges::none_of(curves[i].curve->knots(),
                               [&](const Knot& knot) { return knot.displacement_mm == mark_mm; }))
        all.push_back({curves[i].placeOf(mark_mm), i, mark_mm});
  }
  std::ranges::stable_sort(all, {}, &Placed::place);
  std::vector<Joint> joints;
  for (const Placed& each : all) {
    const bool joins =
        !joints.empty() && each.place - joints.back().place < samePlace &&
        joints.back().own_mm[each.curve].value_or(each.displacement_mm) == each.displacement_mm;
    if (!joins) joints.push_back({each.place, std::vector<std::optional<double>>(curves.size()), false});
    std::optional<double>& own = joints.back().own_mm[each.curve];
    joints.back().isVertical = joints.back().isVertical || own.has_value();
    own = each.displacement_mm;
  }
  return joints;
}

/// Mean of the curves at one joint. Slopes are per share of the way, so that they average like forces.
struct Mean {
  double displacement_mm = 0, forceBefore_N = 0, forceAfter_N = 0;
  double slopeBefore_N = 0, slopeAfter_N = 0, lengthBefore_mm = 0, lengthAfter_mm = 0;

  void add(const AlignedCurve& curve, double place, double displacement, double weight) {
    const auto interval = std::min(static_cast<std::size_t>(place), curve.lastInterval());
    const bool onMark = place == static_cast<double>(interval) && interval > 0;
    const double before_mm = curve.length_mm(onMark ? interval - 1 : interval);
    const double after_mm = curve.length_mm(interval);
    displacement_mm += weight * displacement;
    forceBefore_N += weight * curve.curve->forceBefore_N(displacement);
    forceAfter_N += weight * curve.curve->force_N(displacement);
    slopeBefore_N += weight * before_mm * curve.curve->slopeBefore_N_per_mm(displacement);
    slopeAfter_N += weight * after_mm * curve.curve->slope_N_per_mm(displacement);
    lengthBefore_mm += weight * before_mm;
    lengthAfter_mm += weight * after_mm;
  }
};

void appendKnots(const Mean& mean, bool isVertical, std::vector<Knot>& knots) {
  if (!knots.empty() && mean.displacement_mm <= knots.back().displacement_mm)
    return;  // the knot coincides with the last one, apart from rounding
  const double before = mean.slopeBefore_N / mean.lengthBefore_mm,
               after = mean.slopeAfter_N / mean.lengthAfter_mm;
  if (!isVertical) {
    knots.push_back({mean.displacement_mm, mean.forceAfter_N, before, after});
    return;
  }
  knots.push_back({mean.displacement_mm, mean.forceBefore_N, before, 0});
  knots.push_back({mean.displacement_mm, mean.forceAfter_N, 0, after});
}

/// Factor on the forces that brings the work of the mean between the works of its curves; 1 if it is there
/// already, or if a curve has negative work.
double factorForWork(const StrokeCurve& mean, const std::vector<AlignedCurve>& curves) {
  const auto workOf = [](const StrokeCurve& curve) {
    return curve.area_mJ(curve.start_mm(), curve.end_mm());
  };
  double least = workOf(*curves.front().curve), most = least;
  for (const AlignedCurve& each : curves) {
    least = std::min(least, workOf(*each.curve));
    most = std::max(most, workOf(*each.curve));
  }
  const double work = workOf(mean);
  return least > 0 && work > 0 ? std::clamp(work, least, most) / work : 1;
}

/// `weights` are all above 0 and sum to 1.
Result<StrokeCurve> blendCurves(const std::vector<AlignedCurve>& curves, const std::vector<double>& weights) {
  std::vector<Knot> knots;
  for (const Joint& joint : jointsOf(curves)) {
    Mean mean;
    for (std::size_t i = 0; i < curves.size(); ++i)
      mean.add(curves[i], joint.place, joint.own_mm[i].value_or(curves[i].displacementAt(joint.place)),
               weights[i]);
    appendKnots(mean, joint.isVertical, knots);
  }
  auto mean = StrokeCurve::fromKnots(std::move(knots));
  if (!mean) return mean;
  const double factor = factorForWork(*mean, curves);
  if (factor == 1) return mean;
  std::vector<Knot> scaled;
  for (const Knot& knot : mean->knots())
    scaled.push_back({knot.displacement_mm, factor * knot.force_N, factor * knot.slopeBefore_N_per_mm,
                      factor * knot.slopeAfter_N_per_mm});
  return StrokeCurve::fromKnots(std::move(scaled));
}

using States = std::vector<const ButtonState*>;

Result<StrokeCurve> blendStroke(const States& states, Stroke stroke, const std::vector<double>& weights,
                                const SectionSettings& settings) {
  std::vector<const StrokeCurve*> curves;
  std::vector<Features> features;
  for (const ButtonState* state : states) {
    curves.push_back(&state->graph.curve(stroke));
    features.push_back(featuresOf(*state, stroke, settings));
  }
  return blendCurves(aligned(curves, features), weights);
}

/// Weighted mean of the states' operating or reset points; nullopt unless every state has the point.
std::optional<double> meanPoint(const States& states, const std::vector<double>& weights,
                                std::optional<double> ButtonState::*point) {
  double mean_mm = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!(states[i]->*point)) return {};
    mean_mm += weights[i] * *(states[i]->*point);
  }
  return mean_mm;
}

/// Averages damping over the share of the travel.
std::vector<DampingPoint> meanDamping(const States& states, const std::vector<double>& weights) {
  std::vector<double> shares;
  double travel_mm = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    travel_mm += weights[i] * states[i]->graph.travel_mm();
    for (const DampingPoint& point : states[i]->damping)
      shares.push_back(point.displacement_mm / states[i]->graph.travel_mm());
  }
  std::ranges::sort(shares);
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  std::vector<DampingPoint> damping;
  for (const double share : shares) {
    DampingPoint point{share * travel_mm, 0};
    for (std::size_t i = 0; i < states.size(); ++i)
      point.damping_Ns_per_mm +=
          weights[i] * dampingAt(states[i]->damping, share * states[i]->graph.travel_mm());
    damping.push_back(point);
  }
  return damping;
}

Result<ButtonState> blendStates(const States& states, const std::vector<double>& weights,
                                const SectionSettings& settings) {
  auto press = blendStroke(states, Stroke::press, weights, settings);
  if (!press) return press.failure();
  std::optional<StrokeCurve> release;
  if (std::ranges::all_of(states,
                          [](const ButtonState* state) { return state->graph.release().has_value(); })) {
    auto blended = blendStroke(states, Stroke::release, weights, settings);
    if (!blended) return blended.failure();
    release = std::move(*blended);
  }
  auto graph = ForceGraph::fromCurves(std::move(*press), std::move(release));
  if (!graph) return graph.failure();
  return ButtonState{states.front()->name, std::move(*graph),
                     meanPoint(states, weights, &ButtonState::operatingPoint_mm),
                     meanPoint(states, weights, &ButtonState::resetPoint_mm), meanDamping(states, weights)};
}

std::optional<Failure> refusalOf(const std::vector<Button>& buttons, const std::vector<double>& weights) {
  const auto refuse = [](const char* subject, Message problem, const Message& advice) {
    return Failure{FailureCode::wrongUsage, subject, "", std::move(problem), advice};
  };
  if (buttons.empty())
    return refuse("buttons", Message("there are no buttons"), Message("Give one button or more"));
  const auto usable = [](double weight) { return std::isfinite(weight) && weight >= 0; };
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (weights.size() != buttons.size() || !std::ranges::all_of(weights, usable) || !(sum > 0) ||
      !std::isfinite(sum))
    return refuse("weights",
                  Message("the number of weights, or one of the weights, does not suit the buttons"),
                  Message("Give each button one weight of 0 or more, but not 0 to all"));
  for (const Button& button : buttons)
    if (button.states().size() != buttons.front().states().size())
      return refuse("buttons", Message("some of the buttons are momentary, others are self-locking"),
                    Message("Choose buttons of one kind"));
  return {};
}

}  // namespace

Result<Button> blend(const std::vector<Button>& buttons, const std::vector<double>& weights,
                     const SectionSettings& settings) {
  if (auto refusal = refusalOf(buttons, weights)) return std::move(*refusal);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<const Button*> counted;
  std::vector<double> shares;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (weights[i] == 0) continue;
    counted.push_back(&buttons[i]);
    shares.push_back(weights[i] / sum);
  }
  std::vector<ButtonState> states;
  for (std::size_t s = 0; s < buttons.front().states().size(); ++s) {
    States each;
    for (const Button* button : counted) each.push_back(&button->states()[s]);
    auto state = blendStates(each, shares, settings);
    if (!state) return state.failure();
    states.push_back(std::move(*state));
  }
  return Button::fromStates(buttons.front().name(), std::move(states));
}

Result<Button> between(const Button& from, const Button& to, double share, const SectionSettings& settings) {
  if (!(share >= 0 && share <= 1))
    return Failure{FailureCode::wrongUsage, "share", "", Message("the share is %1", share),
                   Message("Give a share from 0 to 1")};
  if (auto refusal = refusalOf({from, to}, {1, 1})) return std::move(*refusal);
  if (share == 0) return from;
  if (share == 1) return to;
  auto blended = blend({from, to}, {1 - share, share}, settings);
  if (!blended) return blended;
  return Button::fromStates(from.name() + " - " + to.name(), blended->states());
}

}  // namespace detent
