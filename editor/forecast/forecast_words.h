// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts in the words of the window.

#include <QString>

#include "playback/study.h"

namespace detent::editor {

/// A forecast in the same words as on the terminal and in reports: "People tell these apart: 0 to 7 errors in
/// 90. Most differs on the release: how strong it is."
QString forecastWords(const playback::PredictedPair& pair);
/// Verdict and range of errors in a few words, for a line of a list.
QString shortForecastWords(const playback::PredictedPair& pair);
/// "Snap ratio × 1.25": the name of the undo step.
QString suggestionWords(const playback::Suggestion& suggestion);
/// "Snap ratio × 1.25: 0 to 8 errors in 90": an entry of a menu.
QString offerWords(const playback::Suggestion& suggestion);

}  // namespace detent::editor
