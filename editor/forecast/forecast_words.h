// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts in words, as the window says them.

#include <QString>

#include "playback/playback.h"

namespace detent::editor {

/// "People will probably tell these apart: about 2 errors in 90. Most on the release: how strong it is."
QString forecastWords(const playback::PredictedPair& pair);
/// "Most on the press: how far it seems to yield."
QString reasonWords(const playback::PredictedPair& pair);
/// "Snap ratio x 1.25": an entry of a menu and the name of the undo step.
QString suggestionWords(const playback::Suggestion& suggestion);

}  // namespace detent::editor
