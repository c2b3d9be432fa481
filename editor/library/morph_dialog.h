// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Blends two buttons, and forecasts for which of the two people will take the result.

#include <optional>
#include <QBoxLayout>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/forecast/forecast_source.h"
#include "model/button.h"

namespace detent::editor {

class ComparePlot;

/// Works on copies, so later edits of the buttons have no effect. GUI thread; forecasts are computed on
/// another one.
class MorphDialog : public QDialog {
  Q_OBJECT

 public:
  /// `buttons`: two or more; `first`: index of the one at the slider's beginning.
  MorphDialog(std::vector<Button> buttons, std::size_t first, const DisplayUnits& units,
              QWidget* parent = nullptr);

  /// The button at the slider's position; empty if the two chosen buttons cannot be blended.
  const std::optional<Button>& between() const { return between_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QComboBox* buttonChoice(const char* name, const QString& tip, std::size_t chosen);
  const Button& chosen(const QComboBox& box) const;
  void follow();
  void say(const Forecast& forecast);

  std::vector<Button> buttons_;
  DisplayUnits units_;
  QComboBox *from_ = nullptr, *to_ = nullptr;
  QSlider* share_ = nullptr;
  ComparePlot* plot_ = nullptr;
  QBoxLayout* sides_ = nullptr;  // contains the plot, and the rest below or beside it
  QLabel *percent_ = nullptr, *forecastFrom_ = nullptr, *forecastTo_ = nullptr;
  QPushButton* create_ = nullptr;
  std::optional<Button> between_;
  ForecastSource source_;
};

}  // namespace detent::editor
