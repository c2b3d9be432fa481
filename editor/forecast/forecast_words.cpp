// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_words.h"

#include <QCoreApplication>

#include "editor/quantity/quantity.h"

namespace detent::editor {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Forecast", text); }

QString cueWords(playback::Cue cue) {
  switch (cue) {
    case playback::Cue::strength:
      return tr("how strong it is");
    case playback::Cue::timing:
      return tr("when the click comes");
    case playback::Cue::force:
      return tr("how hard one has to press");
    case playback::Cue::travel:
      break;
  }
  return tr("how far it seems to yield");
}

QString errorWords(const playback::PredictedPair& pair) {
  const QString least = fixedText(pair.leastErrorsPer90(), 0), most = fixedText(pair.mostErrorsPer90(), 0);
  if (most == "0") return tr("hardly an error in 90");
  if (least == most) return tr("about %1 errors in 90").arg(most);
  return tr("%1 to %2 errors in 90").arg(least, most);
}

}  // namespace

QString shortForecastWords(const playback::PredictedPair& pair) {
  return pair.distinguishable() ? tr("told apart: %1").arg(errorWords(pair))
                                : tr("confused: %1").arg(errorWords(pair));
}

QString reasonWords(const playback::PredictedPair& pair) {
  if (pair.dPrime <= 0) return tr("Nothing differs.");
  return (pair.onPress ? tr("Most differs on the press: %1.") : tr("Most differs on the release: %1."))
      .arg(cueWords(pair.cue));
}

QString forecastWords(const playback::PredictedPair& pair) {
  const QString told = pair.distinguishable() ? tr("People will probably tell these apart: %1.")
                                              : tr("People will probably not tell these apart: %1.");
  return told.arg(errorWords(pair)) + " " + reasonWords(pair);
}

QString suggestionWords(const playback::Suggestion& suggestion) {
  const QString factor = fixedText(suggestion.factor, 2);
  switch (suggestion.lever) {
    case playback::Lever::snap:
      return tr("Snap ratio × %1").arg(factor);
    case playback::Lever::travel:
      return tr("Travel × %1").arg(factor);
    case playback::Lever::force:
      break;
  }
  return tr("Force × %1").arg(factor);
}

QString offerWords(const playback::Suggestion& suggestion) {
  return tr("%1: %2").arg(suggestionWords(suggestion), errorWords(suggestion.forecast));
}

}  // namespace detent::editor
