// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind the feel panel, one by one.

#include <algorithm>
#include <cmath>
#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include "editor/feel/feel_settings.h"
#include "editor/feel/force_meter.h"
#include "editor/feel/level_meter.h"
#include "editor/feel/placement_delays.h"
#include "editor/feel/press_signal_source.h"
#include "editor/feel/press_strip.h"
#include "editor/feel/signal_view.h"
#include "editor/feel/sound_device_list.h"
#include "model/edits.h"
#include "model/speed_family.h"
#include "tests/editor/feel/feel_buttons.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::test;
using playback::EventKind;

namespace {

std::size_t countOf(const PressSignal& signal, EventKind kind) {
  return static_cast<std::size_t>(std::count_if(signal.events.begin(), signal.events.end(),
                                                [&](const auto& e) { return e.kind == kind; }));
}

Button stronger(const Button& button, double factor) {
  const Result<Button> scaled = scaleForce(button, factor);
  if (!scaled) throw std::runtime_error(scaled.failure().sentence());
  return *scaled;
}

constexpr double lowest_dB = -200;

/// Pixels of a widget within a few steps of a colour.
int pixelsLike(QWidget& widget, QRgb color) {
  const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
  const auto near = [](int a, int b) { return std::abs(a - b) <= 6; };
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb c = image.pixel(x, y);
      if (near(qRed(c), qRed(color)) && near(qGreen(c), qGreen(color)) && near(qBlue(c), qBlue(color)))
        ++count;
    }
  return count;
}

double grey(QRgb c) { return 0.2126 * qRed(c) + 0.7152 * qGreen(c) + 0.0722 * qBlue(c); }

}  // namespace

class FeelPartsTest : public QObject {
  Q_OBJECT

 private slots:
  // The energy is a fault only where the shown balance is one.
  void noBalanceOfZeroIsShownAsAFault() {
    for (const auto& [balance_mJ, words] : {std::pair(0.0, "0.50 of 1.00 returned"),
                                            {-0.0012, "0.50 of 1.00 returned"},
                                            {-0.0049, "0.50 of 1.00 returned"},
                                            {-0.0051, "balance -0.01 mJ"},
                                            {-0.3, "balance -0.30 mJ"}}) {
      ViewSettings view;
      ForceMeter meter(view);
      meter.show({}, {0.5, 1, 0.5, balance_mJ}, 5);
      QVERIFY2(meter.accessibleDescription().contains(words), qPrintable(meter.accessibleDescription()));
    }
  }

  void aSignalHoldsWhatTheButtonHas() {
    const PressSignal tactile = pressSignalOf({tactileButton(), {}, {}});
    QVERIFY(!tactile.failure);
    QVERIFY(tactile.program);
    QCOMPARE(countOf(tactile, EventKind::pressJump), std::size_t{1});
    QCOMPARE(countOf(tactile, EventKind::releaseJump), std::size_t{1});
    QCOMPARE(countOf(tactile, EventKind::bottomOut), std::size_t{1});
    QVERIFY(tactile.peak > 0.1 && tactile.peak <= 1);
    QVERIFY(tactile.duration_s() > 0.3);
    const double drawn_s = static_cast<double>(tactile.spectrogram.columns) * tactile.spectrogram.hop_s;
    QVERIFY(std::fabs(drawn_s - tactile.duration_s()) < 0.01);
    const PressSignal linear = pressSignalOf({linearButton(), {}, {}});
    QCOMPARE(countOf(linear, EventKind::pressJump), std::size_t{0});
  }

