// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a participant sees: one question at a time, large plain controls, no label of any button. The
// experimenter's view is study_desk.h.

#include <memory>
#include <optional>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// Works through one participant's trials. Every answer is on the disk before the next question is shown.
/// GUI thread.
class StudyWindow : public QWidget {
  Q_OBJECT

 public:
  /// `session` belongs to `study`.
  StudyWindow(std::unique_ptr<playback::Study> study, std::unique_ptr<playback::ParticipantSession> session,
              std::unique_ptr<playback::StudyPlayer> player, const QString& consent,
              QWidget* parent = nullptr);

 signals:
  void finished();  ///< all answered, paused or stopped; the window is closed

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* consentPage(const QString& consent);
  QWidget* trialPage();
  QWidget* endPage();
  void begin();
  void showTrial();
  void pressChoice(std::size_t choice);
  void pressX();
  void answer(std::size_t choice);
  void stop();
  void watchDevice();
  void refresh();
  double now_s() const;

  std::unique_ptr<playback::Study> study_;
  std::unique_ptr<playback::ParticipantSession> session_;
  std::unique_ptr<playback::StudyPlayer> player_;
  std::optional<playback::TrialDesk> desk_;
  QStackedWidget* pages_ = nullptr;
  QLabel *count_ = nullptr, *hint_ = nullptr;
  QPushButton* x_ = nullptr;
  std::vector<QPushButton*> choices_, answers_;
  QElapsedTimer clock_;
  QTimer watch_;
};

}  // namespace detent::editor
