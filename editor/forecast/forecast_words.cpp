// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_words.h"

#include <QCoreApplication>

#include "editor/document/message_words.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Prediction", text); }

}  // namespace

QString shortForecastWords(const playback::PredictedPair& pair) {
  return inWords(playback::shortVerdictOf(pair));
}

QString forecastWords(const playback::PredictedPair& pair) {
  return asSentence(inWords(playback::verdictOf(pair))) + " " + asSentence(inWords(playback::reasonOf(pair)));
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
  return tr("%1: %2").arg(suggestionWords(suggestion), inWords(playback::errorsOf(suggestion.forecast)));
}

}  // namespace detent::editor
