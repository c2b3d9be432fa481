// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/study_window.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QVBoxLayout>

#include "editor/document/message_words.h"
#include "editor/study/study_words.h"

namespace detent::editor {

namespace {

constexpr int watch_ms = 30;
constexpr int consentText_pt = 18;

/// The text of a file as paragraphs: single line breaks become blanks, empty lines separate paragraphs.
QString flowing(const std::string& text) {
  QStringList paragraphs = QString::fromStdString(text).trimmed().split("\n\n");
  for (QString& paragraph : paragraphs) paragraph = paragraph.simplified();
  return paragraphs.join("\n\n");
}

}  // namespace

StudyWindow::StudyWindow(StudyWork work, QWidget* parent)
    : QWidget(parent, Qt::Window), work_(std::move(work)), language_(work_.language) {
  setObjectName("studyWindow");
  setWindowTitle(words("Study"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFocusPolicy(Qt::StrongFocus);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (rehearsal()) {
    auto* banner = new QLabel(words("REHEARSAL: there is no sound device, nothing is felt"));
    banner->setObjectName("studyBanner");
    banner->setAlignment(Qt::AlignCenter);
    banner->setStyleSheet("background: #b3261e; color: white; padding: 6px; font: bold 15pt;");
    layout->addWidget(banner);
  }
  pages_ = new QStackedWidget;
  layout->addWidget(pages_, 1);
  consent_ = consentPage();
  said_ = wordsPage();
  if (isTimed())
    question_ = timing_ = timingPage();
  else
    question_ = trial_ = trialPage();
  paused_ = pausePage();
  stop_ = stopPage();
  end_ = endPage();
  for (KeyedPage* page : {consent_, said_, static_cast<KeyedPage*>(question_), paused_, stop_, end_})
    pages_->addWidget(page);
  clock_.start();
  watch_.setInterval(watch_ms);
  connect(&watch_, &QTimer::timeout, this, &StudyWindow::watchDevice);
  if (!work_.consent) agree();  // agreed already
}

double StudyWindow::now_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }

// ---- pages

KeyedPage* StudyWindow::consentPage() {
  auto* page = new KeyedPage;
  page->addLongText("studyConsent", work_.consent ? flowing(work_.consent->text) : QString(), consentText_pt);
  consentTrouble_ = page->addText("studyConsentTrouble", {}, plainText_pt);
  consentTrouble_->setStyleSheet("color: #b3261e;");
  const QString yes = words("Y"), no = words("N");
  page->addButton({"studyBegin", words("I agree: begin"), {Qt::Key_A + yes[0].unicode() - 'A', yes}},
                  [this] { agree(); });
  page->addButton({"studyLeave", words("No, thank you"), {Qt::Key_A + no[0].unicode() - 'A', no}},
                  [this] { decline(); });
  page->addButton(closeButton("studyCloseUnasked"), [this] { close(); });
  return page;
}

KeyedPage* StudyWindow::wordsPage() {
  auto* page = new KeyedPage;
  saidText_ = page->addText("studyWords", {}, largeText_pt, Qt::AlignCenter, 1);
  page->addButton({"studyContinue", words("Go on"), enterKey()}, [this] { showTrial(); });
  return page;
}

TrialPage* StudyWindow::trialPage() {
  auto* page = new TrialPage(*work_.study, trialWords());
  addWaysOut(page);
  connect(page, &TrialPage::felt, this, &StudyWindow::feel);
  connect(page, &TrialPage::answered, this, [this](std::size_t choice) { answer(choice, {}); });
  connect(page, &TrialPage::rated, this, [this](double number) { answer(0, number); });
  connect(page, &TrialPage::unreadableNumber, this,
          [this] { tell(words("Type a number above 0, then Enter.")); });
  return page;
}

TimingPage* StudyWindow::timingPage() {
  auto* page = new TimingPage({words("Press here"), words("space bar"), words("%1 s left")}, !work_.sensor);
  addWaysOut(page);
  timed_ = new TimedTrials(
      *work_.study, *work_.player, page,
      {words("Hit"), words("Missed"), words("Stop."),
       words("No press fell within the time that counts. Please try again."),
       words("The presses were too close together: let go of the key each time. Please try again."),
       words("The button was not pressed far enough. Please try again."),
       words("The result is not saved yet. %1 Please try again.")},
      this);
  connect(timed_, &TimedTrials::kept, this, [this] {
    if (work_.session->trial() == nullptr) {
      if (const Result<Done> ended = work_.session->end("complete"); !ended)
        return showEnd(sentenceOf(ended.failure()));
    }
    showNext();
  });
  connect(timed_, &TimedTrials::away, this, &StudyWindow::tellAway);
  connect(timed_, &TimedTrials::back, this, [this] {
    showTrial();
    tell(words("The device is connected again. This question starts over."));
  });
  connect(timed_, &TimedTrials::failed, this, &StudyWindow::showEnd);
  return page;
}

void StudyWindow::addWaysOut(QuestionPage* page) {
  page->addBelow(page->makeButton(
      {"studyPause", words("Pause"), {Qt::Key_P, "P"}, plainText_pt, smallHeight_px}, [this] { pause(); }));
  page->addBelow(
      page->makeButton({"studyStop", words("Stop for good"), {Qt::Key_Q, "Q"}, plainText_pt, smallHeight_px},
                       [this] { askToStop(); }));
}

KeyedPage* StudyWindow::pausePage() {
  auto* page = new KeyedPage;
  page->addText("studyPauseWords",
                words("Pause for as long as you like. The question you were at will start over."),
                largeText_pt, Qt::AlignCenter, 1);
  page->addButton({"studyPauseOver", words("Go on"), enterKey()}, [this] { showTrial(); });
  page->addButton(
      {"studyLater",
       words("Stop now and continue another day"),
       {Qt::Key_L, "L"},
       plainText_pt,
       smallHeight_px},
      [this] { showEnd(words("Thank you. Next time you will continue with the question you were at.")); });
  return page;
}

KeyedPage* StudyWindow::stopPage() {
  auto* page = new KeyedPage;
  page->addText("studyStopWords", words("Stop for good? What you have answered is kept."), largeText_pt,
                Qt::AlignCenter, 1);
  page->addButton({"studyGoOn", words("No, go on"), enterKey()}, [this] { goOn(); });
  page->addButton({"studyStopNow", words("Yes, stop"), {Qt::Key_S, "S"}, plainText_pt, smallHeight_px},
                  [this] { stopForGood(); });
  return page;
}

KeyedPage* StudyWindow::endPage() {
  auto* page = new KeyedPage;
  endText_ = page->addText("studyEnd", {}, largeText_pt, Qt::AlignCenter, 1);
  page->addText("studyCall", words("Please call the experimenter."), plainText_pt);
  page->addButton(closeButton("studyClose"), [this] { close(); });
  return page;
}

PageButton StudyWindow::closeButton(const char* name) const {
  return {name, words("For the experimenter: close"), {Qt::Key_F12, "F12"}, smallText_pt, smallHeight_px};
}

// ---- words

QString StudyWindow::answerWords() const {
  const playback::StudyDesign& design = work_.study->design;
  if (playback::asksForX(design.kind)) return words("X is %1");
  if (design.kind == playback::StudyKind::rating) return words("%1 is better");
  switch (design.quantity) {
    case playback::LevelQuantity::peakForce:
      return words("%1 needs more force");
    case playback::LevelQuantity::eventSize:
      return words("%1 has the stronger click");
    case playback::LevelQuantity::travel:
      return words("%1 goes deeper");
    case playback::LevelQuantity::snap:
      return words("%1 snaps more");
    case playback::LevelQuantity::grainStrength:
      break;
  }
  return words("%1 feels rougher while it moves");
}

TrialWords StudyWindow::trialWords() const {
  TrialWords said;
  said.feelX = words("Feel X");
  said.feelOne = words("Feel %1");
  said.feelIt = words("Feel it");
  said.answer = answerWords();
  if (work_.study->design.kind == playback::StudyKind::sameDifferent)
    said.answers = {words("They are the same"), words("They differ")};
  said.space = words("space bar");
  said.enter = words("Enter");
  said.backspace = words("Backspace");
  said.takeBack = words("Delete");
  said.take = words("This is my number");
  said.least = words("1: I do not like it at all");
  said.most = words("7: I like it very much");
  return said;
}

QString StudyWindow::taskWords() const {
  const playback::StudyDesign& design = work_.study->design;
  if (playback::asksForX(design.kind))
    return words("X is one of those below. Feel X and the others, then say which one it is.");
  if (design.kind == playback::StudyKind::sameDifferent)
    return words("Feel both, then say whether they are the same. If you are not sure, guess.");
  if (design.kind == playback::StudyKind::threshold)
    return words("Feel both, then say which one has more. If you are not sure, guess.");
  if (isTimed()) {
    switch (design.task) {
      case playback::TimingTask::cue:
        return words("You will hear four even beats. Press with the fourth.");
      case playback::TimingTask::window:
        return words("A ball runs to the right. Press while its middle is between the two bars.");
      case playback::TimingTask::tapping:
        break;
    }
    return words(
               "Press again and again, as fast as you can, until you are told to stop: %1 seconds from your "
               "first press.")
        .arg(design.run_s);
  }
  if (design.scale == playback::RatingScale::pairwise)
    return words("Feel both, then say which one is better. There is no right or wrong.");
  if (design.scale == playback::RatingScale::preference)
    return words("Feel the button, then say how much you like it. There is no right or wrong.");
  return words(
      "Feel the button, then give a number for how strong it feels: what feels twice as strong gets twice "
      "the number. Any number above 0 will do.");
}

QString StudyWindow::howWords() const {
  if (work_.force)
    return (isTimed() ? words("Press the button under your finger.")
                      : words("Choose one, then press the button under your finger.")) +
           " " + words("Press Escape to switch the force off at once.");
  if (isTimed())
    return work_.sensor ? words("Press the button under your finger.")
                        : words("Press the space bar, or the large field on the screen.");
  return work_.sensor ? words("Choose one, then press the pad with your finger.")
                      : words("To feel a button under your finger, press its key or click it.");
}

/// Text about stimuli that were not pressed completely yet, or were released too early.
QString StudyWindow::unfeltWords() const {
  // the question of a scale has only this stimulus
  if (controller_->slotOfX() == 1) return words("First press the button to the end and let go.");
  QStringList missing;
  for (std::size_t slot = 0; slot <= controller_->slotOfX(); ++slot) {
    const bool isX = slot == controller_->slotOfX();
    if (controller_->feltOf(slot).whole > 0 || (isX && !controller_->hasX())) continue;
    const QString name = isX ? QStringLiteral("X") : QString::number(slot + 1);
    missing << (controller_->feltOf(slot).presses > 0 ? words("%1 (not pressed to the end yet)").arg(name)
                                                      : name);
  }
  return words("First press to the end and let go: %1.").arg(missing.join(", "));
}

// ---- at work

void StudyWindow::show(KeyedPage* page, At at) {
  pages_->setCurrentWidget(page);
  at_ = at;
  StudyProgress progress{at, 0, 0};
  if (work_.session) {
    progress.answered = work_.session->record().answers.size();
    progress.questions = work_.session->record().plan.size();
  }
  emit progressed(progress);
}

Result<Done> StudyWindow::openSession() {
  work_.start.utc_s = playback::systemClock_s();
  if (work_.consent)
    work_.start.consent = {work_.consent->language, work_.consent->sha256, work_.start.utc_s};
  Result<playback::ParticipantSession> session =
      playback::ParticipantSession::open(*work_.study, work_.participant, work_.start);
  if (!session) return session.failure();
  work_.session = std::make_unique<playback::ParticipantSession>(*std::move(session));
  return Done{};
}

void StudyWindow::agree() {
  if (!work_.session) {
    if (const Result<Done> opened = openSession(); !opened)
      return consentTrouble_->setText(studySentence(opened.failure()));
  }
  watch_.start();
  showIntroduction();
}

void StudyWindow::decline() {
  const playback::ConsentDecision decision{work_.consent->language, work_.consent->sha256,
                                           playback::systemClock_s()};
  if (const Result<Done> kept = playback::recordDeclined(work_.study->folder, decision); !kept)
    return consentTrouble_->setText(sentenceOf(kept.failure()));
  showEnd(words("Thank you for coming. Nothing about you was saved."));
}

void StudyWindow::showIntroduction() {
  const playback::Trial* trial = work_.session->trial();
  if (trial == nullptr) return showNext();
  restedBefore_ = trial->number;
  QString text = taskWords() + "\n\n" + howWords();
  if (trial->practice)
    text += "\n\n" + words("Questions for practice, which do not count: %1")
                         .arg(work_.study->design.practice - trial->number + 1);
  showWords(text, At::words);
}

/// Shows the next page after an answer: words before the first question that counts, a rest, the next
/// question, or the end.
void StudyWindow::showNext() {
  const playback::Trial* trial = work_.session->trial();
  if (trial == nullptr) return showEnd(words("That was the last question. Thank you."));
  if (trial->number == restedBefore_) return showTrial();
  const bool first = trial->number == work_.study->design.practice + 1;
  if (first && trial->number > 1) {
    restedBefore_ = trial->number;
    return showWords(words("That was the practice. From now on your answers count."), At::words);
  }
  if (!trial->breakBefore) return showTrial();
  restedBefore_ = trial->number;
  showWords(words("Time for a rest, as long as you like. You have answered %1 of %2.")
                .arg(work_.session->record().answers.size())
                .arg(work_.session->record().plan.size()),
            At::rest);
}

void StudyWindow::leaveQuestion() {
  controller_.reset();
  if (timed_ != nullptr) timed_->leave();
}

void StudyWindow::showWords(const QString& text, At at) {
  leaveQuestion();
  saidText_->setText(text);
  show(said_, at);
}

void StudyWindow::showTrial() {
  const playback::Trial* trial = work_.session->trial();
  if (trial == nullptr) return showNext();
  question_->showCount((trial->practice ? words("Practice: question %1 of %2") : words("Question %1 of %2"))
                           .arg(trial->number)
                           .arg(work_.session->record().plan.size()));
  question_->showTrouble({});
  if (isTimed()) {
    question_->showQuestion(QStringLiteral("<p><b>%1</b></p>").arg(taskWords()));
    show(question_, At::question);
    return timed_->show(*work_.session);
  }
  controller_.emplace(*work_.study, *trial, 0, now_s());
  work_.player->beginTrial();
  work_.player->takeTrouble();
  trial_->mark({});
  trial_->clearNumber();
  if (controller_->physicalTarget())
    trial_->showRealX(words("X is the real switch number %1").arg(controller_->physicalNumber()));
  show(trial_, At::question);
  refresh();
}

void StudyWindow::refresh() {
  const bool may = controller_->mayAnswer();
  trial_->allowAnswers(may);
  if (may && !away_) trial_->showTrouble({});
  const QString ask = may ? words("Now answer, or feel again as often as you like.") : taskWords();
  trial_->showQuestion(QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(ask, howWords()));
}

/// Puts a stimulus under the finger, and counts the presses so far for the previous one.
void StudyWindow::feel(std::size_t slot) {
  if (!controller_ || away_ || (slot == controller_->slotOfX() && !controller_->hasX())) return;
  controller_->felt(work_.player->takeFelt());
  work_.player->press(slot, controller_->buttonIn(slot), controller_->trial().mode);
  controller_->tried(slot, now_s());
  controller_->felt(work_.player->takeFelt());
  trial_->mark(slot);
  refresh();
}

void StudyWindow::answer(std::size_t choice, std::optional<double> rating) {
  if (!controller_ || away_) return;
  controller_->felt(work_.player->takeFelt());
  if (!controller_->mayAnswer()) return tell(unfeltWords());
  if (!playback::ratingFits(*work_.study, rating)) return tell(words("Type a number above 0, then Enter."));
  playback::Answer given = controller_->answer(choice, now_s());
  given.rating = rating;
  if (const Result<Done> kept = work_.session->record(given); !kept)
    return tell(words("Your answer is not saved yet. %1 Then answer again.").arg(sentenceOf(kept.failure())));
  controller_.reset();
  if (work_.session->trial() == nullptr) {
    if (const Result<Done> ended = work_.session->end("complete"); !ended)
      return showEnd(sentenceOf(ended.failure()));
  }
  showNext();
}

void StudyWindow::tell(const QString& trouble) { question_->showTrouble(trouble); }

/// Stimuli that were felt stay felt; a running timed trial ends.
void StudyWindow::askToStop() {
  if (timed_ != nullptr) timed_->leave();
  show(stop_, At::question);
}

/// Continues after the participant changed their mind about stopping.
void StudyWindow::goOn() {
  if (!isTimed()) return show(question_, At::question);
  if (const Result<Done> noted = work_.session->interrupted("stop not confirmed"); !noted)
    return showEnd(sentenceOf(noted.failure()));
  showTrial();
}

void StudyWindow::pause() {
  leaveQuestion();
  show(paused_, At::pause);
}

void StudyWindow::stopForGood() {
  if (const Result<Done> ended = work_.session->end("stopped by the participant"); !ended) {
    show(question_, At::question);
    return tell(sentenceOf(ended.failure()));
  }
  showEnd(words("Thank you. What you have answered is kept."));
}

void StudyWindow::showEnd(const QString& text) {
  watch_.stop();
  leaveQuestion();
  endText_->setText(text);
  show(end_, At::end);
}

/// An interrupted stimulus is repeated, once the device is back.
void StudyWindow::watchDevice() {
  if (!controller_) {
    if (!timed_) work_.player->takeFelt();  // discards presses, so that none accumulate between questions
    return;
  }
  controller_->felt(work_.player->takeFelt());
  if (!away_ && controller_->mayAnswer() != trial_->answersAllowed()) refresh();
  const playback::StudyTrouble trouble = work_.player->takeTrouble();
  if ((trouble != playback::StudyTrouble::none) == away_) return;
  away_ = !away_;
  if (!away_) {
    showTrial();
    return tell(words("The device is connected again. This question starts over."));
  }
  const Result<Done> noted = work_.session->interrupted(nameOf(trouble));
  trial_->allowAnswers(false);
  tellAway(trouble);
  if (!noted) tell(sentenceOf(noted.failure()));
}

void StudyWindow::tellAway(playback::StudyTrouble trouble) {
  show(question_, At::trouble);
  switch (trouble) {
    case playback::StudyTrouble::soundLost:
      return tell(words("The sound device was disconnected. Please call the experimenter."));
    case playback::StudyTrouble::forceLost:
      return tell(words("The force device was disconnected. Please call the experimenter."));
    case playback::StudyTrouble::forceStopped:
      return tell(words("The force is off. Please call the experimenter, who can switch it on with F9."));
    case playback::StudyTrouble::none:
    case playback::StudyTrouble::sensorUnplugged:
    case playback::StudyTrouble::sensorSilent:
    case playback::StudyTrouble::sensorStuck:
      break;
  }
  tell(words("The force sensor was disconnected. Please call the experimenter."));
}

void StudyWindow::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  const int key = event->key() == Qt::Key_Pause ? static_cast<int>(Qt::Key_P) : event->key();
  if (event->key() == Qt::Key_Escape) work_.player->stopForce();
  if (event->key() == Qt::Key_F9) work_.player->rearm();
  if (timed_ != nullptr) timed_->note(*event);
  const auto* page = static_cast<const KeyedPage*>(pages_->currentWidget());
  if (!page->press(key)) QWidget::keyPressEvent(event);
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  if (event->spontaneous() && at_ != At::end) {  // a participant cannot close the window: it pauses instead
    event->ignore();
    if (work_.session && work_.session->trial() != nullptr) pause();
    return;
  }
  watch_.stop();
  leaveQuestion();
  emit finished();
  QWidget::closeEvent(event);
}

}  // namespace detent::editor
