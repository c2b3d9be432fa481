// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/forecast/forecast_bar.h"

#include <QHBoxLayout>
#include <QMenu>

#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "editor/forecast/forecast_words.h"

namespace detent::editor {

ForecastBar::ForecastBar(QWidget* parent) : QWidget(parent) {
  words_ = described(new QLabel, "forecastWords",
                     tr("This prediction comes from the vibration of both buttons and a model of touch; no "
                        "participants were asked. Its limits: docs/reference/predicted-confusion.md."),
                     tr("Predicted confusion"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  help_ = described(new QPushButton(tr("Make &distinguishable…")), "makeDistinguishable",
                    tr("Find the smallest change of button A that people will notice"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(words_, 1);
  layout->addWidget(help_);
  connect(help_, &QPushButton::clicked, this, &ForecastBar::search);
  connect(&source_, &ForecastSource::ready, this, [this](const auto& forecast) { say(*forecast); });
}

ForecastBar::~ForecastBar() {
  giveUp_ = true;
  if (worker_.joinable()) worker_.join();
}

void ForecastBar::setPair(ButtonDocument* changed, ButtonDocument* other) {
  changed_ = changed;
  other_ = other;
  if (changed_ && other_ && changed_ != other_) {
    source_.request({changed_->button(), other_->button()});
    return;
  }
  source_.cancel();
  words_->clear();
  confused_ = false;
  help_->setEnabled(false);
}

void ForecastBar::say(const Forecast& forecast) {
  confused_ = !forecast.pairs.empty() && !forecast.pairs.front().distinguished();
  words_->setText(forecast.pairs.empty() ? forecast.trouble : forecastWords(forecast.pairs.front()));
  help_->setEnabled(confused_ && !searching_);
}

void ForecastBar::search() {
  if (!changed_ || !other_ || searching_) return;
  if (worker_.joinable()) worker_.join();
  searching_ = true;
  help_->setEnabled(false);
  help_->setText(tr("Searching…"));
  worker_ = std::thread([this, button = changed_->button(), other = other_->button()] {
    auto found = std::make_shared<const Found>(
        playback::makeDistinguishable(button, other, {}, [this] { return giveUp_.load(); }));
    QMetaObject::invokeMethod(
        this, [this, found, button] { offer(*found, button); }, Qt::QueuedConnection);
  });
}

/// Opens a menu of the suggestions; each entry is one undoable step.
void ForecastBar::offer(const Found& found, const Button& searched) {
  searching_ = false;
  help_->setText(tr("Make &distinguishable…"));
  help_->setEnabled(confused_);
  // The button was edited meanwhile, so the suggestions do not fit.
  if (!changed_ || !(changed_->button() == searched)) return;
  auto* menu = described(new QMenu(this), "suggestionMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (!found) menu->addAction(sentenceOf(found.failure()))->setEnabled(false);
  if (found && found->empty())
    menu->addAction(tr("Detent found no such change. Even if the snap ratio, the travel or the force of "
                       "button A changes by a factor of 4, people may still confuse the buttons"))
        ->setEnabled(false);
  if (found) {
    for (const playback::Suggestion& suggestion : *found)
      menu->addAction(offerWords(suggestion), this, [this, suggestion] { apply(suggestion); });
  }
  menu->popup(help_->mapToGlobal(QPoint(0, help_->height())));
  emit offered();
}

void ForecastBar::apply(const playback::Suggestion& suggestion) {
  if (changed_ && !changed_->history().dragging())
    changed_->history().apply(suggestion.button, suggestionWords(suggestion));
}

}  // namespace detent::editor
