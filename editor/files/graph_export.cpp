// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/graph_export.h"

#include <algorithm>
#include <QBuffer>
#include <QFile>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgRenderer>

#include "editor/files/exports.h"
#include "model/file/text_file.h"

namespace detent::editor {
namespace {

constexpr double pxPerMm = 96 / 25.4;                                          // a CSS pixel
constexpr double colourDotsPerMm = 300 / 25.4, lineArtDotsPerMm = 600 / 25.4;  // as printers ask for
constexpr double mostDots = 16'000;

Failure notDrawn(const QString& path) {
  return {FailureCode::internalFault, path.toStdString(), "", "could not be drawn", "Export it as SVG"};
}

Result<QByteArray> pdfOf(const Button& button, const SvgPlotStyle& style, const QString& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly)) return notDrawn(path);
  QPdfWriter writer(&buffer);
  writer.setPageSize(
      QPageSize(graphSize_mm(button, style), QPageSize::Millimeter, {}, QPageSize::ExactMatch));
  writer.setPageMargins({});
  writer.setResolution(1200);
  writer.setTitle(QString::fromStdString(button.name()));
  QPainter painter;
  if (!painter.begin(&writer)) return notDrawn(path);
  const bool drawn = paintGraph(painter, QRectF(0, 0, writer.width(), writer.height()), button, style);
  if (!painter.end() || !drawn) return notDrawn(path);
  return bytes;
}

}  // namespace

SvgPlotStyle styleOf(GraphPreset preset, const DisplayUnits& units) {
  SvgPlotStyle style;
  style.forceUnit = units.force;
  style.lengthUnit = units.length;
  style.roomBeyondEnd = 0.04;
  switch (preset) {
    case GraphPreset::datasheet:
      setSize(style, 150, 105);
      style.dimensions = true;
      break;
    case GraphPreset::paper:
      setSize(style, 88, 66);
      style.fontSize_px = 10;
      style.lineWidth_px = 1.4;
      style.monochrome = true;
      style.callouts = false;
      break;
    case GraphPreset::slide:
      setSize(style, 254, 143);
      style.fontSize_px = 22;
      style.lineWidth_px = 3;
      style.callouts = false;
      break;
  }
  return style;
}

PlotWords plotWords(PlotLanguage language) {
  if (language == PlotLanguage::english) return {};
  PlotWords words;
  words.displacement = "Weg";
  words.force = "Kraft";
  words.press = "Drücken";
  words.release = "Loslassen";
  words.tactilePoint = "Druckpunkt";
  words.tactilePointOfRelease = "Druckpunkt (Rückweg)";
  words.operatingPoint = "Schaltpunkt";
  words.resetPoint = "Rückschaltpunkt";
  words.bottomOut = "Anschlag";
  words.at = "bei";
  words.preTravel = "Vorlaufweg";
  words.differentialTravel = "Differenzweg";
  return words;
}

void setSize(SvgPlotStyle& style, double width_mm, double height_mm) {
  style.width_mm = width_mm;
  style.width_px = width_mm * pxPerMm;
  style.height_px = height_mm * pxPerMm;
}

bool hasRoom(const SvgPlotStyle& style) {
  constexpr double margins_em = 13, marginsAbove_em = 9;  // of svg_plot.cpp, with a second scale
  constexpr double least = 0.35;                          // of the drawing, for the frame
  return margins_em * style.fontSize_px < (1 - least) * style.width_px &&
         marginsAbove_em * style.fontSize_px < (1 - least) * style.height_px;
}

QSizeF graphSize_mm(const Button& button, const SvgPlotStyle& style) {
  const double width_mm = style.width_mm.value_or(style.width_px / pxPerMm);
  const auto plots = static_cast<double>(button.states().size());
  return {width_mm, width_mm * style.height_px * plots / style.width_px};
}

bool paintGraph(QPainter& painter, const QRectF& place, const Button& button, const SvgPlotStyle& style) {
  QSvgRenderer drawing(QByteArray::fromStdString(svgFrom(button, style)));
  if (!drawing.isValid()) return false;
  const QSizeF size = graphSize_mm(button, style).scaled(place.size(), Qt::KeepAspectRatio);
  drawing.render(&painter, QRectF(place.topLeft(), size));
  return true;
}

QImage graphImage(const Button& button, const SvgPlotStyle& style) {
  const QSizeF wanted = graphSize_mm(button, style) * (style.monochrome ? lineArtDotsPerMm : colourDotsPerMm);
  const double most = std::max(wanted.width(), wanted.height());
  const QSize size = (wanted * std::min(1.0, mostDots / most)).toSize();
  QImage image(size, QImage::Format_RGB32);
  if (image.isNull()) return image;
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!paintGraph(painter, QRectF(QPointF(), size), button, style)) return {};
  return image;
}

Result<Done> exportGraph(const Button& button, const GraphExport& wanted, const QString& path) {
  SvgPlotStyle style = wanted.style;
  style.words = plotWords(wanted.language);
  if (wanted.format == GraphFileFormat::png) return exportPng(graphImage(button, style), path);
  const std::string name = QFile::encodeName(path).toStdString();
  if (wanted.format == GraphFileFormat::svg) return writeTextFileAtomically(name, svgFrom(button, style));
  const auto pdf = pdfOf(button, style, path);
  if (!pdf) return pdf.failure();
  return writeTextFileAtomically(name, pdf->toStdString());
}

}  // namespace detent::editor
