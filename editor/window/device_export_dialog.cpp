// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/device_export_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QVBoxLayout>
#include <span>

#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "editor/document/number_text.h"

namespace detent::editor {
namespace {

using playback::ExportFormat;

constexpr unsigned rates_Hz[] = {8000, 16000, 22050, 44100, 48000, 96000, 192000};
constexpr unsigned sampleBits[] = {8, 16};

struct FormatWords {
  Q_DECLARE_TR_FUNCTIONS(FormatWords)

 public:
  ExportFormat format;
  QString name, purpose;
  const char* ending;

  static std::vector<FormatWords> all();
};

std::vector<FormatWords> FormatWords::all() {
  return {
      {ExportFormat::package, tr("Detent package (JSON)"),
       tr("Everything for your own playback program: force thresholds, waveforms, curve and filters."),
       ".json"},
      {ExportFormat::cHeader, tr("Firmware (C header)"),
       tr("Force thresholds, waveforms and curve for a microcontroller. Filters, equalizer and limiter are "
          "left out."),
       ".h"},
      {ExportFormat::ahap, tr("iPhone (AHAP)"),
       tr("Two files, press and release, 80 to 230 Hz. Plays like a recording; the finger's force has no "
          "effect."),
       ".ahap"},
      {ExportFormat::haptic, tr("Meta and Lofelt (.haptic)"),
       tr("One tone, 80 to 230 Hz. Plays like a recording; the finger's force has no effect."), ".haptic"},
      {ExportFormat::android, tr("Android (Kotlin)"),
       tr("Strength of press and release over time, in steps of at least 20 ms. Plays like a recording; the "
          "finger's force has no effect."),
       ".kt"},
      {ExportFormat::openxr, tr("OpenXR (parametric)"),
       tr("Two files with the same data, JSON and a C header. Plays like a recording; the finger's force has "
          "no effect."),
       ".json"},
      {ExportFormat::hjif, tr("MPEG haptics (HJIF)"),
       tr("ISO/IEC 23090-31, with the unchanged waveform. Plays like a recording; the finger's force has no "
          "effect."),
       ".hjif"},
      {ExportFormat::bos1921, tr("Piezo driver BOS1921"),
       tr("Whole sine cycles for the driver's memory. Plays like a recording; the finger's force has no "
          "effect."),
       ".h"},
      {ExportFormat::da728x, tr("Motor driver DA7280, DA7282"),
       tr("100 bytes of waveform memory; the motor vibrates at its own frequency."), ".h"},
      {ExportFormat::drv2605, tr("Motor driver DRV2605"),
       tr("One amplitude every 5 ms; the motor vibrates at its own frequency."), ".h"},
      {ExportFormat::pcm, tr("Samples (C array)"),
       tr("The waveform as numbers. Plays like a recording; the finger's force has no effect."), ".h"},
      {ExportFormat::touchpad, tr("Haptic touchpad"),
       tr("Sets force threshold (110 to 190 g) and intensity; the touchpad plays its own waveforms."),
       ".json"},
  };
}

QComboBox* numbers(const char* name, const QString& tip, std::span<const unsigned> offered,
                   const QString& unit, unsigned chosen) {
  auto* box = described(new QComboBox, QString::fromLatin1(name), tip, tip);
  for (const unsigned number : offered)
    box->addItem(QString::number(number) + QStringLiteral(" ") + unit, number);
  box->setCurrentIndex(box->findData(chosen));
  return box;
}

QString energyWords(const playback::ExportLoss& loss) {
  QStringList bands;
  for (std::size_t band = 0; band < playback::feltBands.size(); ++band) {
    const auto& [name, low_Hz, high_Hz] = playback::feltBands[band];
    const QString range = QString("%1\u2013%2 Hz").arg(numberText(low_Hz), numberText(high_Hz));
    const auto& kept = loss.energyKept[band];
    bands << range + QStringLiteral(": ") +
                 (kept ? numberText(100 * *kept, 3) + QStringLiteral(" %")
                       : DeviceExportDialog::tr("missing"));
  }
  return DeviceExportDialog::tr("Share of the vibration's energy that the export keeps: %1")
      .arg(bands.join(QStringLiteral(", ")));
}

QString lossWords(const playback::ExportLoss& loss) {
  return energyWords(loss) + QStringLiteral("\n") +
         DeviceExportDialog::tr(
             "Largest timing error: %1 ms; pulses merged: %2; frequencies shifted by up to %3 Hz")
             .arg(numberText(loss.worstTimingError_ms, 3), QString::number(loss.grainsMerged),
                  numberText(loss.frequencyMoved_Hz, 3)) +
         (loss.cut ? QStringLiteral("\n") +
                         DeviceExportDialog::tr("The format cannot hold the whole press: the end of the "
                                                "press is cut off. The file states where.")
                   : QString());
}

}  // namespace

DeviceExportDialog::DeviceExportDialog(Button button, QWidget* parent)
    : QDialog(parent),
      button_(std::move(button)),
      format_(described(new QComboBox, QStringLiteral("deviceFormat"),
                        tr("Format or device for which the press is exported"),
                        tr("Format or device for which the press is exported"))),
      rate_(numbers("deviceRate", tr("Samples per second"), rates_Hz, QStringLiteral("Hz"), 48000)),
      bits_(numbers("deviceBits", tr("Number of bits per sample"), sampleBits, tr("bits"), 16)),
      wayDown_(described(new QSpinBox, QStringLiteral("deviceWayDown"), tr("Duration of the press stroke"),
                         tr("Duration of the press stroke"))),
      purpose_(described(new QLabel, QStringLiteral("devicePurpose"))),
      loss_(described(new QLabel, QStringLiteral("deviceLoss"))),
      form_(new QFormLayout) {
  setObjectName(QStringLiteral("deviceExportDialog"));
  setWindowTitle(tr("Export for a device"));
  for (const FormatWords& words : FormatWords::all())
    format_->addItem(words.name, static_cast<int>(words.format));
  wayDown_->setRange(10, 10'000);
  wayDown_->setValue(120);
  wayDown_->setSuffix(QStringLiteral(" ms"));
  form_->addRow(tr("&Device:"), format_);
  form_->addRow(tr("Press &stroke duration:"), wayDown_);
  form_->addRow(tr("&Rate:"), rate_);
  form_->addRow(tr("&Bits:"), bits_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form_);
  for (QLabel* label : {purpose_, loss_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(fontMetrics().averageCharWidth() * 62);
    label->setMinimumHeight(2 * fontMetrics().lineSpacing());
    layout->addWidget(label);
  }
  loss_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  accept_ = described(buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole),
                      QStringLiteral("deviceExport"), tr("Choose a location and write the file"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  for (QComboBox* box : {format_, rate_, bits_})
    connect(box, &QComboBox::currentIndexChanged, this, &DeviceExportDialog::showChoice);
  connect(wayDown_, &QSpinBox::valueChanged, this, &DeviceExportDialog::showChoice);
  showChoice();
}

DeviceChoice DeviceExportDialog::choice() const {
  DeviceChoice choice;
  choice.wanted.settings.format = static_cast<ExportFormat>(format_->currentData().toInt());
  choice.wanted.settings.sampleRate_Hz = rate_->currentData().toUInt();
  choice.wanted.settings.bits = bits_->currentData().toUInt();
  choice.wanted.wayDown_s = wayDown_->value() / 1000.0;
  for (const FormatWords& words : FormatWords::all())
    if (words.format == choice.wanted.settings.format) {
      choice.name = words.name;
      choice.ending = QString::fromLatin1(words.ending);
    }
  return choice;
}

void DeviceExportDialog::showChoice() {
  const DeviceChoice chosen = choice();
  const bool samples = chosen.wanted.settings.format == ExportFormat::pcm;
  form_->setRowVisible(rate_, samples);
  form_->setRowVisible(bits_, samples);
  for (const FormatWords& words : FormatWords::all())
    if (words.format == chosen.wanted.settings.format) purpose_->setText(words.purpose);
  const auto exported = deviceExport(button_, chosen.wanted);
  accept_->setEnabled(exported.ok());
  loss_->setText(exported.ok() ? lossWords(exported->loss) : sentenceOf(exported.failure()));
}

}  // namespace detent::editor