  // A press recorded in the second state of a latch is drawn and played from there.
  void aPressBeginsInItsState() {
    const Button latch = lockingButton();
    PressSignalRequest request{latch, {}, {}};
    const PressSignal first = pressSignalOf(request);
    request.firstState = 1;
    const PressSignal second = pressSignalOf(request);
    QVERIFY(first.program && second.program);
    QCOMPARE(first.firstState, std::size_t(0));
    QCOMPARE(second.firstState, std::size_t(1));
    QCOMPARE(second.program->program.states[0].end_mm, first.program->program.states[1].end_mm);
    QCOMPARE(second.program->program.states[1].end_mm, first.program->program.states[0].end_mm);
    QVERIFY(first.samples != second.samples);
    request.firstState = 7;  // state of a former button with more states
    QCOMPARE(pressSignalOf(request).firstState, std::size_t(0));
  }

  // A button with graphs at several speeds is drawn as the press finds it, and pressed at the finger's speed.
  void aPressIsDrawnAtItsSpeed() {
    const Button family = *familyOf({linearButton(), tactileButton()}, {10, 60});
    PressSignalRequest request{family, {}, {}};
    const auto travelled = [&](double speed_mm_per_s) {
      auto press = std::make_shared<playback::PressTrace>();
      press->quantity = playback::PressTrace::Quantity::displacement_mm;
      press->readings = {
          {0, -0.1}, {0.05, -0.1}, {0.05 + 4.2 / speed_mm_per_s, 4.1}, {0.1 + 4.2 / speed_mm_per_s, -0.1}};
      request.press = press;
      return pressSignalOf(request);
    };
    const PressSignal slow = travelled(10), quick = travelled(60);
    QVERIFY(std::fabs(*slow.speed_mm_per_s - 10) < 1e-3 && std::fabs(*quick.speed_mm_per_s - 60) < 1e-3);
    QCOMPARE(countOf(slow, EventKind::pressJump), std::size_t{0});
    QCOMPARE(countOf(quick, EventKind::pressJump), std::size_t{1});
    QVERIFY(slow.program->speeds.size() >= 2);
    QVERIFY(pressSignalOf({family, {}, {}}).speed_mm_per_s);
    QVERIFY(!pressSignalOf({tactileButton(), {}, {}}).speed_mm_per_s);
    QVERIFY(pressSignalOf({tactileButton(), {}, {}}).program->speeds.empty());
  }

  void settingsAndProfileReachTheSignal() {
    playback::PlaybackSettings clicks;
    clicks.mode = playback::FeedbackMode::clickOnly;
    QCOMPARE(countOf(pressSignalOf({tactileButton(), {}, clicks}), EventKind::grain), std::size_t{0});
    playback::DeviceProfile weak;
    weak.gain = 0.25;
    const PressSignal full = pressSignalOf({tactileButton(), {}, {}});
    const PressSignal quarter = pressSignalOf({tactileButton(), weak, {}});
    QVERIFY(std::fabs(quarter.peak / full.peak - 0.25) < 0.02);
    playback::DeviceProfile impossible;
    impossible.gain = -1;
    const PressSignal refused = pressSignalOf({tactileButton(), impossible, {}});
    QVERIFY(refused.failure);
    QVERIFY(!refused.program && refused.samples.empty());
  }

  void latestRequestWins() {
    PressSignalSource source;
    std::vector<std::uint64_t> answered;
    std::shared_ptr<const PressSignal> last;
    connect(&source, &PressSignalSource::ready, this, [&](const std::shared_ptr<const PressSignal>& signal) {
      answered.push_back(signal->revision);
      last = signal;
    });
    const Button start = tactileButton();
    for (int i = 1; i <= 200; ++i) source.request({stronger(start, 1 + 0.002 * i), {}, {}});
    QTRY_VERIFY(last && last->revision == source.lastRequested());
    QCOMPARE(source.lastRequested(), std::uint64_t{200});
    QVERIFY(std::is_sorted(answered.begin(), answered.end()));
    QVERIFY2(answered.size() < 100, "overtaken requests are not computed");
    const PressSignal expected = pressSignalOf({stronger(start, 1.4), {}, {}});
    QVERIFY(last->samples == expected.samples);
  }

