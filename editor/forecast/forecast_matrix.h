// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All open buttons against each other: how many errors in 90 people will probably make.

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

/// Not modal; follows every edit while it is open. GUI thread.
class ForecastMatrix : public QDialog {
  Q_OBJECT

 public:
  explicit ForecastMatrix(QWidget* parent = nullptr);
  void setDocuments(const std::vector<ButtonDocument*>& documents);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void ask();
  void fill(const Forecast& forecast);

  std::vector<ButtonDocument*> documents_;
  QTableWidget* table_ = nullptr;
  QLabel* words_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  ForecastSource source_;
  QTimer soon_;
};

}  // namespace detent::editor
