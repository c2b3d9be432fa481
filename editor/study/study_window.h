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

#include "playback/study.h"

namespace detent::editor {

/// One participant at work. The session belongs to the study.
struct StudyWork {
  std::unique_ptr<playback::Study> study;
  std::unique_ptr<playback::ParticipantSession> session;
  std::unique_ptr<playback::StudyPlayer> player;
  bool sensor = false;  ///< a force sensor presses; else keys and the large buttons do
  QString consent;      ///< shown before the first trial
};

/// Works through one participant's trials. Every answer is on the disk before the next question is shown.
/// GUI thread.
class StudyWindow : public QWidget {
  Q_OBJECT

 public:
  explicit StudyWindow(StudyWork work, QWidget* parent = nullptr);

 signals:
  void finished();  ///< all answered, paused or stopped; the window is closed

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* consentPage();
  QWidget* trialPage();
  QLayout* choiceGrid();
  QLayout* bottomRow();
  QWidget* stopPage();
  QWidget* endPage();
  void begin();
  void showTrial();
  void pressChoice(std::size_t choice);
  void pressX();
  void feel(std::size_t slot);
  QString unfeltWords() const;
  void mark(const QPushButton* underFinger);
  void answer(std::size_t choice);
  void stopForGood();
  void watchDevice();
  void tell(const QString& trouble);
  void refresh();
  bool rehearsal() const { return !work_.player->sounding(); }
  double now_s() const;

  StudyWork work_;
  std::optional<playback::TrialDesk> desk_;
  QStackedWidget* pages_ = nullptr;
  QWidget *trialPage_ = nullptr, *stopPage_ = nullptr, *endPage_ = nullptr;
  QLabel *count_ = nullptr, *task_ = nullptr, *trouble_ = nullptr, *endWords_ = nullptr;
  QPushButton* x_ = nullptr;
  std::vector<QPushButton*> choices_, answers_;
  bool away_ = false;  ///< the sound device, just now
  QElapsedTimer clock_;
  QTimer watch_;
};

}  // namespace detent::editor
