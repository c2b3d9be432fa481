// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/limits.h"

#include <algorithm>

#include "model/sections.h"

namespace detent::playback {

namespace {

double keyForce_N(const StrokeCurve& press) {
  const std::vector<TactilePoint> peaks = tactilePoints(press, Stroke::press);
  const BottomOut bottom = bottomOutOf(press);
  double most_N = peaks.empty() ? bottom.force_N : peaks.front().force_N;
  for (const TactilePoint& peak : peaks) most_N = std::max(most_N, peak.force_N);
  return most_N;
}

double valueOf(const StrokeCurve& press, LimitedFigure figure) {
  if (figure == LimitedFigure::keyForce) return keyForce_N(press);
  return bottomOutOf(press).displacement_mm - press.start_mm();
}

LimitOutcome outcomeOf(const Limit& limit, double value) {
  double beyond = 0;
  if (limit.least) beyond = std::max(beyond, *limit.least - value);
  if (limit.most) beyond = std::max(beyond, value - *limit.most);
  if (beyond <= 0) return LimitOutcome::pass;
  return beyond <= limit.tolerance ? LimitOutcome::withinTolerance : LimitOutcome::fail;
}

}  // namespace

const std::vector<Limit>& knownLimits() {
  // As quoted by a maker of keys and by the NUREG; the ANSI/HFES text itself was not read, so its clauses are not named.
  static const std::vector<Limit> limits = {
      {"ANSI/HFES, key mechanics", "as quoted by tactuskeyboard.com/keymech.htm", "", "required",
       LimitedFigure::keyForce, 0.25, 1.5, 0.01},
      {"ANSI/HFES, key mechanics", "as quoted by tactuskeyboard.com/keymech.htm", "", "preferred",
       LimitedFigure::keyForce, 0.5, 0.6, 0.01},
      {"ANSI/HFES, key mechanics", "as quoted by tactuskeyboard.com/keymech.htm", "", "preferred",
       LimitedFigure::travel, 2, 4, 0.05},
      {"NUREG-0700", "revision 3", "repetitive keying", "required", LimitedFigure::keyForce, 0.3, 0.75, 0.01},
  };
  return limits;
}

std::vector<LimitFinding> holdAgainst(const std::vector<Limit>& limits, const Button& button) {
  const StrokeCurve& press = button.states().front().graph.press();
  std::vector<LimitFinding> findings;
  for (const Limit& limit : limits) {
    const double value = valueOf(press, limit.figure);
    findings.push_back({limit, value, outcomeOf(limit, value)});
  }
  return findings;
}

}  // namespace detent::playback
