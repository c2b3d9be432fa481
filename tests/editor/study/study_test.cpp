// SPDX-License-Identifier: GPL-3.0-or-later
// Studies in the window: made, worked through by a participant with keys and large buttons, followed by the
// experimenter.

#include <chrono>
#include <csignal>
#include <ctime>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>

#include <sys/wait.h>
#include <unistd.h>

#include "editor/study/experimenter_dialog.h"
#include "editor/study/study_maker.h"
#include "playback/offline/press_files.h"
#include "tests/editor/window_tests.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;

namespace {

/// The device under a participant's finger in a test.
struct Finger {
  bool sounding = true, lost = false;
  bool lets_go_early = false;
  std::vector<std::size_t> pressed, context;
  // timing
  bool sensed = false;
  bool stopped = false;  ///< emergency stop of the force device
  double ahead_s = 0;    ///< time by which this clock is ahead of the real one
  std::vector<playback::ContactClosing> closings;
  std::vector<double> beats_s;

  double clock_s() const {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count() + ahead_s;
  }
};

class FakePlayer : public playback::StudyPlayer {
 public:
  explicit FakePlayer(std::shared_ptr<Finger> finger) : finger_(std::move(finger)) {}
  bool sounding() const override { return finger_->sounding; }
  std::string device() const override { return finger_->sounding ? "test device" : ""; }
  playback::StudyRoute route() const override {
    playback::StudyRoute route{"", "", "test device, 48000 Hz, 64 frames"};
    route.timing = playback::TimingRoute{"sensor: a test", "picture: a test", {}};
    return route;
  }
  void beginTrial() override { done_ = {}; }
  void place(std::size_t, std::size_t, playback::FeedbackMode) override {}
  bool sensed() const override { return finger_->sensed; }
  double clock_s() const override { return finger_->clock_s(); }
  std::vector<playback::ContactClosing> takeClosings() override {
    if (!finger_->closings.empty()) done_ = {1, 1, 1.5, 3};
    return std::exchange(finger_->closings, {});
  }
  void stopForce() override { finger_->stopped = true; }
  void rearm() override { finger_->stopped = false; }
  void soundBeats(const std::vector<double>& delays_s) override { finger_->beats_s = delays_s; }
  void press(std::size_t slot, std::size_t button, playback::FeedbackMode) override {
    finger_->pressed.push_back(button);
    finger_->context.push_back(slot);
    done_ = {1, finger_->lets_go_early ? 0U : 1U, 1.5, 3};
  }
  playback::Felt takeFelt() override { return std::exchange(done_, {}); }
  playback::StudyTrouble takeTrouble() override {
    if (finger_->stopped) return playback::StudyTrouble::forceStopped;
    return finger_->lost ? playback::StudyTrouble::soundLost : playback::StudyTrouble::none;
  }

 private:
  playback::Felt done_;
  std::shared_ptr<Finger> finger_;
};

/// Chooses the participants' task.
void choose(StudyMaker& maker, playback::StudyKind kind) {
  auto* const kinds = maker.findChild<QComboBox*>("makerKind");
  kinds->setCurrentIndex(kinds->findData(static_cast<int>(kind)));
}

/// A study of two buttons, four questions, in a folder of its own, with the experimenter's view on it.
struct Rig {
  QTemporaryDir folder;
  std::shared_ptr<Finger> finger = std::make_shared<Finger>();
  playback::StudyPlayerSettings requested;
  std::optional<playback::ForceDeviceChoice> force;  ///< device of "Feel it"
  ButtonDocument a{tactileButton()}, b{linearButton()};
  std::unique_ptr<ExperimenterDialog> dialog;
  QString study;

  Rig() {
    study = folder.filePath("clicks");
    StudyContext context;
    context.force = [this] { return Result<std::optional<playback::ForceDeviceChoice>>(force); };
    context.documents = [this] { return std::vector<ButtonDocument*>{&a, &b}; };
    context.open = [this](const playback::Study&, const playback::StudyPlayerSettings& settings) {
      requested = settings;
      finger->sounding = !settings.rehearse;
      return Result<std::unique_ptr<playback::StudyPlayer>>(std::make_unique<FakePlayer>(finger));
    };
    dialog = std::make_unique<ExperimenterDialog>(context);
    dialog->show();
  }
  void makeStudy(int trials = 4) {
    StudyMaker maker({&a, &b}, {});
    maker.findChild<QuantityField*>("makerTrials")->setValue(trials);
    maker.findChild<QuantityField*>("makerPractice")->setValue(0);
    maker.setFolder(study);
    QSignalSpy made(&maker, &StudyMaker::made);
    maker.findChild<QPushButton*>("makerMake")->click();
    QVERIFY2(made.count() == 1, qPrintable(maker.findChild<QLabel*>("makerTrouble")->text()));
    dialog->showStudy(study);
  }
  /// One interval of 0.4 s, a window of 0.12 s, runs of 3 s.
  void makeTimed(playback::TimingTask task, int trials) {
    StudyMaker maker({&a}, {});
    choose(maker, playback::StudyKind::timing);
    maker.findChild<QComboBox*>("makerTask")->setCurrentIndex(static_cast<int>(task));
    maker.findChild<QLineEdit*>("makerIntervals")->setText("0.4");
    maker.findChild<QLineEdit*>("makerWindows")->setText("0.12");
    maker.findChild<QuantityField*>("makerRun")->setValue(3);
    maker.findChild<QuantityField*>("makerTrials")->setValue(trials);
    maker.findChild<QuantityField*>("makerPractice")->setValue(0);
    maker.setFolder(study);
    maker.findChild<QPushButton*>("makerMake")->click();
    QVERIFY2(QDir(study).exists(), qPrintable(maker.findChild<QLabel*>("makerTrouble")->text() +
                                              maker.findChild<QLabel*>("makerLength")->text()));
    dialog->showStudy(study);
    QVERIFY2(trouble().isEmpty(), qPrintable(trouble()));
  }
  void answersBy(int choice) { dialog->findChild<QComboBox*>("studyAnswers")->setCurrentIndex(choice); }
  QString trouble() { return dialog->findChild<QLabel*>("studyTrouble")->text(); }
  QString cell(int row, int column) {
    const auto* item = dialog->findChild<QTableWidget*>("studyPeople")->item(row, column);
    return item != nullptr ? item->text() : QString();
  }
  StudyWindow* begin(const QString& participant = "P01") {
    dialog->findChild<QLineEdit*>("studyParticipant")->setText(participant);
    dialog->findChild<QPushButton*>("studyStart")->click();
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* window = qobject_cast<StudyWindow*>(widget); window && window->isVisible()) return window;
    return nullptr;
  }
  std::vector<playback::ParticipantRecord> records() {
    return *playback::readParticipants(*playback::openStudy(study.toStdString()));
  }
  playback::ParticipantRecord record() { return records().front(); }
  const playback::Trial* next(const playback::ParticipantRecord& r) { return r.next(); }
};

