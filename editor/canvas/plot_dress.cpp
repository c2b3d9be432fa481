// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/plot_dress.h"

namespace detent::editor {

void dressAxis(QCPAxis& axis, const GraphColors& colors) {
  axis.setBasePen(QPen(colors.axis));
  axis.setTickPen(QPen(colors.axis));
  axis.setSubTickPen(QPen(colors.axis));
  axis.setTickLabelColor(colors.text);
  axis.setLabelColor(colors.text);
  axis.grid()->setPen(QPen(colors.grid));
  axis.grid()->setZeroLinePen(QPen(colors.axis));
}

GraphColors dressPlot(QCustomPlot& plot) {
  const GraphColors colors = graphColors(isDark(plot.palette()));
  plot.setBackground(colors.background);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) dressAxis(*axis, colors);
  plot.legend->setTextColor(colors.text);
  plot.legend->setBrush(QBrush(colors.background));
  plot.legend->setBorderPen(QPen(colors.grid));
  return colors;
}

void putLegendAbove(QCustomPlot& plot) {
  plot.legend->setVisible(true);
  plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
  plot.plotLayout()->insertRow(0);
  plot.plotLayout()->addElement(0, 0, plot.legend);
  constexpr double noMoreThanNeeded = 1e-3;
  plot.plotLayout()->setRowStretchFactor(0, noMoreThanNeeded);
}

}  // namespace detent::editor
