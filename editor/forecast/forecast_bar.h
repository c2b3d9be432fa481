// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecast below two compared buttons: whether people will tell them apart, and changes that would make them
// distinguishable.

#include <atomic>
#include <memory>
#include <optional>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QWidget>
#include <thread>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/forecast/forecast_source.h"

namespace detent::editor {

/// GUI thread; forecasts are computed on another one.
class ForecastBar : public QWidget {
  Q_OBJECT

 public:
  explicit ForecastBar(QWidget* parent = nullptr);
  ~ForecastBar() override;  ///< cancels a running search

  /// Sets the pair; "make distinguishable" changes `changed`. Null: no pair.
  void setPair(ButtonDocument* changed, ButtonDocument* other);

 signals:
  /// The menu of suggestions is open.
  void offered();

 private:
  using Found = Result<std::vector<playback::Suggestion>>;
  void say(const Forecast& forecast);
  void search();
  void offer(const Found& found, const Button& searched);
  void apply(const playback::Suggestion& suggestion);

  QPointer<ButtonDocument> changed_, other_;
  QLabel* words_ = nullptr;
  QPushButton* help_ = nullptr;
  ForecastSource source_;
  bool confused_ = false;
  std::atomic<bool> giveUp_{false};
  bool searching_ = false;
  std::thread worker_;
};

}  // namespace detent::editor
