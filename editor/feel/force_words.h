// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a force device does to a button, in the words of the window.

#include <QString>
#include <vector>

#include "editor/document/display_units.h"
#include "playback/playback.h"

namespace detent::editor {

/// "The wall from 3.9 to 4.0 mm rises by 142 N/mm; the device bears 0.67 N/mm."
QString stretchWords(const playback::UnstableStretch& stretch, const Button& button,
                     const DisplayUnits& units);
/// How many places there are and the worst of them; that all is well where there is none.
QString marginWords(const playback::StabilityMargin& margin, const Button& button, const DisplayUnits& units);
/// "At 4 mm a wall of 142 N/mm is felt as 2 N/mm."
QString remarkWords(const playback::ForceRemark& remark, const Button& button, const DisplayUnits& units);
/// What the nearest stable button changed, state by state.
QString changeWords(const std::vector<playback::StabilityChange>& changes, const Button& button,
                    const DisplayUnits& units);

}  // namespace detent::editor
