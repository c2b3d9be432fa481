// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/feel_setup.h"

#include <algorithm>
#include <cmath>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QShowEvent>
#include <QSignalBlocker>

#include "editor/document/described.h"
#include "editor/feel/placement_delays.h"
#include "editor/feel/setup_widgets.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {

FeelSetup::FeelSetup(ViewSettings& view, SoundDeviceList& devices, QWidget* parent)
    : QWidget(parent), view_(view), devices_(devices) {
  filling_ = true;
  auto* form = form_ = setupForm(this);
  addPressing(*form);
  addFeeling(*form);
  addSound(*form);
  addSensor(*form);
  filling_ = false;
  connect(&view_, &ViewSettings::changed, this, &FeelSetup::showUnits);
  connect(&devices_, &SoundDeviceList::changed, this, &FeelSetup::showDevices);
  setSettings({});
  setSensor({}, {});
  setProfile({}, {});
}

void FeelSetup::addPressing(QFormLayout& form) {
  drive_ = comboBox("driveChoice", tr("How mouse and touch press the pad. Keys always play a timed press; a "
                                      "pen presses by its pressure."));
  addChoice(drive_, tr("Hold: a human-like press"), static_cast<int>(Drive::time));
  addChoice(drive_, tr("Drag down: depth"), static_cast<int>(Drive::depth));
  addChoice(drive_, tr("Drag down: force"), static_cast<int>(Drive::force));
  connect(drive_, &QComboBox::currentIndexChanged, this, &FeelSetup::take);
  form.addRow(tr("&Press with mouse:"), drive_);

  full_ = described(new QuantityField(Quantity::force, view_.units()), "fullForce",
                    tr("Force at the end of a timed press, at full pen pressure, or at the end of a drag. "
                       "Automatic: a quarter more than the button's strongest force."));
  full_->setRange({0, 100});
  full_->setLowestText(tr("automatic"));
  connect(full_, &QuantityField::valueChanged, this, &FeelSetup::take);
  form.addRow(tr("&Full press:"), full_);

  followState_ = described(
      new QCheckBox(tr("Show the state that is felt")), "followState",
      tr("For a self-locking button, the graph changes to the state that is felt: unlocked or locked."));
  connect(followState_, &QCheckBox::toggled, this, &FeelSetup::take);
  form.addRow(QString(), followState_);
}

void FeelSetup::addFeeling(QFormLayout& form) {
  using playback::FeedbackMode;
  mode_ = comboBox(
      "modeChoice",
      tr("Which parts of the button are felt; reduced feedback serves as a baseline for comparison."));
  addChoice(mode_, tr("Everything"), static_cast<int>(FeedbackMode::full));
  addChoice(mode_, tr("Clicks only (jumps, bottom-out)"), static_cast<int>(FeedbackMode::clickOnly));
  addChoice(mode_, tr("Slopes only (vibration pulses)"), static_cast<int>(FeedbackMode::slopeOnly));
  addChoice(mode_, tr("Nothing"), static_cast<int>(FeedbackMode::off));
  connect(mode_, &QComboBox::currentIndexChanged, this, &FeelSetup::take);
  form.addRow(tr("F&eedback:"), mode_);

  stamped_ = described(new QRadioButton(tr("Even: constant delay for every event")), "placementStamped",
                       tr("Events are played with a constant delay after the finger passed them."));
  fast_ = described(
      new QRadioButton(tr("Fast: every event as early as possible")), "placementFast",
      tr("Events are played as soon as the sensor shows them: earlier on average, but less evenly."));
  stampedDelay_ = noteLabel("placementStampedDelay");
  fastDelay_ = noteLabel("placementFastDelay");
  auto* placement = new QWidget;
  auto* column = new QVBoxLayout(placement);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  for (QWidget* widget : std::initializer_list<QWidget*>{stamped_, stampedDelay_, fast_, fastDelay_}) {
    if (qobject_cast<QLabel*>(widget) != nullptr) widget->setContentsMargins(22, 0, 0, 3);
    column->addWidget(widget);
  }
  connect(stamped_, &QRadioButton::toggled, this, &FeelSetup::take);
  form.addRow(tr("Timing:"), placement);

  profileFile_ =
      described(new QPushButton, "profileFile",
                tr("File (.device) that states how strong the transducer is at each frequency, and how the "
                   "force sensor is calibrated. The command `detent-play sweep` measures the transducer, "
                   "`detent-play calibrate` the sensor; the user's guide shows how."));
  connect(profileFile_, &QPushButton::clicked, this, &FeelSetup::chooseProfile);
  noProfile_ = described(new QPushButton(tr("None")), "noProfile", tr("Play as for an ideal device"));
  connect(noProfile_, &QPushButton::clicked, this, [this] {
    settings_.profileFile.clear();
    tell();
  });
  form.addRow(tr("&Device profile:"), rowOf({profileFile_, noProfile_}));
  profileNote_ = noteLabel("profileNote");
  form.addRow(QString(), profileNote_);
}

