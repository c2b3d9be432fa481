// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecasts of a press in words, as the window says them. GUI thread.

#include <QString>

#include "editor/document/display_units.h"
#include "playback/pressing.h"

namespace detent::editor {

/// A figure as it is shown: what it is called, the unit behind its name, and what a value is multiplied with.
struct PressTerm {
  QString name, unit, definition;
  double factor = 1;
};
PressTerm termOf(playback::PressFigure figure, const DisplayUnits& units);

/// "52 (40 to 71)": median in two digits, and 5 to 95 % of the fingers; "no forecast" where there is none.
QString bandWords(const playback::PressForecast& forecast, playback::PressFigure figure,
                  const DisplayUnits& units);
/// The reason why a figure is not forecast, a sentence; empty if it is.
QString reasonWords(playback::NoForecast reason);
/// "higher, × 1.4", "no difference forecast": how the second stands to the first.
QString differenceWords(const playback::PressDifference& difference);

}  // namespace detent::editor
