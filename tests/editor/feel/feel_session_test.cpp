// SPDX-License-Identifier: GPL-3.0-or-later
// The feel session without any widget: the pair, the finger, what is computed and when.

#include "editor/feel/feel_session.h"

#include <algorithm>
#include <cmath>
#include <QSignalSpy>
#include <QTest>
#include <utility>

#include "editor/feel/force_words.h"
#include "model/edits.h"
#include "tests/editor/feel/feel_buttons.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;

namespace {

/// The panel's settings with that force device.
FeelSettings withForce(const QString& device, bool holds = false) {
  FeelSettings settings;
  settings.sound = false;
  settings.force.device = device;
  settings.force.holds = holds;
  return settings;
}

/// Three times the template: its drop is steeper than any device may render.
Button steepButton() {
  const Result<Button> steep = scaleForce(tactileButton(), 3);
  if (!steep) throw std::runtime_error(steep.failure().sentence());
  return *steep;
}

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
  ForceSession& force() { return session.force(); }
  /// A simulated finger presses the first button.
  void startForce(const QString& device = "sim", bool holds = false) {
    QTRY_VERIFY(ready());
    session.setSettings(withForce(device, holds));
    force().start();
    QTRY_COMPARE(force().state(), ForceState::on);
  }
  double deepest_mm() const {
    double mm = 0;
    for (const auto& p : finger)
      if (p) mm = std::max(mm, p->displacement_mm);
    return mm;
  }
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
    rig.session.exchange();  // no button is loaded
    QCOMPARE(rig.session.feltSide(), FeelSide::b);
  }

  void nothingIsComputedWhileHidden() {
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

  // ---- force

  void noForceWithoutADevice() {
    Rig rig;
    rig.force().start();
    QCOMPARE(rig.force().state(), ForceState::off);
    QVERIFY(!rig.force().margin());
    rig.session.setSettings(withForce("sim:kite"));
    QCOMPARE(rig.force().state(), ForceState::failed);
    QVERIFY(rig.force().trouble().contains("sim:kite"));
    rig.session.setSettings(withForce("sim"));
    QCOMPARE(rig.force().state(), ForceState::off);
    QVERIFY(rig.force().trouble().isEmpty());
  }

  void aSimulatedPressIsWatched() {
    Rig rig;
    rig.startForce();
    QTRY_VERIFY_WITH_TIMEOUT(rig.deepest_mm() > 3.5, 10000);
    QTRY_VERIFY_WITH_TIMEOUT(rig.force().energy().most_mJ > 0.5, 10000);
    QVERIFY(rig.force().status().steps > 100);
    QVERIFY(rig.force().energy().lowestBalance_mJ > -0.05);
    double strongest_N = 0;
    for (const auto& p : rig.finger)
      if (p) strongest_N = std::max(strongest_N, p->force_N);
    QVERIFY2(strongest_N > 0.5, qPrintable(QString::number(strongest_N)));
    rig.force().stop();
    QCOMPARE(rig.force().state(), ForceState::off);
    QTRY_VERIFY(!rig.session.motion().pressed);
    QVERIFY(!rig.finger.back());
  }

  void vibrationFollowsTheSamePress() {
    Rig rig;
    QSignalSpy felt(&rig.session, &FeelSession::eventsFelt);
    rig.startForce();
    const auto jumps = [&] {
      std::size_t count = 0;
      for (const auto& call : felt)
        for (const playback::EngineEvent& e : call.front().value<std::vector<playback::EngineEvent>>())
          count += e.kind == playback::EventKind::pressJump ? 1 : 0;
      return count;
    };
    QTRY_VERIFY_WITH_TIMEOUT(jumps() >= 1, 10000);
    QVERIFY(!rig.session.player().down(1));  // one finger at a time
    rig.force().stop();
    QTRY_VERIFY(!rig.session.player().pressed());
    QVERIFY(rig.session.player().down(1));
    rig.session.up();
  }

  void anotherDeviceStartsByHandOnly() {
    Rig rig;
    rig.startForce("sim");
    rig.session.setSettings(withForce("sim:rig"));
    QTRY_COMPARE(rig.force().state(), ForceState::off);
    QTest::qWait(50);
    QCOMPARE(rig.force().state(), ForceState::off);
    QVERIFY(!rig.force().player());
  }

  void thereIsNoForceOutOfSight() {
    Rig rig;
    rig.startForce("sim", true);
    rig.session.setWatched(false);
    QTRY_VERIFY(!rig.force().running());
    QVERIFY(!rig.force().margin());
    rig.session.setWatched(true);
    QVERIFY(rig.force().margin());
    QVERIFY(!rig.force().running());
  }

  void anEditReachesTheFinger() {
    Rig rig;
    rig.startForce("sim", true);
    QTRY_VERIFY_WITH_TIMEOUT(rig.session.motion().displacement_mm > 1, 10000);
    const Result<Button> stronger = scaleForce(tactileButton(), 1.5);
    QVERIFY(stronger);
    // On a busy machine a press takes its time, and its peak may be as strong as the stronger button held.
    double held_N = 0;
    const auto rests = [&] {
      const double before_N = std::exchange(held_N, rig.session.motion().force_N);
      QTest::qWait(200);
      return std::abs(rig.session.motion().force_N - held_N) < 0.005 && std::abs(held_N - before_N) < 0.005;
    };
    QTRY_VERIFY_WITH_TIMEOUT(rests(), 10000);
    rig.a.history().apply(*stronger, "Scale");
    QTRY_VERIFY_WITH_TIMEOUT(
        rig.session.motion().force_N > held_N + 0.05 || rig.session.motion().displacement_mm < 1.9, 10000);
    QVERIFY(rig.force().running());
  }

  void aDeviceThatCannotBeHadIsSaid() {
    Rig rig;
    QTRY_VERIFY(rig.ready());
    rig.session.setSettings(withForce("serial:/dev/detent-no-such-port"));
    rig.force().start();
    QTRY_COMPARE(rig.force().state(), ForceState::failed);
    QVERIFY(rig.force().trouble().contains("detent-no-such-port"));
    QVERIFY(!rig.session.player().pressed());
  }

  void theNearestStableButtonIsOneStep() {
    Rig rig;
    const Button steep = steepButton();
    ButtonDocument document{steep};
    rig.session.setDocument(FeelSide::a, &document);
    rig.session.setSettings(withForce("sim"));
    QVERIFY(rig.force().margin() && !rig.force().margin()->stable());
    QSignalSpy said(&rig.session, &FeelSession::said);
    rig.force().makeStable();
    QVERIFY(rig.force().margin()->stable());
    QVERIFY(!(document.button() == steep));
    QCOMPARE(rig.force().changes().size(), std::size_t{1});
    const QString words = changeWords(rig.force().changes(), document.button(), {});
    QVERIFY2(words.contains("cN"), qPrintable(words));
    QCOMPARE(said.count(), 1);
    QCOMPARE(document.history().stack().count(), 1);
    document.history().stack().undo();
    QVERIFY(document.button() == steep);
    QTRY_VERIFY(rig.force().changes().empty() && !rig.force().margin()->stable());
  }

  void choicesOfForceAreKept() {
    FeelSettings settings = withForce("odrive:/dev/ttyACM1", true);
    settings.force.largest_N = 1.5;
    settings.force.step_mm = 0.02;
    settings.force.mmPerTurn = -42;
    settings.force.firmwareFile = "/tmp/novint.bin";
    settings.force.upload = settings.force.controller = true;
    QVERIFY(feelSettingsFrom(toMap(settings)) == settings);
  }
};

DETENT_GUILESS_TEST(FeelSessionTest)
#include "feel_session_test.moc"
