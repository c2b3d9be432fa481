// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Settings of a magnetic keyboard's key, with the button's curve and the key's events along two presses.

#include <QCheckBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <string>
#include <vector>

#include "editor/quantity/quantity_field.h"
#include "playback/magnetic.h"

class QCustomPlot;
class QCPAxisRect;

namespace detent::editor {

/// The graphs follow every change; settings that contradict each other are refused in words. GUI thread.
class MagneticDialog : public QDialog {
  Q_OBJECT

 public:
  MagneticDialog(Button button, const DisplayUnits& units, QWidget* parent = nullptr);

  playback::MagneticKeySettings settings() const;
  /// Displacements between which the key moves: rest, down, up, down, rest.
  std::vector<double> turns_mm() const;
  /// The C header that `detent-play magnetic` writes, without its forecast.
  std::string header() const;
  /// Uses the readings of a CSV file instead of assumed ones; says in the dialogue if they cannot be read.
  void readSensor(const QString& file);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QLayout* choices();
  void moveReset();
  void setUpPlot();
  QuantityField* lengthField(QFormLayout& form, const char* name, const QString& label, const QString& tip,
                             double value_mm);
  QCheckBox* checkBox(QFormLayout& form, const char* name, const QString& text, const QString& tip);
  void showChoice();
  void draw();
  void drawCurves(const std::vector<playback::KeyEvent>& events);
  void drawMovement(const std::vector<playback::KeyEvent>& events);
  void drawLimits(QCPAxisRect& rect, const playback::MagneticKeySettings& settings);
  QString refusal() const;

  Button button_;
  DisplayUnits units_;
  playback::MagneticSensor sensor_;
  std::vector<QuantityField*> fields_;
  QuantityField *actuate_, *reset_, *press_, *release_, *top_, *bottom_, *down_, *up_;
  bool resetTyped_ = false;  ///< until then the release point follows the actuation point
  QCheckBox *rapid_, *continuous_;
  QLabel *readings_, *events_, *refusal_;
  QCustomPlot* plot_;
  QCPAxisRect* movement_;
  QPushButton* accept_ = nullptr;
};

}  // namespace detent::editor
