// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One question as a participant sees it: buttons to feel and answers to choose from, for each kind of study.
// It shows no button's name.

#include <optional>

#include "editor/study/participant_language.h"
#include "editor/study/question_page.h"
#include "playback/study.h"

namespace detent::editor {

/// Texts on a question's controls, in the participant's language.
struct TrialWords {
  QString feelX, feelOne, feelIt;  ///< "Feel X", "Feel %1", "Feel it"
  QString answer;                  ///< "X is %1", "%1 is better"
  QStringList answers{};           ///< answer for each choice, instead of `answer`
  QString space, enter, backspace, takeBack, take;
  QString least, most;  ///< ends of the scale 1 to 7
};

/// GUI thread.
class TrialPage : public QuestionPage {
  Q_OBJECT

 public:
  TrialPage(const playback::Study& study, const TrialWords& words, QWidget* parent = nullptr);

  /// Says that X is a real switch, which the experimenter hands over.
  void showRealX(const QString& text) { x_->setText(text); }
  void allowAnswers(bool allowed);
  bool answersAllowed() const;
  /// Marks the stimulus under the finger; empty: none.
  void mark(std::optional<std::size_t> slot);
  /// Discards a number of which the first digits were typed.
  void clearNumber();

 signals:
  void felt(std::size_t slot);
  void answered(std::size_t choice);
  void rated(double number);
  void unreadableNumber();

 private:
  void addChoices(const playback::Study& study, const TrialWords& words);
  void addScale(const TrialWords& words);
  void addNumber(const TrialWords& words);
  void type(QChar digit);
  void takeNumber();

  QLabel* number_ = nullptr;
  QPushButton* x_ = nullptr;
  std::vector<QPushButton*> choices_, answers_;
  QString typed_;
};

}  // namespace detent::editor
