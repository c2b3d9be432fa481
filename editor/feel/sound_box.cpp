// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/sound_box.h"

#include <cmath>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "editor/feel/feel_clock.h"
#include "editor/feel/level_meter.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double gainStepsPer_dB = 2;  // steps of the slider per dB
constexpr double figuresEvery_s = 0.25;
constexpr int mostStatusLines = 4;

QString withMinus(QString number) { return number.replace('-', QChar(0x2212)); }

}  // namespace

SoundBox::SoundBox(FeelSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addLayout(levelRow());
  column->addLayout(gainRow());
  column->addLayout(statusRow());
  connect(&session_, &FeelSession::settingsChanged, this, &SoundBox::showSettings);
  connect(&session_, &FeelSession::moved, this, &SoundBox::showStatus);
  connect(&session_.player(), &FeelPlayer::soundChanged, this, &SoundBox::showSound);
  showSettings();
  showSound();
}

QLayout* SoundBox::levelRow() {
  sound_ = described(new QToolButton, "soundSwitch",
                     tr("Play the vibration of each press through the sound device. The first press opens "
                        "the device; switching this off closes it."));
  sound_->setText(tr("Sound"));
  sound_->setCheckable(true);
  connect(sound_, &QToolButton::toggled, this, [this](bool on) {
    FeelSettings next = session_.settings();
    next.sound = on;
    session_.setSettings(next);
  });
  meter_ = described(new LevelMeter, "levelMeter");
  felt_ = described(
      new QLabel, "feltLevel",
      tr("Strength of the strongest 10 ms within the last 1.5 s, in dB above the weakest "
         "vibration that a fingertip feels. It is computed from the strength of the transducer "
         "in the device profile. ≈ means that the strength of the transducer was assumed, not measured."));
  felt_->setMinimumWidth(
      felt_->fontMetrics().horizontalAdvance(tr("felt %1 dB").arg(QStringLiteral("≈ 100"))));
  felt_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* row = new QHBoxLayout;
  row->addWidget(sound_);
  row->addWidget(meter_, 1);
  row->addWidget(felt_);
  return row;
}

QLayout* SoundBox::gainRow() {
  auto* label = new QLabel(tr("&Gain"));
  gain_ = described(new QSlider(Qt::Horizontal), "gain",
                    tr("Gain before the limiter, −40 to +20 dB. 0 dB is the strength that button and device "
                       "profile require"));
  gain_->setRange(static_cast<int>(lowestGain_dB * gainStepsPer_dB),
                  static_cast<int>(highestGain_dB * gainStepsPer_dB));
  gain_->setPageStep(static_cast<int>(6 * gainStepsPer_dB));
  gain_->setTickInterval(static_cast<int>(20 * gainStepsPer_dB));
  gain_->setTickPosition(QSlider::TicksBelow);
  connect(gain_, &QSlider::valueChanged, this, [this](int steps) {
    FeelSettings next = session_.settings();
    next.gain_dB = steps / gainStepsPer_dB;
    session_.setSettings(next);
  });
  label->setBuddy(gain_);
  gainText_ = new QLabel;
  gainText_->setMinimumWidth(gainText_->fontMetrics().horizontalAdvance("−40.0 dB"));
  gainText_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(gain_, 1);
  row->addWidget(gainText_);
  return row;
}

QLayout* SoundBox::statusRow() {
  status_ = wrappingLabel("soundStatus");
  again_ = described(new QPushButton(tr("Try again")), "soundAgain", tr("Open the sound device once more"));
  connect(again_, &QPushButton::clicked, &session_.player(), &FeelPlayer::startSound);
  // Reserves space for the longest text, so that the controls below do not move.
  status_->setMinimumHeight(mostStatusLines * status_->fontMetrics().lineSpacing());
  status_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  QSizePolicy kept = again_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  again_->setSizePolicy(kept);
  auto* row = new QHBoxLayout;
  row->addWidget(status_, 1);
  row->addWidget(again_, 0, Qt::AlignTop);
  return row;
}

void SoundBox::showSettings() {
  const QSignalBlocker soundBlocked(sound_), gainBlocked(gain_);
  sound_->setChecked(session_.settings().sound);
  gain_->setValue(static_cast<int>(std::lround(session_.settings().gain_dB * gainStepsPer_dB)));
  gainText_->setText(tr("%1 dB").arg(withMinus(fixedText(session_.settings().gain_dB, 1))));
  showStatus();
}

void SoundBox::showSound() {
  const SoundState sound = session_.player().sound();
  again_->setVisible(sound == SoundState::failed);
  if (sound == SoundState::lost || sound == SoundState::failed)
    emit session_.said(tr("No sound: presses are tracked without sound"));
  showStatus();
}

QString SoundBox::soundWords() const {
  const playback::PlayerStatus& s = session_.player().status();
  switch (session_.player().sound()) {
    case SoundState::off:
      return session_.settings().sound ? tr("Sound starts with the first press.")
                                       : tr("Sound is off; presses are tracked without sound.");
    case SoundState::starting:
      return tr("Opening the sound device; until then, presses are tracked without sound.");
    case SoundState::lost:
      return tr("The sound device %1 is disconnected. Plug it in or start its server again: sound resumes by "
                "itself. Until then, presses are tracked without sound.")
          .arg(QString::fromStdString(s.device));
    case SoundState::failed:
      return tr("No audio output. Presses are tracked without sound. %1")
          .arg(asSentence(session_.player().trouble()));
    case SoundState::on:
      break;
  }
  QString text = tr("%1 · %2 kHz").arg(QString::fromStdString(s.device), numberText(s.sampleRate_Hz / 1000));
  if (s.blockFrames > 0 && s.sampleRate_Hz > 0)
    text += tr(" · buffer %1 (%2 ms)")
                .arg(s.blockFrames)
                .arg(fixedText(1000 * s.blockFrames / s.sampleRate_Hz, 1));
  text += tr(" · load %1 %").arg(fixedText(100 * s.meanLoad, 1)) + tr(" · drop-outs: %1").arg(s.xruns);
  if (s.deviceLosses > 0) text += tr(" · lost: %1").arg(s.deviceLosses);
  return text;
}

QString SoundBox::feltWords() const {
  const double felt_dB = session_.player().status().felt_dB;
  if (session_.player().sound() != SoundState::on || !(felt_dB > 0)) return {};
  const auto& profile = session_.profile();
  const bool measured = profile && profile->fullScale_dB;
  return tr("felt %1 dB").arg((measured ? QString() : QStringLiteral("≈ ")) + fixedText(felt_dB, 0));
}

void SoundBox::showStatus() {
  const SoundState sound = session_.player().sound();
  const QString text = soundWords();
  // Figures change all the time, so they are updated only now and then.
  const bool figures = sound == SoundState::on && shownSound_ == SoundState::on;
  if (text != status_->text() && (!figures || steadyTime_s() - figuresAt_s_ > figuresEvery_s)) {
    status_->setText(text);
    figuresAt_s_ = steadyTime_s();
    shownSound_ = sound;
  }
  felt_->setText(feltWords());
  if (sound != SoundState::on) return meter_->setIdle();
  const auto program = session_.program();
  meter_->setLevel(session_.player().status().level, program ? program->program.limiterCeiling : 1,
                   steadyTime_s());
}

}  // namespace detent::editor
