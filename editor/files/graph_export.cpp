// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/graph_export.h"

#include <algorithm>
#include <cmath>
#include <QBuffer>
#include <QFile>
#include <QPageSize>
#include <QPaintEngine>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QXmlStreamReader>
#include <vector>

#include "editor/files/exports.h"
#include "model/file/text_file.h"

namespace detent::editor {
namespace {

constexpr double pxPerMm = 96 / 25.4;  // a CSS pixel
// resolutions that printers require
constexpr double colourDotsPerMm = 300 / 25.4, lineArtDotsPerMm = 600 / 25.4;
constexpr double mostDots = 16'000;

Failure notDrawn(const QString& path) {
  return {FailureCode::internalFault, path.toStdString(), "", Message("the graph could not be drawn"),
          Message("Export an SVG instead")};
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

// ---- words of a drawing as text

/// One text element of our own drawings (model/file/svg_plot.cpp).
struct DrawnText {
  QPointF at;
  QString words, anchor;
  double size_px = 12, turn_deg = 0;
  bool bold = false;
};

struct DrawnTexts {
  QStringList families;
  QColor color;
  std::vector<DrawnText> texts;
};

DrawnTexts textsOf(const QByteArray& svg) {
  DrawnTexts drawn;
  double usual_px = 12;
  QXmlStreamReader xml(svg);
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const QXmlStreamAttributes given = xml.attributes();
    if (xml.name() == QLatin1String("svg")) {
      for (const QString& family : given.value("font-family").toString().split(','))
        drawn.families << family.trimmed();
      usual_px = given.value("font-size").toDouble();
      drawn.color = QColor(given.value("fill").toString());
    }
    if (xml.name() != QLatin1String("text")) continue;
    DrawnText text{{given.value("x").toDouble(), given.value("y").toDouble()}, {}, {}, usual_px};
    text.anchor = given.value("text-anchor").toString();
    if (given.hasAttribute("font-size")) text.size_px = given.value("font-size").toDouble();
    text.bold = given.value("font-weight") == QLatin1String("bold");
    // the drawing rotates texts only about their own position
    if (given.value("transform").startsWith(QLatin1String("rotate(")))
      text.turn_deg = given.value("transform").mid(7).split(u' ').front().toDouble();
    text.words = xml.readElementText();
    drawn.texts.push_back(std::move(text));
  }
  return drawn;
}

void paintTexts(QPainter& painter, const DrawnTexts& drawn) {
  constexpr double finer = 100;  // factor of enlargement, because fonts have whole sizes
  for (const DrawnText& text : drawn.texts) {
    QFont font;
    font.setFamilies(drawn.families);
    font.setPixelSize(static_cast<int>(std::lround(finer * text.size_px)));
    font.setBold(text.bold);
    font.setHintingPreference(QFont::PreferNoHinting);
    const double width = QFontMetricsF(font).horizontalAdvance(text.words);
    const double before = text.anchor == QLatin1String("middle") ? 0.5 : text.anchor == QLatin1String("end");
    painter.save();
    painter.setPen(drawn.color);
    painter.setFont(font);
    painter.translate(text.at);
    painter.rotate(text.turn_deg);
    painter.scale(1 / finer, 1 / finer);
    painter.drawText(QPointF(-before * width, 0), text.words);
    painter.restore();
  }
}

}  // namespace

SvgPlotStyle styleOf(GraphPreset preset, const DisplayUnits& units) {
  SvgPlotStyle style;
  style.forceUnit = units.force;
  style.lengthUnit = units.length;
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
  words.release = "Rückweg";
  words.tactilePoint = "Druckpunkt";
  words.tactilePointOfRelease = "Druckpunkt (Rückweg)";
  words.operatingPoint = "Schaltpunkt";
  words.resetPoint = "Rückschaltpunkt";
  words.bottomOut = "Anschlag";
  words.at = "bei";
  words.preTravel = "Vorlaufweg";
  words.differentialTravel = "Differenzweg";
  words.unlocked = "gelöst";
  words.locked = "eingerastet";
  return words;
}

void setSize(SvgPlotStyle& style, double width_mm, double height_mm) {
  style.width_mm = width_mm;
  style.width_px = width_mm * pxPerMm;
  style.height_px = height_mm * pxPerMm;
}

bool hasRoom(const SvgPlotStyle& style) {
  constexpr double margins_em = 13, marginsAbove_em = 9;  // margins in svg_plot.cpp with a second scale
  constexpr double least = 0.35;                          // share of the drawing for the frame
  return margins_em * style.fontSize_px < (1 - least) * style.width_px &&
         marginsAbove_em * style.fontSize_px < (1 - least) * style.height_px;
}

QSizeF graphSize_mm(const Button& button, const SvgPlotStyle& style) {
  const double width_mm = style.width_mm.value_or(style.width_px / pxPerMm);
  const auto plots = static_cast<double>(button.states().size());
  return {width_mm, width_mm * style.height_px * plots / style.width_px};
}

bool paintGraph(QPainter& painter, const QRectF& place, const Button& button, const SvgPlotStyle& style) {
  QByteArray svg = QByteArray::fromStdString(svgFrom(button, style));
  DrawnTexts texts;
  // Qt's renderer draws words as outlines, but in a PDF it must be possible to select and search them.
  if (painter.paintEngine()->type() == QPaintEngine::Pdf) {
    texts = textsOf(svg);
    static const QRegularExpression textElement("<text [^>]*>[^<]*</text>");
    svg = QString::fromUtf8(svg).remove(textElement).toUtf8();
  }
  QSvgRenderer drawing(svg);
  if (!drawing.isValid()) return false;
  const QSizeF size = graphSize_mm(button, style).scaled(place.size(), Qt::KeepAspectRatio);
  drawing.render(&painter, QRectF(place.topLeft(), size));
  painter.save();
  painter.translate(place.topLeft());
  painter.scale(size.width() / drawing.viewBoxF().width(), size.height() / drawing.viewBoxF().height());
  paintTexts(painter, texts);
  painter.restore();
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
