// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/graph_print.h"

#include <QCoreApplication>
#include <QDate>
#include <QLocale>
#include <QPainter>
#include <QPrinter>

#include "editor/document/button_document.h"
#include "editor/document/state_name.h"
#include "editor/document/view_settings.h"
#include "editor/files/graph_export.h"
#include "editor/panels/key_figures_model.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double lineHeight_mm = 5.5, gap_mm = 5;
constexpr double mostForGraph = 0.62;  // share of the page's height; the figures have the rest
constexpr double lineSize_pt = 9;

struct PageWords {
  Q_DECLARE_TR_FUNCTIONS(PageWords)
};

SvgPlotStyle styleOnPaper(const ViewSettings& settings) {
  const QLocale locale;
  SvgPlotStyle style = styleOf(GraphPreset::datasheet, settings.units());
  style.words =
      plotWords(locale.language() == QLocale::German ? PlotLanguage::german : PlotLanguage::english);
  style.decimalSign = locale.decimalPoint() == QStringLiteral(",") ? ',' : '.';
  return style;
}

QString sourceLine(const Button& button) {
  const auto& from = button.provenance();
  if (!from) return {};
  return PageWords::tr("Source: %1, page %2, graph %3")
      .arg(QString::fromStdString(from->sourceFile))
      .arg(from->page)
      .arg(from->graph);
}

// Unit to print behind a figure of the table; empty for figures without a unit.
QString symbolOf(FigureUnit unit, const DisplayUnits& units) {
  switch (unit) {
    case FigureUnit::mm:
      return QStringLiteral(" ") + units.lengthSymbol();
    case FigureUnit::N:
      return QStringLiteral(" ") + units.forceSymbol();
    case FigureUnit::N_per_mm:
      return QStringLiteral(" ") + units.slopeSymbol();
    case FigureUnit::mJ:
    case FigureUnit::share:
      return {};
  }
  return {};
}

QStringList figureLines(const KeyFiguresModel& figures, const DisplayUnits& units) {
  QStringList lines;
  for (int row = 0; row < figures.rowCount(); ++row) {
    const auto cell = [&](int column) {
      return figures.data(figures.index(row, column), Qt::DisplayRole).toString();
    };
    const QString value = cell(KeyFiguresModel::now);
    const FigureUnit unit = keyFigureNames()[static_cast<std::size_t>(row)].unit;
    if (!value.isEmpty())
      lines << cell(KeyFiguresModel::figure) + QStringLiteral(": ") + value + symbolOf(unit, units);
  }
  return lines;
}

// The rest of the page below the figures, as far as it goes.
void printNotes(QPainter& painter, const QRectF& room, const ButtonDocument& document,
                const DisplayUnits& units) {
  QStringList lines;
  for (const Note& note : document.annotations().notes) {
    if (note.state >= document.button().states().size()) continue;  // kept, not shown
    const QString at = quantityWithUnit(note.displacement_mm, Quantity::length, units, 4);
    QString place = note.stroke == Stroke::press ? PageWords::tr("Press at %1: ").arg(at)
                                                 : PageWords::tr("Release at %1: ").arg(at);
    if (document.button().states().size() > 1)
      place = PageWords::tr("%1: %2").arg(nameOfState(document.button(), note.state), place);
    lines << place + QString::fromStdString(note.text);
  }
  painter.drawText(room, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, lines.join('\n'));
}

}  // namespace

bool printGraph(QPrinter& printer, ButtonDocument& document, ViewSettings& settings) {
  QPainter painter;
  if (!painter.begin(&printer)) return false;
  const QRectF page = printer.pageRect(QPrinter::DevicePixel);
  const double mm = printer.resolution() / 25.4, line = lineHeight_mm * mm;
  const Button& button = document.history().committed();
  const SvgPlotStyle style = styleOnPaper(settings);
  const QSizeF graph = graphSize_mm(button, style)
                           .scaled(QSizeF(page.width(), mostForGraph * page.height()), Qt::KeepAspectRatio);
  if (!paintGraph(painter, QRectF(QPointF(), graph), button, style)) return false;
  QFont font(QStringLiteral("sans-serif"));
  font.setPointSizeF(lineSize_pt);
  painter.setFont(font);
  painter.setPen(Qt::black);
  const KeyFiguresModel figures(document, settings);
  const QStringList lines = figureLines(figures, settings.units());
  const auto rows = (lines.size() + 1) / 2;
  const double top = graph.height() + gap_mm * mm;
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const QRectF place(i < rows ? 0 : 0.5 * page.width(), top + static_cast<double>(i % rows) * line,
                       0.48 * page.width(), line);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, lines[i]);
  }
  const double below = top + (static_cast<double>(rows) + 0.5) * line;
  printNotes(painter, QRectF(0, below, page.width(), page.height() - 1.5 * line - below), document,
             settings.units());
  const QRectF footer(0, page.height() - line, page.width(), line);
  painter.drawText(footer, Qt::AlignLeft | Qt::AlignVCenter, sourceLine(button));
  painter.drawText(footer, Qt::AlignRight | Qt::AlignVCenter,
                   QLocale().toString(QDate::currentDate(), QLocale::ShortFormat));
  return painter.end();
}

}  // namespace detent::editor
