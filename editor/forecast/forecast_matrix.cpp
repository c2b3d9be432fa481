// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_matrix.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"
#include "editor/forecast/forecast_words.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {

namespace {

constexpr int soon_ms = 150;
constexpr double mostErrors = 45;  // errors in 90 trials by guessing
constexpr float strongestTint = 0.6F;

}  // namespace

ForecastMatrix::ForecastMatrix(QWidget* parent) : QDialog(parent) {
  setObjectName("forecastMatrix");
  setWindowTitle(tr("Predicted confusion of the open buttons"));
  resize(720, 480);
  auto* title =
      new QLabel(tr("Number of wrong answers predicted if people compare two buttons by feel 90 times. 45 "
                    "means that they guess. 9 or fewer means that they can tell the buttons apart. Bold "
                    "numbers are not certain. Double-click a number to compare the two buttons."));
  title->setWordWrap(true);
  table_ =
      described(new QTableWidget, "forecastTable", {}, tr("Predicted errors in 90 trials for every pair"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  words_ = described(new QLabel, "matrixWords");
  words_->setWordWrap(true);
  words_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  progress_ = described(new QProgressBar, "matrixProgress");
  progress_->setFormat(tr("%v of %m"));
  stop_ = described(new QPushButton(tr("&Stop")), "matrixStop",
                    tr("Cancel the computation; the next edit starts a new one"));
  stop_->setAutoDefault(false);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(progress_, 1);
  bottom->addWidget(stop_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title);
  layout->addWidget(table_, 1);
  layout->addWidget(words_);
  layout->addLayout(bottom);
  soon_.setSingleShot(true);
  soon_.setInterval(soon_ms);
  connect(&soon_, &QTimer::timeout, this, &ForecastMatrix::ask);
  connect(&source_, &ForecastSource::progress, this, [this](int done, int all) {
    progress_->setRange(0, all);
    progress_->setValue(done);
  });
  connect(&source_, &ForecastSource::ready, this, [this](const auto& forecast) { fill(*forecast); });
  connect(stop_, &QPushButton::clicked, this, &ForecastMatrix::giveUp);
  connect(table_, &QTableWidget::currentItemChanged, this, [this](const QTableWidgetItem* item) {
    if (item != nullptr) words_->setText(item->toolTip());
  });
  connect(table_, &QTableWidget::cellDoubleClicked, this, [this](int row, int column) {
    if (column <= row)
      emit compareRequested(documents_[static_cast<std::size_t>(column)],
                            documents_[static_cast<std::size_t>(row) + 1]);
  });
  giveUp();
}

void ForecastMatrix::setDocuments(const std::vector<ButtonDocument*>& documents) {
  for (ButtonDocument* document : documents) {
    if (std::find(documents_.begin(), documents_.end(), document) != documents_.end()) continue;
    connect(document, &ButtonDocument::changed, &soon_, qOverload<>(&QTimer::start));
    connect(document, &ButtonDocument::titleChanged, this, &ForecastMatrix::nameRows);
  }
  if (documents == documents_) return;
  documents_ = documents;
  source_.cancel();  // otherwise an answer for the previous buttons could fill these rows
  const int others = std::max(0, static_cast<int>(documents_.size()) - 1);
  table_->setVisible(others > 0);
  table_->clear();
  table_->setRowCount(others);
  table_->setColumnCount(others);
  nameRows();
  soon_.start();
}

/// Forecasts are below the diagonal, so the first button has no row and the last one no column.
void ForecastMatrix::nameRows() {
  const QStringList titles = distinctTitles(documents_);
  for (int i = 0; i < table_->rowCount(); ++i) {
    table_->setVerticalHeaderItem(i, new QTableWidgetItem(titles[i + 1]));
    table_->setHorizontalHeaderItem(i, new QTableWidgetItem(titles[i]));
  }
}

void ForecastMatrix::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  soon_.start();
}

void ForecastMatrix::hideEvent(QHideEvent* event) {
  giveUp();
  QDialog::hideEvent(event);
}

void ForecastMatrix::ask() {
  if (!isVisible()) return;
  if (documents_.size() < 2) {
    words_->setText(tr("Open two buttons or more to compare them."));
    return giveUp();
  }
  std::vector<Button> buttons;
  for (const ButtonDocument* document : documents_) buttons.push_back(document->button());
  progress_->show();
  stop_->show();
  stop_->setEnabled(true);
  source_.request(std::move(buttons));
}

void ForecastMatrix::giveUp() {
  source_.cancel();
  stop_->setEnabled(false);
  progress_->hide();
  stop_->hide();
}

QTableWidgetItem* ForecastMatrix::cellOf(const playback::PredictedPair& pair) const {
  const QString least = fixedText(pair.leastErrorsPer90(), 0), most = fixedText(pair.mostErrorsPer90(), 0);
  auto* item = new QTableWidgetItem(least == most ? most : tr("%1 to %2").arg(least, most));
  item->setTextAlignment(Qt::AlignCenter);
  QColor tint = graphColors(isDark(palette())).refused;
  tint.setAlphaF(strongestTint * static_cast<float>(std::min(pair.errorsPer90() / mostErrors, 1.0)));
  item->setBackground(tint);
  QFont font = table_->font();
  font.setBold(!pair.distinguished());
  item->setFont(font);
  item->setToolTip(forecastWords(pair));
  return item;
}

void ForecastMatrix::fill(const Forecast& forecast) {
  giveUp();
  words_->setText(forecast.trouble);
  std::size_t at = 0;
  for (const auto& [first, second] : playback::pairsOf(documents_.size())) {
    if (at == forecast.pairs.size()) return;
    table_->setItem(static_cast<int>(second) - 1, static_cast<int>(first), cellOf(forecast.pairs[at++]));
  }
}

}  // namespace detent::editor
