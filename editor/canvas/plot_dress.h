// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Common style of all plots drawn by QCustomPlot alone: theme colours, legend in one line above the axes.

#include <qcustomplot.h>

#include "editor/document/graph_colors.h"

namespace detent::editor {

/// One axis with its grid and labels.
void dressAxis(QCPAxis& axis, const GraphColors& colors);
/// Sets axes, grid, labels, legend and background to the colours of the plot's palette and returns them. GUI
/// thread.
GraphColors dressPlot(QCustomPlot& plot);
/// Call once, before there are curves.
void putLegendAbove(QCustomPlot& plot);

}  // namespace detent::editor