void FeelSetup::addSound(QFormLayout& form) {
  device_ = comboBoxOfNames("soundDevice", tr("Sound device that drives the transducer"));
  connect(device_, &QComboBox::currentIndexChanged, this, &FeelSetup::take);
  refresh_ =
      described(new QPushButton(tr("Search again")), "refreshDevices", tr("Search for sound devices again"));
  connect(refresh_, &QPushButton::clicked, &devices_, &SoundDeviceList::refresh);
  form.addRow(tr("&Sound device:"), rowOf({device_, refresh_}));
  deviceNote_ = noteLabel("deviceNote");
  form.addRow(QString(), deviceNote_);

  rate_ = comboBox("sampleRate", tr("Sample rate in Hz"));
  addChoice(rate_, tr("rate of the device"), 0.0);
  for (const double rate : {44100.0, 48000.0, 88200.0, 96000.0, 192000.0})
    addChoice(rate_, tr("%1 Hz").arg(fixedText(rate, 0)), rate);
  connect(rate_, &QComboBox::currentIndexChanged, this, &FeelSetup::take);
  bufferChoice_ = comboBox("bufferFrames",
                           tr("Samples per buffer: smaller is faster, larger is safer against drop-outs"));
  addChoice(bufferChoice_, tr("chosen by the system"), 0U);
  for (const unsigned frames : {32U, 64U, 128U, 256U, 512U, 1024U})
    addChoice(bufferChoice_, tr("%1 samples").arg(frames), frames);
  connect(bufferChoice_, &QComboBox::currentIndexChanged, this, &FeelSetup::take);
  form.addRow(tr("Sample &rate:"), rate_);
  form.addRow(tr("&Buffer:"), bufferChoice_);
}

void FeelSetup::addSensor(QFormLayout& form) {
  port_ = comboBoxOfNames("sensorPort", tr("Serial port of the force sensor, for example /dev/ttyACM0"));
  port_->setEditable(true);
  baud_ = comboBoxOfNames(
      "sensorBaud",
      tr("Speed of the serial port in bits per second. Sensors with a USB connection ignore it"));
  baud_->setEditable(true);
  for (const int baud : {9600, 57600, 115200, 230400, 460800, 921600}) baud_->addItem(QString::number(baud));
  connect_ = described(new QPushButton(tr("Connect")), "sensorConnect",
                       tr("Press with the force sensor, as calibrated in the device profile"));
  connect_->setCheckable(true);
  connect(connect_, &QPushButton::clicked, this, &FeelSetup::take);
  form.addRow(tr("Force se&nsor:"), rowOf({port_, connect_}));
  form.addRow(tr("Ba&ud rate:"), baud_);
  sensorNote_ = noteLabel("sensorNote");
  form.addRow(QString(), sensorNote_);
}

