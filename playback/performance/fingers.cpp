// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/fingers.h"

#include <cstddef>
#include <numeric>
#include <utility>

#include "playback/performance/elementary.h"

namespace detent::playback {

namespace {

constexpr std::uint64_t seed = 20261124;
constexpr double restingMedian_N = 0.4;
// standard deviation of the logarithm, like the spread within a finger
constexpr double restingSpreadBetween = 0.30;

/// One position in each of `fingerCount` equal parts of 0..1, in random order.
std::vector<double> positions(FixedRandom& random) {
  std::vector<std::size_t> order(fingerCount);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size() - 1; i > 0; --i)
    std::swap(order[i], order[static_cast<std::size_t>(random.next() % (i + 1))]);
  std::vector<double> shares;
  for (const std::size_t part : order)
    shares.push_back((static_cast<double>(part) + random.share()) / fingerCount);
  return shares;
}

}  // namespace

std::vector<Finger> allFingers() {
  FixedRandom random(seed);
  std::vector<Finger> fingers(fingerCount);
  const auto draw = [&](double Finger::*value, double low, double high) {
    const std::vector<double> shares = positions(random);
    for (std::size_t i = 0; i < fingers.size(); ++i) fingers[i].*value = low + (high - low) * shares[i];
  };
  draw(&Finger::mass_kg, 0.008, 0.016);
  draw(&Finger::pulp_N_per_m, 800, 3000);
  draw(&Finger::pulpDamping_Ns_per_m, 2, 6);
  draw(&Finger::amplitudeSpread, 0.10, 0.25);
  draw(&Finger::muscleRise_s, 0.02, 0.04);
  draw(&Finger::extensorShare, 0.7, 1.3);
  draw(&Finger::feedbackDelay_s, 0.06, 0.10);
  const std::vector<double> weights = positions(random);
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    fingers[i].muscleFall_s = 1.5 * fingers[i].muscleRise_s;
    fingers[i].restingWeightMedian_N =
        restingMedian_N * exponential(restingSpreadBetween * normalScore(weights[i]));
  }
  return fingers;
}

}  // namespace detent::playback
