// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/pressing/press_view.h"

#include <algorithm>
#include <cmath>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "editor/document/csv_field.h"
#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "editor/pressing/effort_plot.h"
#include "editor/pressing/press_words.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {

namespace {

using playback::PressFigure;

constexpr int soon_ms = 300;  // a slider that is dragged asks when it rests
constexpr double perStep_mm = 0.01;
constexpr int leastPlot_px = 220, rowMargin_px = 6, longestHead = 16;

}  // namespace

PressView::PressView(QWidget* parent) : QWidget(parent) {
  setObjectName("pressView");
  words_ = described(new QLabel, "pressWords");
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  table_ = described(new QTableWidget, "pressTable", {}, tr("Forecast of how people will press"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + rowMargin_px);
  // All rows are there; what it stands in scrolls.
  table_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  table_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  plot_ =
      described(new EffortPlot, "effortPlot",
                tr("Further left is less effort, further down fewer misses; the lines span 5 to 95 % of the "
                   "fingers"),
                tr("Misses against effort"));
  plot_->setMinimumHeight(leastPlot_px);
  progress_ = described(new QProgressBar, "pressProgress", {}, tr("Buttons forecast"));
  progress_->setFormat(tr("%v of %m"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  copy_ = described(new QPushButton(tr("Copy the &forecast")), "pressCopy",
                    tr("Copy the forecast as CSV, in the units shown"));
  copy_->setEnabled(false);
  connect(copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(tableText()); });
  for (QWidget* each : std::initializer_list<QWidget*>{words_, whatIf(), progress_, table_, plot_})
    layout->addWidget(each);
  layout->addWidget(copy_, 0, Qt::AlignLeft);
  soon_.setSingleShot(true);
  soon_.setInterval(soon_ms);
  connect(&soon_, &QTimer::timeout, this, &PressView::ask);
  connect(&source_, &PressSource::progress, this, [this](int done, int all) {
    progress_->setRange(0, all);
    progress_->setValue(done);
  });
  connect(&source_, &PressSource::ready, this, [this](const auto& answer) {
    progress_->hide();
    copy_->setEnabled(true);
    fill(*answer);
  });
}

QWidget* PressView::whatIf() {
  elsewhere_ = described(new QCheckBox(tr("&What if the contact closed at")), "pressElsewhere",
                         tr("Forecast all of them as if they acted there; the buttons stay as they are"));
  slider_ =
      described(new QSlider(Qt::Horizontal), "pressOperateAt", {}, tr("Operating point of the forecast"));
  slider_->setEnabled(false);
  place_ = described(new QLabel, "pressPlace");
  connect(elsewhere_, &QCheckBox::toggled, this, [this](bool on) {
    slider_->setEnabled(on);
    showPlace();
    soon_.start();
  });
  connect(slider_, &QSlider::valueChanged, this, [this] {
    showPlace();
    soon_.start();
  });
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(elsewhere_);
  layout->addWidget(slider_, 1);
  layout->addWidget(place_);
  return row;
}

std::optional<double> PressView::operateAt_mm() const {
  if (!elsewhere_->isChecked()) return {};
  return perStep_mm * slider_->value();
}

void PressView::showPlace() {
  const auto at_mm = operateAt_mm();
  place_->setText(at_mm ? quantityWithUnit(*at_mm, Quantity::length, units_) : QString());
}

void PressView::setButtons(std::vector<Named> buttons, const DisplayUnits& units) {
  const auto same = [](const Named& a, const Named& b) { return a.name == b.name && a.button == b.button; };
  if (units == units_ && std::equal(buttons.begin(), buttons.end(), buttons_.begin(), buttons_.end(), same))
    return;
  source_.cancel();  // an answer about the others must not come into these columns
  buttons_ = std::move(buttons);
  units_ = units;
  if (!buttons_.empty()) {
    double least_mm = buttons_.front().button.states().front().graph.travel_mm();
    for (const Named& each : buttons_)
      least_mm = std::min(least_mm, each.button.states().front().graph.travel_mm());
    const QSignalBlocker quiet(slider_);
    slider_->setRange(1, std::max(1, static_cast<int>(std::floor(least_mm / perStep_mm))));
    if (const auto at_mm = buttons_.front().button.states().front().operatingPoint_mm;
        at_mm && !elsewhere_->isChecked())
      slider_->setValue(static_cast<int>(std::lround(*at_mm / perStep_mm)));
  }
  showPlace();
  soon_.start();
}

void PressView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  soon_.start();
}

void PressView::hideEvent(QHideEvent* event) {
  giveUp();
  QWidget::hideEvent(event);
}

void PressView::giveUp() {
  soon_.stop();
  source_.cancel();
  progress_->hide();
}

void PressView::ask() {
  if (!isVisible() || buttons_.empty()) return;
  std::vector<Button> buttons;
  for (const Named& each : buttons_) buttons.push_back(each.button);
  progress_->setRange(0, static_cast<int>(buttons.size()));
  progress_->setValue(0);
  progress_->show();
  source_.request(std::move(buttons), operateAt_mm());
}

void PressView::fill(const PressAnswer& answer) {
  const auto& forecasts = answer.forecasts;
  QStringList whole{tr("Forecast")};
  std::vector<QString> names;
  for (const Named& each : buttons_) {
    whole << each.name;
    names.push_back(each.name);
  }
  for (std::size_t i = 1; i < buttons_.size(); ++i)
    whole << tr("%1 against %2").arg(buttons_[i].name, buttons_[0].name);
  QStringList heads;
  for (const QString& head : whole) heads << shortened(head, longestHead);
  table_->clear();
  table_->setRowCount(static_cast<int>(playback::pressFigureCount));
  table_->setColumnCount(static_cast<int>(heads.size()));
  table_->setHorizontalHeaderLabels(heads);
  for (int column = 0; column < table_->columnCount(); ++column)
    table_->horizontalHeaderItem(column)->setToolTip(whole[column]);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (std::size_t f = 0; f < playback::pressFigureCount; ++f) {
    const auto figure = static_cast<PressFigure>(f);
    const PressTerm term = termOf(figure, units_);
    int column = 0;
    const auto put = [&](const QString& text, const QString& tip) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(tip);
      if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(static_cast<int>(f), column++, item);
    };
    put(QStringLiteral("%1 (%2)").arg(term.name, term.unit), term.definition);
    for (const auto& each : forecasts) put(bandWords(*each, figure, units_), reasonWords(each->why[f]));
    for (std::size_t i = 1; i < forecasts.size(); ++i)
      put(differenceWords(playback::differenceOf(*forecasts[0], *forecasts[i], figure)), {});
  }
  QStringList lines{
      tr("A forecast by 64 simulated fingers, median and 5 to 95 % of them. Differences mean more than "
         "numbers, and of the published effects it hits those of force, not those of travel or of "
         "speed (press-forecast in the documents).")};
  for (std::size_t i = 0; i < forecasts.size(); ++i)
    if (forecasts[i]->plans.empty())
      lines << tr("%1: %2").arg(buttons_[i].name, reasonWords(forecasts[i]->why.front()));
  words_->setText(lines.join('\n'));
  plot_->setForecasts(forecasts, names, units_);
}

QString PressView::tableText() const {
  QStringList lines;
  for (int row = -1; row < table_->rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < table_->columnCount(); ++column)
      fields << csvField(row < 0 ? table_->horizontalHeaderItem(column)->toolTip()
                                 : table_->item(row, column)->text());
    lines << fields.join(',');
  }
  return lines.join('\n') + '\n';
}

}  // namespace detent::editor
