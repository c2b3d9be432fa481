// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/forecast_words.h"

#include <cmath>

namespace detent::playback {

namespace {

Message cueOf(const PredictedPair& pair) {
  switch (pair.cue) {
    case Cue::strength:
      return Message("how strong it is");
    case Cue::timing:
      return Message("when the click comes");
    case Cue::force:
      return Message("how hard one has to press");
    case Cue::travel:
      break;
  }
  return Message("how far it seems to give way");
}

/// Share in whole per cent.
MessageValue percentOf(double probability) { return {std::round(100 * probability) / 100, Measure::share}; }

}  // namespace

Message errorsOf(const PredictedPair& pair) {
  const long least = std::lround(pair.leastErrorsPer90()), most = std::lround(pair.mostErrorsPer90());
  if (most == 0) return Message("almost no errors in 90 trials");
  if (least == most) return Message("about %1 errors in 90 trials", most);
  return Message("%1 to %2 errors in 90 trials", least, most);
}

Message verdictOf(const PredictedPair& pair) {
  switch (pair.verdict()) {
    case Verdict::distinguished:
      return Message("people can tell these apart: %1", errorsOf(pair));
    case Verdict::notDistinguished:
      return Message("people cannot tell these apart: %1", errorsOf(pair));
    case Verdict::undecided:
      break;
  }
  return pair.probabilityApart >= 0.5 ? Message("people can probably tell these apart (%1): %2",
                                                percentOf(pair.probabilityApart), errorsOf(pair))
                                      : Message("people probably cannot tell these apart (%1): %2",
                                                percentOf(1 - pair.probabilityApart), errorsOf(pair));
}

Message shortVerdictOf(const PredictedPair& pair) {
  switch (pair.verdict()) {
    case Verdict::distinguished:
      return Message("told apart: %1", errorsOf(pair));
    case Verdict::notDistinguished:
      return Message("not told apart: %1", errorsOf(pair));
    case Verdict::undecided:
      break;
  }
  return pair.probabilityApart >= 0.5 ? Message("probably told apart: %1", errorsOf(pair))
                                      : Message("probably not told apart: %1", errorsOf(pair));
}

Message reasonOf(const PredictedPair& pair) {
  if (pair.dPrime <= 0) return Message("nothing differs");
  return pair.onPress ? Message("the largest difference is on the press: %1", cueOf(pair))
                      : Message("the largest difference is on the release: %1", cueOf(pair));
}

}  // namespace detent::playback
