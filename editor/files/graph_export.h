// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exports a graph as chosen in the dialogue. One drawing (model/file/svg_plot.h) goes into SVG, PDF, PNG and
// onto paper, so that all of them show the same.

#include <optional>
#include <QImage>
#include <QPainter>
#include <QString>

#include "editor/document/display_units.h"
#include "model/button.h"
#include "model/file/svg_plot.h"

namespace detent::editor {

/// Purpose of the graph.
enum class GraphPreset {
  datasheet,  ///< 150 mm, callouts and dimensions
  paper,      ///< 88 mm, one column, black, only the curves
  slide,      ///< 254 mm, large and thick
};
enum class GraphFileFormat { svg, pdf, png };
enum class PlotLanguage { english, german };

struct GraphExport {
  GraphFileFormat format = GraphFileFormat::svg;
  PlotLanguage language = PlotLanguage::english;
  SvgPlotStyle style;  ///< width_mm is set
};

/// Size, fonts and contents of a preset; axes in `units`.
SvgPlotStyle styleOf(GraphPreset preset, const DisplayUnits& units);
/// The words of a plot in that language.
PlotWords plotWords(PlotLanguage language);
/// Sets the size of one plot; both at least 60 mm.
void setSize(SvgPlotStyle& style, double width_mm, double height_mm);
/// Returns true if there is room for curves beside axes, numbers and titles.
bool hasRoom(const SvgPlotStyle& style);

/// Size of the whole drawing: one plot per state.
QSizeF graphSize_mm(const Button& button, const SvgPlotStyle& style);
/// Draws the graph into `place` of the painter's coordinates, as large as fits. Returns false if nothing was
/// drawn.
bool paintGraph(QPainter& painter, const QRectF& place, const Button& button, const SvgPlotStyle& style);
/// Image at 300 dpi, black and white at 600 dpi; at most 16,000 pixels wide and high.
QImage graphImage(const Button& button, const SvgPlotStyle& style);
/// Writes the whole file; the Failure says why it could not be written.
Result<Done> exportGraph(const Button& button, const GraphExport& wanted, const QString& path);

}  // namespace detent::editor
