// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Forecast of people's presses of the compared buttons: figures, misses against effort, and the effect of
// another contact point.

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/pressing/press_source.h"
#include "model/button.h"

namespace detent::editor {

class EffortPlot;

/// Computes only while it is visible. GUI thread.
class PressView : public QWidget {
  Q_OBJECT

 public:
  explicit PressView(QWidget* parent = nullptr);

  /// A button and what it is called among the others.
  struct Named {
    Button button;
    QString name;
  };
  void setButtons(std::vector<Named> buttons, const DisplayUnits& units);
  /// Names, values with bands and units, differences to the first, as CSV lines.
  QString tableText() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* whatIf();
  void ask();
  void giveUp();
  void fill(const PressAnswer& answer);
  void showPlace();
  std::optional<double> operateAt_mm() const;

  std::vector<Named> buttons_;
  DisplayUnits units_;
  QLabel *words_, *place_ = nullptr;
  QTableWidget* table_;
  EffortPlot* plot_;
  QCheckBox* elsewhere_ = nullptr;
  QSlider* slider_ = nullptr;
  QProgressBar* progress_;
  QPushButton* copy_;
  QTimer soon_;
  PressSource source_;
};

}  // namespace detent::editor
