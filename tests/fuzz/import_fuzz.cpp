// SPDX-License-Identifier: GPL-3.0-or-later
// The whole import on any bytes: document -> frames -> axes -> trace -> strokes -> callouts -> fit -> button,
// or log -> fit -> button. Nothing may crash, hang, leak, or give a button with a number that is not finite.
//
// Pictures are given their ranges and units: what their labels say is Tesseract's business, which would take
// nearly all of the time and shows the fuzzer nothing. Documents are read without hints, as they carry their
// own text.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include "importer/assemble_report.h"
#include "importer/overlay/overlay.h"
#include "importer/page/picture_header.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// Small, so that a run tries many inputs.
PageLimits fuzzLimits() {
  PageLimits limits;
  limits.maxMegapixels = 0.3;
  limits.maxPages = 8;
  limits.maxFileMegabytes = 0.25;
  limits.maxPathPoints = 5000;
  limits.maxPageSeconds = 2;
  limits.maxDocumentMegabytes = 128;
  return limits;
}

LocateOptions optionsFor(PageUnit unit) {
  LocateOptions options;
  options.view.minFrameWidth_px = 240;
  if (unit == PageUnit::pixel) {
    options.axes.xMin = 0, options.axes.xMax = 4.5;
    options.axes.yMin = 0, options.axes.yMax = 100;
    options.axes.xUnit = LengthUnit::millimetre;
    options.axes.yUnit = ForceUnit::centinewton;
  }
  return options;
}

void mustBeFinite(const StrokeCurve& curve) {
  for (const Knot& knot : curve.knots())
    if (!std::isfinite(knot.displacement_mm) || !std::isfinite(knot.force_N)) std::abort();
}

void mustBeFinite(const Button& button) {
  for (const ButtonState& state : button.states()) {
    mustBeFinite(state.graph.press());
    mustBeFinite(state.graph.curve(Stroke::release));
  }
}

Result<FittedStrokes> fitBoth(const StrokePair& strokes, const FitOptions& options) {
  auto press = fitStroke(strokes.press.points, Stroke::press, options);
  if (!press) return press.failure();
  FittedStrokes fitted{std::move(press).value(), {}};
  if (strokes.release) {
    auto release = fitStroke(strokes.release->points, Stroke::release, options);
    if (!release) return release.failure();
    fitted.release = std::move(release).value();
  }
  return fitted;
}

void importGraph(const LocatedGraph& graph) {
  TraceOptions spacing;
  spacing.pointSpacing_px = 2;
  const auto traces = traceCurves(graph.view, graph.frame.value, graph.axes, {}, spacing);
  if (!traces) return;
  auto strokes = separateStrokes(*traces, graph.axes);
  if (!strokes) return;
  auto callouts = readCallouts(graph.view, graph.frame.value, graph.axes, strokes->value);
  const AxisCalibration& calibration = graph.axes.calibration.value;
  const PointNoise noise{0.3 * calibration.mmPerPx(), 0.3 * calibration.newtonPerPx()};
  auto fitted = fitBoth(strokes->value, fitOptionsFor(FitEffort::draft, noise));
  if (!fitted) return;
  const auto report = assembleReport({graph,
                                      *traces,
                                      std::move(strokes).value(),
                                      std::move(fitted).value(),
                                      0.3,
                                      0.3,
                                      std::move(callouts),
                                      {}},
                                     {"fuzz", "fuzz", "", 1, 1, {}}, {});
  if (!report) return;
  mustBeFinite(report->button);
  static_cast<void>(drawOverlay(*report->evidence, report->strokes, report->button));
}

void importDocument(const Document& document) {
  const auto page = document.page(1);
  if (!page) return;
  static_cast<void>(readPrintedSpecs(*page));
  LocateOptions options = optionsFor(page->unit);
  auto located = locateGraphs(document, *page, options);
  if (located && located->graphs.empty() && page->unit == PageUnit::pixel) {
    // No frame was found: one given by hand leads the rest of the import over whatever is there.
    options.frameCorners = {{page->width * 0.15, page->height * 0.1},
                            {page->width * 0.95, page->height * 0.85}};
    located = locateGraphs(document, *page, options);
  }
  if (located && !located->graphs.empty()) importGraph(located->graphs.front());
}

void importLog(const std::uint8_t* data, std::size_t size) {
  const int file = memfd_create("fuzz", 0);
  if (file < 0 || write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
  const auto log = readForceLog("/proc/self/fd/" + std::to_string(file));
  close(file);
  if (!log) return;
  auto fitted = fitBoth(log->strokes, fitOptionsFor(FitEffort::draft, {log->noise_mm, log->noise_N}));
  if (!fitted) return;
  const auto button = buttonFrom("fuzz", *fitted, {}, {});
  if (button) mustBeFinite(*button);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<unsigned char> bytes(data, data + size);
  if (sniffFileKind(bytes) == FileKind::unknown) {
    importLog(data, size);
    return 0;
  }
  const auto document = Document::fromBytes(std::move(bytes), "fuzz", fuzzLimits());
  if (document) importDocument(*document);
  return 0;
}
