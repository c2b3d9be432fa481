// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The view's settings between two runs.

#include <QSettings>

#include "editor/document/view_settings.h"

namespace detent::editor {

/// Units are stored by their symbols, so that the file is readable and a new unit does not shift the others.
/// Missing and invalid values keep their defaults.
void restoreView(ViewSettings& view, const QSettings& settings);
void storeView(const ViewSettings& view, QSettings& settings);

}  // namespace detent::editor
