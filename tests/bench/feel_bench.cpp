// SPDX-License-Identifier: GPL-3.0-or-later
// feel_bench [--out FILE] [--note TEXT]: delay from an edit to its display in the feel panel, and rate of the
// finger's updates. Figures: docs/measurements/bench-feel.md

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <fstream>
#include <iostream>
#include <QApplication>
#include <QEventLoop>
#include <QTest>
#include <QTimer>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "editor/feel/feel_panel.h"
#include "editor/feel/signal_view.h"
#include "model/edits.h"
#include "model/file/button_file.h"

using namespace detent;
using namespace detent::editor;
using Clock = std::chrono::steady_clock;

namespace {

constexpr double bar_ms = 50;  // issue 5: updated within 50 ms of an edit while dragging
constexpr int editsPerRun = 400;

double since_ms(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

template <class T>
T must(Result<T> result) {
  if (result) return *std::move(result);
  std::cerr << result.failure().sentence() << "\n";
  std::exit(1);
}

/// The same shape with `count` knots on the press stroke.
Button withKnots(const Button& button, std::size_t count) {
  return must(editGraph(button, 0, [count](const ForceGraph& graph) {
    return editStroke(graph, Stroke::press, [count](const StrokeCurve& curve) -> Result<StrokeCurve> {
      StrokeCurve dense = curve;
      for (std::size_t i = 1; dense.knots().size() < count && i < 3 * count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count + 1);
        Result<StrokeCurve> next = insertKnot(dense, curve.start_mm() + share * curve.travel_mm());
        if (next) dense = *std::move(next);
      }
      return dense;
    });
  }));
}

/// Handles events without spinning: real-time threads that never sleep are stopped by the system.
void waitFor_ms(double wait_ms) {
  if (wait_ms <= 0) return;
  QEventLoop loop;
  QTimer::singleShot(std::chrono::milliseconds(std::lround(std::ceil(wait_ms))), Qt::PreciseTimer, &loop,
                     &QEventLoop::quit);
  loop.exec();
}

/// Nothing that sounds: the figures are those of the window.
FeelDevices noDevices() {
  FeelDevices devices;
  devices.open = [](const playback::PlayerSettings&,
                    const playback::LiveProgram&) -> Result<std::unique_ptr<playback::LivePlayer>> {
    return Failure{FailureCode::deviceTrouble, "sound", "", "is left out of this benchmark", "Go on"};
  };
  devices.list = []() -> Result<std::vector<playback::SoundDevice>> {
    return std::vector<playback::SoundDevice>{};
  };
  return devices;
}

/// Delays from each edit to the first picture that shows it or a later one.
struct DragFigures {
  std::vector<double> delays_ms;
  std::size_t pictures = 0;
  double computing_ms = 0;  ///< median of prepare, render and spectrogram
};

DragFigures drag(const Button& button, double editsPerSecond) {
  ViewSettings settings;
  ButtonDocument document(button);
  FeelSession session(nullptr, noDevices());
  FeelPanel panel(settings, session);
  panel.resize(420, 900);
  panel.show();
  auto* view = panel.findChild<SignalView*>("signalView");
  std::deque<std::pair<quint64, Clock::time_point>> waiting;
  DragFigures figures;
  std::vector<double> computing;
  QObject::connect(view, &SignalView::shown, &panel, [&](quint64 revision) {
    if (waiting.empty() || waiting.front().first > revision) return;
    ++figures.pictures;
    computing.push_back(1000 * view->pressSignal()->computing_s);
    for (; !waiting.empty() && waiting.front().first <= revision; waiting.pop_front())
      figures.delays_ms.push_back(since_ms(waiting.front().second));
  });
  session.setDocument(FeelSide::a, &document);
  while (!view->pressSignal() || !view->pressSignal()->program) QTest::qWait(5);
  quint64 revision = view->pressSignal()->revision;

  document.history().beginDrag("Drag");
  const auto began = Clock::now();
  for (int i = 0; i < editsPerRun; ++i) {
    const Button next = must(scaleForce(button, 1 + 0.3 * std::sin(0.05 * i)));
    const double due_ms = 1000 * i / editsPerSecond;
    waitFor_ms(due_ms - since_ms(began));
    waiting.emplace_back(++revision, Clock::now());
    document.history().preview(next);
    QCoreApplication::processEvents();
  }
  for (const auto end = Clock::now() + std::chrono::seconds(2); !waiting.empty() && Clock::now() < end;)
    waitFor_ms(5);
  document.history().cancelDrag();
  figures.computing_ms = quantile(computing, 0.5);
  return figures;
}

struct FingerFigures {
  double perSecond = 0;
  std::vector<double> gaps_ms;
};

FingerFigures finger(const Button& button) {
  ViewSettings settings;
  ButtonDocument document(button);
  FeelSession session(nullptr, noDevices());
  FeelPanel panel(settings, session);
  panel.resize(420, 900);
  panel.show();
  FingerFigures figures;
  std::vector<Clock::time_point> reported_;
  QObject::connect(&session, &FeelSession::fingerMoved, &panel, [&](auto p) {
    if (p) reported_.push_back(Clock::now());
  });
  session.setDocument(FeelSide::a, &document);
  auto* pad = panel.findChild<QWidget*>("pressPad");
  pad->setFocus();
  QTest::qWait(200);
  QTest::keyPress(pad, Qt::Key_Space);
  QTest::qWait(3000);
  QTest::keyRelease(pad, Qt::Key_Space);
  for (std::size_t i = 1; i < reported_.size(); ++i)
    figures.gaps_ms.push_back(
        std::chrono::duration<double, std::milli>(reported_[i] - reported_[i - 1]).count());
  if (reported_.size() > 1)
    figures.perSecond = static_cast<double>(reported_.size() - 1) /
                        std::chrono::duration<double>(reported_.back() - reported_.front()).count();
  return figures;
}

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  std::string out, note;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--out") == 0) out = argv[i + 1];
    if (std::strcmp(argv[i], "--note") == 0) note = std::string(argv[i + 1]) + "\n\n";
  }

  const std::string folder = DETENT_SOURCE_DIR "/samples/buttons/";
  const Button brown = must(readButtonFile(folder + "B.button.json"));
  const Button camera = must(readButtonFile(folder + "D.button.json"));
  const Button locking = must(readButtonFile(folder + "EF.button.json"));
  const struct {
    const char* name;
    Button button;
  } cases[] = {{"B, tactile", brown},
               {"D, two levels", camera},
               {"EF, self-locking", locking},
               {"D, 1,000 knots", withKnots(camera, 1000)}};

  std::ostringstream text;
  text << "# The feel panel, measured\n\n"
          "Written by `feel_bench` (tests/bench). Qt's offscreen platform, a panel of 420 × 900 px, "
       << std::thread::hardware_concurrency()
       << " processors; ms.\nWithout a display's own delay, and without a sound "
          "device.\n\n"
       << note
       << "## Edit to waveform and spectrogram\n\n"
          "A drag previews "
       << editsPerRun
       << " buttons at a steady pace. From each edit to the end of the first repaint that shows it or\n"
          "a later one; an edit that a later one overtakes is not computed. The bar is "
       << format("%.0f", bar_ms)
       << " ms. *Computing* is the worker's\npart: prepare, render, spectrogram.\n\n"
          "| button | edits/s | p50 | p99 | max | pictures | computing, median "
          "|\n|---|---|---|---|---|---|---|\n";
  bool held = true;
  for (const auto& c : cases) {
    for (const double rate : {60.0, 125.0}) {
      const DragFigures f = drag(c.button, rate);
      const double p99 = quantile(f.delays_ms, 0.99);
      held = held && p99 <= bar_ms && f.delays_ms.size() == editsPerRun;
      text << format("| %s | %.0f | %.1f | %.1f | %.1f | %zu | %.1f |\n", c.name, rate,
                     quantile(f.delays_ms, 0.5), p99, quantile(f.delays_ms, 1), f.pictures, f.computing_ms);
    }
  }
  const FingerFigures f = finger(brown);
  text << "\n## Finger to the graph\n\n"
          "`fingerMoved` while a key is held for 3 s. At least 60 a second are asked for.\n\n"
          "| a second | gap p50 | gap p99 | gap max |\n|---|---|---|---|\n"
       << format("| %.0f | %.1f | %.1f | %.1f |\n", f.perSecond, quantile(f.gaps_ms, 0.5),
                 quantile(f.gaps_ms, 0.99), quantile(f.gaps_ms, 1));
  std::cout << text.str();
  if (!out.empty()) std::ofstream(out) << text.str();
  if (!held) std::cerr << "The bar of " << bar_ms << " ms was not held.\n";
  return held ? 0 : 1;
}
