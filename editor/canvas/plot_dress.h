// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What all plots that QCustomPlot draws alone look like: the theme's colours, the legend in one line above the axes.

#include <qcustomplot.h>

#include "editor/document/graph_colors.h"

namespace detent::editor {

/// One axis with its grid and labels.
void dressAxis(QCPAxis& axis, const GraphColors& colors);
/// Axes, grid, labels, legend and ground in the colours of the plot's palette; gives them. GUI thread.
GraphColors dressPlot(QCustomPlot& plot);
/// Once, before there are curves.
void putLegendAbove(QCustomPlot& plot);

}  // namespace detent::editor
