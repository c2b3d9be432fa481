// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/question_page.h"

namespace detent::editor {

QuestionPage::QuestionPage(QWidget* parent) : KeyedPage(parent) {
  question_ = addText("studyHint", {}, plainText_pt);
  trouble_ = addText("studyTrouble", {}, plainText_pt);
  trouble_->setStyleSheet("color: #b3261e;");
  trouble_->hide();
}

void QuestionPage::addBottom() {
  count_ = addText("studyCount", {}, plainText_pt, Qt::AlignLeft | Qt::AlignVCenter);
  column()->removeWidget(count_);
  bottom_ = new QHBoxLayout;
  bottom_->addWidget(count_, 1);
  column()->addLayout(bottom_);
}

void QuestionPage::showTrouble(const QString& text) {
  trouble_->setText(text);
  trouble_->setVisible(!text.isEmpty());
}

}  // namespace detent::editor
