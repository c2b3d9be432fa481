// SPDX-License-Identifier: GPL-3.0-or-later
// The feel session without any widget: the pair, the finger, what is computed and when.

#include "editor/feel/feel_session.h"

#include <algorithm>
#include <QSignalSpy>
#include <QTest>

#include "model/edits.h"
#include "tests/editor/feel/feel_buttons.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;

namespace {

struct Rig {
  NoDevices none;
  ButtonDocument a{tactileButton()}, b{linearButton()};
  FeelSession session{nullptr, none.devices()};
  std::vector<std::optional<FingerPosition>> finger;

  Rig() {
    QObject::connect(&session, &FeelSession::fingerMoved, &session, [this](auto p) { finger.push_back(p); });
    session.setWatched(true);
    session.setDocument(FeelSide::a, &a);
  }
  bool ready() const { return session.program() != nullptr; }
};

}  // namespace

class FeelSessionTest : public QObject {
  Q_OBJECT

 private slots:
  void itNeedsNoWidget() { QVERIFY(qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr); }

  void aPressIsFollowed() {
    Rig rig;
    QTRY_VERIFY(rig.ready());
    QSignalSpy moved(&rig.session, &FeelSession::moved);
    rig.session.down();
    QTRY_VERIFY(rig.session.motion().displacement_mm >= 4);
    QVERIFY(rig.session.motion().pressed);
    rig.session.up();
    QTRY_VERIFY(!rig.session.motion().pressed);
    QVERIFY(moved.count() > 5);
    QVERIFY(!rig.finger.back());
    QTRY_VERIFY(rig.session.ownPressKnown());
  }

  void theOtherButtonIsFeltWhereTheFirstOneGoes() {
    Rig rig;
    rig.session.setDocument(FeelSide::b, &rig.b);
    QVERIFY(rig.session.exchangeable());
    rig.session.setDocument(FeelSide::a, nullptr);
    QCOMPARE(rig.session.feltDocument(), &rig.b);
    QCOMPARE(rig.session.feltSide(), FeelSide::b);
    rig.session.exchange();  // nothing is there
    QCOMPARE(rig.session.feltSide(), FeelSide::b);
  }

  void nothingIsComputedWhileNobodyLooks() {
    Rig rig;
    QTRY_VERIFY(rig.ready());
    rig.session.setWatched(false);
    const auto before = rig.session.signal();
    const Result<Button> next = scaleForce(tactileButton(), 2);
    QVERIFY(next);
    rig.a.history().apply(*next, "Scale");
    QTest::qWait(80);
    QCOMPARE(rig.session.signal(), before);
    rig.session.setWatched(true);
    QTRY_VERIFY(rig.session.signal() != before);
  }

  void aPortIsOfferedAndNotOpened() {
    Rig rig;
    QSignalSpy offered(&rig.session, &FeelSession::sensorOffered);
    rig.session.restoreState({{"sensorPort", "/dev/ttyACM7"}, {"gain_dB", -6}});
    QCOMPARE(offered.count(), 1);
    QCOMPARE(offered.front().front().toString(), QString("/dev/ttyACM7"));
    QVERIFY(rig.session.settings().sensorPort.isEmpty());
    QCOMPARE(rig.session.settings().gain_dB, -6.0);
    QCOMPARE(rig.none.opened->load(), 0);
  }

  void aSensorThatCannotBeReachedIsLetGo() {
    Rig rig;
    QTRY_VERIFY(rig.ready());
    QSignalSpy offered(&rig.session, &FeelSession::sensorOffered);
    FeelSettings settings;
    settings.sensorPort = "/dev/detent-no-such-port";
    rig.session.setSettings(settings);
    QTRY_COMPARE(offered.count(), 1);
    QVERIFY(rig.session.settings().sensorPort.isEmpty());
    QVERIFY(rig.session.player().sensorTrouble().contains("detent-no-such-port"));
  }
};

QTEST_GUILESS_MAIN(FeelSessionTest)
#include "feel_session_test.moc"
