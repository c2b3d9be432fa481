// SPDX-License-Identifier: GPL-3.0-or-later
// Every way to press the pad, with the events a window system sends.

#include "editor/feel/press_pad.h"

#include <memory>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>

#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;

namespace {

PadButton someButton() {
  PadButton button;
  button.name = "tactile";
  button.end_mm = 4;
  button.full_N = 1;
  button.pressPoints = {{1.2, 0.55, 0.17}};
  button.operating_mm = 2;
  return button;
}

/// The pad in a window, with the signals it emits.
struct Rig {
  ViewSettings settings;
  PressPad pad{settings};
  QSignalSpy down{&pad, &PressPad::timedDown}, up{&pad, &PressPad::timedUp};
  QSignalSpy force{&pad, &PressPad::forceMoved}, depth{&pad, &PressPad::depthMoved};
  QSignalSpy lifted{&pad, &PressPad::lifted};

  Rig() {
    pad.resize(360, 260);
    pad.setButton(someButton());
    pad.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&pad));
    pad.setFocus();
  }
  QPoint at(double share) const { return {pad.width() / 2, static_cast<int>(share * pad.height())}; }

  static double last(const QSignalSpy& spy) { return spy.last().first().toDouble(); }
};

void sendPen(PressPad& pad, QEvent::Type type, double pressure) {
  static const QPointingDevice pen(
      "test pen", 77, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
      QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
  const QPointF at(pad.width() / 2.0, pad.height() / 2.0);
  const bool lifts = type == QEvent::TabletRelease;
  QTabletEvent event(type, &pen, at, pad.mapToGlobal(at), pressure, 0, 0, 0, 0, 0, Qt::NoModifier,
                     type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                     lifts ? Qt::NoButton : Qt::LeftButton);
  QCoreApplication::sendEvent(&pad, &event);
  QVERIFY(event.isAccepted());
}

}  // namespace

class PressPadTest : public QObject {
  Q_OBJECT

 private slots:
  void aHeldMouseButtonPressesByTime() {
    Rig rig;
    QTest::mousePress(&rig.pad, Qt::LeftButton, {}, rig.at(0.3));
    QCOMPARE(rig.down.count(), 1);
    QTest::mouseMove(&rig.pad, rig.at(0.9));
    QCOMPARE(rig.up.count(), 0);
    QTest::mouseRelease(&rig.pad, Qt::LeftButton, {}, rig.at(0.9));
    QCOMPARE(rig.up.count(), 1);
    QCOMPARE(rig.depth.count() + rig.force.count() + rig.lifted.count(), 0);
    QTest::mousePress(&rig.pad, Qt::RightButton, {}, rig.at(0.3));
    QCOMPARE(rig.down.count(), 1);
  }

  void aDragPressesAsDeepAsItGoesDown() {
    Rig rig;
    rig.pad.setDrive(Drive::depth);
    QTest::mousePress(&rig.pad, Qt::LeftButton, {}, rig.at(0.2));
    QCOMPARE(Rig::last(rig.depth), 0.0);
    double before = 0;
    for (double share = 0.3; share < 0.7; share += 0.1) {
      QTest::mouseMove(&rig.pad, rig.at(share));
      QVERIFY(Rig::last(rig.depth) > before);
      before = Rig::last(rig.depth);
    }
    QTest::mouseMove(&rig.pad,
                     {rig.pad.width() / 2, 3 * rig.pad.height()});  // outside: all the way, no further
    QCOMPARE(Rig::last(rig.depth), 1.0);
    QTest::mouseMove(&rig.pad, {rig.pad.width() / 2, -100});
    QCOMPARE(Rig::last(rig.depth), 0.0);
    QTest::mouseRelease(&rig.pad, Qt::LeftButton, {}, rig.at(0.2));
    QCOMPARE(rig.lifted.count(), 1);
    QCOMPARE(rig.down.count() + rig.force.count(), 0);

    rig.pad.setDrive(Drive::force);
    QTest::mousePress(&rig.pad, Qt::LeftButton, {}, rig.at(0.2));
    QTest::mouseMove(&rig.pad, rig.at(0.5));
    QVERIFY(Rig::last(rig.force) > 0.4);
    QTest::mouseRelease(&rig.pad, Qt::LeftButton, {}, rig.at(0.5));
    QCOMPARE(rig.lifted.count(), 2);
  }