void FeelSetup::setSettings(const FeelSettings& settings) {
  settings_ = settings;
  filling_ = true;
  select(drive_, static_cast<int>(settings.drive));
  select(mode_, static_cast<int>(settings.mode));
  followState_->setChecked(settings.followState);
  (settings.placement == playback::EventPlacement::atOnce ? fast_ : stamped_)->setChecked(true);
  select(rate_, settings.rate_Hz);
  select(bufferChoice_, settings.buffer);
  baud_->setCurrentText(QString::number(settings.sensorBaud));
  showPorts();
  if (!settings.sensorPort.isEmpty()) port_->setCurrentText(settings.sensorPort);
  filling_ = false;
  showChosen();
  showUnits();
  showDevices();
  showDelays();
}

/// Puts the current choice on a push button.
void FeelSetup::showChosen() {
  connect_->setChecked(!settings_.sensorPort.isEmpty());
  connect_->setText(settings_.sensorPort.isEmpty() ? tr("Connect") : tr("Disconnect"));
  const bool none = settings_.profileFile.isEmpty();
  profileFile_->setText(none ? tr("Choose…") : QFileInfo(settings_.profileFile).fileName());
  noProfile_->setEnabled(!none);
}

void FeelSetup::tell() {
  showChosen();
  emit changed(settings_);
}

void FeelSetup::take() {
  if (filling_) return;
  settings_.drive = static_cast<Drive>(drive_->currentData().toInt());
  settings_.mode = static_cast<playback::FeedbackMode>(mode_->currentData().toInt());
  settings_.full_N = full_->value();
  settings_.followState = followState_->isChecked();
  settings_.placement =
      fast_->isChecked() ? playback::EventPlacement::atOnce : playback::EventPlacement::timeStamped;
  settings_.device = device_->currentData().toString();
  settings_.rate_Hz = rate_->currentData().toDouble();
  settings_.buffer = bufferChoice_->currentData().toUInt();
  settings_.sensorPort = connect_->isChecked() ? port_->currentText().trimmed() : QString();
  bool isNumber = false;
  const unsigned baud = baud_->currentText().toUInt(&isNumber);
  if (isNumber && baud > 0) settings_.sensorBaud = baud;
  tell();
}

void FeelSetup::showUnits() {
  full_->setUnits(view_.units());
  full_->setValue(settings_.full_N);
}

void FeelSetup::showDevices() {
  filling_ = true;
  device_->clear();
  QString standard;
  for (const playback::SoundDevice& device : devices_.outputs())
    if (device.defaultOutput) standard = QString::fromStdString(device.name);
  device_->addItem(standard.isEmpty() ? tr("Default output") : tr("Default output (%1)").arg(standard),
                   QString());
  for (const playback::SoundDevice& device : devices_.outputs()) {
    const QString name = QString::fromStdString(device.name);
    device_->addItem(name, name);
    device_->setItemData(
        device_->count() - 1,
        tr("output channels: %1, %2 Hz").arg(device.outputChannels).arg(fixedText(device.sampleRate_Hz, 0)),
        Qt::ToolTipRole);
  }
  // A chosen device that is disconnected stays chosen.
  if (device_->findData(settings_.device) < 0)
    device_->addItem(tr("%1 (not connected)").arg(settings_.device), settings_.device);
  select(device_, settings_.device);
  filling_ = false;
  const QString note =
      devices_.asking()               ? tr("Looking for sound devices…")
      : !devices_.trouble().isEmpty() ? devices_.trouble()
      : listed_ && devices_.outputs().empty()
          ? tr("No sound device was found. Connect one or start the sound server, then search again.")
          : QString();
  deviceNote_->setText(note);
  form_->setRowVisible(deviceNote_, !note.isEmpty());
  refresh_->setEnabled(!devices_.asking());
}

void FeelSetup::showPorts() {
  const QString typed = port_->currentText();
  port_->clear();
  port_->addItems(serialPorts());
  if (!typed.isEmpty()) port_->setCurrentText(typed);
}

