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
  return Message("how far it seems to yield");
}

}  // namespace

Message errorsOf(const PredictedPair& pair) {
  const long least = std::lround(pair.leastErrorsPer90()), most = std::lround(pair.mostErrorsPer90());
  if (most == 0) return Message("hardly an error in 90");
  if (least == most) return Message("about %1 errors in 90", most);
  return Message("%1 to %2 errors in 90", least, most);
}

Message verdictOf(const PredictedPair& pair) {
  switch (pair.verdict()) {
    case Verdict::toldApart:
      return Message("people tell these apart: %1", errorsOf(pair));
    case Verdict::notToldApart:
      return Message("people do not tell these apart: %1", errorsOf(pair));
    case Verdict::cannotBeSaid:
      break;
  }
  return Message("whether people tell these apart cannot be said: %1", errorsOf(pair));
}

Message shortVerdictOf(const PredictedPair& pair) {
  switch (pair.verdict()) {
    case Verdict::toldApart:
      return Message("told apart: %1", errorsOf(pair));
    case Verdict::notToldApart:
      return Message("not told apart: %1", errorsOf(pair));
    case Verdict::cannotBeSaid:
      break;
  }
  return Message("cannot be said: %1", errorsOf(pair));
}

Message reasonOf(const PredictedPair& pair) {
  if (pair.dPrime <= 0) return Message("nothing differs");
  return pair.onPress ? Message("most differs on the press: %1", cueOf(pair))
                      : Message("most differs on the release: %1", cueOf(pair));
}

}  // namespace detent::playback
