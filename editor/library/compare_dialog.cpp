// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/compare_dialog.h"

#include <algorithm>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <qcustomplot.h>

#include "editor/document/graph_colors.h"
#include "editor/document/message_words.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

constexpr int updateDelay_ms = 50;
constexpr int rowMargin_px = 8;
constexpr int firstPlot_px = 300, firstTable_px = 220;
constexpr double roomForLegend = 0.2;  // of the force range

enum Column { nameColumn, aColumn, bColumn, differenceColumn, unitColumn, columnCount };

void dress(QCustomPlot& plot, const GraphColors& colors) {
  plot.setBackground(colors.background);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setBasePen(QPen(colors.axis));
    axis->setTickPen(QPen(colors.axis));
    axis->setSubTickPen(QPen(colors.axis));
    axis->setTickLabelColor(colors.text);
    axis->setLabelColor(colors.text);
    axis->grid()->setPen(QPen(colors.grid));
    axis->grid()->setZeroLinePen(QPen(colors.axis));
  }
  plot.legend->setTextColor(colors.text);
  plot.legend->setBrush(QBrush(colors.background));
  plot.legend->setBorderPen(QPen(colors.grid));
}

}  // namespace

CompareDialog::CompareDialog(ViewSettings& settings, QWidget* parent) : QDialog(parent), settings_(settings) {
  setObjectName("compareDialog");
  setWindowTitle(tr("Compare two buttons"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  resize(860, 640);

  plot_ = new QCustomPlot;
  plot_->setObjectName("comparePlot");
  plot_->setAccessibleName(tr("Both force graphs over each other"));
  plot_->setMinimumHeight(180);
  plot_->legend->setVisible(true);
  plot_->legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);  // one line, in the room above the curves
  plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignHCenter);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);

  table_ = new QTableWidget(0, columnCount);
  table_->setObjectName("compareTable");
  table_->setAccessibleName(tr("Differences"));
  table_->setHorizontalHeaderLabels({tr("Figure"), tr("A"), tr("B"), tr("B \u2212 A"), tr("Unit")});
  table_->horizontalHeader()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + rowMargin_px);
  table_->setWordWrap(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);

  auto* split = new QSplitter(Qt::Vertical);
  split->addWidget(plot_);
  split->addWidget(table_);
  split->setSizes({firstPlot_px, firstTable_px});
  distance_ = new QLabel;
  distance_->setObjectName("compareDistance");
  distance_->setWordWrap(true);
  distance_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* swap = new QPushButton(tr("E&xchange A and B"));
  swap->setObjectName("compareExchange");
  connect(swap, &QPushButton::clicked, this, &CompareDialog::exchange);
  auto* copy = new QPushButton(tr("&Copy the table"));
  copy->setObjectName("compareCopy");
  copy->setToolTip(tr("Copy the differences as CSV, in the units shown"));
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(tableText()); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(swap);
  buttons->addWidget(copy);
  buttons->addStretch();

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(sideRow(a_, "A"));
  layout->addWidget(sideRow(b_, "B"));
  layout->addWidget(split, 1);
  layout->addWidget(distance_);
  forecast_ = new ForecastBar;
  forecast_->setObjectName("compareForecast");
  layout->addWidget(forecast_);
  layout->addLayout(buttons);

  soon_.setSingleShot(true);
  soon_.setInterval(updateDelay_ms);
  connect(&soon_, &QTimer::timeout, this, &CompareDialog::update);
  connect(&settings_, &ViewSettings::changed, &soon_, qOverload<>(&QTimer::start));
}

QWidget* CompareDialog::sideRow(Side& side, const QString& letter) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel("<b>" + letter + "</b>");
  side.button = new QComboBox;
  side.button->setObjectName("compareButton" + letter);
  side.button->setAccessibleName(tr("Button %1").arg(letter));
  side.button->setToolTip(tr("Button %1 of the comparison").arg(letter));
  side.state = new QComboBox;
  side.state->setObjectName("compareState" + letter);
  side.state->setAccessibleName(tr("State of button %1").arg(letter));
  side.state->setToolTip(tr("Which state of a self-locking button is compared"));
  layout->addWidget(label);
  layout->addWidget(side.button, 1);
  layout->addWidget(side.state);
  connect(side.button, &QComboBox::activated, this, [this, &side](int index) {
    if (index >= 0 && index < static_cast<int>(documents_.size()))
      choose(side, documents_[static_cast<std::size_t>(index)]);
  });
  connect(side.state, &QComboBox::activated, this, &CompareDialog::update);
  return row;
}

void CompareDialog::setDocuments(const std::vector<ButtonDocument*>& documents) {
  for (ButtonDocument* document : documents)
    if (std::find(documents_.begin(), documents_.end(), document) == documents_.end()) {
      connect(document, &ButtonDocument::changed, &soon_, qOverload<>(&QTimer::start));
      connect(document, &ButtonDocument::titleChanged, this, [this] {
        fillButtons(a_);
        fillButtons(b_);
      });
    }
  documents_ = documents;
  for (Side* side : {&a_, &b_})
    if (std::find(documents_.begin(), documents_.end(), side->document) == documents_.end())
      side->document = documents_.empty() ? nullptr : documents_.front();
  compare(a_.document, b_.document);
}

