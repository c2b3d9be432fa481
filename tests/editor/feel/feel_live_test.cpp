// SPDX-License-Identifier: GPL-3.0-or-later
// The feel panel on a real sound server (JACK with its dummy driver) and a real serial port (a pty).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "editor/feel/feel_panel.h"
#include "editor/feel/level_meter.h"
#include "editor/feel/signal_view.h"
#include "tests/editor/window_tests.h"
#include "tests/playback/device/jack_rig.h"
#include "tests/playback/device/pty_sensor.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;

namespace {

const QString jackDevice = "JACK Audio Connection Kit: system";

/// A panel on the devices of this machine, set to the test's own JACK server.
struct Rig {
  ViewSettings settings;
  ButtonDocument a{tactileButton()}, b{linearButton()};
  FeelSession session;
  FeelPanel panel{settings, session};
  std::optional<FingerPosition> finger;
  double deepest_mm = 0;

  Rig() {
    QObject::connect(&session, &FeelSession::fingerMoved, &panel, [this](auto p) {
      finger = p;
      if (p) deepest_mm = std::max(deepest_mm, p->displacement_mm);
    });
    panel.resize(420, 1000);
    panel.restoreState({{"device", jackDevice}});
    panel.show();
    session.setDocument(FeelSide::a, &a);
  }
  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  QString status() { return part<QLabel>("soundStatus")->text(); }
  LevelMeter* meter() { return part<LevelMeter>("levelMeter"); }
  bool ready() {
    auto* view = part<SignalView>("signalView");
    return view->pressSignal() && view->pressSignal()->program;
  }
  void press(int hold_ms = 150) {
    auto* pad = part<QWidget>("pressPad");
    pad->setFocus();
    QTest::keyPress(pad, Qt::Key_Space);
    QTest::qWait(hold_ms);
    static_cast<void>(
        QTest::qWaitFor([this] { return deepest_mm >= 4; }, 2000));  // waits, however busy the machine is
    QTest::keyRelease(pad, Qt::Key_Space);
  }
  bool sounding() { return status().contains("48 kHz"); }
};

double loudest(const JackListener& listener, std::size_t from = 0) {
  const std::vector<float> heard = listener.recorded();
  float peak = 0;
  for (std::size_t i = from; i < heard.size(); ++i) peak = std::max(peak, std::fabs(heard[i]));
  return static_cast<double>(peak);
}

/// The loudest sample of a press played as drawn, which does not depend on how fast this machine moves a
/// finger. A take of which the sound server lost something is taken again.
double drawnPeak(Rig& rig, const JackListener& listener) {
  auto* play = rig.part<QToolButton>("play");
  double peak = 0;
  for (int take = 0; take < 8; ++take) {
    if (!QTest::qWaitFor([&] { return play->isEnabled() && !rig.finger; }, 5000)) return 0;
    const std::uint64_t losses = listener.xruns();
    const std::size_t from = listener.recorded().size();
    QTest::keyClick(rig.part<QWidget>("pressPad"), Qt::Key_P);
    if (!QTest::qWaitFor([&] { return !play->isEnabled(); }, 5000)) return 0;
    if (!QTest::qWaitFor([&] { return play->isEnabled(); }, 10000)) return 0;
    QTest::qWait(100);
    peak = loudest(listener, from);
    if (listener.xruns() == losses) return peak;
  }
  return peak;
}

bool skipped(const JackServer& server, const char* what) {
  if (server.ready()) return false;
  std::cout << "SKIPPED " << what << ": " << server.whyNot() << std::endl;
  return true;
}

}  // namespace

class FeelLiveTest : public QObject {
  Q_OBJECT

 private slots:
  void theFirstPressOpensTheDeviceAndTheNextSounds() {
    JackServer server(128);
    if (skipped(server, "the feel panel's sound")) return;
    Rig rig;
    QTRY_VERIFY(rig.ready());
    QVERIFY(!rig.sounding());
    rig.press();
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 5000);
    QTRY_VERIFY2(rig.status().contains("buffer 128 (2.7 ms)"), qPrintable(rig.status()));
    QTRY_VERIFY(!rig.finger);

    JackListener listener;
    QVERIFY(listener.ready() && listener.listenTo("detent:out_1"));
    rig.press();
    QTRY_VERIFY(loudest(listener) > 0.05);
    QTRY_VERIFY(rig.meter()->peak_dB() > -30);
    QCOMPARE(rig.deepest_mm, 4.0);

