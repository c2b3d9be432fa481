// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/design_help.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/edits.h"
#include "model/metrics.h"

namespace detent::playback {

namespace {

Result<Button> withSnap(const Button& button, double factor) {
  Result<Button> changed = button;
  for (std::size_t s = 0; s < button.states().size(); ++s) {
    const StrokeMetrics press = metricsOf(button.states()[s].graph.press(), Stroke::press);
    for (std::size_t t = 0; t < press.tactile.size() && changed; ++t) {
      if (!press.tactile[t].snapRatio) continue;
      changed = editGraph(*changed, s, [&](const ForceGraph& graph) {
        return editStroke(graph, Stroke::press, [&](const StrokeCurve& curve) {
          return setSnapRatio(curve, t, *press.tactile[t].snapRatio * factor);
        });
      });
    }
  }
  return changed;
}

Result<Button> changedBy(const Button& button, Lever lever, double factor) {
  switch (lever) {
    case Lever::snap:
      return withSnap(button, factor);
    case Lever::travel:
      return scaleTravel(button, factor);
    case Lever::force:
      break;
  }
  return scaleForce(button, factor);
}

/// Searches one lever in one direction.
class Search {
 public:
  Search(const Button& button, const FeltButton& other, const DesignHelpSettings& settings,
         const std::function<bool()>& cancelled)
      : button_(button), other_(other), settings_(settings), cancelled_(cancelled) {}

  /// The first factor on the way from 1 to `farthest` that passes the bar.
  std::optional<Suggestion> along(Lever lever, double farthest) const {
    constexpr int strides = 6;
    const double whole = std::log(farthest);
    double below = 0;  // logarithms of factors
    for (int i = 1; i <= strides; ++i) {
      const double share = whole * i / strides;
      std::optional<Suggestion> found = attempt(lever, share);
      if (!found) return {};
      if (found->forecast.dPrime >= settings_.bar_dPrime)
        return narrowed(lever, below, share, *std::move(found));
      below = share;
    }
    return {};
  }

 private:
  std::optional<Suggestion> attempt(Lever lever, double logFactor) const {
    if (cancelled_ && cancelled_()) return {};
    Result<Button> changed = changedBy(button_, lever, std::exp(logFactor));
    if (!changed || *changed == button_) return {};
    Result<FeltButton> felt = feel(*changed, settings_.perception, cancelled_);
    if (!felt) return {};
    PredictedPair forecast = predictConfusion(*felt, other_, settings_.confusion);
    return Suggestion{lever, std::exp(logFactor), *std::move(changed), forecast};
  }

  Suggestion narrowed(Lever lever, double below, double above, Suggestion found) const {
    while (std::fabs(above - below) > settings_.resolution) {
      const double middle = (below + above) / 2;
      std::optional<Suggestion> tried = attempt(lever, middle);
      if (!tried) break;
      if (tried->forecast.dPrime >= settings_.bar_dPrime) {
        above = middle;
        found = *std::move(tried);
      } else {
        below = middle;
      }
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
  if (predictConfusion(*itself, *felt, settings.confusion).dPrime >= settings.bar_dPrime) return suggestions;
  const Search search(button, *felt, settings, cancelled);
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
