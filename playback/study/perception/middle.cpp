// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/middle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "model/blend.h"

namespace detent::playback {
namespace {

constexpr double equalWithin = 0.05;

/// Imbalance of the two halves: 0 if they are equal, positive if the place is farther from `from`.
double imbalanceOf(const PerceptualMiddle& place) {
  const double sum = place.dPrimeFrom + place.dPrimeTo;
  return sum > 0 ? 2 * (place.dPrimeFrom - place.dPrimeTo) / sum : 0;
}

/// Tries places between two buttons and keeps the one whose halves differ least.
class MiddleSearch {
 public:
  MiddleSearch(const Button& from, const Button& to, const PerceptionSettings& perception,
               const ConfusionSettings& confusion, const std::function<bool()>& cancelled)
      : from_(from), to_(to), perception_(perception), confusion_(confusion), cancelled_(cancelled) {}

  std::optional<Failure> begin() {
    auto from = feel(from_, perception_, cancelled_);
    if (!from) return from.failure();
    auto to = feel(to_, perception_, cancelled_);
    if (!to) return to.failure();
    feltFrom_ = *std::move(from);
    feltTo_ = *std::move(to);
    return {};
  }

  Result<double> imbalanceAt(double share) {
    auto button = between(from_, to_, share);
    if (!button) return button.failure();
    const auto felt = feel(*button, perception_, cancelled_);
    if (!felt) return felt.failure();
    PerceptualMiddle tried{share, *std::move(button), predictConfusion(feltFrom_, *felt, confusion_).dPrime,
                           predictConfusion(*felt, feltTo_, confusion_).dPrime};
    const double imbalance = imbalanceOf(tried);
    if (!best_ || std::fabs(imbalance) < std::fabs(imbalanceOf(*best_))) best_ = std::move(tried);
    return imbalance;
  }

  /// Bisects a stretch at whose ends the imbalance has different signs.
  std::optional<Failure> narrow(double low, double high, bool rising) {
    constexpr int halvings = 10;
    for (int i = 0; i < halvings && !closeEnough(); ++i) {
      const double middle = (low + high) / 2;
      const auto imbalance = imbalanceAt(middle);
      if (!imbalance) return imbalance.failure();
      ((*imbalance < 0) == rising ? low : high) = middle;
    }
    return {};
  }

  bool closeEnough() const { return best_ && std::fabs(imbalanceOf(*best_)) < equalWithin / 10; }
  PerceptualMiddle best() && { return *std::move(best_); }

 private:
  const Button &from_, &to_;
  const PerceptionSettings& perception_;
  const ConfusionSettings& confusion_;
  const std::function<bool()>& cancelled_;
  FeltButton feltFrom_, feltTo_;
  std::optional<PerceptualMiddle> best_;
};

}  // namespace

bool PerceptualMiddle::equal() const { return std::fabs(imbalanceOf(*this)) <= equalWithin; }

Result<PerceptualMiddle> placeBetween(const Button& from, const Button& to, double share,
                                      const std::function<bool()>& cancelled) {
  auto button = between(from, to, share);
  if (!button) return button.failure();
  std::array<FeltButton, 3> felt;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    auto one = feel(i == 0 ? from : i == 1 ? *button : to, {}, cancelled);
    if (!one) return one.failure();
    felt[i] = *std::move(one);
  }
  return PerceptualMiddle{share, *std::move(button), predictConfusion(felt[0], felt[1]).dPrime,
                          predictConfusion(felt[1], felt[2]).dPrime};
}

Result<PerceptualMiddle> perceptualMiddle(const Button& from, const Button& to,
                                          const PerceptionSettings& perception,
                                          const ConfusionSettings& confusion,
                                          const std::function<bool()>& cancelled) {
  MiddleSearch search(from, to, perception, confusion, cancelled);
  if (auto failure = search.begin()) return std::move(*failure);
  if (const auto half = search.imbalanceAt(0.5); !half) return half.failure();
  // number of stretches that are searched: the forecast jumps by whole grains, so the halves may be equal in
  // several places, or in none
  constexpr int stretches = 32;
  double before = -1;  // imbalance at the previous place; -1 for `from` itself
  for (int i = 1; i <= stretches && !search.closeEnough(); ++i) {
    const auto here = i == stretches ? Result<double>(1) : search.imbalanceAt(double(i) / stretches);
    if (!here) return here.failure();
    if ((before < 0) != (*here < 0))
      if (auto failure = search.narrow(double(i - 1) / stretches, double(i) / stretches, before < 0))
        return std::move(*failure);
    before = *here;
  }
  return std::move(search).best();
}

}  // namespace detent::playback
