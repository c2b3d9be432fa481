// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words of the window for the effect of a force device on a button.

#include <QString>
#include <vector>

#include "editor/document/display_units.h"
#include "playback/playback.h"

namespace detent::editor {

/// Sentence with the range and slope of a stretch, and the slope that the device can render there.
QString stretchWords(const playback::UnstableStretch& stretch, const Button& button,
                     const DisplayUnits& units);
/// Number of unstable places and the worst of them; a positive sentence if there is none.
QString marginWords(const playback::StabilityMargin& margin, const Button& button, const DisplayUnits& units);
/// A sentence with displacement, drawn slope and felt slope of a remark.
QString remarkWords(const playback::ForceRemark& remark, const Button& button, const DisplayUnits& units);
/// Changes of the nearest stable button, state by state.
QString changeWords(const std::vector<playback::StabilityChange>& changes, const Button& button,
                    const DisplayUnits& units);

}  // namespace detent::editor
