// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "playback/study.h"
#include "playback/study/perception/forecast_words.h"

namespace detent::playback {

namespace {

Result<std::vector<FeltButton>> feltIn(const Study& study, FeedbackMode mode) {
  PerceptionSettings settings;
  if (study.profile) settings.device = *study.profile;
  settings.playback.mode = mode;
  settings.playback.feel = study.design.feel;
  std::vector<FeltButton> felt;
  for (const StudyButton& button : study.buttons) {
    Result<FeltButton> one = feel(button.button, settings);
    if (!one) return one.failure();
    felt.push_back(*std::move(one));
  }
  return felt;
}

}  // namespace

Result<std::vector<ForetoldPair>> foretold(const Study& study) {
  std::vector<ForetoldPair> forecasts;
  if (!asksForX(study.design.kind)) return forecasts;
  for (const FeedbackMode mode : study.design.modes) {
    Result<std::vector<FeltButton>> felt = feltIn(study, mode);
    if (!felt) return felt.failure();
    const auto pairs = pairsOf(felt->size());
    const std::vector<PredictedPair> predicted = predictAll(*felt);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const PredictedPair& pair = predicted[i];
      forecasts.push_back({mode, pairs[i].first, pairs[i].second, pair.dPrime, pair.shareOfErrors,
                           english(verdictOf(pair)), english(reasonOf(pair))});
    }
  }
  return forecasts;
}

}  // namespace detent::playback
