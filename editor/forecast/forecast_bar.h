// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Below two compared buttons: whether people will tell them apart, live, and help if not.

#include <atomic>
#include <future>
#include <optional>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

#include "editor/document/button_document.h"
#include "editor/forecast/forecast_source.h"

namespace detent::editor {

/// GUI thread; computes beside it.
class ForecastBar : public QWidget {
  Q_OBJECT

 public:
  explicit ForecastBar(QWidget* parent = nullptr);
  ~ForecastBar() override;  ///< gives up a running search

  /// The pair to speak of; "make distinguishable" changes `changed`. Null: none.
  void show(ButtonDocument* changed, ButtonDocument* other);

 private:
  using Found = Result<std::vector<playback::Suggestion>>;
  void say(const Forecast& forecast);
  void search();
  void offer();

  QPointer<ButtonDocument> changed_, other_;
  QLabel* words_ = nullptr;
  QPushButton* help_ = nullptr;
  ForecastSource source_;
  std::atomic<bool> giveUp_{false};
  std::future<Found> searching_;
  std::optional<Button> searchedFrom_;
  QTimer look_;
};

}  // namespace detent::editor
