// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_window.h"

#include <QCloseEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMessageBox>
#include <QVBoxLayout>

namespace detent::editor {

namespace {

constexpr int watch_ms = 100;
constexpr int largeText_pt = 22, plainText_pt = 15, buttonHeight_px = 110, answerHeight_px = 70;
constexpr int mostColumns = 5;

template <class Widget>
Widget* large(Widget* widget, int points) {
  QFont font = widget->font();
  font.setPointSize(points);
  widget->setFont(font);
  return widget;
}

QPushButton* largeButton(const QString& text, const QString& name, int points, int height_px) {
  auto* button = large(new QPushButton(text), points);
  button->setObjectName(name);
  button->setMinimumHeight(height_px);
  button->setFocusPolicy(Qt::NoFocus);  // the keys belong to the question
  return button;
}

QLabel* banner(const QString& text) {
  auto* label = large(new QLabel(text), plainText_pt);
  label->setObjectName("studyBanner");
  label->setAlignment(Qt::AlignCenter);
  label->setStyleSheet("background: #b3261e; color: white; padding: 6px; font-weight: bold;");
  return label;
}

}  // namespace

StudyWindow::StudyWindow(std::unique_ptr<playback::Study> study,
                         std::unique_ptr<playback::ParticipantSession> session,
                         std::unique_ptr<playback::StudyPlayer> player, const QString& consent,
                         QWidget* parent)
    : QWidget(parent, Qt::Window),
      study_(std::move(study)),
      session_(std::move(session)),
      player_(std::move(player)) {
  setObjectName("studyWindow");
  setWindowTitle(tr("Study"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(960, 640);
  auto* layout = new QVBoxLayout(this);
  if (!player_->sounding())
    layout->addWidget(banner(tr("REHEARSAL: there is no sound device, nothing is felt")));
  pages_ = new QStackedWidget;
  layout->addWidget(pages_, 1);
  pages_->addWidget(consentPage(consent));
  pages_->addWidget(trialPage());
  pages_->addWidget(endPage());
  clock_.start();
  watch_.setInterval(watch_ms);
  connect(&watch_, &QTimer::timeout, this, &StudyWindow::watchDevice);
  if (!session_->record().answers.empty()) begin();  // agreed already
}

double StudyWindow::now_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }

QWidget* StudyWindow::consentPage(const QString& consent) {
  auto* page = new QWidget;
  auto* text = large(new QLabel(consent), plainText_pt);
  text->setObjectName("studyConsent");
  text->setWordWrap(true);
  auto* agree = largeButton(tr("I agree: begin"), "studyBegin", largeText_pt, answerHeight_px);
  auto* leave = largeButton(tr("No, thank you"), "studyLeave", plainText_pt, answerHeight_px);
  connect(agree, &QPushButton::clicked, this, &StudyWindow::begin);
  connect(leave, &QPushButton::clicked, this, &QWidget::close);
  auto* layout = new QVBoxLayout(page);
  layout->addStretch();
  layout->addWidget(text);
  layout->addStretch();
  layout->addWidget(agree);
  layout->addWidget(leave);
  return page;
}

QWidget* StudyWindow::trialPage() {
  auto* page = new QWidget;
  const bool abx = study_->design.kind == playback::StudyKind::abx;
  const bool physical = study_->design.targets == playback::TargetKind::physicalButton;
  const std::size_t count = abx ? 2 : study_->buttons.size();
  count_ = large(new QLabel, plainText_pt);
  count_->setObjectName("studyCount");
  hint_ = large(new QLabel, plainText_pt);
  hint_->setObjectName("studyHint");
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  x_ = largeButton(physical ? QString() : tr("Press X"), "studyX", largeText_pt, buttonHeight_px);
  x_->setEnabled(!physical);
  connect(x_, &QPushButton::pressed, this, &StudyWindow::pressX);
  auto* grid = new QGridLayout;
  for (std::size_t i = 0; i < count; ++i) {
    auto* press = largeButton(tr("Press %1").arg(i + 1), QString("studyPress%1").arg(i + 1), largeText_pt,
                              buttonHeight_px);
    auto* choose = largeButton(tr("X is %1").arg(i + 1), QString("studyAnswer%1").arg(i + 1), largeText_pt,
                               answerHeight_px);
    connect(press, &QPushButton::pressed, this, [this, i] { pressChoice(i); });
    connect(choose, &QPushButton::clicked, this, [this, i] { answer(i); });
    const int row = 2 * (static_cast<int>(i) / mostColumns), column = static_cast<int>(i) % mostColumns;
    grid->addWidget(press, row, column);
    grid->addWidget(choose, row + 1, column);
    choices_.push_back(press);
    answers_.push_back(choose);
  }
  auto* pause = largeButton(tr("Pause"), "studyPause", plainText_pt, answerHeight_px / 2);
  pause->setToolTip(tr("Close; the next start goes on at this very trial"));
  connect(pause, &QPushButton::clicked, this, &QWidget::close);
  auto* end = largeButton(tr("Stop for good"), "studyStop", plainText_pt, answerHeight_px / 2);
  connect(end, &QPushButton::clicked, this, &StudyWindow::stop);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(count_, 1);
  bottom->addWidget(pause);
  bottom->addWidget(end);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(hint_);
  layout->addWidget(x_);
  layout->addLayout(grid, 1);
  layout->addLayout(bottom);
  return page;
}

QWidget* StudyWindow::endPage() {
  auto* page = new QWidget;
  auto* text = large(new QLabel(tr("That was the last one. Thank you.")), largeText_pt);
  text->setObjectName("studyEnd");
  text->setAlignment(Qt::AlignCenter);
  auto* close = largeButton(tr("Close"), "studyClose", largeText_pt, answerHeight_px);
  connect(close, &QPushButton::clicked, this, &QWidget::close);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(text, 1);
  layout->addWidget(close);
  return page;
}

void StudyWindow::begin() {
  watch_.start();
  showTrial();
}

void StudyWindow::showTrial() {
  const playback::Trial* trial = session_->trial();
  if (trial == nullptr) {
    watch_.stop();
    desk_.reset();
    pages_->setCurrentIndex(2);
    return;
  }
  desk_.emplace(*study_, *trial, 0, now_s());
  player_->lostSinceAsked();
  count_->setText((trial->practice ? tr("Practice %1 of %2") : tr("Trial %1 of %2"))
                      .arg(trial->number)
                      .arg(session_->record().plan.size()));
  if (desk_->physicalTarget()) x_->setText(tr("X is the real switch number %1").arg(desk_->physicalNumber()));
  pages_->setCurrentIndex(1);
  refresh();
}

void StudyWindow::refresh() {
  const bool may = desk_->mayAnswer();
  for (QPushButton* button : answers_) button->setEnabled(may);
  hint_->setText(may ? tr("Which one is X? Press each as often as you like.")
                     : tr("Press X and the others, then say which one is X."));
}

void StudyWindow::pressChoice(std::size_t choice) {
  if (!desk_) return;
  const playback::Trial& trial = desk_->trial();
  player_->press(trial.choices[choice], trial.mode);
  desk_->triedChoice(choice, now_s());
  refresh();
}

void StudyWindow::pressX() {
  if (!desk_ || desk_->physicalTarget()) return;
  const playback::Trial& trial = desk_->trial();
  player_->press(trial.choices[trial.target], trial.mode);
  desk_->triedX(now_s());
  refresh();
}

void StudyWindow::answer(std::size_t choice) {
  if (!desk_ || !desk_->mayAnswer()) return;
  Result<Done> kept = session_->record(desk_->answer(choice, now_s()));
  if (kept && session_->trial() == nullptr) kept = session_->end("complete");
  if (!kept) {
    hint_->setText(tr("Your answer is not kept yet: %1 Answer again.")
                       .arg(QString::fromStdString(kept.failure().sentence())));
    return;
  }
  showTrial();
}

void StudyWindow::stop() {
  if (QMessageBox::question(this, tr("Stop for good?"),
                            tr("Stop the study for good? Your answers are kept.")) != QMessageBox::Yes)
    return;
  if (Result<Done> ended = session_->end("stopped by the participant"); !ended) {
    hint_->setText(QString::fromStdString(ended.failure().sentence()));
    return;
  }
  close();
}

void StudyWindow::watchDevice() {
  if (!desk_ || !player_->lostSinceAsked()) return;
  Result<Done> noted = session_->interrupted("sound device lost");
  showTrial();
  hint_->setText(noted ? tr("The sound device went away. This trial begins anew.")
                       : QString::fromStdString(noted.failure().sentence()));
}

void StudyWindow::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (event->isAutoRepeat() || pages_->currentIndex() != 1) return QWidget::keyPressEvent(event);
  if (key == Qt::Key_X) return pressX();
  const int press = key - Qt::Key_1, choose = key - Qt::Key_A;
  if (press >= 0 && press < static_cast<int>(choices_.size()))
    return pressChoice(static_cast<std::size_t>(press));
  if (choose >= 0 && choose < static_cast<int>(answers_.size()))
    return answer(static_cast<std::size_t>(choose));
  QWidget::keyPressEvent(event);
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  watch_.stop();
  desk_.reset();
  emit finished();
  QWidget::closeEvent(event);
}

}  // namespace detent::editor