  void aSourceMayGoWhileItComputes() {
    for (int i = 0; i < 5; ++i) {
      auto source = std::make_unique<PressSignalSource>();
      bool answered = false;
      connect(source.get(), &PressSignalSource::ready, this, [&] { answered = true; });
      source->request({twoLevelButton(), {}, {}});
      source.reset();
      QCoreApplication::processEvents();
      QVERIFY(!answered);
    }
  }

  void theViewSaysWhatItShows() {
    SignalView view;
    view.resize(500, 320);
    view.show();
    QSignalSpy shown(&view, &SignalView::shown);
    auto signal = std::make_shared<PressSignal>(pressSignalOf({tactileButton(), {}, {}}));
    signal->revision = 7;
    view.setSignal(signal);
    QTRY_VERIFY(!shown.isEmpty());
    QCOMPARE(shown.last().first().toULongLong(), 7ULL);
    QVERIFY(view.accessibleDescription().contains("percent of full scale"));

    const QRgb silence = levelColor(lowest_dB, spectrogramFloor_dB);
    QVERIFY2(pixelsLike(view, silence) > 5000, "the spectrogram is mostly silence");
    QVERIFY2(pixelsLike(view, levelColor(-18, spectrogramFloor_dB)) > 10, "and somewhere it is loud");

    auto failed = std::make_shared<PressSignal>();
    failed->failure = Failure{FailureCode::wrongUsage, "gain", "", "is -1", "Give a gain above 0"};
    view.setSignal(failed);
    QCOMPARE(english(view.pressSignal()->failure->subject.name), std::string("gain"));
    QCOMPARE(pixelsLike(view, silence), 0);
    view.setSignal(nullptr);
    view.grab();
  }

  void levelsGetBrighterEvenly() {
    double before = -1;
    for (double dB = spectrogramFloor_dB; dB <= 0; dB += 1) {
      const double now = grey(levelColor(dB, spectrogramFloor_dB));
      QVERIFY(now > before);
      before = now;
    }
    QCOMPARE(levelColor(-200, spectrogramFloor_dB), levelColor(spectrogramFloor_dB, spectrogramFloor_dB));
    QCOMPARE(levelColor(6, spectrogramFloor_dB), levelColor(0, spectrogramFloor_dB));
  }

  void meterHoldsPeaksAndFalls() {
    LevelMeter meter;
    meter.setLevel(0.5, 1, 10);
    QVERIFY(std::fabs(meter.peak_dB() + 6.02) < 0.01);
    meter.setLevel(0, 1, 10.25);
    QVERIFY(std::fabs(meter.shown_dB() + 6.02 + 10) < 0.01);  // 40 dB a second
    meter.setLevel(0, 1, 10 + LevelMeter::hold_s - 0.01);
    QVERIFY(std::fabs(meter.peak_dB() + 6.02) < 0.01);
    meter.setLevel(0, 1, 10 + LevelMeter::hold_s + 1);
    QVERIFY(meter.peak_dB() < -20);
    QVERIFY(!meter.limited());
    meter.setLevel(0.8, 0.8, 20);
    QVERIFY(meter.limited());
    meter.setLevel(0.1, 0.8, 20.5);
    QVERIFY(meter.limited());  // long enough to be seen
    meter.setLevel(0.1, 0.8, 20 + LevelMeter::hold_s + 0.1);
    QVERIFY(!meter.limited());
    meter.setIdle();
    QCOMPARE(meter.peak_dB(), LevelMeter::lowest_dB);
    meter.setLevel(0, 1, 30);
    QVERIFY(std::isfinite(meter.shown_dB()));
  }

  void stripForgets() {
    PressStrip strip;
    std::vector<playback::EngineEvent> events(20);
    for (std::size_t i = 0; i < events.size(); ++i) events[i].frame = static_cast<std::int64_t>(480 * i);
    strip.addEvents(events, 5, 48000);
    QCOMPARE(strip.eventCount(), std::size_t{20});
    strip.addMoment({5 + PressStrip::span_s, 0, false, false});
    // the events of the last 0.1 s before the oldest drawn moment stay
    QCOMPARE(strip.eventCount(), std::size_t{11});
    strip.addMoment({20, 0, false, false});
    QCOMPARE(strip.eventCount(), std::size_t{0});
  }

