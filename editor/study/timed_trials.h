// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Timed trials in a participant's window, one after the other: playback's TimedRun with a page in front of
// it.

#include <optional>
#include <QObject>
#include <QTimer>

#include "editor/study/timing_page.h"
#include "editor/study/wake_watch.h"
#include "playback/study.h"

class QInputEvent;

namespace detent::editor {

/// Texts after a trial, in the participant's language.
struct TimedWords {
  QString hit, missed, enough;
  QString noPress, held, notFelt;
  QString notKept;  ///< %1: why
};

/// Presses are timed by the stamp that the window system gives them, in ms of the system's steady clock;
/// where it gives none, by when they reached this window. How late a stamp may be is watched while a trial is
/// shown. GUI thread.
class TimedTrials : public QObject {
  Q_OBJECT

 public:
  /// Origin of a press's time, for the journal.
  static std::string pressRoute();

  /// Study, player and page must outlive it.
  TimedTrials(const playback::Study& study, playback::StudyPlayer& player, TimingPage* page, TimedWords words,
              QObject* parent = nullptr);

  /// The trial that comes next begins.
  void show(playback::ParticipantSession& session);
  /// Hides the trial and forgets its presses.
  void leave();
  /// The event that is about to press the pad.
  void note(const QInputEvent& event);

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void kept();                                ///< on the disk; the next one is not shown yet
  void away(playback::StudyTrouble trouble);  ///< in the journal
  void back();                                ///< the device is there again: nothing is shown yet
  void failed(const QString& trouble);        ///< the journal cannot be written

 private:
  void press();
  void poll();
  void draw();
  void ended(const playback::TimedOutcome& outcome);
  QString outcomeWords(const playback::TimedOutcome& outcome) const;

  const playback::Study& study_;
  playback::StudyPlayer& player_;
  TimingPage* page_;
  TimedWords words_;
  playback::ParticipantSession* session_ = nullptr;
  std::optional<playback::TimedRun> run_;
  bool away_ = false;
  const double began_s_;
  double looked_s_;                  ///< when this thread last came to its events
  std::optional<quint64> stamp_ms_;  ///< of the event that presses
  QTimer frame_;
  std::optional<WakeWatch> wakes_;  ///< while a trial is shown that keys press
};

}  // namespace detent::editor
