// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/press_response.h"

#include <array>

namespace detent::playback {

namespace {

constexpr double firstGuess_N = 1;
constexpr int halvings = 10;  // bisections of an interval of a factor of 2, to 0.1 %

// Simulated amplitudes, relative to the least that activates; closely spaced where the time of activation
// changes fast.
constexpr std::array shares = {0.5, 0.8, 0.95, 1.0, 1.01, 1.03, 1.07, 1.15,
                               1.3, 1.5, 1.8,  2.2, 2.8,  3.6,  4.8,  6.5};
static_assert(shares.size() % 2 == 0);  // shares are simulated in pairs

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
  const auto at = [share](double first, double second) { return first + share * (second - first); };
  ResponsePoint p;
  p.amplitude_N = amplitude_N;
  p.peak_N = at(a.peak_N, b.peak_N);
  p.impulse_Ns = at(a.impulse_Ns, b.impulse_Ns);
  p.deepest_m = at(a.deepest_m, b.deepest_m);
  p.touch_s = at(a.touch_s, b.touch_s);
  p.activation_s = at(a.activation_s, b.activation_s);
  p.peak_s = at(a.peak_s, b.peak_s);
  p.cycle_s = at(a.cycle_s, b.cycle_s);
  p.held_s = at(a.held_s, b.held_s);
  p.rapidHeld_s = at(a.rapidHeld_s, b.rapidHeld_s);
  p.doubled = at(a.doubled, b.doubled);
  p.rapidDoubled = at(a.rapidDoubled, b.rapidDoubled);
  return p;
}

}  // namespace

std::optional<PressResponse> PressResponse::measure(const KeyTables& key, const ContactPoints& contact,
                                                    const Finger& finger, double duration_s, double lift_s) {
  const auto activates = [&](double amplitude_N) {
    return closesContact(key, contact, finger, {amplitude_N, duration_s, lift_s});
  };
  double high_N = firstGuess_N;
  while (!activates(high_N)) {
    high_N *= 2;
    if (high_N > 2 * mostAmplitude_N) return {};
  }
  double low_N = 0.5 * high_N;
  while (high_N <= firstGuess_N && activates(low_N)) {  // the button is lighter than the first guess
    high_N = low_N;
    low_N *= 0.5;
    if (low_N < 1e-6) break;  // a micronewton moves no key
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle_N = 0.5 * (low_N + high_N);
    (activates(middle_N) ? high_N : low_N) = middle_N;
  }
  if (high_N > mostAmplitude_N) return {};
  PressResponse response;
  response.least_N_ = high_N;
  for (std::size_t i = 0; i < shares.size(); i += 2) {
    const double first_N = shares[i] * high_N, second_N = shares[i + 1] * high_N;
    const auto [first, second] = simulatePresses(
        key, contact, finger, {{{first_N, duration_s, lift_s}, {second_N, duration_s, lift_s}}});
    response.points_.push_back(pointOf(first, first_N));
    response.points_.push_back(pointOf(second, second_N));
  }
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

ResponsePoint PressResponse::at(double amplitude_N, std::size_t& place) const {
  if (amplitude_N <= 0) {
    ResponsePoint rest;
    rest.cycle_s = points_.front().cycle_s;
    return rest;
  }
  while (place < points_.size() && points_[place].amplitude_N < amplitude_N) ++place;
  if (place == 0) return points_.front();
  if (place == points_.size()) return points_.back();
  const ResponsePoint &before = points_[place - 1], &next = points_[place];
  if (amplitude_N < least_N_ && next.amplitude_N >= least_N_) return before;
  return between(before, next, amplitude_N);
}

}  // namespace detent::playback