    const double full = drawnPeak(rig, listener);
    QVERIFY(full > 0.05);
    rig.panel.restoreState({{"device", jackDevice}, {"gain_dB", -20}});
    QTest::qWait(400);
    const double tenth = drawnPeak(rig, listener);
    QVERIFY2(std::fabs(tenth / full - 0.1) < 0.02, qPrintable(QString::number(tenth / full)));

    // True levels: a linear button has no jump, and nothing makes up for it.
    rig.session.setDocument(FeelSide::b, &rig.b);
    rig.session.exchange();
    QTRY_COMPARE(rig.session.feltDocument(), &rig.b);

    QTest::mouseClick(rig.part<QToolButton>("soundSwitch"), Qt::LeftButton);
    QTRY_VERIFY(rig.status().contains("off"));
    const std::size_t silent = listener.recorded().size();
    rig.press();
    QTest::qWait(200);
    QCOMPARE(loudest(listener, silent + 4800), 0.0);
  }

  void aReferenceSoundsUnchangedAndEndsOnRequest() {
    JackServer server(128);
    if (skipped(server, "the feel panel's reference")) return;
    Rig rig;
    QTRY_VERIFY(rig.ready());
    QTemporaryDir folder;
    const std::string file = folder.filePath("tone.wav").toStdString();
    std::vector<float> tone(48000);
    for (std::size_t i = 0; i < tone.size(); ++i)
      tone[i] = static_cast<float>(0.4 * std::sin(2 * M_PI * 250 * static_cast<double>(i) / 48000));
    QVERIFY(playback::writeSoundFile(tone, 48000, file));
    rig.session.setReference(QString::fromStdString(file));
    QTRY_VERIFY(rig.session.reference());
    rig.press();  // opens the device
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 5000);
    QTRY_VERIFY(!rig.finger);
    JackListener listener;
    QVERIFY(listener.ready() && listener.listenTo("detent:out_1"));
    auto* play = rig.part<QToolButton>("playReferenceButton");
    QTRY_VERIFY(play->isEnabled());
    QTest::qWait(300);

    const std::size_t from = listener.recorded().size();
    QTest::mouseClick(play, Qt::LeftButton);
    QTRY_VERIFY(play->text().contains("Stop"));
    QTRY_VERIFY_WITH_TIMEOUT(!rig.session.player().samplesPlaying(), 10000);
    QTest::qWait(150);
    QVERIFY(std::fabs(loudest(listener, from) - 0.4) < 0.002);
    const std::vector<float> heard = listener.recorded();
    const auto sounding = std::count_if(heard.begin() + static_cast<std::ptrdiff_t>(from), heard.end(),
                                        [](float v) { return std::fabs(v) > 0.01f; });
    QVERIFY2(sounding > 40000 && sounding < 49000, qPrintable(QString::number(sounding)));

    QTRY_VERIFY(play->isEnabled() && play->text().contains("Play"));
    QTest::mouseClick(play, Qt::LeftButton);
    QTRY_VERIFY(play->text().contains("Stop"));
    QTest::mouseClick(play, Qt::LeftButton);
    // much shorter than the second that the sound lasts
    QTRY_VERIFY_WITH_TIMEOUT(!rig.session.player().samplesPlaying(), 500);
  }

  void forceAndVibrationComeFromOnePress() {
    JackServer server(128);
    if (skipped(server, "force and vibration at once")) return;
    Rig rig;
    QTRY_VERIFY(rig.ready());
    rig.panel.restoreState({{"device", jackDevice}, {"forceDevice", "sim:rig"}});
    QTest::mouseClick(rig.part<QToolButton>("forceSwitch"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 10000);  // the sound device is opened as by a press
    JackListener listener;
    QVERIFY(listener.ready() && listener.listenTo("detent:out_1"));
    rig.deepest_mm = 0;
    QTRY_VERIFY_WITH_TIMEOUT(rig.deepest_mm > 3.5 && loudest(listener) > 0.05, 10000);

    QTest::mouseClick(rig.part<QToolButton>("forceSwitch"), Qt::LeftButton);
    QTRY_VERIFY(!rig.finger);
    QTest::qWait(400);
    const std::size_t from = listener.recorded().size();
    QTest::qWait(300);
    QCOMPARE(loudest(listener, from), 0.0);
    QVERIFY(rig.sounding());
  }

  void theDrawnPressPlaysByItself() {
    JackServer server(128);
    if (skipped(server, "playing a press")) return;
    Rig rig;
    QTRY_VERIFY(rig.ready());
    rig.part<QToolButton>("play")->click();  // opens the device, then plays
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 5000);
    QTRY_VERIFY_WITH_TIMEOUT(rig.deepest_mm == 4.0, 5000);
    QTRY_VERIFY(!rig.finger);
    JackListener listener;
    QVERIFY(listener.ready() && listener.listenTo("detent:out_1"));
    const double heard = drawnPeak(rig, listener);
    const auto drawn = rig.part<SignalView>("signalView")->pressSignal()->peak;
    QVERIFY2(std::fabs(heard / drawn - 1) < 0.02, qPrintable(QString::number(heard / drawn)));
  }

  void aLostDeviceIsSaidAndTakenUpAgain() {
    JackServer server(256);
    if (skipped(server, "the feel panel's lost device")) return;
    Rig rig;
    QTRY_VERIFY(rig.ready());
    rig.press();
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 5000);
    QTRY_VERIFY(!rig.finger);
    server.stop();
    QTRY_VERIFY_WITH_TIMEOUT(rig.status().contains("is disconnected"), 6000);
    rig.deepest_mm = 0;
    rig.press();
    QTRY_COMPARE(rig.deepest_mm, 4.0);
    server.start();
    if (skipped(server, "the feel panel's return of a device")) return;
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 10000);
    QTRY_VERIFY(rig.status().contains("lost: 1"));
    JackListener listener;
    QVERIFY(listener.ready() && listener.listenTo("detent:out_1"));
    rig.press();
    QTRY_VERIFY(loudest(listener) > 0.05);
  }

  void devicesAreListedAndChosen() {
    JackServer server(128);
    if (skipped(server, "the feel panel's list of devices")) return;
    Rig rig;
    rig.panel.restoreState({{"setupShown", true}});
    QTRY_VERIFY(rig.ready());
    auto* devices = rig.part<QComboBox>("soundDevice");
    QTRY_VERIFY_WITH_TIMEOUT(devices->findData(jackDevice) > 0, 5000);
    rig.press();
    QTest::qWait(50);
    devices->setCurrentIndex(devices->findData(jackDevice));
    QCOMPARE(rig.panel.saveState().value("device").toString(), jackDevice);
    QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 8000);
  }

  void aSensorPresses_data() {
    QTest::addColumn<bool>("sound");
    QTest::newRow("with sound") << true;
    QTest::newRow("silent") << false;
  }
  void aSensorPresses() {
    QFETCH(bool, sound);
    JackServer server(128);
    if (sound && skipped(server, "a sensor with sound")) return;
    PtySensor pty;
    if (!pty.ready()) {
      std::cout << "SKIPPED the feel panel's sensor: no pseudo-terminal" << std::endl;
      return;
    }
    Rig rig;
    QTRY_VERIFY(rig.ready());
    if (sound) {
      rig.press();
      QTRY_VERIFY_WITH_TIMEOUT(rig.sounding(), 5000);
      QTRY_VERIFY(!rig.finger);
    } else {
      rig.panel.restoreState({{"sound", false}});
    }
    rig.deepest_mm = 0;
    rig.part<QComboBox>("sensorPort")->setCurrentText(QString::fromStdString(pty.port()));
    rig.part<QPushButton>("sensorConnect")->click();
    QVERIFY2(rig.part<QPushButton>("sensorConnect")->isChecked(),
             qPrintable(rig.part<QLabel>("sensorNote")->text()));
    bool ran = false;
    for (int i = 0; i <= 240; ++i) {
      char line[40];
      std::snprintf(line, sizeof line, "%d,%.4fN\n", i * 2353, 0.9 * std::min(i, 240 - i) / 120);
      pty.send(line);
      QTest::qWait(3);
      ran = ran || rig.part<QLabel>("sensorNote")->text().contains("readings a second");
    }
    QVERIFY(ran);
    QTRY_COMPARE(rig.deepest_mm, 4.0);
    QTRY_VERIFY(!rig.finger);
    pty.unplug();
    QTRY_VERIFY_WITH_TIMEOUT(rig.part<QLabel>("sensorNote")->text().contains("unplugged"), 4000);
    rig.part<QPushButton>("sensorConnect")->click();
    QTRY_VERIFY(!rig.part<QLabel>("sensorNote")->isVisible());
  }
};

DETENT_WINDOW_TEST(FeelLiveTest)
#include "feel_live_test.moc"
