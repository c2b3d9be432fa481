// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_bar.h"

#include <chrono>
#include <QHBoxLayout>
#include <QMenu>

#include "editor/forecast/forecast_words.h"

namespace detent::editor {

namespace {

constexpr int look_ms = 50;

}  // namespace

ForecastBar::ForecastBar(QWidget* parent) : QWidget(parent) {
  words_ = new QLabel;
  words_->setObjectName("forecastWords");
  words_->setAccessibleName(tr("Predicted confusion"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  help_ = new QPushButton(tr("Make &distinguishable…"));
  help_->setObjectName("makeDistinguishable");
  help_->setToolTip(tr("Look for the smallest change of button A that people will notice"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(words_, 1);
  layout->addWidget(help_);
  connect(help_, &QPushButton::clicked, this, &ForecastBar::search);
  connect(&source_, &ForecastSource::ready, this, [this](const auto& forecast) { say(*forecast); });
  look_.setInterval(look_ms);
  connect(&look_, &QTimer::timeout, this, &ForecastBar::offer);
}

ForecastBar::~ForecastBar() {
  giveUp_ = true;
  if (searching_.valid()) searching_.wait();
}

void ForecastBar::show(ButtonDocument* changed, ButtonDocument* other) {
  changed_ = changed;
  other_ = other;
  if (!changed_ || !other_ || changed_ == other_) {
    source_.cancel();
    words_->clear();
    help_->setEnabled(false);
    return;
  }
  source_.request({changed_->button(), other_->button()});
}

void ForecastBar::say(const Forecast& forecast) {
  if (forecast.pairs.empty()) {
    words_->setText(forecast.trouble);
    help_->setEnabled(false);
    return;
  }
  words_->setText(forecastWords(forecast.pairs.front()));
  help_->setEnabled(!forecast.pairs.front().distinguishable() && !searching_.valid());
}

void ForecastBar::search() {
  if (!changed_ || !other_ || searching_.valid()) return;
  searchedFrom_ = changed_->button();
  help_->setEnabled(false);
  help_->setText(tr("Looking…"));
  giveUp_ = false;
  searching_ = std::async(std::launch::async, [this, button = changed_->button(), other = other_->button()] {
    return playback::makeDistinguishable(button, other, {}, [this] { return giveUp_.load(); });
  });
  look_.start();
}

/// A menu of what was found; each entry is one step that can be undone.
void ForecastBar::offer() {
  if (searching_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  look_.stop();
  const Found found = searching_.get();
  help_->setText(tr("Make &distinguishable…"));
  help_->setEnabled(true);
  // Edited meanwhile: what was found no longer fits.
  if (!changed_ || !(changed_->button() == *searchedFrom_)) return;
  QMenu menu;
  menu.setObjectName("suggestionMenu");
  if (!found || found->empty())
    menu.addAction(tr("No single change of up to a factor 2 helps"))->setEnabled(false);
  if (found) {
    for (const playback::Suggestion& suggestion : *found)
      menu.addAction(suggestionWords(suggestion), this, [this, suggestion] {
        if (changed_) changed_->history().apply(suggestion.button, suggestionWords(suggestion));
      });
  }
  menu.exec(help_->mapToGlobal(QPoint(0, help_->height())));
}

}  // namespace detent::editor
