// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/press_counter.h"

#include <algorithm>

namespace detent::playback {

namespace {

constexpr double upShare = 0.1;  // share of the travel: a finger that only rests on the button counts as up
constexpr double throughShare = 0.95;  // share of the travel, for a button without a bottom-out
constexpr double leastTravel_mm = 1e-3;

struct Travelled {
  double deep_mm = 0;
  bool up = false, through = false;
};

/// Progress within the stroke; for a button without travel, of its force.
Travelled travelled(const StateProgram& state, const StrokePosition& position) {
  const double end_mm = state.hasBottomOut ? state.bottomOut_mm
                                           : state.start_mm + throughShare * (state.end_mm - state.start_mm);
  const double travel_mm = end_mm - state.start_mm;
  Travelled t;
  t.deep_mm = std::max(position.displacement_mm - state.start_mm, 0.0);
  if (travel_mm > leastTravel_mm) {
    t.up = t.deep_mm <= upShare * travel_mm;
    t.through = t.deep_mm >= travel_mm;
    return t;
  }
  const double strongest_N =
      state.press.pointCount > 0 ? state.press.points[state.press.pointCount - 1].force_N : 0;
  t.up = position.force_N <= upShare * strongest_N;
  t.through = position.force_N >= strongest_N && strongest_N > 0;
  return t;
}

}  // namespace

void PressCounter::use(const HapticProgram* program) {
  program_ = program;
  phase_ = Phase::notYetUp;
}

void PressCounter::take(const StrokePosition& position) {
  if (program_ == nullptr) return;
  const Travelled t = travelled(program_->states[position.state], position);
  if (t.up) {
    if (phase_ == Phase::through) ++count_.whole;
    phase_ = Phase::up;
    return;
  }
  if (phase_ == Phase::notYetUp) return;
  if (phase_ == Phase::up) {
    ++count_.begun;
    phase_ = Phase::down;
  }
  if (t.through) phase_ = Phase::through;
  count_.peak_N = std::max(count_.peak_N, position.force_N);
  count_.travel_mm = std::max(count_.travel_mm, t.deep_mm);
}

PressCount PressCounter::taken() {
  const PressCount count = count_;
  count_ = {};
  return count;
}

}  // namespace detent::playback
