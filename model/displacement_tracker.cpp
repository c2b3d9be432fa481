// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/displacement_tracker.h"

#include <algorithm>
#include <cmath>

#include "model/check.h"

namespace detent {
namespace {

std::vector<double> jumpStarts(const StrokeCurve& curve, Stroke stroke, const SectionSettings& settings) {
  std::vector<double> starts;
  for (const Section& section : sectionsOf(curve, stroke, settings))
    if (section.kind == SectionKind::jump) starts.push_back(section.from_mm);
  return starts;
}

bool holds(const MonotoneStretch& stretch, double force_N) {
  return force_N >= std::min(stretch.fromForce_N, stretch.toForce_N) &&
         force_N <= std::max(stretch.fromForce_N, stretch.toForce_N);
}

}  // namespace

DisplacementTracker::DisplacementTracker(ForceGraph graph, TrackerSettings settings)
    : graph_(std::move(graph)), settings_(settings) {
  DETENT_CHECK(std::isfinite(settings_.hysteresis_N) && settings_.hysteresis_N >= 0,
               "hysteresis_N finite and >= 0");
  readGraph();
  reset();
}

void DisplacementTracker::readGraph() {
  pressStretches_ = graph_.press().monotoneStretches();
  releaseStretches_ = graph_.curve(Stroke::release).monotoneStretches();
  pressJumps_mm_ = jumpStarts(graph_.press(), Stroke::press, settings_.sections);
  releaseJumps_mm_ = jumpStarts(graph_.curve(Stroke::release), Stroke::release, settings_.sections);
}

void DisplacementTracker::reset() {
  position_ = {graph_.press().start_mm(), Stroke::press, false};
  turningForce_N_ = 0;
  touched_ = false;
  rejected_ = 0;
}

void DisplacementTracker::continueOn(ForceGraph graph) { nextGraph_ = std::move(graph); }

TrackedPosition DisplacementTracker::update(double force_N) {
  position_.jumped = false;
  if (!std::isfinite(force_N)) {
    ++rejected_;
    return position_;
  }
  turnIfDue(force_N);
  const double before_mm = position_.displacement_mm;
  position_.displacement_mm = position_.stroke == Stroke::press ? pressedTo(force_N) : releasedTo(force_N);
  position_.jumped = crossesJump(before_mm, position_.displacement_mm);
  return position_;
}

void DisplacementTracker::turnIfDue(double force_N) {
  if (!touched_) {
    touched_ = true;
    turningForce_N_ = force_N;
  }
  const double sign = position_.stroke == Stroke::press ? 1 : -1;
  if (sign * force_N >= sign * turningForce_N_) {
    turningForce_N_ = force_N;
  } else if (sign * (turningForce_N_ - force_N) > settings_.hysteresis_N) {
    position_.stroke = position_.stroke == Stroke::press ? Stroke::release : Stroke::press;
    turningForce_N_ = force_N;
    if (position_.stroke == Stroke::release || !nextGraph_) return;
    graph_ = *std::move(nextGraph_);
    nextGraph_.reset();
    readGraph();
  }
}

double DisplacementTracker::pressedTo(double force_N) const {
  const StrokeCurve& curve = graph_.press();
  const double x = position_.displacement_mm;
  // At a wall the curve carries every force of the wall, so its larger end must be exceeded to move on.
  if (force_N <= std::max(curve.forceBefore_N(x), curve.force_N(x))) return x;
  if (x >= curve.end_mm()) return x;
  auto stretch = std::upper_bound(pressStretches_.begin(), pressStretches_.end(), x,
                                  [](double at, const MonotoneStretch& s) { return at < s.to_mm; });
  for (; stretch != pressStretches_.end(); ++stretch) {
    if (stretch->direction == 1 && force_N <= stretch->toForce_N)
      return std::max(x,
                      holds(*stretch, force_N) ? curve.displacementIn(*stretch, force_N) : stretch->from_mm);
  }
  return curve.end_mm();
}

double DisplacementTracker::releasedTo(double force_N) const {
  const StrokeCurve& curve = graph_.curve(Stroke::release);
  const double x = position_.displacement_mm;
  if (force_N >= std::min(curve.forceBefore_N(x), curve.force_N(x))) return x;
  if (x <= curve.start_mm()) return x;
  const auto beyond = std::lower_bound(releaseStretches_.begin(), releaseStretches_.end(), x,
                                       [](const MonotoneStretch& s, double at) { return s.from_mm < at; });
  for (auto stretch = beyond; stretch != releaseStretches_.begin();) {
    --stretch;
    if (stretch->direction == 1 && force_N >= stretch->fromForce_N)
      return std::min(x, holds(*stretch, force_N) ? curve.displacementIn(*stretch, force_N) : stretch->to_mm);
  }
  return curve.start_mm();
}

bool DisplacementTracker::crossesJump(double from_mm, double to_mm) const {
  if (position_.stroke == Stroke::press)
    return std::any_of(pressJumps_mm_.begin(), pressJumps_mm_.end(),
                       [&](double jump_mm) { return from_mm <= jump_mm && to_mm > jump_mm; });
  return std::any_of(releaseJumps_mm_.begin(), releaseJumps_mm_.end(),
                     [&](double jump_mm) { return from_mm >= jump_mm && to_mm < jump_mm; });
}

}  // namespace detent
