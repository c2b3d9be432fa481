// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/speed_tracker.h"

#include <cmath>

namespace detent::playback {

namespace {

// Marks as shares of the travel. From the first to the second mark a press is timed from its first touch;
// after that from the second mark, as in rendering, because a press begins slowly.
constexpr double touchShare = 0.02, fromShare = 0.1, toShare = 0.9;
constexpr double timedFrom = 0.03;  // share of the distance from 10 to 90 % that is enough to show a speed
constexpr double settledAt = 0.5;   // share of the travel, if there is no jump before
constexpr double fastest_mm_per_s = 1e6;  // limit for a single reading that covers the whole distance

double strongestUpTo(const StrokeTable& press, double at_mm) {
  double strongest = press.pointCount > 0 ? press.points[0].force_N : 0;
  for (std::size_t i = 1; i < press.pointCount; ++i) {
    const TablePoint &a = press.points[i - 1], &b = press.points[i];
    if (a.displacement_mm >= at_mm) break;
    const double share =
        b.displacement_mm > at_mm ? (at_mm - a.displacement_mm) / (b.displacement_mm - a.displacement_mm) : 1;
    strongest = std::fmax(strongest, a.force_N + (b.force_N - a.force_N) * share);
  }
  return strongest;
}

bool meets(const Crossings& crossings, CrossingKind kind) {
  for (std::size_t i = 0; i < crossings.count; ++i)
    if (crossings.items[i].kind == kind) return true;
  return false;
}

}  // namespace

PressMarks placeMarks(const StateProgram& state) {
  const double travel_mm = state.end_mm - state.start_mm;
  const auto placeOf = [&](double share) { return state.start_mm + share * travel_mm; };
  return {placeOf(touchShare), placeOf(fromShare), placeOf(toShare), (toShare - fromShare) * travel_mm};
}

PressMarks forceMarks(const StateProgram& state) {
  const double travel_mm = state.end_mm - state.start_mm;
  double strongest_N = 0;  // includes the top of a vertical bottom-out
  for (std::size_t i = 0; i < state.press.pointCount; ++i)
    strongest_N = std::fmax(strongest_N, state.press.points[i].force_N);
  PressMarks marks{touchShare * strongest_N, fromShare * strongest_N,
                   strongestUpTo(state.press, state.start_mm + settledAt * travel_mm)};
  if (marks.to <= 0) marks.to = toShare * strongest_N;  // there is no force in the first half
  marks.from = std::fmin(marks.from, marks.to / 2);     // applies if a bottom-out dwarfs all other forces
  marks.touch = std::fmin(marks.touch, marks.from / 2);
  marks.way_mm = strongest_N > 0 ? travel_mm * (marks.to - marks.from) / strongest_N : 0;
  return marks;
}

void PressPace::use(const HapticProgram& front) {
  interrupt();
  for (std::size_t s = 0; s < front.stateCount; ++s) {
    marks_[s] = {placeMarks(front.states[s]), forceMarks(front.states[s])};
  }
}

bool PressPace::take(double value, bool isForce, std::uint8_t state, double time_s) {
  const PressMarks& m = isForce ? marks_[state].N : marks_[state].mm;
  const double before = heard_ ? before_ : value, before_s = before_s_;
  heard_ = true, before_ = value, before_s_ = time_s;
  if (value < m.touch) begun_ = timed_ = false;
  const auto passes = [&](double mark) { return before < mark && value >= mark; };
  const auto passedAt_s = [&](double mark) {
    return before_s + (time_s - before_s) * (mark - before) / (value - before);
  };
  if (passes(m.touch)) begun_ = true, touched_s_ = passedAt_s(m.touch);
  if (begun_ && passes(m.from)) timed_ = true, passed_s_ = passedAt_s(m.from);
  const bool asRender = timed_ && value >= m.from + timedFrom * (m.to - m.from);
  const double from = asRender ? m.from : m.touch, since_s = asRender ? passed_s_ : touched_s_;
  if (!begun_ || !(value > from) || !(value > before) || !(time_s > since_s)) return false;
  const double takes_s = (time_s - since_s) * (m.to - m.from) / (value - from);
  speed_ = std::fmin(m.way_mm / takes_s, fastest_mm_per_s);
  return true;
}

void SpeedTracker::use(const HapticProgram* program, const std::vector<SpeedProgram>* speeds) {
  speeds_ = speeds;
  if (program != nullptr && family()) {
    pace_.use(*program);
    program = &nearest(*speeds_, pace_.speed_mm_per_s()).program;
  }
  playing_ = wanted_ = program;
  settled_ = false;
  tracker_.use(program);
}

void SpeedTracker::goOver(double value) {
  const bool on = value > last_;
  last_ = value;
  if (!on || wanted_ == playing_) return;
  playing_ = wanted_;
  tracker_.exchange(playing_);
}

const Crossings& SpeedTracker::updateForce(double force_N, double time_s) {
  goOver(force_N);
  const Crossings& crossings = tracker_.updateForce(force_N);
  if (family()) addCrossings(crossings, force_N, true, time_s);
  return crossings;
}

const Crossings& SpeedTracker::updateDisplacement(double displacement_mm, double time_s) {
  goOver(displacement_mm);
  const Crossings& crossings = tracker_.updateDisplacement(displacement_mm);
  if (family()) addCrossings(crossings, displacement_mm, false, time_s);
  return crossings;
}

void SpeedTracker::addCrossings(const Crossings& crossings, double value, bool isForce, double time_s) {
  const StrokePosition& at = tracker_.position();
  const StateProgram& state = playing_->states[at.state];
  const bool known = pace_.take(value, isForce, at.state, time_s);
  if (!pace_.begun()) {
    settled_ = false;
    if (at.displacement_mm <= state.start_mm) wanted_ = &speeds_->front().program;
    return;
  }
  settled_ = settled_ || at.releasing || meets(crossings, CrossingKind::pressJump) ||
             at.displacement_mm >= state.start_mm + settledAt * (state.end_mm - state.start_mm);
  if (known && !settled_) wanted_ = &nearest(*speeds_, pace_.speed_mm_per_s()).program;
}

// The speed of this change is unknown, so the previous one is kept.
void SpeedTracker::placeAtForce(double force_N) {
  tracker_.placeAtForce(force_N);
  pace_.interrupt();
}

void SpeedTracker::placeAtDisplacement(double displacement_mm) {
  tracker_.placeAtDisplacement(displacement_mm);
  pace_.interrupt();
}

}  // namespace detent::playback
