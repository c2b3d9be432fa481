// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Common parts of every question's page: the question, faults, the number of questions, and the ways out of
// it.

#include "editor/study/keyed_page.h"

namespace detent::editor {

/// GUI thread.
class QuestionPage : public KeyedPage {
  Q_OBJECT

 public:
  explicit QuestionPage(QWidget* parent = nullptr);

  void showQuestion(const QString& text) { question_->setText(text); }
  void showCount(const QString& text) { count_->setText(text); }
  /// Empty: nothing is wrong.
  void showTrouble(const QString& text);
  /// Buttons beside the count, below the question.
  void addBelow(QWidget* widget) { bottom_->addWidget(widget); }

 protected:
  /// The count's row; after everything else of the page.
  void addBottom();

 private:
  QLabel *question_ = nullptr, *trouble_ = nullptr, *count_ = nullptr;
  QHBoxLayout* bottom_ = nullptr;
};

}  // namespace detent::editor
