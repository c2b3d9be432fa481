// SPDX-License-Identifier: GPL-3.0-or-later
// The feel panel as a person uses it, on a machine without a sound device.

#include "editor/feel/feel_panel.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "editor/feel/feel_setup.h"
#include "editor/feel/press_pad.h"
#include "editor/feel/press_strip.h"
#include "editor/feel/signal_view.h"
#include "editor/quantity/quantity_field.h"
#include "model/edits.h"
#include "playback/playback.h"
#include "tests/editor/feel/feel_buttons.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;

namespace {

constexpr const char* transientAhap =
    R"({"Version": 1.0, "Pattern": [{"Event": {"Time": 0.05, "EventType": "HapticTransient", "EventParameters": [
      {"ParameterID": "HapticIntensity", "ParameterValue": 0.8}, {"ParameterID": "HapticSharpness", "ParameterValue": 0.5}]}}]})";
constexpr const char* hapticEnvelope =
    R"({"version": {"major": 1, "minor": 0, "patch": 0}, "metadata": {"editor": "", "source": "", "project": "", "tags": [],
      "description": ""}, "signals": {"continuous": {"envelopes": {"amplitude": [{"time": 0.0, "amplitude": 0.9},
      {"time": 0.3, "amplitude": 0.5}], "frequency": [{"time": 0.0, "frequency": 0.5}, {"time": 0.3, "frequency": 0.5}]}}}})";
constexpr const char* hjifSine =
    R"({"version": "2023", "profile": "Main", "level": 1, "date": "", "description": "", "timescale": 1000, "avatars": [], "syncs": [],
      "perceptions": [{"id": 0, "avatar_id": 0, "priority": 0, "description": "", "perception_modality": "Vibrotactile",
        "reference_devices": [], "effect_library": [], "channels": [{"id": 0, "description": "", "body_part_mask": 0,
          "priority": 0, "gain": 1.0, "mixing_weight": 1.0, "vertices": [], "bands": [{"band_type": "VectorialWave",
            "lower_frequency_limit": 0, "upper_frequency_limit": 1000, "effects": [{"effect_type": "Basis", "position": 0,
              "phase": 0.0, "base_signal": "Sine", "keyframes": [
                {"relative_position": 0, "amplitude_modulation": 0.6, "frequency_modulation": 150},
                {"relative_position": 500, "amplitude_modulation": 0.6, "frequency_modulation": 150}]}]}]}]}]})";

QString written(const QTemporaryDir& folder, const QString& name, const QByteArray& content) {
  QFile file(folder.filePath(name));
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write(content);
  return file.fileName();
}

QString writtenWave(const QTemporaryDir& folder, const QString& name) {
  std::vector<float> samples(4800);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<float>(0.5 * std::sin(2 * M_PI * 100 * static_cast<double>(i) / 48000));
  const std::string wave = folder.filePath("sound.wav").toStdString();
  if (!playback::writeSoundFile(samples, 48000, wave)) return {};
  const QString path = folder.filePath(name);
  return QFile::rename(QString::fromStdString(wave), path) ? path : QString();
}

/// A panel in a window, with the signals it emits.
struct Rig {
  NoDevices none;
  ViewSettings settings;
  ButtonDocument a, b;
  FeelSession session;
  FeelPanel panel;
  std::vector<std::optional<FingerPosition>> finger, otherFinger;
  std::vector<std::uint64_t> shown;

