// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace detent::editor {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Forecast", text); }

QString cueWords(playback::Cue cue) {
  switch (cue) {
    case playback::Cue::strength:
      return tr("how strong it is");
    case playback::Cue::timing:
      return tr("when the click comes");
    case playback::Cue::travel:
      break;
  }
  return tr("how far it seems to yield");
}

}  // namespace

QString reasonWords(const playback::PredictedPair& pair) {
  if (pair.dPrime <= 0) return tr("Nothing differs.");
  return (pair.onPress ? tr("Most on the press: %1.") : tr("Most on the release: %1."))
      .arg(cueWords(pair.cue));
}

QString forecastWords(const playback::PredictedPair& pair) {
  const QString errors = QLocale().toString(pair.errorsPer90(), 'f', 0);
  return (pair.distinguishable() ? tr("People will probably tell these apart: about %1 errors in 90.")
                                 : tr("People will probably not tell these apart: about %1 errors in 90."))
             .arg(errors) +
         " " + reasonWords(pair);
}

QString suggestionWords(const playback::Suggestion& suggestion) {
  const QString factor = QLocale().toString(suggestion.factor, 'f', 2);
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

}  // namespace detent::editor
