// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/design_help.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/edits.h"

namespace detent::playback {

namespace {

Result<Button> changedBy(const Button& button, Lever lever, double factor) {
  switch (lever) {
    case Lever::snap:
      return scaleSnapRatios(button, factor);
    case Lever::travel:
      return scaleTravel(button, factor);
    case Lever::force:
      break;
  }
  return scaleForce(button, factor);
}

/// Searches one lever in one direction.
class DesignSearch {
 public:
  DesignSearch(const Button& button, const FeltButton& other, const DesignHelpSettings& settings,
               const std::function<bool()>& cancelled)
      : button_(button), other_(other), settings_(settings), cancelled_(cancelled) {}

  /// The first factor on the way from 1 to `farthest` that makes the two distinguishable. The way is searched
  /// in strides, then the two strides before the first success step by step, because a verdict may change
  /// several times.
  std::optional<Suggestion> along(Lever lever, double farthest) const {
    constexpr int strides = 12;
    int below = 100, beforeThat = 100;
    for (int i = 1; i <= strides; ++i) {
      const int percent = static_cast<int>(std::lround(100 * std::pow(farthest, double(i) / strides)));
      std::optional<Suggestion> found = attempt(lever, percent);
      if (!found) return {};
      if (found->forecast.distinguished()) return firstBetween(lever, beforeThat, percent, *std::move(found));
      beforeThat = std::exchange(below, percent);
    }
    return {};
  }

 private:
  std::optional<Suggestion> attempt(Lever lever, int percent) const {
    if (cancelled_ && cancelled_()) return {};
    const double factor = percent / 100.0;
    Result<Button> changed = changedBy(button_, lever, factor);
    if (!changed || *changed == button_) return {};
    Result<FeltButton> felt = feel(*changed, settings_.perception, cancelled_);
    if (!felt) return {};
    PredictedPair forecast = predictConfusion(*felt, other_, settings_.confusion);
    return Suggestion{lever, factor, *std::move(changed), forecast};
  }

  /// The first factor after `from` with which the two are distinguishable, in steps of a hundredth. `found`
  /// is distinguishable at `to`.
  Suggestion firstBetween(Lever lever, int from, int to, Suggestion found) const {
    const int direction = to > from ? 1 : -1;
    for (int percent = from + direction; percent != to; percent += direction) {
      std::optional<Suggestion> tried = attempt(lever, percent);
      if (!tried) break;
      if (tried->forecast.distinguished()) return *std::move(tried);
    }
    return found;
  }

  const Button& button_;
  const FeltButton& other_;
  const DesignHelpSettings& settings_;
  const std::function<bool()>& cancelled_;
};

}  // namespace

Result<std::vector<Suggestion>> makeDistinguishable(const Button& button, const Button& other,
                                                    const DesignHelpSettings& settings,
                                                    const std::function<bool()>& cancelled) {
  Result<FeltButton> itself = feel(button, settings.perception, cancelled);
  if (!itself) return itself.failure();
  Result<FeltButton> felt = feel(other, settings.perception, cancelled);
  if (!felt) return felt.failure();
  std::vector<Suggestion> suggestions;
  if (predictConfusion(*itself, *felt, settings.confusion).distinguished()) return suggestions;
  const DesignSearch search(button, *felt, settings, cancelled);
  for (const Lever lever : {Lever::snap, Lever::travel, Lever::force})
    for (const double farthest : {settings.largestFactor, 1 / settings.largestFactor})
      if (std::optional<Suggestion> found = search.along(lever, farthest))
        suggestions.push_back(*std::move(found));
  if (cancelled && cancelled()) suggestions.clear();
  std::stable_sort(suggestions.begin(), suggestions.end(), [](const Suggestion& a, const Suggestion& b) {
    return std::fabs(std::log(a.factor)) < std::fabs(std::log(b.factor));
  });
  return suggestions;
}

}  // namespace detent::playback
