// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Settings of a magnetic keyboard's key, with the button's curve and the key's events along two presses.

#include <optional>
#include <QCheckBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVariantMap>
#include <string>
#include <vector>

#include "editor/quantity/quantity_field.h"
#include "playback/magnetic.h"

class QCustomPlot;
class QCPAxisRect;

namespace detent::editor {

/// Everything that the user has chosen in the dialogue, so that it can be opened again with it. Plain value.
struct MagneticChoice {
  QVariantMap typed;  ///< lengths in mm and ticks, by the names of their widgets; the rest follows the button
  std::optional<playback::MagneticSensor> sensor;  ///< readings of `sensorFile`; none: assumed ones
  QString sensorFile;
};

/// The graphs follow every change; settings that contradict each other are refused in words. GUI thread.
class MagneticDialog : public QDialog {
  Q_OBJECT

 public:
  MagneticDialog(Button button, const DisplayUnits& units, MagneticChoice choice = {},
                 QWidget* parent = nullptr);

  const MagneticChoice& choice() const { return choice_; }
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
  void take(const QuantityField& field);
  void setUpPlot();
  QuantityField* lengthField(QFormLayout& form, const char* name, const QString& label, const QString& tip,
                             double value_mm);
  QCheckBox* checkBox(QFormLayout& form, const char* name, const QString& text, const QString& tip);
  void showReadings();
  void showChoice();
  void draw();
  void drawCurves(const std::vector<playback::KeyEvent>& events);
  void drawMovement(const std::vector<playback::KeyEvent>& events);
  void drawLimits(QCPAxisRect& rect, const playback::MagneticKeySettings& settings);
  QString refusal() const;

  Button button_;
  DisplayUnits units_;
  MagneticChoice choice_;
  std::vector<QuantityField*> fields_;
  QuantityField *actuate_, *reset_, *press_, *release_, *top_, *bottom_, *down_, *up_;
  QCheckBox *rapid_, *continuous_;
  QLabel *readings_, *events_, *refusal_;
  QCustomPlot* plot_;
  QCPAxisRect* movement_;
  QPushButton* accept_ = nullptr;
};

}  // namespace detent::editor