QPushButton* buttonIn(StudyWindow* window, const char* name) { return window->findChild<QPushButton*>(name); }

/// Agrees to the consent and reads the instructions.
void agree(StudyWindow* window) {
  if (buttonIn(window, "studyBegin")->isVisible()) QTest::keyClick(window, Qt::Key_Y);
  if (buttonIn(window, "studyContinue")->isVisible()) QTest::keyClick(window, Qt::Key_Return);
}

void feelAll(StudyWindow* window) {
  for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_X}) QTest::keyClick(window, key);
}

/// The whole process, every thread of it, does nothing for so long.
void standStill(int still_ms) {
  const pid_t self = getpid();
  const pid_t child = fork();
  QVERIFY(child >= 0);
  if (child == 0) {
    const timespec still{0, 1000000L * still_ms};
    kill(self, SIGSTOP);
    nanosleep(&still, nullptr);
    kill(self, SIGCONT);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
}

}  // namespace

class StudyTest : public QObject {
  Q_OBJECT

 private slots:
  /// A failed test leaves its window to none of the others.
  void cleanup() {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (qobject_cast<StudyWindow*>(widget) != nullptr) delete widget;
  }

  void aStudyIsMadeOfWhatIsShown() {
    Rig rig;
    StudyMaker maker({&rig.a, &rig.b, &rig.a}, {});
    auto* make = maker.findChild<QPushButton*>("makerMake");
    QVERIFY(!make->isEnabled());  // no folder yet
    maker.setFolder(rig.study);
    QVERIFY(make->isEnabled());
    const QString words = maker.findChild<QLabel*>("makerLength")->text();
    QVERIFY2(words.contains("34"), qPrintable(words));  // 3 pairs x 10 + 4 for practice
    auto* list = maker.findChild<QListWidget*>("makerButtons");
    QVERIFY(list->item(0)->text() != list->item(2)->text());
    list->item(1)->setCheckState(Qt::Unchecked);
    list->item(2)->setCheckState(Qt::Unchecked);
    QVERIFY(!make->isEnabled());
    list->item(1)->setCheckState(Qt::Checked);
    QSignalSpy made(&maker, &StudyMaker::made);
    make->click();
    QCOMPARE(made.count(), 1);
    const auto study = playback::openStudy(rig.study.toStdString());
    QVERIFY(study && study->buttons.size() == 2);
    QVERIFY(study->buttons[0].button == tactileButton());

    StudyMaker again({&rig.a, &rig.b}, {});
    again.setFolder(rig.study);
    again.findChild<QPushButton*>("makerMake")->click();
    QVERIFY(again.findChild<QLabel*>("makerTrouble")->text().contains("clicks"));
  }

  // The sound of a press, with the options of detent-play study new.
  void aStudyHasTheSoundThatWasChosen() {
    Rig rig;
    const QString recording = rig.folder.filePath("click.wav");
    QVERIFY(playback::writeSoundFile(std::vector<float>(480, 0.25F), 48000, recording.toStdString()).ok());
    const auto made = [&](StudyMaker& maker, const char* name) {
      maker.setFolder(rig.folder.filePath(name));
      maker.findChild<QPushButton*>("makerMake")->click();
      return playback::openStudy(rig.folder.filePath(name).toStdString());
    };
    StudyMaker maker({&rig.a, &rig.b}, {});
    maker.show();
    maker.setFolder(rig.folder.filePath("heard"));
    auto* sound = maker.findChild<QComboBox*>("makerSound");
    auto* make = maker.findChild<QPushButton*>("makerMake");
    auto* delay = maker.findChild<QuantityField*>("makerSoundDelay");
    QVERIFY(!delay->isVisible() && make->isEnabled());
    sound->setCurrentIndex(2);
    QVERIFY(delay->isVisible() && maker.findChild<QLineEdit*>("makerRecording")->isVisible());
    QVERIFY(!make->isEnabled());  // which recording?
    maker.findChild<QLineEdit*>("makerRecording")->setText(rig.folder.filePath("gone.wav"));
    make->click();
    QVERIFY2(maker.findChild<QLabel*>("makerTrouble")->text().contains("gone.wav"),
             qPrintable(maker.findChild<QLabel*>("makerTrouble")->text()));
    maker.findChild<QLineEdit*>("makerRecording")->setText(recording);
    delay->setFocus();
    delay->selectAll();
    QTest::keyClicks(delay->findChild<QLineEdit*>(), "501");
    QVERIFY(!make->isEnabled());
    delay->setValue(8);
    maker.findChild<QuantityField*>("makerSoundLevel")->setValue(-6);
    const auto heard = made(maker, "heard");
    QVERIFY(heard.ok());
    QCOMPARE(heard->design.sound.source, std::string("sound.wav"));
    QCOMPARE(heard->design.sound.delay_ms, 8.0);
    QCOMPARE(heard->design.sound.level_dB, -6.0);
    QCOMPARE(playback::pressSoundOf(*heard)->samples.size(), std::size_t{480});

    StudyMaker vibrating({&rig.a, &rig.b}, {});
    vibrating.findChild<QComboBox*>("makerSound")->setCurrentIndex(1);
    const auto rendered = made(vibrating, "rendered");
    QVERIFY(rendered.ok() && rendered->design.sound.source == playback::renderedSound);
    StudyMaker silent({&rig.a, &rig.b}, {});
    const auto quiet = made(silent, "silent");
    QVERIFY(quiet.ok() && quiet->design.sound.source.empty());
    if (const QString pictures = qEnvironmentVariable("DETENT_PICTURES"); !pictures.isEmpty()) {
      StudyMaker shown({&rig.a, &rig.b}, {});
      shown.show();
      shown.findChild<QComboBox*>("makerSound")->setCurrentIndex(2);
      shown.grab().save(pictures + "/maker.png");
    }
  }

