// SPDX-License-Identifier: GPL-3.0-or-later
// Drag to repaint: from a mouse event to the finished picture, with a 12-megapixel page under 1,000 knots.
// Prints a table as Markdown (docs/measurements/bench-editor.md). Run with QT_QPA_PLATFORM=offscreen for
// drawing alone, in a real window for the whole way.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <QApplication>
#include <QMouseEvent>

#include "editor/canvas/graph_canvas.h"
#include "editor/panels/graph_workspace.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/values_panel.h"
#include "model/templates.h"

using namespace detent;
using namespace detent::editor;

namespace {

constexpr int knotCount = 1000, moves = 400, rounds = 5;

// A tactile curve sampled at many knots, on both strokes together `knotCount`.
Button manyKnots() {
  const auto plain = tactileButton();
  const auto resampled = [](const StrokeCurve& curve) {
    std::vector<CurvePoint> points;
    const double end = curve.end_mm() - 1e-6;
    for (int i = 0; i < knotCount / 2; ++i) {
      const double x = end * i / (knotCount / 2 - 1);
      points.push_back({x, curve.force_N(x)});
    }
    return StrokeCurve::throughPoints(points);
  };
  ButtonState state = plain->states()[0];
  const auto graph =
      ForceGraph::fromCurves(*resampled(state.graph.press()), *resampled(*state.graph.release()));
  state.graph = *graph;
  state.operatingPoint_mm = 2.0;
  state.resetPoint_mm = 1.7;
  return *Button::fromStates("bench", {state});
}

// Paper with a fine grid and some noise, so that nothing compresses or aligns by luck.
std::shared_ptr<const importer::ImportReport> bigPage(const Button& button) {
  auto report = std::make_shared<importer::ImportReport>(button);
  auto evidence = std::make_shared<importer::GraphEvidence>();
  importer::Raster& raster = evidence->view.raster;
  raster.width_px = 4000;
  raster.height_px = 3000;
  raster.rgb.resize(4000UL * 3000UL * 3UL);
  std::uint32_t noise = 1;
  for (std::size_t i = 0; i < raster.rgb.size(); ++i) {
    noise = noise * 1664525U + 1013904223U;
    const std::size_t pixel = i / 3, x = pixel % 4000, y = pixel / 4000;
    const bool line = x % 250 < 3 || y % 250 < 3;
    raster.rgb[i] = static_cast<std::uint8_t>((line ? 120 : 235) + (noise >> 28));
  }
  // 4000 px are 5 mm, 3000 px are 1.5 N; y of the page counts downwards.
  evidence->axes.calibration.value.viewToUnits = {5.0 / 4000, 0, -0.4, 0, -1.5 / 3000, 1.35, 0, 0, 1};
  report->evidence = evidence;
  return report;
}

class PaintCounter : public QObject {
 public:
  int paints = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++paints;
    return false;
  }
};

struct Figures {
  double p50_ms = 0, p99_ms = 0, max_ms = 0;
};

// Elapsed time is the waiting time of a person; processor time is meaningful on a busy machine too.
struct Times {
  std::vector<double> elapsed_ms, processor_ms;
};

struct Run {
  Figures elapsed, processor;
};

Figures figuresOf(std::vector<double> times_ms) {
  std::sort(times_ms.begin(), times_ms.end());
  const auto at = [&](double share) {
    return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
  };
  return {at(0.5), at(0.99), times_ms.back()};
}

void send(QWidget& widget, QEvent::Type type, QPointF at) {
  const Qt::MouseButtons down = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, at, widget.mapToGlobal(at),
                    type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, down, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &event);
}

// One long drag in circles around the grabbed point; each move waits until the canvas has painted.
Times dragTimes(GraphCanvas& canvas, QPointF grab, PaintCounter& counter) {
  Times times;
  send(canvas, QEvent::MouseButtonPress, grab);
  for (int i = 0; i < moves; ++i) {
    const double angle = 0.1 * i;
    const QPointF at = grab + QPointF(9 * std::cos(angle), 9 * std::sin(angle) - 14);
    const int before = counter.paints;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t startProcessor = std::clock();
    send(canvas, QEvent::MouseMove, at);
    for (int spins = 0; counter.paints == before && spins < 100; ++spins) QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents();
    const auto end = std::chrono::steady_clock::now();
    times.elapsed_ms.push_back(std::chrono::duration<double, std::milli>(end - start).count());
    times.processor_ms.push_back(1e3 * static_cast<double>(std::clock() - startProcessor) / CLOCKS_PER_SEC);
  }
  send(canvas, QEvent::MouseButtonRelease, grab);
  return times;
}

void show(GraphWorkspace& workspace, const char* action, bool on) {
  for (QAction* candidate : workspace.viewActions())
    if (candidate->objectName() == QLatin1String(action)) candidate->setChecked(on);
}

void measure(const char* name, const Button& button, bool page, bool everything, QSize size) {
  ViewSettings settings;
  ButtonDocument document(button);
  if (page) document.setOrigin(bigPage(button));
  GraphWorkspace workspace(document, settings);
  ValuesPanel values(document, settings);
  HistoryPanel history(document);
  workspace.resize(size);
  workspace.show();
  if (everything) {
    show(workspace, "viewDisplacementForce", true);
    values.resize(420, 900);
    values.show();
    history.show();
  }
  QCoreApplication::processEvents();
  GraphCanvas& canvas = workspace.canvas();
  PaintCounter counter;
  canvas.installEventFilter(&counter);
  std::vector<Run> runs;
  for (int round = 0; round < rounds; ++round) {
    const TactilePoint peak = canvas.values().press.tactile.at(0);
    const QPointF grab = canvas.mapping().toPixel(peak.displacement_mm, peak.force_N);
    const Times times = dragTimes(canvas, grab, counter);
    runs.push_back({figuresOf(times.elapsed_ms), figuresOf(times.processor_ms)});
    document.history().stack().undo();
    QCoreApplication::processEvents();
  }
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.elapsed.p99_ms < b.elapsed.p99_ms; });
  const Run &best = runs.front(), &median = runs[runs.size() / 2];
  std::printf("| %s | %d × %d | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", name, size.width(),
              size.height(), median.elapsed.p50_ms, median.elapsed.p99_ms, best.elapsed.p50_ms,
              best.elapsed.p99_ms, median.processor.p50_ms, median.processor.p99_ms);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  const Button small = *tactileButton(), large = manyKnots();
  std::printf(
      "| case | window | p50 ms | p99 ms | best p50 ms | best p99 ms | processor p50 ms | processor p99 ms "
      "|\n"
      "|---|---|---|---|---|---|---|---|\n");
  measure("6 knots, no page", small, false, false, {1200, 800});
  measure("1,000 knots, no page", large, false, false, {1200, 800});
  measure("1,000 knots, 12-megapixel page", large, true, false, {1200, 800});
  measure("the same, second view, values and history", large, true, true, {1200, 800});
  measure("the same, larger window", large, true, true, {1880, 1000});
  return 0;
}
