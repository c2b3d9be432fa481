// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/feel_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/units.h"

namespace detent::importer {
namespace {

/// Limit of slopes. Steeper ones belong to bottom-outs and edges, where a hundredth of a millimetre decides.
constexpr double steepest_gf_per_mm = 60;

/// Number of cells of the wanted travel: 0.04 mm each on a key switch. Slopes over less are the meters'
/// noise.
constexpr int cells = 96;
/// Largest shift between the contacts of two records, and step of the search for it, in cells. Preload and
/// first resistance differ between testers.
constexpr int farthestShift = 8, shiftStride = 2;
/// Share of the common travel that is left out at either end: contact and bottom-out, where a hundredth of a
/// millimetre decides.
constexpr double leftOutOfEnds = 0.05;

/// Forces at 0, step, ... within the shape, at most `most` of them, interpolated linearly.
std::vector<double> sampled_gf(const std::vector<float>& forces_N, double travel_mm, double step_mm,
                               int most) {
  const double gf_per_N = 1 / newtonsPer(ForceUnit::gramForce);
  const auto last = static_cast<double>(forces_N.size() - 1);
  const double perStep = step_mm / travel_mm * last;
  std::vector<double> forces_gf;
  forces_gf.reserve(static_cast<std::size_t>(most));
  for (int k = 0; k < most; ++k) {
    const double at = std::min(perStep * k, last);
    if (perStep * k > last * (1 + 1e-9)) break;
    const auto i = std::min(static_cast<std::size_t>(at), forces_N.size() - 2);
    const double share = at - static_cast<double>(i);
    forces_gf.push_back(gf_per_N * ((1 - share) * double{forces_N[i]} + share * double{forces_N[i + 1]}));
  }
  return forces_gf;
}

/// The samples that are compared: `count` of them, beginning at these indices of the two shapes.
struct Overlap {
  int a = 0, b = 0, count = 0;
};

Overlap overlapAt(int shift, int aCount, int bCount) {
  Overlap overlap{std::max(0, -shift), std::max(0, shift), 0};
  const int sharedCells = std::min(aCount - overlap.a, bCount - overlap.b) - 1;  // cells
  const int out = static_cast<int>(std::ceil(leftOutOfEnds * sharedCells));
  overlap.a += out;
  overlap.b += out;
  overlap.count = sharedCells + 1 - 2 * out;
  return overlap;
}

struct Moments {
  double mean = 0, aboutMean = 0;
};

Moments apart(const std::vector<double>& a, const std::vector<double>& b, Overlap over) {
  double sum = 0, squares = 0;
  for (int i = 0; i < over.count; ++i) {
    const double d = a[static_cast<std::size_t>(over.a + i)] - b[static_cast<std::size_t>(over.b + i)];
    sum += d;
    squares += d * d;
  }
  const double mean = sum / over.count;
  return {mean, std::max(0.0, squares / over.count - mean * mean)};
}

double slopesApart_gf2_per_mm2(const std::vector<double>& a, const std::vector<double>& b, Overlap over,
                               double step_mm) {
  const double steepest = steepest_gf_per_mm * step_mm;
  const auto rise = [&](const std::vector<double>& of, int at) {
    const auto i = static_cast<std::size_t>(at);
    return std::clamp(of[i + 1] - of[i], -steepest, steepest);
  };
  double sum = 0;
  for (int i = 0; i + 1 < over.count; ++i) {
    const double d = rise(a, over.a + i) - rise(b, over.b + i);
    sum += d * d;
  }
  return over.count > 1 ? sum / (over.count - 1) / (step_mm * step_mm) : 0;
}

double squared(double value) { return value * value; }

/// d^2 at one shift, over the terms that are known.
double sum_gf2(const FeelDifference& of, const FeelWeights& weights) {
  return of.press_gf2 + squared(weights.release) * of.release_gf2 +
         squared(weights.slope_mm) * of.slope_gf2_per_mm2 + squared(weights.level * of.level_gf) +
         squared(weights.travel_gf_per_mm * of.travel_mm) + squared(weights.shift_gf_per_mm * of.shift_mm);
}

}  // namespace

FeelDistance::FeelDistance(const FeltShape& wanted, const FeelWeights& weights)
    : travel_mm_(wanted.travel_mm), step_mm_(wanted.travel_mm / cells), weights_(weights) {
  press_gf_ = sampled_gf(wanted.press_N, travel_mm_, step_mm_, cells + 1);
  if (!wanted.release_N.empty()) release_gf_ = sampled_gf(wanted.release_N, travel_mm_, step_mm_, cells + 1);
}

std::vector<FeelDifference> FeelDistance::differencesTo(const FeltShape& other, double atMost_gf) const {
  constexpr int most = cells + 1 + farthestShift;
  // Rounding must not exclude a switch at the same distance as the last accepted one.
  const double most_gf2 = squared(atMost_gf) * (1 + 1e-9);
  const std::vector<double> press = sampled_gf(other.press_N, other.travel_mm, step_mm_, most);
  // A record without a release is compared by its press alone, which then counts for both strokes.
  const bool releases = !release_gf_.empty() && !other.release_N.empty();
  std::vector<double> release;
  std::vector<FeelDifference> all;
  all.reserve(2 * farthestShift / shiftStride + 1);
  for (int shift = -farthestShift; shift <= farthestShift; shift += shiftStride) {
    const Overlap over = overlapAt(shift, static_cast<int>(press_gf_.size()), static_cast<int>(press.size()));
    if (over.count < 1) continue;
    const Moments down = apart(press_gf_, press, over);
    FeelDifference each{down.aboutMean, 0, 0, 0, other.travel_mm - travel_mm_, shift * step_mm_};
    if (sum_gf2(each, weights_) > most_gf2) continue;
    if (releases && release.empty()) release = sampled_gf(other.release_N, other.travel_mm, step_mm_, most);
    const Moments up = releases ? apart(release_gf_, release, over) : down;
    each.release_gf2 = up.aboutMean;
    each.level_gf = (down.mean + up.mean) / 2;
    if (sum_gf2(each, weights_) > most_gf2) continue;
    each.slope_gf2_per_mm2 = slopesApart_gf2_per_mm2(press_gf_, press, over, step_mm_);
    all.push_back(each);
  }
  return all;
}

double FeelDistance::to(const FeltShape& other, double atMost_labNoise) const {
  return distance_gf(differencesTo(other, atMost_labNoise * labNoise_gf), weights_) / labNoise_gf;
}

double FeelDistance::leastTo(double travel_mm) const {
  constexpr double roundedDown = 1 - 1e-9;
  return roundedDown * weights_.travel_gf_per_mm * std::abs(travel_mm - travel_mm_) / labNoise_gf;
}

double distance_gf(const std::vector<FeelDifference>& byShift, const FeelWeights& weights) {
  double least_gf2 = std::numeric_limits<double>::infinity();
  for (const FeelDifference& each : byShift) least_gf2 = std::min(least_gf2, sum_gf2(each, weights));
  return std::sqrt(least_gf2);
}

}  // namespace detent::importer
