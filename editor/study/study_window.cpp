// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_window.h"

#include <QCloseEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include "editor/document/message_words.h"
#include "editor/feel/setup_widgets.h"

namespace detent::editor {

namespace {

constexpr int watch_ms = 30;
constexpr int largeText_pt = 22, plainText_pt = 15;
constexpr int pressHeight_px = 110, answerHeight_px = 70, smallHeight_px = 40;
constexpr int mostColumns = 5;
constexpr std::size_t mostListedKeys = 4;
constexpr int margin_px = 36, spacing_px = 18, mostWidth_px = 1100;

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
  button->setMinimumSize(button->sizeHint().width() + spacing_px, height_px);
  button->setFocusPolicy(Qt::NoFocus);  // the keys belong to the question
  return button;
}

QLabel* plainLabel(const QString& name, int points, Qt::Alignment alignment = Qt::AlignCenter) {
  auto* label = large(new QLabel, points);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setAlignment(alignment);
  return label;
}

QLabel* banner(const QString& text) {
  QLabel* label = plainLabel("studyBanner", plainText_pt);
  label->setText(text);
  label->setStyleSheet("background: #b3261e; color: white; padding: 6px; font-weight: bold;");
  return label;
}

/// A large button that stays down while it is under the finger; it acts when it goes down, not when it comes up.
QPushButton* feelButton(const QString& text, const QString& name) {
  QPushButton* button = largeButton(text, name, largeText_pt, pressHeight_px);
  button->setCheckable(true);
  button->setStyleSheet(
      "QPushButton:checked { border: 5px solid palette(highlight); border-radius: 4px; background: "
      "palette(button); }");
  QObject::connect(button, &QPushButton::clicked, button, [button] { button->setChecked(true); });
  return button;
}

/// "1, 2, 3", or "1 to 9" where they are many.
QString keysFrom(char first, std::size_t count) {
  QStringList keys;
  for (std::size_t i = 0; i < count; ++i) keys << QString(QChar(first + static_cast<char>(i)));
  return count <= mostListedKeys ? keys.join(", ")
                                 : StudyWindow::tr("%1 to %2").arg(keys.front(), keys.back());
}

/// The text of a file: its lines are broken anew, empty lines part paragraphs.
QString flowing(const QString& text) {
  QStringList paragraphs = text.trimmed().split("\n\n");
  for (QString& paragraph : paragraphs) paragraph = paragraph.simplified();
  return paragraphs.join("\n\n");
}

/// Its content in the middle, however wide the screen is.
QVBoxLayout* columnOf(QWidget* page) {
  auto* inner = new QWidget;
  inner->setMaximumWidth(mostWidth_px);
  auto* outer = new QHBoxLayout(page);
  outer->setContentsMargins(margin_px, margin_px, margin_px, margin_px);
  outer->addWidget(inner);
  auto* column = new QVBoxLayout(inner);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing_px);
  return column;
}

}  // namespace

