// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Switches sound on and off, sets its gain, and shows its level and the state of the sound device.

#include <QWidget>

#include "editor/feel/feel_session.h"

class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace detent::editor {

class LevelMeter;

/// Shows the sound of a session and changes its settings. GUI thread.
class SoundBox : public QWidget {
  Q_OBJECT

 public:
  /// `session` must outlive it.
  explicit SoundBox(FeelSession& session, QWidget* parent = nullptr);

 private:
  QLayout* levelRow();
  QLayout* gainRow();
  QLayout* statusRow();
  void showSettings();
  void showSound();
  void showStatus();
  QString soundWords() const;
  QString feltWords() const;

  FeelSession& session_;
  LevelMeter* meter_ = nullptr;
  QToolButton* sound_ = nullptr;
  QSlider* gain_ = nullptr;
  QLabel *gainText_ = nullptr, *status_ = nullptr, *felt_ = nullptr;
  QPushButton* again_ = nullptr;
  SoundState shownSound_ = SoundState::off;
  double figuresAt_s_ = 0;
};

}  // namespace detent::editor
