// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Colours of the page as small pictures on buttons and in lists.

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <vector>

#include "importer/importer.h"

namespace detent::editor {

QColor colorFrom(const importer::Rgb& rgb);
/// One or more colours side by side, with frames in `palette`; transparent colours stay empty.
QIcon swatchOf(const std::vector<QColor>& colors, const QPalette& palette);

}  // namespace detent::editor
