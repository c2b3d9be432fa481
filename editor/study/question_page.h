// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Common parts of every question's page: the question, faults, the number of the question, and the buttons
// for pausing and leaving.

#include "editor/study/keyed_page.h"

namespace detent::editor {

/// GUI thread.
class QuestionPage : public KeyedPage {
  Q_OBJECT

 public:
  explicit QuestionPage(QWidget* parent = nullptr);

  void showQuestion(const QString& text) { question_->setText(text); }
  void showCount(const QString& text) { count_->setText(text); }
  /// Shows a fault; empty: none.
  void showTrouble(const QString& text);
  /// Adds a widget beside the count, below the question.
  void addBelow(QWidget* widget) { bottom_->addWidget(widget); }

 protected:
  /// Adds the row with the count; call it after everything else of the page was added.
  void addBottom();

 private:
  QLabel *question_ = nullptr, *trouble_ = nullptr, *count_ = nullptr;
  QHBoxLayout* bottom_ = nullptr;
};

}  // namespace detent::editor