  void keysPressAndRepeatsAreIgnored_data() {
    QTest::addColumn<int>("key");
    QTest::newRow("Space") << static_cast<int>(Qt::Key_Space);
    QTest::newRow("Return") << static_cast<int>(Qt::Key_Return);
    QTest::newRow("Enter") << static_cast<int>(Qt::Key_Enter);
  }
  void keysPressAndRepeatsAreIgnored() {
    QFETCH(int, key);
    Rig rig;
    rig.pad.setDrive(Drive::depth);  // keys press by time with every drive
    QTest::keyPress(&rig.pad, static_cast<Qt::Key>(key));
    for (int i = 0; i < 5; ++i) {
      QKeyEvent up(QEvent::KeyRelease, key, Qt::NoModifier, {}, true);
      QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier, {}, true);
      QCoreApplication::sendEvent(&rig.pad, &up);
      QCoreApplication::sendEvent(&rig.pad, &down);
    }
    QCOMPARE(rig.down.count(), 1);
    QCOMPARE(rig.up.count(), 0);
    QTest::keyRelease(&rig.pad, static_cast<Qt::Key>(key));
    QCOMPARE(rig.up.count(), 1);
  }

  void otherKeysGoOn() {
    Rig rig;
    QKeyEvent other(QEvent::KeyPress, Qt::Key_X, Qt::NoModifier, "x");
    QCoreApplication::sendEvent(&rig.pad, &other);
    QVERIFY(!other.isAccepted());
    QCOMPARE(rig.down.count(), 0);
  }

  void aFingerNobodyCouldLiftIsLifted() {
    Rig rig;
    QTest::keyPress(&rig.pad, Qt::Key_Space);
    rig.pad.clearFocus();
    QCOMPARE(rig.up.count(), 1);
    rig.pad.setFocus();
    QTest::mousePress(&rig.pad, Qt::LeftButton, {}, rig.at(0.5));
    QCOMPARE(rig.down.count(), 2);
    rig.pad.hide();
    QCOMPARE(rig.up.count(), 2);
  }

  void aPensPressureIsTheForce() {
    Rig rig;
    sendPen(rig.pad, QEvent::TabletPress, 0.1);
    QCOMPARE(Rig::last(rig.force), 0.1);
    sendPen(rig.pad, QEvent::TabletMove, 0.75);
    QCOMPARE(Rig::last(rig.force), 0.75);
    sendPen(rig.pad, QEvent::TabletRelease, 0);
    QCOMPARE(rig.lifted.count(), 1);
    sendPen(rig.pad, QEvent::TabletMove, 0);  // hovers
    QCOMPARE(rig.force.count(), 2);
    QCOMPARE(rig.down.count(), 0);
  }

  void touchPresses() {
    Rig rig;
    const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
    QTest::touchEvent(&rig.pad, screen.get()).press(1, rig.at(0.3), &rig.pad);
    QCOMPARE(rig.down.count(), 1);
    QTest::touchEvent(&rig.pad, screen.get())
        .stationary(1)
        .press(2, rig.at(0.6), &rig.pad);  // a second finger
    QCOMPARE(rig.down.count(), 1);
    QTest::touchEvent(&rig.pad, screen.get())
        .release(1, rig.at(0.3), &rig.pad)
        .release(2, rig.at(0.6), &rig.pad);
    QCOMPARE(rig.up.count(), 1);

    rig.pad.setDrive(Drive::depth);
    QTest::touchEvent(&rig.pad, screen.get()).press(1, rig.at(0.2), &rig.pad);
    QTest::touchEvent(&rig.pad, screen.get()).move(1, rig.at(0.5), &rig.pad);
    QVERIFY(Rig::last(rig.depth) > 0.4);
    QTest::touchEvent(&rig.pad, screen.get()).release(1, rig.at(0.5), &rig.pad);
    QCOMPARE(rig.lifted.count(), 1);
  }

  void oneFingerAtATime() {
    Rig rig;
    QTest::keyPress(&rig.pad, Qt::Key_Space);
    QTest::mousePress(&rig.pad, Qt::LeftButton, {}, rig.at(0.5));
    QTest::keyPress(&rig.pad, Qt::Key_Return);
    QCOMPARE(rig.down.count(), 1);
    QTest::mouseRelease(&rig.pad, Qt::LeftButton, {}, rig.at(0.5));
    QTest::keyRelease(&rig.pad, Qt::Key_Return);
    QCOMPARE(rig.up.count(), 0);
    QTest::keyRelease(&rig.pad, Qt::Key_Space);
    QCOMPARE(rig.up.count(), 1);
  }

  void nothingToPress() {
    Rig rig;
    rig.pad.setButton(std::nullopt, "No button is open");
    QTest::keyPress(&rig.pad, Qt::Key_Space);
    QTest::mousePress(&rig.pad, Qt::LeftButton, {}, rig.at(0.5));
    sendPen(rig.pad, QEvent::TabletPress, 0.5);
    QCOMPARE(rig.down.count() + rig.force.count(), 0);
    rig.pad.grab();
  }

  /// The curve of someButton() has no bottom-out, so that the engine reports none.
  void theLampOfTheBottomOutIsOnAtTheEnd() {
    Rig rig;
    const auto drawn = [&](double displacement_mm) {
      rig.pad.setMotion({displacement_mm, 0.5, true, false, false});
      return rig.pad.grab().toImage().copy(0, 0, rig.pad.width(), 30);
    };
    const QImage before = drawn(someButton().end_mm - 0.01);
    QVERIFY(drawn(someButton().end_mm) != before);
  }

  void drawsAtTheExtremes() {
    Rig rig;
    PadButton flat = someButton();
    flat.end_mm = 0;  // no travel
    rig.pad.setButton(flat);
    rig.pad.setMotion({0, 1e9, true, false, true});
    rig.pad.resize(40, 30);
    rig.pad.grab();
    rig.pad.resize(2000, 90);
    rig.pad.grab();
    for (const auto lamp :
         {PressPad::Lamp::pressJump, PressPad::Lamp::releaseJump, PressPad::Lamp::bottomOut})
      rig.pad.flash(lamp);
    rig.pad.grab();
  }
};

DETENT_WINDOW_TEST(PressPadTest)
#include "press_pad_test.moc"
