// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The view's settings between two runs.

#include <QSettings>

#include "editor/document/view_settings.h"

namespace detent::editor {

/// Units by their symbols, so that the file can be read and a new unit does not shift the others. What is
/// missing or makes no sense keeps its default.
void restoreView(ViewSettings& view, const QSettings& settings);
void storeView(const ViewSettings& view, QSettings& settings);

}  // namespace detent::editor