StudyWindow::StudyWindow(StudyWork work, QWidget* parent)
    : QWidget(parent, Qt::Window), work_(std::move(work)) {
  setObjectName("studyWindow");
  setWindowTitle(tr("Study"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(onScreen(*this, {960, 680}));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (rehearsal()) layout->addWidget(banner(tr("REHEARSAL: there is no sound device, nothing is felt")));
  pages_ = new QStackedWidget;
  layout->addWidget(pages_, 1);
  trialPage_ = trialPage();
  stopPage_ = stopPage();
  endPage_ = endPage();
  for (QWidget* page : {consentPage(), trialPage_, stopPage_, endPage_}) pages_->addWidget(page);
  clock_.start();
  watch_.setInterval(watch_ms);
  connect(&watch_, &QTimer::timeout, this, &StudyWindow::watchDevice);
  if (!work_.session->record().answers.empty()) begin();  // agreed already
}

double StudyWindow::now_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }

// ---- pages

QWidget* StudyWindow::consentPage() {
  auto* page = new QWidget;
  QLabel* text = plainLabel("studyConsent", plainText_pt, Qt::AlignLeft | Qt::AlignVCenter);
  text->setText(flowing(work_.consent));
  auto* agree = largeButton(tr("I agree: begin"), "studyBegin", largeText_pt, answerHeight_px);
  auto* leave = largeButton(tr("No, thank you"), "studyLeave", plainText_pt, smallHeight_px);
  connect(agree, &QPushButton::clicked, this, &StudyWindow::begin);
  connect(leave, &QPushButton::clicked, this, &QWidget::close);
  QVBoxLayout* column = columnOf(page);
  column->addWidget(text, 1);
  column->addWidget(agree);
  column->addWidget(leave);
  return page;
}

QWidget* StudyWindow::trialPage() {
  auto* page = new QWidget;
  task_ = plainLabel("studyHint", plainText_pt);
  trouble_ = plainLabel("studyTrouble", plainText_pt);
  trouble_->setStyleSheet("color: #b3261e;");
  trouble_->hide();
  const bool physical = work_.study->design.targets == playback::TargetKind::physicalButton;
  x_ = feelButton(tr("Feel X"), "studyX");
  x_->setEnabled(!physical);
  connect(x_, &QPushButton::pressed, this, &StudyWindow::pressX);
  QVBoxLayout* column = columnOf(page);
  column->addWidget(task_);
  column->addWidget(trouble_);
  column->addWidget(x_);
  column->addLayout(choiceGrid(), 1);
  column->addLayout(bottomRow());
  return page;
}

QLayout* StudyWindow::choiceGrid() {
  const bool abx = work_.study->design.kind == playback::StudyKind::abx;
  const std::size_t count = abx ? 2 : work_.study->buttons.size();
  auto* grid = new QGridLayout;
  grid->setSpacing(spacing_px);
  for (std::size_t i = 0; i < count; ++i) {
    auto* press = feelButton(tr("Feel %1").arg(i + 1), QString("studyPress%1").arg(i + 1));
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
  return grid;
}

QLayout* StudyWindow::bottomRow() {
  count_ = plainLabel("studyCount", plainText_pt, Qt::AlignLeft | Qt::AlignVCenter);
  auto* pause = largeButton(tr("Pause"), "studyPause", plainText_pt, smallHeight_px);
  pause->setToolTip(tr("Close; the next start goes on at this very question"));
  connect(pause, &QPushButton::clicked, this, &QWidget::close);
  auto* stop = largeButton(tr("Stop for good"), "studyStop", plainText_pt, smallHeight_px);
  connect(stop, &QPushButton::clicked, this, [this] { pages_->setCurrentWidget(stopPage_); });
  auto* row = new QHBoxLayout;
  row->addWidget(count_, 1);
  row->addWidget(pause);
  row->addWidget(stop);
  return row;
}

QWidget* StudyWindow::stopPage() {
  auto* page = new QWidget;
  QLabel* text = plainLabel("studyStopWords", largeText_pt);
  text->setText(tr("Stop for good? What you have answered is kept."));
  auto* back = largeButton(tr("No, go on"), "studyGoOn", largeText_pt, answerHeight_px);
  auto* stop = largeButton(tr("Yes, stop"), "studyStopNow", plainText_pt, smallHeight_px);
  connect(back, &QPushButton::clicked, this, [this] { pages_->setCurrentWidget(trialPage_); });
  connect(stop, &QPushButton::clicked, this, &StudyWindow::stopForGood);
  QVBoxLayout* column = columnOf(page);
  column->addWidget(text, 1);
  column->addWidget(back);
  column->addWidget(stop);
  return page;
}

QWidget* StudyWindow::endPage() {
  auto* page = new QWidget;
  endWords_ = plainLabel("studyEnd", largeText_pt);
  endWords_->setText(tr("That was the last one. Thank you."));
  auto* close = largeButton(tr("Close"), "studyClose", largeText_pt, answerHeight_px);
  connect(close, &QPushButton::clicked, this, &QWidget::close);
  QVBoxLayout* column = columnOf(page);
  column->addWidget(endWords_, 1);
  column->addWidget(close);
  return page;
}

// ---- at work

void StudyWindow::begin() {
  watch_.start();
  showTrial();
}

void StudyWindow::showTrial() {
  const playback::Trial* trial = work_.session->trial();
  if (trial == nullptr) {
    watch_.stop();
    desk_.reset();
    pages_->setCurrentWidget(endPage_);
    return;
  }
  desk_.emplace(*work_.study, *trial, 0, now_s());
  work_.player->beginTrial();
  work_.player->troubleSinceAsked();
  mark(nullptr);
  trouble_->hide();
  count_->setText((trial->practice ? tr("Practice: question %1 of %2") : tr("Question %1 of %2"))
                      .arg(trial->number)
                      .arg(work_.session->record().plan.size()));
  if (desk_->physicalTarget()) x_->setText(tr("X is the real switch number %1").arg(desk_->physicalNumber()));
  pages_->setCurrentWidget(trialPage_);
  refresh();
}

void StudyWindow::refresh() {
  const bool may = desk_->mayAnswer();
  for (QPushButton* button : answers_) button->setEnabled(may);
  if (may && !away_) trouble_->hide();
  const QString keys = tr("Keys: %1 and X to feel, %2 to answer.")
                           .arg(keysFrom('1', choices_.size()), keysFrom('A', answers_.size()));
  const QString ask = may ? tr("Which one is X? Feel each as often as you like, then answer below it.")
                          : tr("X is one of those below. Feel X and the others, then say which one it is.");
  const QString how = work_.sensor ? tr("Choose one, then press the pad with your finger.")
                                   : tr("Click to feel it under your finger.");
  task_->setText(QStringLiteral("<p><b>%1</b></p><p>%2 %3</p>").arg(ask, how, keys));
}

/// Which one is under the finger.
void StudyWindow::mark(const QPushButton* underFinger) {
  x_->setChecked(x_ == underFinger);
  for (QPushButton* choice : choices_) choice->setChecked(choice == underFinger);
}

void StudyWindow::pressChoice(std::size_t choice) {
  if (!desk_) return;
  feel(choice);
  mark(choices_[choice]);
}

/// Puts it under the finger; what was done with the one before belongs to that one.
void StudyWindow::feel(std::size_t slot) {
  desk_->felt(work_.player->takeFelt());
  work_.player->press(slot, desk_->buttonIn(slot), desk_->trial().mode);
  desk_->tried(slot, now_s());
  desk_->felt(work_.player->takeFelt());
  refresh();
}

void StudyWindow::pressX() {
  if (!desk_ || desk_->physicalTarget()) return;
  feel(desk_->slotOfX());
  mark(x_);
}

void StudyWindow::answer(std::size_t choice) {
  if (!desk_ || away_) return;
  desk_->felt(work_.player->takeFelt());
  if (!desk_->mayAnswer()) return tell(unfeltWords());
  if (const Result<Done> kept = work_.session->record(desk_->answer(choice, now_s())); !kept)
    return tell(tr("Your answer is not kept yet. %1 Then answer again.").arg(sentenceOf(kept.failure())));
  if (work_.session->trial() == nullptr) {
    if (const Result<Done> ended = work_.session->end("complete"); !ended)
      endWords_->setText(endWords_->text() + "\n" + sentenceOf(ended.failure()));
  }
  showTrial();
}

void StudyWindow::tell(const QString& trouble) {
  trouble_->setText(trouble);
  trouble_->show();
}

void StudyWindow::stopForGood() {
  if (const Result<Done> ended = work_.session->end("stopped by the participant"); !ended) {
    pages_->setCurrentWidget(trialPage_);
    return tell(sentenceOf(ended.failure()));
  }
  close();
}

/// Which ones were not pressed through yet, and which of them were let go too early.
QString StudyWindow::unfeltWords() const {
  QStringList missing;
  for (std::size_t slot = 0; slot <= desk_->slotOfX(); ++slot) {
    if (desk_->feltOf(slot).whole > 0 || (slot == desk_->slotOfX() && desk_->physicalTarget())) continue;
    const QString name = slot == desk_->slotOfX() ? QStringLiteral("X") : QString::number(slot + 1);
    missing << (desk_->feltOf(slot).presses > 0 ? tr("%1 (not to the end yet)").arg(name) : name);
  }
  return tr("First press to the end and let go: %1.").arg(missing.join(", "));
}

/// What was half felt is asked anew, once the device is back.
void StudyWindow::watchDevice() {
  if (!desk_) return;
  desk_->felt(work_.player->takeFelt());
  if (desk_->mayAnswer() != answers_.front()->isEnabled()) refresh();
  const playback::StudyTrouble trouble = work_.player->troubleSinceAsked();
  if ((trouble != playback::StudyTrouble::none) == away_) return;
  away_ = !away_;
  trialPage_->setEnabled(!away_);
  if (!away_) {
    showTrial();
    return tell(tr("It is back. This question begins anew."));
  }
  const Result<Done> noted = work_.session->interrupted(nameOf(trouble));
  const QString words = trouble == playback::StudyTrouble::soundLost
                            ? tr("The sound device went away. Please call the experimenter.")
                            : tr("The force sensor went away. Please call the experimenter.");
  tell(noted ? words : sentenceOf(noted.failure()));
}

void StudyWindow::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (event->isAutoRepeat() || away_ || pages_->currentWidget() != trialPage_)
    return QWidget::keyPressEvent(event);
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