  void aFolderWithoutAStudyIsSaid() {
    Rig rig;
    rig.dialog->showStudy(rig.folder.path());
    QVERIFY(!rig.trouble().isEmpty());
    QVERIFY(!rig.dialog->findChild<QPushButton*>("studyStart")->isEnabled());
  }

  void aParticipantAnswersByKeys() {
    Rig rig;
    rig.makeStudy();
    QCOMPARE(rig.dialog->findChild<QLineEdit*>("studyParticipant")->text(), QString("P01"));
    QPointer<StudyWindow> window = rig.begin();
    QVERIFY(window);
    QVERIFY(window->findChild<QLabel*>("studyBanner") == nullptr);
    QVERIFY(buttonIn(window, "studyBegin")->isVisible());
    QTest::keyClick(window, Qt::Key_A);  // no key answers before the trial begins
    QVERIFY(rig.records().empty());      // nor is anybody in a journal who has not agreed
    agree(window);
    for (std::size_t i = 0; i < 4; ++i) {
      QVERIFY(!buttonIn(window, "studyAnswer1")->isEnabled());
      QTest::keyClick(window, Qt::Key_A);
      QCOMPARE(rig.record().answers.size(), i);
      feelAll(window);
      QVERIFY(buttonIn(window, "studyAnswer1")->isEnabled());
      QTest::keyClick(window, Qt::Key_B);
      QCOMPARE(rig.record().answers.size(), i + 1);  // on the disk before the next question is shown
    }
    const playback::ParticipantRecord record = rig.record();
    QVERIFY(record.complete());
    for (std::size_t i = 0; i < 4; ++i) {
      const playback::Trial& trial = record.plan[i];
      QCOMPARE(record.answers[i].answer.choice, std::size_t{1});
      QCOMPARE(rig.finger->pressed[3 * i], trial.choices[0]);
      QCOMPARE(rig.finger->pressed[3 * i + 1], trial.choices[1]);
      QCOMPARE(rig.finger->pressed[3 * i + 2], trial.choices[trial.target]);
    }
    QVERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());
    buttonIn(window, "studyClose")->click();
    QTRY_VERIFY(!window);
    QTRY_VERIFY(rig.cell(0, 1).contains("complete"));
    QCOMPARE(rig.dialog->findChild<QLineEdit*>("studyParticipant")->text(), QString("P02"));
  }

  /// The sensor, not the key, says what was felt; each stimulus keeps its own lock.
  void whatWasLetGoTooEarlyIsNotAnswered() {
    Rig rig;
    rig.makeStudy();
    StudyWindow* window = rig.begin();
    agree(window);
    rig.finger->lets_go_early = true;
    feelAll(window);
    QTest::keyClick(window, Qt::Key_A);
    QVERIFY(rig.record().answers.empty());
    QVERIFY(!buttonIn(window, "studyAnswer1")->isEnabled());
    const QString words = window->findChild<QLabel*>("studyTrouble")->text();
    for (const char* name : {"1", "2", "X"}) QVERIFY2(words.contains(name), qPrintable(words));
    rig.finger->lets_go_early = false;
    feelAll(window);
    QCOMPARE(rig.finger->context.back(), std::size_t{2});
    QVERIFY(!window->findChild<QLabel*>("studyTrouble")->isVisible());
    QTest::keyClick(window, Qt::Key_A);
    const playback::Answer answer = rig.record().answers.front().answer;
    QCOMPARE(answer.feltX.presses, std::size_t{2});
    QCOMPARE(answer.feltX.whole, std::size_t{1});
    window->close();
  }

  void noLabelIsShown() {
    Rig rig;
    rig.makeStudy();
    StudyWindow* window = rig.begin();
    agree(window);
    QStringList texts{window->windowTitle()};
    for (const QLabel* label : window->findChildren<QLabel*>()) texts << label->text() << label->toolTip();
    for (const QPushButton* button : window->findChildren<QPushButton*>())
      texts << button->text() << button->toolTip() << button->accessibleName();
    for (const QString& text : texts)
      for (const char* label : {"tactile", "linear", "clicks"})
        QVERIFY2(!text.contains(label), qPrintable(text));
    window->close();
  }

  void theLargeButtonsWork() {
    Rig rig;
    rig.makeStudy();
    StudyWindow* window = rig.begin();
    agree(window);
    for (const char* name : {"studyPress1", "studyPress2", "studyX"}) {
      auto* button = buttonIn(window, name);
      QVERIFY(button->height() >= 80);
      QTest::mousePress(button, Qt::LeftButton);
      QVERIFY(button->isChecked());  // felt at once, not on release
      QTest::mouseRelease(button, Qt::LeftButton);
      QVERIFY(button->isChecked());
    }
    QVERIFY(!buttonIn(window, "studyPress1")->isChecked());
    QCOMPARE(rig.finger->pressed.size(), std::size_t{3});
    buttonIn(window, "studyAnswer2")->click();
    QCOMPARE(rig.record().answers.size(), std::size_t{1});
    window->close();
  }

  void aPauseGoesOnAtTheVeryQuestion() {
    Rig rig;
    rig.makeStudy();
    QPointer<StudyWindow> window = rig.begin();
    agree(window);
    feelAll(window);
    QTest::keyClick(window, Qt::Key_A);
    QTest::keyClick(window, Qt::Key_Pause);  // the Pause key does what the button and P do
    QVERIFY(buttonIn(window, "studyPauseOver")->isVisible());
    QTest::keyClick(window, Qt::Key_1);
    QCOMPARE(rig.finger->pressed.size(), std::size_t{3});
    QTest::keyClick(window, Qt::Key_Return);
    QVERIFY(window->findChild<QLabel*>("studyCount")->isVisible());
    QTest::keyClick(window, Qt::Key_P);
    QTest::keyClick(window, Qt::Key_L);
    QVERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());
    QTest::keyClick(window, Qt::Key_F12);
    QTRY_VERIFY(!window);
    window = rig.begin();
    QVERIFY(window);
    QVERIFY(!buttonIn(window, "studyBegin")->isVisible());  // agreed already
    QTest::keyClick(window, Qt::Key_Return);
    QVERIFY(window->findChild<QLabel*>("studyCount")->text().contains("2"));
    window->close();
  }

  void stoppingForGoodNeedsAConfirmation() {
    Rig rig;
    rig.makeStudy();
    QPointer<StudyWindow> window = rig.begin();
    agree(window);
    feelAll(window);
    QTest::keyClick(window, Qt::Key_A);
    buttonIn(window, "studyStop")->click();
    QTest::keyClick(window, Qt::Key_1);  // no question is shown, so no key presses a button
    QCOMPARE(rig.finger->pressed.size(), std::size_t{3});
    buttonIn(window, "studyGoOn")->click();
    QVERIFY(window->findChild<QLabel*>("studyHint")->isVisible());
    QTest::keyClick(window, Qt::Key_Q);
    QTest::keyClick(window, Qt::Key_S);
    QVERIFY(rig.record().endedEarly);
    QVERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());  // not what is behind the window
    QTest::keyClick(window, Qt::Key_F12);
    QTRY_VERIFY(!window);
    QTRY_VERIFY(rig.cell(0, 1).contains("ended early"));
  }

  void aFinishedParticipantGetsNoFurtherQuestions() {
    Rig rig;
    rig.makeStudy();
    rig.answersBy(3);
    rig.begin("P01");
    QVERIFY(rig.begin("P01") == nullptr);
    QVERIFY(rig.trouble().contains("P01"));
  }

  void aLostDeviceIsMarked() {
    Rig rig;
    rig.makeStudy();
    StudyWindow* window = rig.begin();
    agree(window);
    feelAll(window);
    rig.finger->lost = true;
    QTRY_VERIFY(window->findChild<QLabel*>("studyTrouble")->text().contains("disconnected"));
    QTest::keyClick(window, Qt::Key_A);
    QVERIFY(rig.record().answers.empty());
    QTest::qWait(250);
    QCOMPARE(rig.record().interruptions, std::size_t{1});  // counted once, however long the device is away
    rig.finger->lost = false;
    QTRY_VERIFY(window->findChild<QLabel*>("studyTrouble")->text().contains("connected again"));
    QVERIFY(!buttonIn(window, "studyAnswer1")->isEnabled());  // anew
    feelAll(window);
    QTest::keyClick(window, Qt::Key_A);
    QCOMPARE(rig.record().answers.front().interruptions, std::size_t{1});
    window->close();
  }

  void aRehearsalIsMarked() {
    Rig rig;
    rig.makeStudy();
    rig.answersBy(1);
    StudyWindow* window = rig.begin();
    QVERIFY(rig.requested.rehearse);
    QVERIFY(window->findChild<QLabel*>("studyBanner")->text().contains("REHEARSAL"));
    agree(window);
    feelAll(window);
    QTest::keyClick(window, Qt::Key_A);
    QVERIFY(rig.record().answers.front().kind == playback::SessionKind::rehearsal);
    window->close();
    QTRY_VERIFY(rig.cell(0, 2).contains("REHEARSAL"));
  }

  void theProgramAnswersAndSaysSo() {
    Rig rig;
    rig.makeStudy();
    rig.answersBy(3);
    QVERIFY(rig.begin() == nullptr);
    QVERIFY2(rig.trouble().isEmpty(), qPrintable(rig.trouble()));
    QCOMPARE(rig.cell(0, 2), QString("SIMULATED"));
    QVERIFY(rig.cell(0, 1).contains("complete"));
    const playback::ParticipantRecord record = rig.record();
    for (std::size_t i = 0; i < record.answers.size(); ++i)
      QCOMPARE(record.answers[i].answer.choice, record.plan[i].target);
  }

  void idsThatCouldNameAPersonAreRefused() {
    Rig rig;
    rig.makeStudy();
    QVERIFY(rig.begin("Anna Schmidt") == nullptr);
    QVERIFY(rig.trouble().contains("Anna Schmidt"));
  }

  void twoParticipantsAtOnceAreRefused() {
    Rig rig;
    rig.makeStudy();
    StudyWindow* window = rig.begin("P01");
    rig.dialog->findChild<QLineEdit*>("studyParticipant")->setText("P02");
    rig.dialog->findChild<QPushButton*>("studyStart")->click();
    QVERIFY(rig.trouble().contains("is answering"));
    window->close();
  }

  void rainIsPlayedWhereItMasks() {
    Rig rig;
    rig.makeStudy();
    auto* headphones = rig.dialog->findChild<QLineEdit*>("studyHeadphones");
    QVERIFY(!headphones->isVisible());
    rig.dialog->findChild<QComboBox*>("studyListening")->setCurrentIndex(1);
    QVERIFY(headphones->isVisible());
    headphones->setText("USB headphones");
    StudyWindow* window = rig.begin();
    agree(window);
    QVERIFY(rig.requested.player.masking.level > 0);
    QCOMPARE(rig.requested.player.masking.device, std::string("USB headphones"));
    QVERIFY(rig.record().sessions.front().listening == playback::Listening::masked);
    QCOMPARE(rig.record().sessions.front().noiseLevel, rig.requested.player.masking.level);
    window->close();
  }

  void noThankYouIsNoUnfinishedParticipant() {
    Rig rig;
    rig.makeStudy();
    QPointer<StudyWindow> window = rig.begin();
    QTest::keyClick(window, Qt::Key_N);
    QVERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());
    QTest::keyClick(window, Qt::Key_F12);
    QTRY_VERIFY(!window);
    QVERIFY(rig.records().empty());
    QCOMPARE(playback::declinedIn(rig.study.toStdString()), std::size_t{1});
    QCOMPARE(rig.dialog->findChild<QLineEdit*>("studyParticipant")->text(), QString("P01"));
  }

  void aLongConsentIsReadByKeys() {
    Rig rig;
    rig.makeStudy();
    QFile text(rig.study + "/consent.txt");
    QVERIFY(text.open(QIODevice::WriteOnly));
    for (int i = 0; i < 200; ++i) text.write("What you agree to is this.\n\n");
    text.close();
    StudyWindow* window = rig.begin();
    QVERIFY(window->height() <= window->screen()->geometry().height());
    const QLabel* words = window->findChild<QLabel*>("studyConsent");
    const int before = words->mapTo(window, QPoint(0, 0)).y();
    QTest::keyClick(window, Qt::Key_PageDown);
    QVERIFY(words->mapTo(window, QPoint(0, 0)).y() < before - 100);
    QVERIFY(buttonIn(window, "studyLeave")->size() ==
            buttonIn(window, "studyBegin")->size());  // neither is the easier one
    window->close();
  }

  void whatWasAgreedToStandsInTheJournal() {
    Rig rig;
    rig.makeStudy();
    StudyWindow* window = rig.begin();
    QVERIFY(window->findChild<QLabel*>("studyConsent")->text().contains("virtual buttons"));
    agree(window);
    const auto text = playback::consentIn(rig.study.toStdString(), "en");
    const auto kept = rig.record().consent;
    QVERIFY(kept && text);
    QCOMPARE(kept->sha256, text->sha256);
    QCOMPARE(kept->language, std::string("en"));
    QVERIFY(kept->utc_s > 1.6e9);
    window->close();
  }

  /// The station covers the screen and nothing of the program is behind it; afterwards all is as it was.
  void nothingIsBehindTheStation() {
    Rig rig;
    rig.makeStudy();
    QWidget other;
    other.show();
    QPointer<StudyWindow> window = rig.begin();
    QVERIFY(window->isFullScreen());
    QVERIFY(!rig.dialog->isVisible() && !other.isVisible());
    QCOMPARE(window->windowTitle(), QString("Study"));
    agree(window);
    QCloseEvent fromOutside;
    QGuiApplication::sendEvent(window->windowHandle(), &fromOutside);  // Alt+F4
    QVERIFY(window && window->isVisible());
    QVERIFY(buttonIn(window, "studyPauseOver")->isVisible());
    QTest::keyClick(window, Qt::Key_L);
    QTest::keyClick(window, Qt::Key_F12);
    QTRY_VERIFY(!window);
    QVERIFY(rig.dialog->isVisible() && other.isVisible());
  }

  /// editor_study_two_screens runs it where there are two.
  void theExperimenterDialogStaysOnAScreenOfItsOwn() {
    const QList<QScreen*> screens = QGuiApplication::screens();
    if (screens.size() < 2) QSKIP("there is one screen");
    Rig rig;
    rig.makeStudy();
    QWidget other;
    other.show();
    QVERIFY(rig.dialog->findChild<QComboBox*>("studyScreen")->isVisible());
    StudyWindow* window = rig.begin();
    QCOMPARE(window->geometry(), screens.last()->geometry());
    QVERIFY(rig.dialog->isVisible() && !other.isVisible());
    agree(window);
    feelAll(window);
    QTest::keyClick(window, Qt::Key_A);
    const QString words = rig.dialog->findChild<QLabel*>("studyProgress")->text();
    QVERIFY2(words.contains("P01") && words.contains("1 of 4"), qPrintable(words));
    window->close();
    QVERIFY(other.isVisible());
  }

  void practiceAndRestsAreSaid() {
    Rig rig;
    StudyMaker maker({&rig.a, &rig.b}, {});
    maker.findChild<QuantityField*>("makerTrials")->setValue(51);
    maker.findChild<QuantityField*>("makerPractice")->setValue(1);
    maker.setFolder(rig.study);
    maker.findChild<QPushButton*>("makerMake")->click();
    rig.dialog->showStudy(rig.study);
    StudyWindow* window = rig.begin();
    const auto words = [&] { return window->findChild<QLabel*>("studyWords"); };
    QTest::keyClick(window, Qt::Key_Y);
    QVERIFY(words()->isVisible() && words()->text().contains("practice"));
    for (int i = 0; i < 52; ++i) {
      if (i == 1) QVERIFY(words()->isVisible() && words()->text().contains("count"));
      if (i == 51)
        QVERIFY2(words()->isVisible() && words()->text().contains("51 of 52"), qPrintable(words()->text()));
      if (words()->isVisible()) QTest::keyClick(window, Qt::Key_Return);
      feelAll(window);
      QTest::keyClick(window, Qt::Key_A);
    }
    QVERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());
    QVERIFY(rig.record().complete());
    window->close();
  }

  void aThresholdStudyRunsInTheWindow() {
    Rig rig;
    StudyMaker maker({&rig.a}, {});
    choose(maker, playback::StudyKind::threshold);
    QCOMPARE(maker.findChild<QuantityField*>("makerTrials")->value(), 60.0);
    maker.findChild<QuantityField*>("makerTrials")->setValue(3);
    maker.findChild<QuantityField*>("makerPractice")->setValue(0);
    maker.setFolder(rig.study);
    maker.findChild<QPushButton*>("makerMake")->click();
    rig.dialog->showStudy(rig.study);
    StudyWindow* window = rig.begin();
    agree(window);
    QVERIFY(buttonIn(window, "studyX") == nullptr);
    QVERIFY(buttonIn(window, "studyAnswer1")->text().contains("force"));
    for (int i = 0; i < 3; ++i) {
      QTest::keyClick(window, Qt::Key_A);  // unfelt
      QCOMPARE(rig.record().answers.size(), static_cast<std::size_t>(i));
      QTest::keyClick(window, Qt::Key_1);
      QTest::keyClick(window, Qt::Key_2);
      QTest::keyClick(window, Qt::Key_B);
    }
    QVERIFY(rig.record().complete());
    window->close();
  }

  void scaleQuestionsRunInTheWindow() {
    for (const int scale : {0, 1, 2}) {
      Rig rig;
      StudyMaker maker({&rig.a, &rig.b}, {});
      choose(maker, playback::StudyKind::rating);
      maker.findChild<QComboBox*>("makerScale")->setCurrentIndex(scale);
      maker.findChild<QuantityField*>("makerTrials")->setValue(1);
      maker.findChild<QuantityField*>("makerPractice")->setValue(0);
      maker.setFolder(rig.study);
      maker.findChild<QPushButton*>("makerMake")->click();
      rig.dialog->showStudy(rig.study);
      StudyWindow* window = rig.begin();
      agree(window);
      const int questions = scale == 2 ? 1 : 2;
      for (int i = 0; i < questions; ++i) {
        if (scale == 2)
          for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_A}) QTest::keyClick(window, key);
        if (scale == 0) {
          QTest::keyClick(window, Qt::Key_5);  // unfelt
          for (const Qt::Key key : {Qt::Key_Space, Qt::Key_5}) QTest::keyClick(window, key);
        }
        if (scale == 1) {
          QTest::keyClick(window, Qt::Key_Space);
          QTest::keyClick(window, Qt::Key_Return);  // Enter without a typed number does nothing
          QVERIFY(window->findChild<QLabel*>("studyTrouble")->isVisible());
          for (const Qt::Key key :
               {Qt::Key_7, Qt::Key_Backspace, Qt::Key_2, Qt::Key_Comma, Qt::Key_5, Qt::Key_Enter})
            QTest::keyClick(window, key);
        }
      }
      const playback::ParticipantRecord record = rig.record();
      QVERIFY(record.complete());
      if (scale == 0) QCOMPARE(record.answers[1].answer.rating.value(), 5.0);
      if (scale == 1) QCOMPARE(record.answers[1].answer.rating.value(), 2.5);
      window->close();
    }
  }

  // ---- timing

  void aPressWithTheCueIsKept() {
    Rig rig;
    rig.makeTimed(playback::TimingTask::cue, 2);
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    QTest::keyClick(window, Qt::Key_Y);
    QVERIFY(window->findChild<QLabel*>("studyWords")->text().contains("fourth"));
    QTest::keyClick(window, Qt::Key_Return);
    QVERIFY(window->findChild<QLabel*>("studyCount")->text().contains("1"));
    QCOMPARE(rig.finger->beats_s.size(), std::size_t{4});
    QVERIFY(std::abs(rig.finger->beats_s[3] - rig.finger->beats_s[0] - 3 * 0.4) < 1e-9);
    const double cue_s = rig.finger->beats_s.back();
    rig.finger->ahead_s += cue_s + 0.03;  // a little after the cue
    const auto* picture = static_cast<TimingPicture*>(window->findChild<QWidget*>("studyPicture"));
    QTRY_COMPARE(picture->view().beatsCome, std::size_t{4});  // the window has looked since
    QTest::keyClick(window, Qt::Key_Space);
    rig.finger->ahead_s += 1;
    QTRY_COMPARE(rig.record().answers.size(), std::size_t{1});
    const playback::Answer answer = rig.record().answers[0].answer;
    QCOMPARE(answer.presses_s.size(), std::size_t{1});
    QVERIFY2(answer.presses_s[0] > 0.02 && answer.presses_s[0] < 0.2,
             qPrintable(QString::number(answer.presses_s[0])));
    QVERIFY(answer.pressWithin_s >= 0 && answer.pressWithin_s < 0.2);
    QCOMPARE(answer.felt[0].whole, std::size_t{1});
    QTRY_VERIFY(window->findChild<QLabel*>("studyCount")->text().contains("2 of 2"));
    // The pad presses too, at once and not when it comes up.
    rig.finger->ahead_s += rig.finger->beats_s.back();
    const QPoint middle = buttonIn(window, "studyPad")->rect().center();
    QTest::mousePress(buttonIn(window, "studyPad"), Qt::LeftButton, {}, middle);
    QCOMPARE(rig.finger->pressed.size(), std::size_t{2});
    QTest::mouseRelease(buttonIn(window, "studyPad"), Qt::LeftButton, {}, middle);
    rig.finger->ahead_s += 1;
    QTRY_VERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());
    QVERIFY(rig.record().complete());
    QCOMPARE(rig.finger->pressed.size(), std::size_t{2});
    const auto timing = rig.record().sessions[0].route.timing;
    QVERIFY(timing && QString::fromStdString(timing->press).startsWith("key or pad"));
    window->close();
  }

  void theWindowIsHitOrMissed() {
    Rig rig;
    rig.makeTimed(playback::TimingTask::window, 2);
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    agree(window);
    const auto result = [&] { return window->findChild<QLabel*>("studyResult")->text(); };
    const auto* picture = static_cast<TimingPicture*>(window->findChild<QWidget*>("studyPicture"));
    for (const double late_s : {0.02, 0.2}) {  // the window is open for 0.12 s
      QTRY_VERIFY(picture->view().way < 0);
      rig.finger->ahead_s += 0.5 + 0.4 + late_s;
      QTest::keyClick(window, Qt::Key_Space);
      QTRY_VERIFY(picture->view().way > 1);
      QVERIFY(std::abs(picture->view().windowShare - 0.3) < 1e-9);
      rig.finger->ahead_s += 1;
      QTRY_COMPARE(result(), late_s < 0.12 ? QString("Hit") : QString("Missed"));
    }
    QVERIFY(rig.record().complete());
    window->close();
  }

  void tappingEndsBehindItsFirstPress() {
    Rig rig;
    rig.makeTimed(playback::TimingTask::tapping, 1);
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    agree(window);
    const auto* picture = static_cast<TimingPicture*>(window->findChild<QWidget*>("studyPicture"));
    rig.finger->ahead_s += 30;  // a trial has no time limit
    QTest::qWait(50);
    QVERIFY(rig.record().answers.empty() && picture->view().left_s == 3);
    for (int i = 0; i < 12; ++i) {
      QTest::keyClick(window, Qt::Key_Space);
      QKeyEvent held(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, " ",
                     true);  // key repetition is no press
      QApplication::sendEvent(window, &held);
      rig.finger->ahead_s += 0.2;
    }
    QTRY_VERIFY(picture->view().left_s < 1);
    rig.finger->ahead_s += 3;
    QTRY_VERIFY(window->findChild<QLabel*>("studyEnd")->isVisible());
    QCOMPARE(rig.record().answers[0].answer.presses_s.size(), std::size_t{12});
    window->close();
  }

  /// On a machine that wakes waiting threads late, a time stamp is not exact to the millisecond.
  void aPressIsAsExactAsTheMachineIsPunctual() {
    Rig rig;
    rig.makeTimed(playback::TimingTask::cue, 1);
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    agree(window);
    QTest::qWait(20);
    standStill(120);
    rig.finger->ahead_s += rig.finger->beats_s.back();
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, " ");
    press.setTimestamp(
        static_cast<quint64>(std::chrono::duration_cast<std::chrono::milliseconds>(now).count()));
    QApplication::sendEvent(window, &press);
    rig.finger->ahead_s += 1;
    QTRY_COMPARE(rig.record().answers.size(), std::size_t{1});
    const double within_s = rig.record().answers[0].answer.pressWithin_s;
    QVERIFY2(within_s > 0.002 + 0.1, qPrintable(QString::number(within_s)));
    window->close();
  }

  void whatCannotCountBeginsAnewAndIsInTheJournal() {
    Rig rig;
    rig.makeTimed(playback::TimingTask::cue, 1);
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    agree(window);
    const auto trouble = [&] { return window->findChild<QLabel*>("studyTrouble")->text(); };
    const auto next = [&] { rig.finger->beats_s.clear(); };
    next();
    rig.finger->ahead_s += 5;  // nobody presses
    QTRY_VERIFY(trouble().contains("No press"));
    QTRY_VERIFY(!rig.finger->beats_s.empty());
    next();
    rig.finger->ahead_s += 0.5 + 3 * 0.4;
    for (int i = 0; i < 5; ++i) QTest::keyClick(window, Qt::Key_Space);
    rig.finger->ahead_s += 1;
    QTRY_VERIFY(trouble().contains("too close"));
    QTRY_VERIFY(!rig.finger->beats_s.empty());
    QCOMPARE(rig.record().interruptions, std::size_t{2});
    QTest::keyClick(window, Qt::Key_Q);
    QTest::keyClick(window, Qt::Key_Space);  // no question is shown
    const std::size_t pressed = rig.finger->pressed.size();
    QTest::keyClick(window, Qt::Key_Return);
    QCOMPARE(rig.finger->pressed.size(), pressed);
    QCOMPARE(rig.record().interruptions, std::size_t{3});  // "stop not confirmed"
    QTest::keyClick(window, Qt::Key_P);
    QVERIFY(buttonIn(window, "studyPauseOver")->isVisible());
    rig.finger->ahead_s += 10;
    QTest::qWait(50);
    QCOMPARE(rig.record().interruptions, std::size_t{3});  // a pause is no interruption
    QTest::keyClick(window, Qt::Key_Return);
    rig.finger->lost = true;
    QTRY_VERIFY(trouble().contains("disconnected"));
    QTest::qWait(100);
    QCOMPARE(rig.record().interruptions, std::size_t{4});  // counted once, however long the device is away
    rig.finger->lost = false;
    QTRY_VERIFY(trouble().contains("connected again"));
    QTest::keyClick(window, Qt::Key_Q);
    QTest::keyClick(window, Qt::Key_S);
    QVERIFY(rig.record().endedEarly && rig.record().answers.empty());
    window->close();
  }

  void aSensorPressesInPlaceOfKeys() {
    Rig rig;
    rig.makeTimed(playback::TimingTask::tapping, 1);
    rig.finger->sensed = true;
    rig.dialog->findChild<QComboBox*>("studySensor")->setCurrentText("/dev/ttyACM3");
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    agree(window);
    QVERIFY(buttonIn(window, "studyPad") == nullptr);
    QTest::keyClick(window, Qt::Key_Space);
    QVERIFY(rig.finger->pressed.empty());
    const double from_s = rig.finger->clock_s();
    for (const double at_s : {-1.0, 0.1, 0.3, 0.5}) rig.finger->closings.push_back({from_s + at_s, 0.002});
    rig.finger->ahead_s += 4;
    QTRY_VERIFY(rig.record().complete());
    const playback::Answer answer = rig.record().answers[0].answer;
    QCOMPARE(answer.presses_s.size(), std::size_t{3});  // presses before the trial do not count
    QVERIFY(std::abs(answer.presses_s[2] - 0.4) < 1e-6);
    QCOMPARE(answer.pressWithin_s, 0.002);
    QVERIFY(QString::fromStdString(rig.record().sessions[0].route.timing->press).startsWith("sensor"));
    window->close();
  }

  /// Any key that a frightened participant finds first, in every kind of study.
  void escapeTakesTheForceAway() {
    for (const bool timed : {true, false}) {
      Rig rig;
      if (timed)
        rig.makeTimed(playback::TimingTask::tapping, 1);
      else
        rig.makeStudy();
      rig.dialog->findChild<QCheckBox*>("studyForce")->setChecked(true);
      QVERIFY(rig.begin() == nullptr);  // no force device is chosen
      QVERIFY(!rig.trouble().isEmpty());
      rig.force = *playback::forceDeviceFrom("sim:rig");
      rig.finger->sensed = true;
      StudyWindow* window = rig.begin();
      QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
      QVERIFY(rig.requested.force && rig.requested.force->profile.name == rig.force->profile.name);
      agree(window);
      QVERIFY(buttonIn(window, "studyPad") == nullptr);
      QTest::keyClick(window, Qt::Key_Escape);
      QVERIFY(rig.finger->stopped);
      const auto trouble = [&] { return window->findChild<QLabel*>("studyTrouble")->text(); };
      QTRY_VERIFY2(trouble().contains("F9"), qPrintable(trouble()));
      QCOMPARE(rig.record().interruptions, std::size_t{1});
      QTest::keyClick(window, Qt::Key_F9);
      QTRY_VERIFY(trouble().contains("connected again"));
      QVERIFY(!rig.finger->stopped);
      window->close();
    }
  }

  void aTimingStudyIsMadeInTheWindow() {
    Rig rig;
    StudyMaker maker({&rig.a}, {});
    maker.show();
    choose(maker, playback::StudyKind::timing);
    maker.setFolder(rig.study);
    auto* make = maker.findChild<QPushButton*>("makerMake");
    QVERIFY(make->isEnabled());
    QVERIFY(maker.findChild<QLineEdit*>("makerIntervals")->isVisible());
    QVERIFY(!maker.findChild<QLineEdit*>("makerWindows")->isVisible());
    maker.findChild<QComboBox*>("makerTask")->setCurrentIndex(1);
    for (const char* wrong : {"", "0.1; 0.2; x", "7"}) {
      maker.findChild<QLineEdit*>("makerWindows")->setText(wrong);
      QVERIFY2(!make->isEnabled(), wrong);
      const QString lengthText = maker.findChild<QLabel*>("makerLength")->text();
      QVERIFY2(lengthText.startsWith("Time windows in s: ") && lengthText.contains("0.01 to 1 s"),
               qPrintable(lengthText));
    }
    maker.findChild<QLineEdit*>("makerWindows")->setText("0,1; 0.2");
    maker.findChild<QLineEdit*>("makerIntervals")->setText("0.7");
    QVERIFY(make->isEnabled());
    make->click();
    const auto study = playback::openStudy(rig.study.toStdString());
    QVERIFY(study && study->design.task == playback::TimingTask::window);
    QCOMPARE(study->design.windows_s, (std::vector<double>{0.1, 0.2}));
    QCOMPARE(study->design.intervals_s, std::vector<double>{0.7});
    QCOMPARE(study->design.trials, std::size_t{60});
    rig.dialog->showStudy(rig.study);
    rig.answersBy(3);  // no share of errors, because timing studies have no wrong answer
    QVERIFY(rig.begin() == nullptr);
    QVERIFY2(rig.trouble().startsWith("Answers by: ") && rig.records().empty(), qPrintable(rig.trouble()));
    QVERIFY(!rig.trouble().contains("errors=P"));
  }

  /// Errors name controls of the window, never options of the command-line program.
  void whatIsWrongIsNamedAsTheWindowDoes() {
    Rig rig;
    StudyMaker maker({&rig.a, &rig.b}, {});
    maker.setFolder(rig.study);
    const auto lengthText = [&] { return maker.findChild<QLabel*>("makerLength")->text(); };
    for (const char* box : {"makerFull", "makerClicks", "makerSlopes"})
      maker.findChild<QCheckBox*>(box)->setChecked(false);
    QVERIFY2(lengthText().startsWith("Feedback: "), qPrintable(lengthText()));
    maker.findChild<QCheckBox*>("makerFull")->setChecked(true);
    auto* list = maker.findChild<QListWidget*>("makerButtons");
    list->item(0)->setCheckState(Qt::Unchecked);
    QVERIFY2(lengthText().contains("at least two") && !lengthText().contains("file"),
             qPrintable(lengthText()));
    list->item(0)->setCheckState(Qt::Checked);
    choose(maker, playback::StudyKind::timing);
    maker.findChild<QLineEdit*>("makerIntervals")->setText("9");
    QVERIFY2(lengthText().startsWith("Intervals in s: ") && lengthText().contains("0.2 to 5 s"),
             qPrintable(lengthText()));
    rig.makeStudy();
    QVERIFY(rig.begin("no name!") == nullptr);
    QVERIFY2(rig.trouble().startsWith("Next participant: "), qPrintable(rig.trouble()));
  }

  void theSensorReachesTheFinger() {
    Rig rig;
    rig.makeStudy();
    rig.dialog->findChild<QComboBox*>("studySensor")->setCurrentText("/dev/ttyACM3");
    StudyWindow* window = rig.begin();
    QVERIFY2(window != nullptr, qPrintable(rig.trouble()));
    QCOMPARE(rig.requested.sensorPort, std::string("/dev/ttyACM3"));
    agree(window);
    QVERIFY(window->findChild<QLabel*>("studyHint")->text().contains("pad"));
    window->close();
  }
};

DETENT_WINDOW_TEST(StudyTest)
#include "study_test.moc"