void CompareDialog::compare(ButtonDocument* a, ButtonDocument* b) {
  a_.document = a;
  b_.document = b;
  for (Side* side : {&a_, &b_}) {
    fillButtons(*side);
    fillStates(*side);
  }
  update();
}

void CompareDialog::choose(Side& side, ButtonDocument* document) {
  side.document = document;
  fillStates(side);
  update();
}

void CompareDialog::exchange() {
  const int stateA = a_.state->currentIndex(), stateB = b_.state->currentIndex();
  compare(b_.document, a_.document);
  a_.state->setCurrentIndex(stateB);
  b_.state->setCurrentIndex(stateA);
  update();
}

void CompareDialog::fillButtons(Side& side) {
  side.button->clear();
  for (ButtonDocument* document : documents_) {
    side.button->addItem(document->title());
    if (document == side.document) side.button->setCurrentIndex(side.button->count() - 1);
  }
}

void CompareDialog::fillStates(Side& side) {
  const int before = side.state->currentIndex();
  side.state->clear();
  if (!side.document) return;
  for (const ButtonState& state : side.document->button().states())
    side.state->addItem(QString::fromStdString(state.name));
  side.state->setVisible(side.state->count() > 1);
  if (before >= 0 && before < side.state->count()) side.state->setCurrentIndex(before);
}

const ButtonState* CompareDialog::stateOf(const Side& side) const {
  if (!side.document) return nullptr;
  const auto& states = side.document->button().states();
  const auto index = static_cast<std::size_t>(std::max(0, side.state->currentIndex()));
  return &states[std::min(index, states.size() - 1)];
}

void CompareDialog::update() {
  for (Side* side : {&a_, &b_})  // an edit may have added or taken a state
    if (side->document && side->state->count() != static_cast<int>(side->document->button().states().size()))
      fillStates(*side);
  forecast_->setPair(a_.document, b_.document);
  const ButtonState *a = stateOf(a_), *b = stateOf(b_);
  if (!a || !b) {
    table_->setRowCount(0);
    plot_->clearGraphs();
    plot_->clearPlottables();
    plot_->replot();
    distance_->setText(tr("Open two buttons to compare them."));
    return;
  }
  drawCurves(*a, *b);
  fillTable(*a, *b);
  const auto distance = detent::compare(polylinesOf(a->graph), polylinesOf(b->graph));
  distance_->setText(distance ? shownDistance(*distance, settings_.units()) : sentenceOf(distance.failure()));
}

void CompareDialog::drawCurves(const ButtonState& a, const ButtonState& b) {
  const DisplayUnits& units = settings_.units();
  const GraphColors colors = graphColors(isDark(palette()));
  dress(*plot_, colors);
  plot_->clearPlottables();
  const auto draw = [&](const ButtonState& state, const QString& letter, const QColor& color) {
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      if (stroke == Stroke::release && !state.graph.release()) continue;
      auto* curve = new QCPCurve(plot_->xAxis, plot_->yAxis);
      for (const CurvePoint& p : travelledSamples(state.graph, stroke))
        curve->addData(units.lengthFrom(p.displacement_mm), units.forceFrom(p.force_N));
      curve->setPen(QPen(color, 2, stroke == Stroke::press ? Qt::SolidLine : Qt::DashLine));
      curve->setAntialiased(true);
      curve->setName(letter + " " + (stroke == Stroke::press ? tr("press") : tr("release")));
    }
  };
  draw(a, "A", colors.press);
  draw(b, "B", colors.release);
  plot_->xAxis->setLabel(tr("Displacement (%1)").arg(units.lengthSymbol()));
  plot_->yAxis->setLabel(tr("Force (%1)").arg(units.forceSymbol()));
  plot_->rescaleAxes();
  plot_->yAxis->scaleRange(1.1);
  plot_->yAxis->setRangeUpper(plot_->yAxis->range().upper + roomForLegend * plot_->yAxis->range().size());
  plot_->replot();
}

void CompareDialog::fillTable(const ButtonState& a, const ButtonState& b) {
  const DisplayUnits& units = settings_.units();
  const std::vector<DifferenceRow> rows = differencesOf(a, b);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const DifferenceRow& row = rows[static_cast<std::size_t>(i)];
    const QString texts[] = {row.name, shownValue(row.a, row.measure, units),
                             shownValue(row.b, row.measure, units), shownDifference(row, units),
                             shownUnit(row.measure, units)};
    for (int column = 0; column < columnCount; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      if (column != nameColumn && column != unitColumn)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(i, column, item);
    }
  }
}

QString CompareDialog::tableText() const {
  QStringList lines{QStringLiteral("figure,a,b,difference,unit")};
  for (int row = 0; row < table_->rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < columnCount; ++column)
      fields << '"' + table_->item(row, column)->text().replace('"', QStringLiteral("\"\"")) + '"';
    lines << fields.join(',');
  }
  return lines.join('\n') + '\n';
}

void CompareDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) soon_.start();
}

}  // namespace detent::editor
