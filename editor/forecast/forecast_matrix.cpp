// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_matrix.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>

#include "editor/forecast/forecast_words.h"

namespace detent::editor {

namespace {

constexpr int soon_ms = 150;
constexpr double mostErrors = 45;  // in 90, by guessing
constexpr int strongestTint = 170;

}  // namespace

ForecastMatrix::ForecastMatrix(QWidget* parent) : QDialog(parent) {
  setObjectName("forecastMatrix");
  setWindowTitle(tr("Who will be taken for whom?"));
  resize(720, 480);
  table_ = new QTableWidget;
  table_->setObjectName("forecastTable");
  table_->setAccessibleName(tr("Predicted errors in 90 of every pair"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  words_ =
      new QLabel(tr("Errors in 90 that people will probably make when they compare two buttons by feel."));
  words_->setObjectName("matrixWords");
  words_->setWordWrap(true);
  progress_ = new QProgressBar;
  progress_->setObjectName("matrixProgress");
  cancel_ = new QPushButton(tr("&Stop"));
  cancel_->setObjectName("matrixStop");
  cancel_->setToolTip(tr("Give up what is being computed"));
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(progress_, 1);
  bottom->addWidget(cancel_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(table_, 1);
  layout->addWidget(words_);
  layout->addLayout(bottom);
  soon_.setSingleShot(true);
  soon_.setInterval(soon_ms);
  connect(&soon_, &QTimer::timeout, this, &ForecastMatrix::ask);
  connect(&source_, &ForecastSource::progress, this, [this](std::uint64_t, int done, int all) {
    progress_->setRange(0, all);
    progress_->setValue(done);
  });
  connect(&source_, &ForecastSource::ready, this, [this](const auto& forecast) { fill(*forecast); });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    source_.cancel();
    progress_->reset();
    cancel_->setEnabled(false);
  });
  connect(table_, &QTableWidget::currentItemChanged, this, [this](QTableWidgetItem* item) {
    if (item != nullptr && !item->toolTip().isEmpty()) words_->setText(item->toolTip());
  });
}

void ForecastMatrix::setDocuments(const std::vector<ButtonDocument*>& documents) {
  for (ButtonDocument* document : documents)
    if (std::find(documents_.begin(), documents_.end(), document) == documents_.end())
      connect(document, &ButtonDocument::changed, &soon_, qOverload<>(&QTimer::start));
  documents_ = documents;
  soon_.start();
}

void ForecastMatrix::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  soon_.start();
}

void ForecastMatrix::hideEvent(QHideEvent* event) {
  source_.cancel();
  QDialog::hideEvent(event);
}

void ForecastMatrix::ask() {
  if (!isVisible()) return;
  std::vector<Button> buttons;
  for (const ButtonDocument* document : documents_) buttons.push_back(document->button());
  cancel_->setEnabled(true);
  source_.request(std::move(buttons));
}

void ForecastMatrix::fill(const Forecast& forecast) {
  cancel_->setEnabled(false);
  const int n = static_cast<int>(documents_.size());
  table_->clear();
  table_->setRowCount(std::max(0, n - 1));
  table_->setColumnCount(std::max(0, n - 1));
  if (!forecast.trouble.isEmpty()) words_->setText(forecast.trouble);
  if (n < 2) words_->setText(tr("Open two buttons or more to compare them."));
  std::size_t at = 0;
  for (int second = 1; second < n; ++second) {
    table_->setVerticalHeaderItem(
        second - 1, new QTableWidgetItem(documents_[static_cast<std::size_t>(second)]->title()));
    table_->setHorizontalHeaderItem(
        second - 1, new QTableWidgetItem(documents_[static_cast<std::size_t>(second) - 1]->title()));
    for (int first = 0; first < second && at < forecast.pairs.size(); ++first, ++at) {
      const playback::PredictedPair& pair = forecast.pairs[at];
      auto* item = new QTableWidgetItem(QLocale().toString(pair.errorsPer90(), 'f', 1));
      item->setTextAlignment(Qt::AlignCenter);
      const double share = std::min(pair.errorsPer90() / mostErrors, 1.0);
      item->setBackground(QColor(200, 60, 40, static_cast<int>(strongestTint * share)));
      item->setToolTip(forecastWords(pair));
      table_->setItem(second - 1, first, item);
    }
  }
}

}  // namespace detent::editor
