// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_conditioner.h"

#include <cmath>

namespace detent::playback {

namespace {
constexpr std::uint32_t earlyReadingsThatProve = 8;  // 19 ms at 425 Hz, 80 ms at 100 Hz
}

ConditionerSettings limitsFor(const HapticProgram& program) {
  constexpr double overload = 5;           // factor for a finger that presses a button five times too hard
  constexpr double fastestPress_s = 1e-3;  // shortest time from zero to the strongest force
  constexpr double noisiest = 0.125;       // share of the strongest force
  const double strongest_N = strongestForce_N(program);
  ConditionerSettings settings;
  settings.knownNoise = program.sensorNoise_N;
  settings.mostNoise = noisiest * strongest_N;
  settings.highest = std::fmax(settings.highest, overload * strongest_N);
  settings.lowest = std::fmin(settings.lowest, -strongest_N);
  settings.fastest_per_s = std::fmax(settings.fastest_per_s, strongest_N / fastestPress_s);
  return settings;
}

void ForceConditioner::setSettings(const ConditionerSettings& settings) {
  settings_ = settings;
  steadier_.configure(settings.knownNoise, settings.mostNoise);
  rest_.configure(settings.mostNoise);
}

void ForceConditioner::learn(double value) {
  if (std::isfinite(value) && value >= settings_.lowest && value <= settings_.highest) steadier_.learn(value);
}

ConditionerVerdict ForceConditioner::judge(double time_s, double value) {
  if (!std::isfinite(value) || !std::isfinite(time_s)) {
    ++counts_.notFinite;
    return ConditionerVerdict::reject;
  }
  if (value < settings_.lowest || value > settings_.highest) {
    ++counts_.outOfRange;
    return ConditionerVerdict::reject;
  }
  if (!any_) return accept(time_s, value, true);
  const double elapsed_s = time_s - lastTime_s_;
  if (!(elapsed_s > 0)) return judgeEarly(time_s, value);
  earlyInRow_ = 0;
  if (elapsed_s > settings_.silentAfter_s) {
    ++counts_.gaps;
    return accept(time_s, value, true);
  }
  const double step = std::fabs(value - lastValue_);
  const bool confirmed = suspected_ && std::fabs(value - suspect_) <= settings_.confirmBand * step;
  if (confirmed) --counts_.glitches;  // the rejected reading was valid after all
  if (confirmed || step <= settings_.fastest_per_s * elapsed_s) return accept(time_s, value, false);
  ++counts_.glitches;
  suspected_ = true;
  suspect_ = value;
  return ConditionerVerdict::reject;
}

// A single time far ahead would make all later readings appear too early. If readings continue to arrive in
// order and all of them are early, that single time was wrong.
ConditionerVerdict ForceConditioner::judgeEarly(double time_s, double value) {
  ++counts_.outOfOrder;
  earlyInRow_ = earlyInRow_ > 0 && time_s > earlySuspect_s_ ? earlyInRow_ + 1 : 1;
  earlySuspect_s_ = time_s;
  if (earlyInRow_ < earlyReadingsThatProve) return ConditionerVerdict::reject;
  --counts_.outOfOrder;  // this reading is accepted; the previous early ones are lost and stay counted
  ++counts_.wrongTimes;
  return accept(time_s, value, true);
}

ConditionerVerdict ForceConditioner::accept(double time_s, double value, bool resumed) {
  if (!any_ || value != lastValue_ || resumed || value <= settings_.stuckAbove) sameSince_s_ = time_s;
  stuck_ = time_s - sameSince_s_ > settings_.stuckAfter_s;
  any_ = true;
  suspected_ = false;
  earlyInRow_ = 0;
  if (resumed) {
    steadier_.startAnew();
    rest_.startAnew();
  }
  steadyValue_ = rest_.next(time_s, steadier_.next(time_s, value));
  lastTime_s_ = time_s;
  lastValue_ = value;
  ++counts_.accepted;
  return resumed ? ConditionerVerdict::resume : ConditionerVerdict::accept;
}

bool ForceConditioner::silent(double now_s) const {
  return !any_ || now_s - lastTime_s_ > settings_.silentAfter_s;
}

}  // namespace detent::playback