  void settingsSurvive() {
    FeelSettings s;
    s.drive = Drive::force;
    s.full_N = 3.25;
    s.followState = false;
    s.mode = playback::FeedbackMode::slopeOnly;
    s.placement = playback::EventPlacement::atOnce;
    s.profileFile = "transducer.device";
    s.sound = false;
    s.device = "ALSA: hw:0,0";
    s.rate_Hz = 96000;
    s.buffer = 128;
    s.gain_dB = -7.5;
    s.sensorPort = "/dev/ttyACM3";
    s.sensorBaud = 115200;
    QVERIFY(feelSettingsFrom(toMap(s)) == s);
    QVERIFY(feelSettingsFrom({}) == FeelSettings{});
    QVERIFY(feelSettingsFrom({{"gain_dB", 1e9},
                              {"full_N", "much"},
                              {"buffer", -3},
                              {"mode", "loud"},
                              {"rate_Hz", std::nan("")}}) == FeelSettings{});
  }

  void delaysAreTheMeasuredOnes() {
    QFile file(DETENT_SOURCE_DIR "/docs/measurements/bench-playback.md");
    QVERIFY(file.open(QIODevice::ReadOnly));
    QString text = QString::fromUtf8(file.readAll());
    text = text.mid(text.indexOf("## Force crossing on a 425 Hz serial sensor"));
    text = text.left(text.indexOf("\n## ", 5));
    for (const PlacementDelay& delay : placementDelays) {
      const QString name = delay.placement == playback::EventPlacement::atOnce ? "fast" : "time-stamped";
      const QRegularExpression row(
          QString(R"(\| %1 \| %2 \| ([\d.]+) \| [\d.]+ \| ([\d.]+) \|)").arg(delay.bufferFrames).arg(name));
      const QRegularExpressionMatch match = row.match(text);
      QVERIFY2(match.hasMatch(), qPrintable(row.pattern()));
      QCOMPARE(delay.median_ms, match.captured(1).toDouble());
      QCOMPARE(delay.spread_ms, match.captured(2).toDouble());
    }
    QVERIFY(measuredDelay(playback::EventPlacement::atOnce, 0).contains("64"));
    QVERIFY(measuredDelay(playback::EventPlacement::atOnce, 1024).contains("128"));
  }

  void devicesAreListedOnAThreadOfTheirOwn() {
    FeelDevices devices;
    std::atomic<bool> onGuiThread{true};
    devices.list = [&, gui = std::this_thread::get_id()]() -> Result<std::vector<playback::SoundDevice>> {
      onGuiThread = std::this_thread::get_id() == gui;
      return std::vector<playback::SoundDevice>{{"ALSA: speaker", 0, 2, 48000, true, false},
                                                {"ALSA: microphone", 1, 0, 48000, false, true}};
    };
    SoundDeviceList list(nullptr, devices);
    list.refresh();
    QVERIFY(list.asking());
    list.refresh();  // one question at a time
    QTRY_VERIFY(!list.asking());
    QVERIFY(!onGuiThread);
    QCOMPARE(list.outputs().size(), std::size_t{1});
    QCOMPARE(list.outputs()[0].name, std::string("ALSA: speaker"));
    QVERIFY(list.trouble().isEmpty());

    devices.list = []() -> Result<std::vector<playback::SoundDevice>> {
      return Failure{FailureCode::deviceTrouble, "sound", "", "no host", "Start one"};
    };
    SoundDeviceList none(nullptr, devices);
    none.refresh();
    QTRY_VERIFY(!none.asking());
    QVERIFY(none.trouble().contains("Start one"));
  }
};

DETENT_WINDOW_TEST(FeelPartsTest)
#include "feel_parts_test.moc"
