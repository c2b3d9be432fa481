// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The participant's station: consent, instructions, one question at a time, rests, the end. Large plain
// controls, each with its key, in the participant's language, and no button's name. The experimenter's view
// is experimenter_dialog.h.

#include <memory>
#include <optional>
#include <QElapsedTimer>
#include <QStackedWidget>
#include <QTimer>
#include <QWidget>

#include "editor/study/participant_language.h"
#include "editor/study/timed_trials.h"
#include "editor/study/trial_page.h"
#include "playback/study.h"

namespace detent::editor {

/// Data for one participant's session. An open session belongs to the study.
struct StudyWork {
  std::unique_ptr<playback::Study> study;
  std::string participant;
  playback::SessionStart start;  ///< the session is opened with this after the participant has agreed
  /// Text of the consent; empty if the participant has agreed before.
  std::optional<playback::ConsentText> consent;
  std::unique_ptr<playback::StudyPlayer> player;
  /// true: a force sensor or a force device presses; false: keys and the large buttons
  bool sensor = false;
  bool force =
      false;  ///< true: a force device presses; Escape removes its force, the experimenter's F9 restores it
  QString language = QStringLiteral("en");
  std::unique_ptr<playback::ParticipantSession> session{};  ///< open already if no consent is needed
};

/// A participant's progress, for the experimenter.
struct StudyProgress {
  enum class At : std::uint8_t { consent, words, question, rest, pause, trouble, end };
  At at = At::consent;
  std::size_t answered = 0, questions = 0;  ///< practice too
};

/// Works through one participant's trials. Every answer is on the disk before the next question is shown.
/// Shown over a whole screen; closing it from outside (Alt+F4) pauses. GUI thread.
class StudyWindow : public QWidget {
  Q_OBJECT

 public:
  explicit StudyWindow(StudyWork work, QWidget* parent = nullptr);

 signals:
  void progressed(const StudyProgress& progress);
  void finished();  ///< the window is about to close, and the experimenter takes over

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  using At = StudyProgress::At;

  KeyedPage* consentPage();
  KeyedPage* wordsPage();
  TrialPage* trialPage();
  TimingPage* timingPage();
  void addWaysOut(QuestionPage* page);
  KeyedPage* pausePage();
  KeyedPage* stopPage();
  KeyedPage* endPage();
  PageButton closeButton(const char* name) const;
  PageKey enterKey() const { return {Qt::Key_Return, words("Enter")}; }
  TrialWords trialWords() const;
  QString answerWords() const;
  QString taskWords() const;
  QString howWords() const;

  void agree();
  void decline();
  Result<Done> openSession();
  void showIntroduction();
  void showNext();
  void showWords(const QString& text, At at);
  void showTrial();
  void goOn();
  void askToStop();
  void feel(std::size_t slot);
  void answer(std::size_t choice, std::optional<double> rating);
  QString unfeltWords() const;
  void stopForGood();
  void pause();
  void showEnd(const QString& text);
  void watchDevice();
  void tellAway(playback::StudyTrouble trouble);
  void tell(const QString& trouble);
  void refresh();
  void show(KeyedPage* page, At at);
  bool isTimed() const { return work_.study->design.kind == playback::StudyKind::timing; }
  void leaveQuestion();
  bool rehearsal() const { return !work_.player->sounding(); }
  double now_s() const;
  QString words(const char* text) const { return language_.words(text); }

  StudyWork work_;
  ParticipantLanguage language_;
  std::optional<playback::TrialController> controller_;
  QStackedWidget* pages_ = nullptr;
  KeyedPage *consent_ = nullptr, *said_ = nullptr, *paused_ = nullptr, *stop_ = nullptr, *end_ = nullptr;
  QuestionPage* question_ = nullptr;  ///< trial_ or timing_
  TrialPage* trial_ = nullptr;        ///< null in a timing study
  TimingPage* timing_ = nullptr;      ///< page of a timing study; null in other studies
  TimedTrials* timed_ = nullptr;      ///< with timing_
  QLabel *saidText_ = nullptr, *endText_ = nullptr, *consentTrouble_ = nullptr;
  std::size_t restedBefore_ = 0;  ///< number of the trial before which a rest or words were shown
  At at_ = At::consent;
  bool away_ = false;  ///< a device is missing at the moment
  QElapsedTimer clock_;
  QTimer watch_;
};

}  // namespace detent::editor
