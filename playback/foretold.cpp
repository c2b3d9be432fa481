// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "playback/playback.h"

namespace detent::playback {

Result<std::vector<ForetoldPair>> foretold(const Study& study,
                                           const std::function<std::string(const PredictedPair&)>& reason) {
  PerceptionSettings settings;
  if (study.profile) settings.device = *study.profile;
  settings.playback.mode = study.design.modes.front();
  std::vector<FeltButton> felt;
  for (const StudyButton& button : study.buttons) {
    Result<FeltButton> one = feel(button.button, settings);
    if (!one) return one.failure();
    felt.push_back(*std::move(one));
  }
  std::vector<ForetoldPair> pairs;
  const std::vector<PredictedPair> predicted = predictAll(felt);
  for (const auto& [first, second] : pairsOf(felt.size())) {
    const PredictedPair& pair = predicted[pairs.size()];
    pairs.push_back({first, second, pair.dPrime, pair.shareOfErrors, reason(pair)});
  }
  return pairs;
}

}  // namespace detent::playback
