// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Timed trials in a participant's window, one after the other: connects playback's TimedRun with a page.

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

/// A press gets the time that the window system stamped, in ms of the system's steady clock. Without a stamp
/// it gets the time at which it reached this window. The lateness of stamps is measured while a trial is
/// shown. GUI thread.
class TimedTrials : public QObject {
  Q_OBJECT

 public:
  /// Origin of a press's time, for the journal.
  static std::string pressRoute();

  /// Study, player and page must outlive it.
  TimedTrials(const playback::Study& study, playback::StudyPlayer& player, TimingPage* page, TimedWords words,
              QObject* parent = nullptr);

  /// Begins the next trial of a session.
  void show(playback::ParticipantSession& session);
  /// Hides the trial and forgets its presses.
  void leave();
  /// Notes the time of the event that is about to press the pad.
  void note(const QInputEvent& event);

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void kept();                                ///< The trial is on the disk; the next one is not shown yet.
  void away(playback::StudyTrouble trouble);  ///< A device is missing; noted in the journal.
  void back();                                ///< The device is back; nothing is shown yet.
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
  double looked_s_;                  ///< time at which this thread last handled events
  std::optional<quint64> stamp_ms_;  ///< stamp of the event that presses
  QTimer frame_;
  std::optional<WakeWatch> wakes_;  ///< exists while a trial is shown that keys press
};

}  // namespace detent::editor
