// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/press_response.h"

#include <algorithm>
#include <array>

namespace detent::playback {

namespace {

constexpr double firstGuess_N = 1;
constexpr int halvings = 10;  // of a bracket of a factor 2: to 0.1 %

// Where presses are simulated, as shares of the least amplitude that activates: close together where the time of
// activation changes fast.
constexpr std::array below = {0.5, 0.8, 0.95};
constexpr std::array above = {1.0, 1.01, 1.03, 1.07, 1.15, 1.3, 1.5, 1.8, 2.2, 2.8, 3.6, 4.8, 6.5};

ResponsePoint pointOf(const PressOutcome& o, double amplitude_N) {
  ResponsePoint p;
  p.amplitude_N = amplitude_N;
  p.peak_N = o.peak_N;
  p.impulse_Ns = o.impulse_Ns;
  p.deepest_m = o.deepest_m;
  p.touch_s = o.touch_s.value_or(0);
  p.activation_s = o.activation_s.value_or(0);
  p.peak_s = o.peak_s;
  p.cycle_s = o.end_s;
  if (o.activation_s) {
    p.held_s = o.opening_s.value_or(o.end_s) - *o.activation_s;
    p.rapidHeld_s = o.rapidOpening_s.value_or(o.end_s) - *o.activation_s;
  }
  p.doubled = o.closings > 1 ? 1 : 0;
  p.rapidDoubled = o.rapidClosings > 1 ? 1 : 0;
  return p;
}

ResponsePoint between(const ResponsePoint& a, const ResponsePoint& b, double amplitude_N) {
  const double share = (amplitude_N - a.amplitude_N) / (b.amplitude_N - a.amplitude_N);
  ResponsePoint p;
  p.amplitude_N = amplitude_N;
  for (double ResponsePoint::*value :
       {&ResponsePoint::peak_N, &ResponsePoint::impulse_Ns, &ResponsePoint::deepest_m,
        &ResponsePoint::touch_s, &ResponsePoint::activation_s, &ResponsePoint::peak_s,
        &ResponsePoint::cycle_s, &ResponsePoint::held_s, &ResponsePoint::rapidHeld_s, &ResponsePoint::doubled,
        &ResponsePoint::rapidDoubled})
    p.*value = a.*value + share * (b.*value - a.*value);
  return p;
}

}  // namespace

std::optional<PressResponse> PressResponse::measure(const KeyTables& key, const ContactPoints& contact,
                                                    const Finger& finger, double duration_s, double lift_s) {
  const auto press = [&](double amplitude_N) {
    return simulatePress(key, contact, finger, {amplitude_N, duration_s, lift_s});
  };
  const auto activates = [&](double amplitude_N) {
    return closesContact(key, contact, finger, {amplitude_N, duration_s, lift_s});
  };
  double high_N = firstGuess_N;
  while (!activates(high_N)) {
    high_N *= 2;
    if (high_N > 2 * mostAmplitude_N) return {};
  }
  double low_N = 0.5 * high_N;
  while (high_N <= firstGuess_N && activates(low_N)) {  // a lighter button than guessed
    high_N = low_N;
    low_N *= 0.5;
    if (low_N < 1e-6) break;  // N: as good as none
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle_N = 0.5 * (low_N + high_N);
    (activates(middle_N) ? high_N : low_N) = middle_N;
  }
  if (high_N > mostAmplitude_N) return {};
  PressResponse response;
  response.least_N_ = high_N;
  for (const double share : below) response.points_.push_back(pointOf(press(share * high_N), share * high_N));
  for (const double share : above) response.points_.push_back(pointOf(press(share * high_N), share * high_N));
  return response;
}

double PressResponse::leastReaching_N(double depth_m) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i].deepest_m < depth_m) continue;
    if (i == 0) return points_[0].amplitude_N;
    const ResponsePoint &a = points_[i - 1], &b = points_[i];
    const double rise_m = b.deepest_m - a.deepest_m;
    const double share = rise_m > 0 ? (depth_m - a.deepest_m) / rise_m : 1;
    return a.amplitude_N + share * (b.amplitude_N - a.amplitude_N);
  }
  return points_.back().amplitude_N;
}

ResponsePoint PressResponse::at(double amplitude_N) const {
  if (amplitude_N <= 0) {
    ResponsePoint rest;
    rest.cycle_s = points_.front().cycle_s;
    return rest;
  }
  const auto next =
      std::lower_bound(points_.begin(), points_.end(), amplitude_N,
                       [](const ResponsePoint& p, double wanted_N) { return p.amplitude_N < wanted_N; });
  if (next == points_.begin()) return points_.front();
  if (next == points_.end()) return points_.back();
  if (amplitude_N < least_N_ && next->amplitude_N >= least_N_) return *(next - 1);
  return between(*(next - 1), *next, amplitude_N);
}

}  // namespace detent::playback
