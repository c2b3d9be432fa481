// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/import_document.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "importer/assemble_report.h"
#include "importer/overlay/overlay.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::fuzz {
namespace {

/// Small, so that a run tries many inputs.
PageLimits fuzzLimits() {
  PageLimits limits;
  limits.maxMegapixels = 0.3;
  limits.maxPages = 8;
  limits.maxFileMegabytes = 0.5;
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

void knotsMustBeFinite(const StrokeCurve& curve) {
  for (const Knot& knot : curve.knots())
    if (!std::isfinite(knot.displacement_mm) || !std::isfinite(knot.force_N)) std::abort();
}

}  // namespace

void mustBeFinite(const Button& button) {
  for (const ButtonState& state : button.states()) {
    knotsMustBeFinite(state.graph.press());
    knotsMustBeFinite(state.graph.curve(Stroke::release));
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

namespace {

void importGraph(const LocatedGraph& graph) {
  TraceOptions spacing;
  spacing.pointSpacing_px = 2;
  const trace::PlotScene scene(graph.view.raster, graph.frame.value, graph.axes.texts);
  const auto traces = traceCurves(graph.view, scene, graph.axes, {}, spacing);
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

void importPage(const Document& document) {
  const auto page = document.page(1);
  if (!page) return;
  static_cast<void>(readPrintedSpecs(*page));
  LocateOptions options = optionsFor(page->unit);
  auto located = locateGraphs(document, *page, options);
  if (located && located->graphs.empty() && page->unit == PageUnit::pixel) {
    // No frame was found, so a given one leads the rest of the import over the page's content.
    options.frameCorners = {{page->width * 0.15, page->height * 0.1},
                            {page->width * 0.95, page->height * 0.85}};
    located = locateGraphs(document, *page, options);
  }
  if (located && !located->graphs.empty()) importGraph(located->graphs.front());
}

}  // namespace

void importDocument(std::vector<unsigned char> bytes) {
  const auto document = Document::fromBytes(std::move(bytes), "fuzz", fuzzLimits());
  if (document) importPage(*document);
}

}  // namespace detent::importer::fuzz
