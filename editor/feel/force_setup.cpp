// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/force_setup.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "editor/document/described.h"
#include "editor/feel/setup_widgets.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {
namespace {

// Names as playback::forceDeviceFrom takes them. A name that ends with ':' requires a port.
constexpr char serialKind[] = "serial:", odriveKind[] = "odrive:", falconKind[] = "falcon";

bool wantsPort(const QString& kind) { return kind.endsWith(':'); }

}  // namespace

ForceSetup::ForceSetup(ViewSettings& view, QWidget* parent) : QWidget(parent), view_(view) {
  filling_ = true;
  form_ = setupForm(this);
  addDevice(*form_);
  addLimits(*form_);
  filling_ = false;
  connect(&view_, &ViewSettings::changed, this, &ForceSetup::showUnits);
  setChoices({});
}

void ForceSetup::addDevice(QFormLayout& form) {
  device_ =
      comboBox("forceDevice",
               tr("Device that produces the force: a simulated one with a simulated finger, or a real one"));
  addChoice(device_, tr("none"), QString());
  addChoice(device_, tr("simulated: bench device, 1 µm"), QStringLiteral("sim"));
  addChoice(device_, tr("simulated: Novint Falcon"), QStringLiteral("sim:falcon"));
  addChoice(device_, tr("simulated: voice coil, 10 µm"), QStringLiteral("sim:rig"));
  addChoice(device_, tr("microcontroller on a serial port"), QString(serialKind));
  addChoice(device_, tr("ODrive"), QString(odriveKind));
  addChoice(device_, tr("Novint Falcon"), QString(falconKind));
  connect(device_, &QComboBox::currentIndexChanged, this, &ForceSetup::take);
  form.addRow(tr("F&orce device:"), device_);
  note_ = noteLabel("forceNote");
  form.addRow(QString(), note_);

  port_ = comboBoxOfNames("forcePort", tr("Serial port of the force device, for example /dev/ttyACM0"));
  port_->setEditable(true);
  port_->addItems(serialPorts());
  connect(port_, &QComboBox::currentTextChanged, this, &ForceSetup::take);
  form.addRow(tr("&Port:"), port_);

  firmware_ =
      described(new QPushButton, "forceFirmware",
                tr("Firmware file that came with the Falcon's driver (7 to 9 kB). The Falcon needs it each "
                   "time it is switched on. Its licence does not allow Detent to include it"));
  connect(firmware_, &QPushButton::clicked, this, &ForceSetup::chooseFirmware);
  form.addRow(tr("Fir&mware:"), firmware_);

  finger_ = comboBox("forceFinger", tr("Behaviour of the simulated finger"));
  addChoice(finger_, tr("presses again and again"), false);
  addChoice(finger_, tr("rests in the middle of the travel"), true);
  connect(finger_, &QComboBox::currentIndexChanged, this, &ForceSetup::take);
  form.addRow(tr("F&inger:"), finger_);
}

void ForceSetup::addLimits(QFormLayout& form) {
  const auto field = [&](Quantity quantity, const char* name, const QString& tip,
                         const QuantityRange& range) {
    auto* made = described(new QuantityField(quantity, view_.units()), name, tip);
    made->setRange(range);
    connect(made, &QuantityField::valueChanged, this, &ForceSetup::take);
    return made;
  };
  largest_ = field(Quantity::force, "forceLargest", tr("The force never exceeds this value"),
                   {0, strongestDevice_N});
  largest_->setLowestText(tr("limit of the device"));
  form.addRow(tr("&Largest force:"), largest_);
  step_ = field(Quantity::length, "forceStep", tr("Encoder step, at the finger"), {0, coarsestStep_mm});
  step_->setLowestText(tr("10 µm"));
  form.addRow(tr("Encoder s&tep:"), step_);
  turn_ = field(
      Quantity::length, "forceTurn",
      tr("Travel of the handle in one turn of the motor; negative if pressing turns the motor backwards"),
      {-longestTurn_mm, longestTurn_mm});
  form.addRow(tr("Travel per t&urn:"), turn_);
  upload_ =
      described(new QCheckBox(tr("Compute the force on the microcontroller, at its own rate")), "forceUpload",
                tr("Uploads a table of forces to the microcontroller, so that no USB delay lies between "
                   "position and force"));
  connect(upload_, &QCheckBox::toggled, this, &ForceSetup::take);
  form.addRow(QString(), upload_);
  controller_ = described(
      new QCheckBox(tr("Add damping where the button returns more energy than it took up")),
      "forceController",
      tr("Steadier on a device that vibrates, but less crisp where a button snaps (passivity controller)"));
  connect(controller_, &QCheckBox::toggled, this, &ForceSetup::take);
  form.addRow(QString(), controller_);
}

QString ForceSetup::kind() const { return device_->currentData().toString(); }

void ForceSetup::setChoices(const ForceChoices& choices) {
  choices_ = choices;
  filling_ = true;
  const QString kind = choices.device.startsWith(serialKind)   ? QString(serialKind)
                       : choices.device.startsWith(odriveKind) ? QString(odriveKind)
                                                               : choices.device;
  select(device_, kind);
  if (wantsPort(kind)) port_->setCurrentText(choices.device.mid(kind.size()));
  select(finger_, choices.holds);
  upload_->setChecked(choices.upload);
  controller_->setChecked(choices.controller);
  largest_->setValue(choices.largest_N);
  step_->setValue(choices.step_mm);
  turn_->setValue(choices.mmPerTurn);
  filling_ = false;
  showUnits();
  showRows();
}

void ForceSetup::take() {
  if (filling_) return;
  choices_.device = wantsPort(kind()) ? kind() + port_->currentText().trimmed() : kind();
  choices_.holds = finger_->currentData().toBool();
  choices_.upload = upload_->isChecked();
  choices_.controller = controller_->isChecked();
  choices_.largest_N = largest_->value();
  choices_.step_mm = step_->value();
  choices_.mmPerTurn = turn_->value();
  showRows();
  emit changed(choices_);
}

/// Shows the rows that the chosen device needs.
void ForceSetup::showRows() {
  const QString chosen = kind();
  const bool simulated = chosen.startsWith("sim"), real = !chosen.isEmpty() && !simulated;
  form_->setRowVisible(port_, wantsPort(chosen));
  form_->setRowVisible(finger_, simulated);
  form_->setRowVisible(firmware_, chosen == falconKind);
  firmware_->setText(choices_.firmwareFile.isEmpty() ? tr("Choose…")
                                                     : QFileInfo(choices_.firmwareFile).fileName());
  form_->setRowVisible(largest_, !chosen.isEmpty());
  form_->setRowVisible(step_, wantsPort(chosen));
  form_->setRowVisible(turn_, chosen == odriveKind);
  form_->setRowVisible(upload_, chosen == serialKind);
  form_->setRowVisible(controller_, !chosen.isEmpty());
  form_->setRowVisible(note_, real);
  note_->setText(
      tr("The first time, keep a hand on the power switch and set the largest force to 1 N. The guide to "
         "force feedback describes the wiring."));
}

void ForceSetup::chooseFirmware() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Firmware of the Falcon"),
                                                    QFileInfo(choices_.firmwareFile).path(),
                                                    tr("Firmware (*.bin);;All files (*)"));
  if (file.isEmpty()) return;
  choices_.firmwareFile = file;
  showRows();
  emit changed(choices_);
}

void ForceSetup::showUnits() {
  for (QuantityField* field : {largest_, step_, turn_}) {
    const QSignalBlocker blocked(field);
    field->setUnits(view_.units());
  }
}

}  // namespace detent::editor
