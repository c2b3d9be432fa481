// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/trial_page.h"

#include <algorithm>
#include <QGridLayout>

namespace detent::editor {

namespace {

constexpr int mostColumns = 5, padColumns = 3, longestNumber = 9, trialSpacing_px = 18;
constexpr std::size_t mostKeys = 9;

/// Key of the i-th button: "1" for the first; none after the ninth.
PageKey digitKey(std::size_t i) {
  if (i >= mostKeys) return {};
  return {Qt::Key_1 + static_cast<int>(i), QString::number(i + 1)};
}

PageKey letterKey(std::size_t i) {
  if (i >= mostKeys) return {};
  return {Qt::Key_A + static_cast<int>(i), QString(QChar('A' + static_cast<char>(i)))};
}

bool onScale(const playback::Study& study) {
  return study.design.kind == playback::StudyKind::rating &&
         study.design.scale != playback::RatingScale::pairwise;
}

}  // namespace

TrialPage::TrialPage(const playback::Study& study, const TrialWords& words, QWidget* parent)
    : QuestionPage(parent) {
  if (!onScale(study))
    addChoices(study, words);
  else if (study.design.scale == playback::RatingScale::preference)
    addScale(words);
  else
    addNumber(words);
  addBottom();
}

void TrialPage::addChoices(const playback::Study& study, const TrialWords& words) {
  const bool matching = study.design.kind == playback::StudyKind::matching;
  const std::size_t count = matching ? study.buttons.size() : 2;
  if (playback::asksForX(study.design.kind)) {
    x_ = makeFeelButton({"studyX", words.feelX, {Qt::Key_X, "X"}, largeText_pt, pressHeight_px},
                        [this, count] { emit felt(count); });
    x_->setEnabled(study.design.targets != playback::TargetKind::physicalButton);
    column()->addWidget(x_);
  }
  auto* grid = new QGridLayout;
  grid->setSpacing(trialSpacing_px);
  for (std::size_t i = 0; i < count; ++i) {
    const QByteArray pressName = QByteArray("studyPress") + QByteArray::number(i + 1);
    const QByteArray answerName = QByteArray("studyAnswer") + QByteArray::number(i + 1);
    auto* press =
        makeFeelButton({pressName, words.feelOne.arg(i + 1), digitKey(i), largeText_pt, pressHeight_px},
                       [this, i] { emit felt(i); });
    auto* answer = makeButton(
        {answerName, words.answers.value(static_cast<qsizetype>(i), words.answer.arg(i + 1)), letterKey(i)},
        [this, i] { emit answered(i); });
    const int row = 2 * (static_cast<int>(i) / mostColumns), at = static_cast<int>(i) % mostColumns;
    grid->addWidget(press, row, at);
    grid->addWidget(answer, row + 1, at);
    choices_.push_back(press);
    answers_.push_back(answer);
  }
  column()->addLayout(grid, 1);
}

void TrialPage::addScale(const TrialWords& words) {
  auto* feel = makeFeelButton(
      {"studyPress1", words.feelIt, {Qt::Key_Space, words.space}, largeText_pt, pressHeight_px},
      [this] { emit felt(0); });
  choices_.push_back(feel);
  column()->addWidget(feel);
  auto* row = new QHBoxLayout;
  for (int i = 1; i <= static_cast<int>(playback::bestPreference); ++i) {
    const QByteArray name = QByteArray("studyAnswer") + QByteArray::number(i);
    // The number itself is the key.
    auto* answer = makeButton({name, QString::number(i), {Qt::Key_0 + i, {}}, largeText_pt, pressHeight_px},
                              [this, i] { emit rated(i); });
    row->addWidget(answer);
    answers_.push_back(answer);
  }
  column()->addLayout(row);
  auto* ends = new QHBoxLayout;
  QLabel* least = addText("studyLeast", words.least, smallText_pt, Qt::AlignLeft);
  QLabel* most = addText("studyMost", words.most, smallText_pt, Qt::AlignRight);
  for (QLabel* label : {least, most}) {
    column()->removeWidget(label);
    ends->addWidget(label);
  }
  column()->addLayout(ends, 1);
}

void TrialPage::addNumber(const TrialWords& words) {
  auto* feel = makeFeelButton(
      {"studyPress1", words.feelIt, {Qt::Key_Space, words.space}, largeText_pt, pressHeight_px},
      [this] { emit felt(0); });
  choices_.push_back(feel);
  column()->addWidget(feel);
  number_ = addText("studyNumber", {}, largeText_pt);
  number_->setMinimumHeight(answerHeight_px);
  number_->setStyleSheet("border: 2px solid palette(mid); border-radius: 4px;");
  auto* pad = new QGridLayout;
  const QString digits = QStringLiteral("123456789.0");
  for (int i = 0; i < digits.size(); ++i) {
    const QChar digit = digits[i];
    const QByteArray name = QByteArray("studyDigit") + QByteArray::number(i);
    const int key = digit == '.' ? Qt::Key_Period : Qt::Key_0 + digit.digitValue();
    pad->addWidget(makeButton({name, QString(digit), {key, {}}, plainText_pt, smallHeight_px},
                              [this, digit] { type(digit); }),
                   i / padColumns, i % padColumns);
  }
  pad->addWidget(makeButton({"studyTakeBack",
                             words.takeBack,
                             {Qt::Key_Backspace, words.backspace},
                             plainText_pt,
                             smallHeight_px},
                            [this] { clearNumber(); }),
                 3, 2);
  column()->addLayout(pad, 1);
  answers_.push_back(
      addButton({"studyAnswer1", words.take, {Qt::Key_Return, words.enter}}, [this] { takeNumber(); }));
}

void TrialPage::type(QChar digit) {
  if (typed_.size() < longestNumber) typed_ += digit;
  number_->setText(typed_);
}

void TrialPage::clearNumber() {
  typed_.clear();
  if (number_ != nullptr) number_->clear();
}

void TrialPage::takeNumber() {
  bool readable = false;
  const double number = typed_.toDouble(&readable);
  if (!readable) return emit unreadableNumber();
  emit rated(number);
}

void TrialPage::allowAnswers(bool allowed) {
  for (QPushButton* button : answers_) button->setEnabled(allowed);
}

bool TrialPage::answersAllowed() const { return answers_.front()->isEnabled(); }

void TrialPage::mark(std::optional<std::size_t> slot) {
  for (std::size_t i = 0; i < choices_.size(); ++i) choices_[i]->setChecked(slot == i);
  if (x_ != nullptr) x_->setChecked(slot == choices_.size());
}

}  // namespace detent::editor
