// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/forecast_words.h"

#include <cmath>

namespace detent::playback {

namespace {

Message cueOf(const PredictedPair& pair) {
  switch (pair.cue) {
    case Cue::strength:
      return Message("the strength of the vibration");
    case Cue::timing:
      return Message("the moment of the click");
    case Cue::force:
      return Message("the force needed to press");
    case Cue::travel:
      break;
  }
  return Message("the travel that is felt");
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
      return Message("distinguishable: %1", errorsOf(pair));
    case Verdict::notDistinguished:
      return Message("not distinguishable: %1", errorsOf(pair));
    case Verdict::undecided:
      break;
  }
  return pair.probabilityApart >= 0.5 ? Message("probably distinguishable: %1", errorsOf(pair))
                                      : Message("probably not distinguishable: %1", errorsOf(pair));
}

Message reasonOf(const PredictedPair& pair) {
  if (pair.dPrime <= 0) return Message("nothing differs");
  return pair.onPress ? Message("the largest difference is on the press: %1", cueOf(pair))
                      : Message("the largest difference is on the release: %1", cueOf(pair));
}

}  // namespace detent::playback