void FeelSetup::offerPort(const QString& port) { port_->setCurrentText(port); }

void FeelSetup::showDelays() {
  using playback::EventPlacement;
  fastDelay_->setText(tr("measured %1").arg(measuredDelay(EventPlacement::atOnce, buffer_)));
  stampedDelay_->setText(tr("measured %1").arg(measuredDelay(EventPlacement::timeStamped, buffer_)));
  const QString tip =
      tr("Delay from the moment the force passes a threshold to the first sound sample. Measured with a 425 "
         "Hz sensor and a JACK server, without converter, amplifier and transducer "
         "(docs/measurements/bench-playback.md)");
  fastDelay_->setToolTip(tip);
  stampedDelay_->setToolTip(tip);
}

void FeelSetup::setBuffer(unsigned frames) {
  if (frames == buffer_) return;
  buffer_ = frames;
  showDelays();
}

void FeelSetup::setProfile(const std::optional<playback::DeviceProfile>& profile, const QString& trouble) {
  QString note = trouble;
  if (profile) {
    note = tr("%1: ").arg(QString::fromStdString(profile->name)) + tr("resonances: %1, equalizer bands: %2")
                                                                       .arg(profile->resonances.size())
                                                                       .arg(profile->equalizer.size());
    if (profile->sensor.weights > 0)
      note += tr("; sensor calibrated from %1 to %2 N, ±%3 N")
                  .arg(numberText(profile->sensor.lowest_N), numberText(profile->sensor.highest_N),
                       numberText(profile->sensor.residual_N, 2));
    if (profile->latency)
      note +=
          tr("; measured delay %1 ms, standard deviation %2 ms, %3 measurements")
              .arg(fixedText(1000 * profile->latency->mean_s, 1), fixedText(1000 * profile->latency->sd_s, 1))
              .arg(profile->latency->n);
  }
  profileNote_->setText(note);
  form_->setRowVisible(profileNote_, !note.isEmpty());
}

void FeelSetup::setSensor(const playback::PlayerStatus& status, const QString& trouble) {
  using playback::SensorCondition;
  QString note;
  switch (status.sensor) {
    case SensorCondition::none:
      note = trouble;
      break;
    case SensorCondition::starting:
      note = tr("Waiting for the first reading. If none arrives, check the baud rate.");
      break;
    case SensorCondition::running:
      note = tr("Running, %1 readings a second").arg(fixedText(status.sensorRate_Hz, 0));
      break;
    case SensorCondition::silent:
      note = tr("No data: the sensor has stopped sending. Check its power supply and firmware.");
      break;
    case SensorCondition::stuck:
      note =
          tr("The sensor has reported the same force for 10 s. Remove anything that presses on it. If the "
             "force stays the same, the sensor is defective.");
      break;
    case SensorCondition::unplugged:
      note = tr("The force sensor is unplugged. Detent continues when it is connected again.");
      break;
  }
  if (status.sensor != SensorCondition::none && status.rejectedReadings + status.malformedLines > 0)
    note += tr("; %1 readings rejected, %2 lines not understood")
                .arg(status.rejectedReadings)
                .arg(status.malformedLines);
  if (note == sensorNote_->text() && form_->isRowVisible(sensorNote_) == !note.isEmpty()) return;
  sensorNote_->setText(note);
  form_->setRowVisible(sensorNote_, !note.isEmpty());
}

void FeelSetup::chooseProfile() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Device profile"), QFileInfo(settings_.profileFile).path(),
                                   tr("Device profiles (*.device);;All files (*)"));
  if (file.isEmpty()) return;
  settings_.profileFile = file;
  tell();
}

void FeelSetup::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (event->spontaneous() || listed_ || !playback::livePlaybackAvailable()) return;
  listed_ = true;
  devices_.refresh();
}

}  // namespace detent::editor