  explicit Rig(const Button& first = tactileButton(), const Button& second = linearButton())
      : a(first), b(second), session(nullptr, none.devices()), panel(settings, session) {
    QObject::connect(&session, &FeelSession::fingerMoved, &panel, [this](auto p) { finger.push_back(p); });
    QObject::connect(&session, &FeelSession::otherFingerMoved, &panel,
                     [this](auto p) { otherFinger.push_back(p); });
    QObject::connect(view(), &SignalView::shown, &panel, [this](auto r) { shown.push_back(r); });
    panel.resize(400, 900);
    panel.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&panel));
  }

  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  PressPad* pad() { return part<PressPad>("pressPad"); }
  SignalView* view() { return part<SignalView>("signalView"); }
  QString status() { return part<QLabel>("soundStatus")->text(); }

  void open() {
    session.setDocument(FeelSide::a, &a);
    pad()->setFocus();
    QTRY_VERIFY(view()->pressSignal() && view()->pressSignal()->program);
  }
  void press(int hold_ms = 160) {
    QTest::keyPress(pad(), Qt::Key_Space);
    QTest::qWait(hold_ms);
    QTest::keyRelease(pad(), Qt::Key_Space);
  }
  /// Holds until the bottom is reached, however busy the machine is.
  void pressToTheEnd() {
    QTest::keyPress(pad(), Qt::Key_Space);
    static_cast<void>(QTest::qWaitFor([this] { return deepest() >= 4; }));
    QTest::keyRelease(pad(), Qt::Key_Space);
  }
  bool atRest() const { return !finger.empty() && !finger.back(); }
  double deepest() const {
    double mm = -1;
    for (const auto& p : finger)
      if (p) mm = std::max(mm, p->displacement_mm);
    return mm;
  }
};

/// With files of other programs to draw beside the press.
struct ReferenceRig : Rig {
  QTemporaryDir folder;
  ReferenceRig() { open(); }
  QString file(const QString& name, const QByteArray& content) const {
    return written(folder, name, content);
  }
  void show(const QString& name, const QByteArray& content) {
    session.setReference(file(name, content));
    QTRY_VERIFY(session.reference());
  }
};

}  // namespace

class FeelPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void noDeviceIsTouchedBeforeTheFirstPress() {
    Rig rig;
    rig.open();
    rig.panel.restoreState(
        {{"device", "ALSA: hw:0,0"}, {"sensorPort", "/dev/ttyACM7"}, {"setupShown", false}});
    QTest::qWait(100);
    QCOMPARE(rig.none.opened->load(), 0);
    QCOMPARE(rig.none.listed->load(), 0);
    QVERIFY(rig.status().contains("first press"));
    rig.press();
    QTRY_COMPARE(rig.none.opened->load(), 1);
  }

  void aPressIsFollowedWithoutASoundDevice() {
    Rig rig;
    rig.open();
    rig.pressToTheEnd();
    QTRY_VERIFY(rig.atRest());
    QCOMPARE(rig.deepest(), 4.0);
    bool pressed = false, released = false;
    for (const auto& p : rig.finger) {
      if (!p) continue;
      pressed = pressed || p->stroke == Stroke::press;
      released = released || p->stroke == Stroke::release;
    }
    QVERIFY(pressed && released);
    QVERIFY(rig.part<PressStrip>("pressStrip")->eventCount() > 20);
    QTRY_VERIFY(rig.status().contains("no sound output was found"));
    QVERIFY(rig.status().contains("Connect a sound device"));
    QVERIFY(rig.status().contains(". Default device"));
    QVERIFY(rig.part<QLabel>("feltLevel")->text().isEmpty());
    QVERIFY(rig.part<QPushButton>("soundAgain")->isVisible());
    rig.press();  // a device that could not be opened is tried again on request, not at each press
    QTest::qWait(150);
    QCOMPARE(rig.none.opened->load(), 1);
    QCOMPARE(rig.otherFinger.size(), std::size_t{0});

    QTest::mouseClick(rig.part<QPushButton>("soundAgain"), Qt::LeftButton);
    QTRY_COMPARE(rig.none.opened->load(), 2);
  }

  void theFingerIsReportedSixtyTimesASecond() {
    Rig rig;
    rig.open();
    QTest::keyPress(rig.pad(), Qt::Key_Space);
    QTest::qWait(100);
    double perSecond = 0;
    for (int attempt = 0; attempt < 3 && perSecond < 60; ++attempt) {  // a busy machine stalls now and then
      const std::size_t before = rig.finger.size();
      QElapsedTimer clock;
      clock.start();
      QTest::qWait(1000);
      perSecond =
          1000.0 * static_cast<double>(rig.finger.size() - before) / static_cast<double>(clock.elapsed());
    }
    QTest::keyRelease(rig.pad(), Qt::Key_Space);
    QVERIFY2(perSecond >= 60, qPrintable(QString::number(perSecond)));
  }

  void draggingSetsTheDepth() {
    Rig rig;
    rig.open();
    rig.panel.restoreState({{"drive", "depth"}});
    const QPoint from(rig.pad()->width() / 2, 20);
    QTest::mousePress(rig.pad(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 40; ++i) {
      QTest::mouseMove(rig.pad(), from + QPoint(0, i * rig.pad()->height() / 100));
      QTest::qWait(4);
    }
    QTRY_VERIFY(!rig.finger.empty() && rig.finger.back());
    // 0.4 of the height, of which 0.55 are the whole travel of 4 mm.
    QTRY_VERIFY(std::abs(rig.finger.back()->displacement_mm - 4 * 0.4 / 0.55) < 0.06);
    const double held = rig.finger.back()->displacement_mm;
    QTest::qWait(400);  // a finger that rests stays where it is
    QCOMPARE(rig.finger.back()->displacement_mm, held);
    QTest::mouseRelease(rig.pad(), Qt::LeftButton, {}, from);
    QTRY_VERIFY(rig.atRest());
  }

  void fullPressIsTheForceThatIsReached() {
    Rig rig;
    rig.open();
    rig.panel.restoreState({{"full_N", 0.45}});  // below the tactile force of 0.55 N
    rig.press(250);
    QTRY_VERIFY(rig.atRest());
    QVERIFY2(rig.deepest() > 0.5 && rig.deepest() < 1.2, qPrintable(QString::number(rig.deepest())));
    double strongest = 0;
    for (const auto& p : rig.finger)
      if (p) strongest = std::max(strongest, p->force_N);
    QVERIFY(std::abs(strongest - 0.45) < 0.02);
  }

  void exchangingIsOneKey() {
    Rig rig;
    rig.open();
    QVERIFY(!rig.panel.exchangeAction()->isEnabled());
    QTest::keyClick(rig.pad(), Qt::Key_X);
    QCOMPARE(rig.session.feltDocument(), &rig.a);
    rig.session.setDocument(FeelSide::b, &rig.b);
    QVERIFY(rig.panel.exchangeAction()->isEnabled());
    QSignalSpy felt(&rig.session, &FeelSession::feltDocumentChanged);

    QTest::keyClick(rig.pad(), Qt::Key_X);
    QCOMPARE(rig.session.feltDocument(), &rig.b);
    QCOMPARE(felt.count(), 1);
    QVERIFY(rig.part<QToolButton>("feelB")->isChecked());
    QTRY_VERIFY(rig.view()->pressSignal() &&
                rig.view()->pressSignal()->samples ==
                    pressSignalOf({linearButton(), {}, playback::usualSettings()}).samples);
    rig.finger.clear();
    rig.press();
    QTRY_VERIFY(!rig.otherFinger.empty() && !rig.otherFinger.back());
    QVERIFY(rig.finger.empty());

    QTest::keyClick(rig.pad(), Qt::Key_X);
    QCOMPARE(rig.session.feltDocument(), &rig.a);
    QTest::mouseClick(rig.part<QToolButton>("feelB"), Qt::LeftButton);
    QCOMPARE(rig.session.feltDocument(), &rig.b);
    rig.session.setDocument(FeelSide::b, nullptr);  // A is pressed again, because B is gone
    QCOMPARE(rig.session.feltDocument(), &rig.a);
  }

  void exchangingUnderTheFingerTakesItAlong() {
    Rig rig;
    rig.open();
    rig.session.setDocument(FeelSide::b, &rig.b);
    QTest::qWait(100);
    QTest::keyPress(rig.pad(), Qt::Key_Space);
    QTRY_VERIFY(rig.deepest() > 3.9);
    QTest::keyClick(rig.pad(), Qt::Key_X);
    QVERIFY(rig.atRest());  // the finger's point on A is not shown any more
    QTRY_VERIFY(!rig.otherFinger.empty() && rig.otherFinger.back() &&
                rig.otherFinger.back()->displacement_mm > 3.9);
    QTest::keyRelease(rig.pad(), Qt::Key_Space);
    QTRY_VERIFY(!rig.otherFinger.back());
  }

  void theGraphFollowsTheStateOfASelfLockingButton() {
    Rig rig(lockingButton());
    rig.open();
    QCOMPARE(rig.a.activeState(), std::size_t{0});
    rig.press(200);
    QTRY_COMPARE(rig.a.activeState(), std::size_t{1});
    rig.press(200);
    QTRY_COMPARE(rig.a.activeState(), std::size_t{0});
    rig.panel.restoreState({{"followState", false}});
    rig.press(200);
    QTest::qWait(200);
    QCOMPARE(rig.a.activeState(), std::size_t{0});
    rig.finger.clear();
    rig.press(200);  // on the locked state, whose graph is not shown
    QTest::qWait(200);
    for (const auto& p : rig.finger) QVERIFY(!p);
  }

  void editsAreShownAndOvertakenOnesAreNot() {
    Rig rig;
    rig.open();
    QTRY_VERIFY(!rig.shown.empty());
    rig.a.history().beginDrag("Drag");
    Result<Button> next = tactileButton();
    for (int i = 1; i <= 60; ++i) {
      next = scaleForce(tactileButton(), 1 + 0.01 * i);
      QVERIFY(next);
      rig.a.history().preview(*next);
    }
    const auto expected = pressSignalOf({*next, {}, playback::usualSettings()});
    QTRY_VERIFY(rig.view()->pressSignal()->samples == expected.samples);
    QVERIFY(rig.shown.size() < 30);
    rig.a.history().cancelDrag();
    QTRY_VERIFY(rig.view()->pressSignal()->samples ==
                pressSignalOf({tactileButton(), {}, playback::usualSettings()}).samples);
  }

  void aHiddenPanelComputesNothing() {
    Rig rig;
    rig.open();
    rig.panel.hide();
    const auto before = rig.view()->pressSignal();
    const Result<Button> next = scaleForce(tactileButton(), 2);
    QVERIFY(next);
    rig.a.history().apply(*next, "Scale");
    QTest::qWait(80);
    QCOMPARE(rig.view()->pressSignal(), before);
    rig.panel.show();
    QTRY_VERIFY(rig.view()->pressSignal() != before);
  }

  void documentsComeAndGo() {
    Rig rig;
    {
      ButtonDocument brief(tactileButton());
      rig.session.setDocument(FeelSide::a, &brief);
      QTest::keyPress(rig.pad(), Qt::Key_Space);  // the program may not be computed yet
      QTest::qWait(60);
    }
    QCOMPARE(rig.session.feltDocument(), nullptr);
    QTest::keyRelease(rig.pad(), Qt::Key_Space);
    QTest::qWait(60);
    rig.open();
    rig.press();
    QTRY_VERIFY(rig.atRest());
    rig.session.setDocument(FeelSide::a, nullptr);
    QVERIFY(!rig.view()->pressSignal());
  }

  void aButtonThatGoesUnderTheFingerLeavesNothingPressed_data() {
    QTest::addColumn<QString>("drive");
    for (const char* drive : {"time", "depth", "force"}) QTest::newRow(drive) << QString(drive);
  }
  void aButtonThatGoesUnderTheFingerLeavesNothingPressed() {
    QFETCH(QString, drive);
    Rig rig;
    rig.open();
    rig.panel.restoreState({{"drive", drive}});
    const QPoint from(rig.pad()->width() / 2, 20);
    QTest::mousePress(rig.pad(), Qt::LeftButton, {}, from);
    QTest::mouseMove(rig.pad(), from + QPoint(0, rig.pad()->height() / 2));
    QTRY_VERIFY(!rig.finger.empty() && rig.finger.back() && rig.finger.back()->displacement_mm > 1);
    rig.session.setDocument(FeelSide::a, nullptr);
    QTRY_VERIFY(rig.atRest());
    rig.session.setDocument(FeelSide::a, &rig.b);
    QTRY_VERIFY(rig.view()->pressSignal());
    rig.finger.clear();
    QTest::qWait(150);
    for (const auto& p : rig.finger) QVERIFY(!p);
    QTest::mouseRelease(rig.pad(), Qt::LeftButton, {}, from);
  }

  void myOwnPressIsDrawnForBothButtons() {
    Rig rig;
    rig.open();
    rig.session.setDocument(FeelSide::b, &rig.b);
    auto* mine = rig.part<QToolButton>("myPress");
    QVERIFY(!mine->isEnabled());
    rig.pressToTheEnd();
    QTRY_VERIFY(rig.atRest());
    QTRY_VERIFY(mine->isEnabled());
    QVERIFY(rig.view()->pressSignal()->standard);
    QTest::mouseClick(mine, Qt::LeftButton);
    QTRY_VERIFY(!rig.view()->pressSignal()->standard);
    const auto own = rig.view()->pressSignal();
    QCOMPARE(own->press.readings.front().value, 0.0);
    QCOMPARE(own->press.readings.back().value, 0.0);
    double strongest = 0;
    for (const auto& r : own->press.readings) strongest = std::max(strongest, r.value);
    QVERIFY(strongest > 0.75 && strongest < 1.03);  // to the end of the travel, at most a full press
    const auto jumps = std::count_if(own->events.begin(), own->events.end(), [](const auto& e) {
      return e.kind == playback::EventKind::pressJump || e.kind == playback::EventKind::releaseJump;
    });
    QCOMPARE(jumps, 2);

    rig.session.exchange();
    QTRY_VERIFY(rig.view()->pressSignal() && !rig.view()->pressSignal()->standard);
    QCOMPARE(rig.view()->pressSignal()->press.readings.size(), own->press.readings.size());
    QTest::mouseClick(rig.part<QToolButton>("standardPress"), Qt::LeftButton);
    QTRY_VERIFY(rig.view()->pressSignal()->standard);
  }

  void aReferenceIsDrawnBesideThePressAndBelongsToNoButton() {
    ReferenceRig rig;
    auto* view = rig.part<SignalView>("referenceView");
    QVERIFY(!view->isVisible());
    QVERIFY(!rig.part<QToolButton>("playReferenceButton")->isVisible());
    const Button before = rig.a.button();
    rig.show("click.ahap", transientAhap);
    QVERIFY(view->isVisible());
    QVERIFY(view->accessibleName().contains("click.ahap"));
    QVERIFY(rig.part<QToolButton>("referenceFile")->accessibleName().contains("click.ahap"));
    QVERIFY(rig.session.reference()->peak > 0.55 &&
            rig.session.reference()->peak < 0.64);  // intensity 0.8, squared, falling
    QVERIFY(rig.part<QLabel>("referenceNote")->text().isEmpty());

    // Undo concerns the button alone.
    QVERIFY(!rig.a.history().stack().canUndo());
    const Result<Button> louder = scaleForce(rig.a.button(), 1.5);
    QVERIFY(louder);
    rig.a.history().apply(*louder, "Scale");
    rig.a.history().stack().undo();
    QCOMPARE(rig.a.button(), before);
    QVERIFY(rig.session.reference());

    // Kept with the panel's choices, also by another panel.
    Rig other;
    other.panel.restoreState(rig.panel.saveState());
    QTRY_VERIFY(other.session.reference());
    QCOMPARE(other.session.reference()->samples, rig.session.reference()->samples);

    QTest::mouseClick(rig.part<QToolButton>("noReference"), Qt::LeftButton);
    QVERIFY(!rig.session.reference());
    QVERIFY(!view->isVisible());
    QVERIFY(rig.panel.saveState().value("referenceFile").toString().isEmpty());
  }

  void everyKindOfReferenceIsReadByItsContent() {
    ReferenceRig rig;
    const QStringList files{rig.file("a.txt", transientAhap), rig.file("b.txt", hapticEnvelope),
                            rig.file("c.txt", hjifSine), writtenWave(rig.folder, "d.txt")};
    for (const QString& file : files) {
      rig.session.setReference(file);
      QTRY_VERIFY2(rig.session.reference(), qPrintable(rig.session.referenceTrouble()));
      QVERIFY(rig.session.reference()->peak > 0.2);
      rig.session.setReference({});
    }
  }

  void aReferenceThatCannotBeReadIsSaidAndTakesNothingWithIt() {
    ReferenceRig rig;
    for (const char* text :
         {"{\"Version\": 1.0, \"Pattern\": [", "{\"Version\": 7.0, \"Pattern\": []}", "press me", ""}) {
      QSignalSpy said(&rig.session, &FeelSession::said);
      rig.session.setReference(rig.file("bad.ahap", text));
      QTRY_COMPARE(said.count(), 1);
      QVERIFY(!rig.session.reference());
      QVERIFY(rig.part<QLabel>("referenceNote")->text().contains("bad.ahap"));
      QVERIFY(rig.panel.saveState().value("referenceFile").toString().isEmpty());
    }
    rig.session.setReference(rig.folder.filePath("nowhere.ahap"));
    QTRY_VERIFY(rig.session.referenceTrouble().contains("nowhere.ahap"));
    rig.pressToTheEnd();
    QTRY_VERIFY(rig.atRest());
  }

  void twoFilesInOneBreathLeaveTheLast() {
    ReferenceRig rig;
    const QString one = rig.file("one.ahap", transientAhap), two = rig.file("two.hjif", hjifSine);
    QSignalSpy changed(&rig.session, &FeelSession::referenceChanged);
    rig.session.setReference(one);
    rig.session.setReference(two);
    QTRY_VERIFY(rig.session.reference());
    const auto last = referenceDrawingOf(two.toStdString());
    QCOMPARE(rig.session.reference()->samples, last.samples);
    rig.session.setReference(one);
    rig.session.setReference({});
    QTest::qWait(150);
    QVERIFY(!rig.session.reference());
  }

  void signalsOfLikeLengthAreDrawnToOneScale() {
    ReferenceRig rig;
    rig.show("c.hjif", hjifSine);
    // 0.5 s of a tone beside some 0.4 s of a press: half the tone's time ends at the same place in both.
    const QImage tone = rig.part<SignalView>("referenceView")->grab().toImage();
    QVERIFY(!tone.isNull());
    const auto longer = std::max(rig.session.reference()->duration_s(), rig.session.signal()->duration_s());
    QCOMPARE(rig.view()->drawnDuration_s(), longer);
    QCOMPARE(rig.part<SignalView>("referenceView")->drawnDuration_s(), longer);
    rig.session.setReference({});
    QTRY_COMPARE(rig.view()->drawnDuration_s(), rig.session.signal()->duration_s());
  }

  void aReferenceCannotBePlayedWithoutSound() {
    ReferenceRig rig;
    rig.show("click.ahap", transientAhap);
    auto* play = rig.part<QToolButton>("playReferenceButton");
    QVERIFY(play->isEnabled());
    rig.pad()->setFocus();
    QTest::keyClick(rig.pad(), Qt::Key_R);
    QTRY_VERIFY(rig.status().contains("no sound output was found"));
    rig.pressToTheEnd();  // a refused playback does not hold the button
    QCOMPARE(rig.deepest(), 4.0);
    QTest::mouseClick(rig.part<QToolButton>("soundSwitch"), Qt::LeftButton);
    QTRY_VERIFY(!play->isEnabled());
  }

  void aPressCannotBePlayedWithoutSound() {
    Rig rig;
    rig.open();
    auto* play = rig.part<QToolButton>("play");
    QVERIFY(play->isEnabled());
    QTest::mouseClick(play, Qt::LeftButton);
    QTRY_VERIFY(rig.status().contains("no sound output was found"));
    rig.pressToTheEnd();  // a refused playback does not hold the button
    QCOMPARE(rig.deepest(), 4.0);
    QTest::mouseClick(rig.part<QToolButton>("soundSwitch"), Qt::LeftButton);
    QTRY_VERIFY(!play->isEnabled());
  }

  void soundCanBeOff() {
    Rig rig;
    rig.open();
    QTest::mouseClick(rig.part<QToolButton>("soundSwitch"), Qt::LeftButton);
    rig.pad()->setFocus();
    rig.pressToTheEnd();
    QTRY_VERIFY(rig.atRest());
    QCOMPARE(rig.deepest(), 4.0);
    QCOMPARE(rig.none.opened->load(), 0);
    QVERIFY(rig.status().contains("off"));
    QCOMPARE(rig.panel.saveState().value("sound").toBool(), false);
  }

  void choicesReachWhatIsFeltAndAreKept() {
    Rig rig;
    rig.open();
    QTest::mouseClick(rig.part<QToolButton>("setupToggle"), Qt::LeftButton);
    QTRY_COMPARE(rig.none.listed->load(), 1);
    auto* mode = rig.part<QComboBox>("modeChoice");
    mode->setCurrentIndex(mode->findData(static_cast<int>(playback::FeedbackMode::off)));
    QTRY_COMPARE(rig.view()->pressSignal()->peak, 0.0);
    rig.part<QSlider>("gain")->setValue(-12);
    auto* full = rig.part<QuantityField>("fullForce");
    full->selectAll();
    QTest::keyClicks(full, "1,2 N");
    const QVariantMap state = rig.panel.saveState();
    QCOMPARE(state.value("mode").toString(), QString("off"));
    QCOMPARE(state.value("gain_dB").toDouble(), -6.0);
    QVERIFY(std::abs(state.value("full_N").toDouble() - 1.2) < 1e-9);
    QVERIFY(state.value("setupShown").toBool());

    Rig other;
    other.panel.restoreState(state);
    QCOMPARE(other.panel.saveState(), state);
    QCOMPARE(other.part<QSlider>("gain")->value(), -12);
  }

  void profilesAreReadAndFaultsAreSaid() {
    QTemporaryDir folder;
    const QString good = folder.filePath("mockup.device"), bad = folder.filePath("bad.device");
    QFile file(good);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("detent-device 1\nname = Mockup\ngain = 0.5\nlatency = 50 0.0061 0.0002 0.0064\n");
    file.close();
    QFile other(bad);
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write("detent-device 1\ngain = loud\n");
    other.close();

    Rig rig;
    rig.open();
    const double full = rig.view()->pressSignal()->peak;
    rig.panel.restoreState({{"profileFile", good}});
    QTRY_VERIFY(std::abs(rig.view()->pressSignal()->peak / full - 0.5) < 0.02);
    QVERIFY(rig.part<QLabel>("profileNote")->text().contains("6.1 ms"));
    QSignalSpy said(&rig.session, &FeelSession::said);
    rig.panel.restoreState({{"profileFile", bad}});
    QTRY_VERIFY(std::abs(rig.view()->pressSignal()->peak / full - 1) < 0.02);
    QVERIFY(said.count() >= 1);
    QVERIFY(rig.part<QLabel>("profileNote")->text().contains("gain"));
    QVERIFY(rig.panel.saveState().value("profileFile").toString().isEmpty());
  }

  void aSensorThatIsNotThereIsSaid() {
    Rig rig;
    rig.open();
    rig.panel.restoreState({{"sensorPort", "/dev/detent-no-such-port"}});
    QCOMPARE(rig.part<QComboBox>("sensorPort")->currentText(), QString("/dev/detent-no-such-port"));
    rig.part<QPushButton>("sensorConnect")->click();
    QTRY_VERIFY(rig.part<QLabel>("sensorNote")->text().contains("detent-no-such-port"));
    QVERIFY(!rig.part<QPushButton>("sensorConnect")->isChecked());
    QCOMPARE(rig.part<QComboBox>("sensorPort")->currentText(), QString("/dev/detent-no-such-port"));
  }

  void theForceSetupShowsWhatTheDeviceHas() {
    Rig rig(*scaleForce(tactileButton(), 3));  // the button's drop is steeper than any device may render
    rig.open();
    rig.panel.restoreState({{"setupShown", true}});
    auto* device = rig.part<QComboBox>("forceDevice");
    const auto shown = [&](const char* name) { return rig.part<QWidget>(name)->isVisible(); };
    const auto choose = [&](const QString& kind) { device->setCurrentIndex(device->findData(kind)); };
    QVERIFY(!shown("forcePort") && !shown("forceFinger") && !shown("forceLargest"));
    QVERIFY(!rig.part<QToolButton>("forceSwitch")->isEnabled());
    choose("sim:falcon");
    QVERIFY(shown("forceFinger") && shown("forceLargest") && !shown("forcePort"));
    QVERIFY(rig.part<QToolButton>("forceSwitch")->isEnabled());
    QVERIFY(rig.part<QLabel>("forceStability")->text().contains("too steep"));
    choose("serial:");
    QVERIFY(shown("forcePort") && shown("forceStep") && shown("forceUpload") && !shown("forceTurn"));
    rig.part<QComboBox>("forcePort")->setCurrentText("/dev/ttyACM5");
    QCOMPARE(rig.session.settings().force.device, QString("serial:/dev/ttyACM5"));
    choose("odrive:");
    QVERIFY(shown("forcePort") && shown("forceTurn") && !shown("forceUpload"));
    choose("falcon");
    QVERIFY(shown("forceFirmware") && !shown("forcePort"));
    QCOMPARE(rig.panel.saveState().value("forceDevice").toString(), QString("falcon"));
  }

  void forceIsWatchedAndMadeStable() {
    Rig rig(*scaleForce(tactileButton(), 3));  // the button's drop is steeper than any device may render
    rig.open();
    rig.panel.restoreState({{"forceDevice", "sim:falcon"}, {"sound", false}});
    auto* meter = rig.part<QWidget>("forceMeter");
    QVERIFY(meter->isVisible() && meter->accessibleDescription().contains("no force"));
    QTest::mouseClick(rig.part<QToolButton>("forceSwitch"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(rig.deepest() > 3.5, 10000);
    QVERIFY(meter->accessibleDescription().contains("mJ"));
    QVERIFY(rig.part<QLabel>("forceStatus")->text().contains("Falcon"));
    QTest::mouseClick(rig.part<QToolButton>("forceSwitch"), Qt::LeftButton);
    QTRY_VERIFY(rig.atRest());
    QVERIFY(meter->accessibleDescription().contains("no force"));

    auto* stable = rig.part<QPushButton>("nearestStable");
    QVERIFY(stable->isVisible());
    QTest::mouseClick(stable, Qt::LeftButton);
    QVERIFY(!stable->isVisible());
    QVERIFY(rig.part<QLabel>("forceStability")->text().contains("Changed"));
    rig.a.history().stack().undo();
    QTRY_VERIFY(stable->isVisible());
    QVERIFY(!rig.part<QLabel>("forceStability")->text().contains("Changed"));
  }

  void everythingIsReachedAndNamed() {
    Rig rig;
    rig.open();
    rig.session.setDocument(FeelSide::b, &rig.b);
    rig.panel.restoreState({{"setupShown", true}});
    QSet<QWidget*> reached;
    QWidget* at = rig.pad();
    at->setFocus();
    for (int i = 0; i < 60; ++i) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      QVERIFY(QApplication::focusWidget() != nullptr);
      reached.insert(QApplication::focusWidget());
    }
    for (const char* name :
         {"pressPad", "feelA", "soundSwitch", "gain", "setupToggle", "driveChoice", "fullForce", "modeChoice",
          "profileFile", "soundDevice", "sensorPort", "sensorConnect"})
      QVERIFY2(reached.contains(rig.part<QWidget>(name)), name);
    for (QWidget* widget : rig.panel.findChildren<QWidget*>()) {
      if (widget->objectName().isEmpty() || widget->objectName().startsWith("qt_")) continue;
      if (qobject_cast<QLabel*>(widget) != nullptr || !widget->isVisible()) continue;
      QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
    }
  }

  void itFitsIntoADockAndIntoABand() {
    Rig rig;
    rig.open();
    rig.panel.resize(300, 700);
    QVERIFY(rig.view()->mapTo(&rig.panel, QPoint()).y() > rig.pad()->mapTo(&rig.panel, QPoint()).y());
    rig.panel.resize(1200, 420);
    QTRY_VERIFY(rig.view()->mapTo(&rig.panel, QPoint()).x() > rig.pad()->mapTo(&rig.panel, QPoint()).x());
  }
};

DETENT_WINDOW_TEST(FeelPanelTest)
#include "feel_panel_test.moc"
