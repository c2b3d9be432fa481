// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/realtime/reverse_function.h"

#include <algorithm>

namespace detent::test {
namespace {

bool holds(const MonotoneStretch& stretch, double force_N) {
  return force_N >= std::min(stretch.fromForce_N, stretch.toForce_N) &&
         force_N <= std::max(stretch.fromForce_N, stretch.toForce_N);
}

}  // namespace

ReverseFunction::ReverseFunction(ForceGraph graph, double hysteresis_N)
    : graph_(std::move(graph)),
      hysteresis_N_(hysteresis_N),
      pressStretches_(graph_.press().monotoneStretches()),
      releaseStretches_(graph_.curve(Stroke::release).monotoneStretches()),
      displacement_mm_(graph_.press().start_mm()) {}

void ReverseFunction::update(double force_N) {
  turnIfDue(force_N);
  displacement_mm_ = stroke_ == Stroke::press ? pressedTo(force_N) : releasedTo(force_N);
}

void ReverseFunction::turnIfDue(double force_N) {
  const double sign = stroke_ == Stroke::press ? 1 : -1;
  if (sign * force_N >= sign * turningForce_N_) {
    turningForce_N_ = force_N;
  } else if (sign * (turningForce_N_ - force_N) > hysteresis_N_) {
    stroke_ = stroke_ == Stroke::press ? Stroke::release : Stroke::press;
    turningForce_N_ = force_N;
  }
}

double ReverseFunction::pressedTo(double force_N) const {
  const StrokeCurve& curve = graph_.press();
  const double x = displacement_mm_;
  // At a vertical rise the curve carries every force of the rise, so its larger end must be exceeded to move
  // on.
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

double ReverseFunction::releasedTo(double force_N) const {
  const StrokeCurve& curve = graph_.curve(Stroke::release);
  const double x = displacement_mm_;
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

}  // namespace detent::test
