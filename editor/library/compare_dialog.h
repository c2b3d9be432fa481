// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Two open buttons over each other, and what sets them apart.

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QTableWidget>
#include <QTimer>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/forecast/forecast_bar.h"
#include "editor/library/difference_rows.h"

class QCustomPlot;

namespace detent::editor {

/// Not modal: both buttons can be worked on while it is open, and it follows. GUI thread.
class CompareDialog : public QDialog {
  Q_OBJECT

 public:
  /// `settings` must outlive this.
  explicit CompareDialog(ViewSettings& settings, QWidget* parent = nullptr);

  /// The buttons that can be chosen. One that is no longer among them is let go of.
  void setDocuments(const std::vector<ButtonDocument*>& documents);
  void compare(ButtonDocument* a, ButtonDocument* b);

  /// What the table says, with units, as CSV text; for the clipboard.
  QString tableText() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// The choice of one side.
  struct Side {
    QComboBox* button = nullptr;
    QComboBox* state = nullptr;
    ButtonDocument* document = nullptr;
  };
  QWidget* sideRow(Side& side, const QString& letter);
  void fillButtons(Side& side);
  void fillStates(Side& side);
  void choose(Side& side, ButtonDocument* document);
  void exchange();
  const ButtonState* stateOf(const Side& side) const;
  void update();
  void drawCurves(const ButtonState& a, const ButtonState& b);
  void fillTable(const ButtonState& a, const ButtonState& b);

  ViewSettings& settings_;
  std::vector<ButtonDocument*> documents_;
  Side a_, b_;
  QCustomPlot* plot_ = nullptr;
  QTableWidget* table_ = nullptr;
  QLabel* distance_ = nullptr;
  ForecastBar* forecast_ = nullptr;
  QTimer soon_;
};

}  // namespace detent::editor
