// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/graph_print.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPicture>
#include <QPrinter>

#include "editor/canvas/graph_canvas.h"
#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/panels/graph_workspace.h"

namespace detent::editor {
namespace {

constexpr QSize graph_px{900, 600};  // in which the graph is laid out; the paper scales it
constexpr double titleHeight_mm = 12, lineHeight_mm = 5.5;

QStringList valueLines(GraphWorkspace& workspace, const DisplayUnits& units) {
  const GraphCanvas& canvas = workspace.canvas();
  QStringList lines;
  for (const Mark& mark : pointMarks(canvas.state(), canvas.values()))
    if (mark.id.kind != MarkKind::knot) lines << describe(mark, units);
  return lines;
}

}  // namespace

bool printGraph(QPrinter& printer, const ButtonDocument& document, GraphWorkspace& workspace,
                const ViewSettings& settings) {
  QPicture graph;
  workspace.canvas().renderTo(graph, graph_px, QPalette(Qt::white));  // as paper is, whatever the window is
  QPainter painter;
  if (!painter.begin(&printer)) return false;
  const QRectF page = printer.pageRect(QPrinter::DevicePixel);
  const double mm = printer.resolution() / 25.4;
  const double width = page.width(), scale = width / graph_px.width();
  QFont font(QStringLiteral("sans-serif"));
  font.setPointSizeF(14);
  painter.setFont(font);
  painter.drawText(QRectF(0, 0, width, titleHeight_mm * mm), Qt::AlignLeft | Qt::AlignVCenter,
                   document.title());
  painter.save();
  painter.translate(0, titleHeight_mm * mm);
  // A picture is played as large on paper as on the screen, which is another scale already.
  const double played = painter.device()->logicalDpiX() / static_cast<double>(graph.logicalDpiX());
  painter.scale(scale / played, scale / played);
  painter.drawPicture(0, 0, graph);
  painter.restore();
  font.setPointSizeF(9);
  painter.setFont(font);
  double y = titleHeight_mm * mm + scale * graph_px.height() + lineHeight_mm * mm;
  for (const QString& line : valueLines(workspace, settings.units())) {
    if (y + lineHeight_mm * mm > page.height()) break;  // one page; the whole table is the CSV's
    painter.drawText(QRectF(0, y, width, lineHeight_mm * mm), Qt::AlignLeft | Qt::AlignVCenter, line);
    y += lineHeight_mm * mm;
  }
  return painter.end();
}

}  // namespace detent::editor
