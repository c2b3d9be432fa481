// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Compares all open buttons pairwise: the number of errors in 90 that people will probably make.

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/forecast/forecast_source.h"

namespace detent::editor {

/// A table of forecasts for all open buttons. Not modal; follows every edit while it is open. GUI thread.
class ForecastMatrix : public QDialog {
  Q_OBJECT

 public:
  explicit ForecastMatrix(QWidget* parent = nullptr);
  /// Sets the documents, in the order of the tabs.
  void setDocuments(const std::vector<ButtonDocument*>& documents);

 signals:
  /// Requests a comparison of two buttons with overlaid curves.
  void compareRequested(detent::editor::ButtonDocument* a, detent::editor::ButtonDocument* b);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void ask();
  void giveUp();
  void fill(const Forecast& forecast);
  void nameRows();
  QTableWidgetItem* cellOf(const playback::PredictedPair& pair) const;

  std::vector<ButtonDocument*> documents_;
  QTableWidget* table_ = nullptr;
  QLabel* words_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* stop_ = nullptr;
  ForecastSource source_;
  QTimer soon_;
};

}  // namespace detent::editor
