#pragma once
// Front door of the importer.
//
// In:  a picture, a PDF or SVG page, or a force meter's CSV, and what the user decided by hand
// (ImportRequest). Out: a Button, its strokes as traced, and what was found with which confidence
// (ImportReport); or a Failure.
//
// Reading order: page/page.h, frame/plot_frame.h, axes/axis_calibration.h, trace/curve_trace.h,
// strokes/stroke_pair.h, callouts/callouts.h, fit/fit_stroke.h; specs/printed_spec.h checks against the
// page's own words, log/force_log.h reads CSV, overlay/overlay.h draws it all back.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/callouts/callouts.h"
#include "importer/fit/fit_stroke.h"
#include "importer/log/force_log.h"
#include "importer/page/page.h"
#include "importer/quality.h"
#include "importer/specs/printed_spec.h"
#include "importer/strokes/stroke_pair.h"
#include "model/button.h"

namespace detent::importer {

/// What the user settled by hand; everything else is found. Given values are kept while the rest is
/// recomputed.
struct ImportHints {
  std::vector<Point> frame;  ///< empty, 2 (opposite) or 4 corners (tl, tr, br, bl), page units
  AxisHints axes;
  TraceHints trace;  ///< masks here in page units
  StrokeHints strokes;
  std::optional<double> dpi;  ///< render documents at this resolution; (0, 1200]

  bool operator==(const ImportHints&) const = default;
};

/// Which graph, how carefully, and what is already settled.
struct ImportRequest {
  std::string path;
  std::optional<int> page;   ///< from 1
  std::optional<int> graph;  ///< from 1 on its page, reading order
  Quality quality = Quality::standard;
  ImportHints hints;
  PageLimits limits;
  bool wantOverlay = false;
};

/// Below this confidence an import says notCertain (exit 5) and what to pass. Set from the corpus
/// (docs/decisions/0800-import-confidence.md).
inline constexpr double confidenceBar = 0.5;

/// One graph of a document, as `--list` prints it.
struct ListedGraph {
  int page = 1, graph = 1;
  PageUnit unit = PageUnit::pixel;
  Box frame;  ///< page units
  int quarterTurns = 0;
  AxisReading x, y;
  double confidence = 0;
};

/// What an import looked at, for drawing it back over the page. Shared, never changed.
struct GraphEvidence {
  PageView view;
  PlotFrame frame;
  AxesFound axes;
  std::vector<CurveTrace> traces;
};

struct StrokeReport {
  FitSummary fit;
  double rms_px = 0;  ///< orthogonal, of the traced points to the fitted curve; 0 for force logs
};

/// Everything an import found. Usable as it stands: anything not certain enough came back as a Failure
/// instead.
struct ImportReport {
  explicit ImportReport(Button imported) : button(std::move(imported)) {}

  Button button;
  StrokePair strokes;  ///< as traced, before the fit
  int page = 1, graph = 1;
  std::optional<AxisReading> x, y;  ///< empty for force logs
  StrokeReport press;
  std::optional<StrokeReport> release;
  std::vector<Callout> callouts;      ///< operating and reset points that the page points at
  std::vector<SpecCheck> specChecks;  ///< what the page says in words, beside what was read
  double confidence = 0;
  Quality quality = Quality::standard;
  std::map<std::string, double> seconds;  ///< per step
  std::vector<std::string> warnings;
  std::shared_ptr<const GraphEvidence> evidence;  ///< null for force logs
  std::optional<Raster> overlay;                  ///< if asked for
  std::string brief() const;                      ///< one line for people
};

/// An open input that is imported again and again while hints change: a step is recomputed only if something
/// it depends on changed (STYLE 8). One thread at a time; `Progress::cancelled` may be asked from it.
class ImportSession {
 public:
  static Result<ImportSession> open(const std::string& path, const PageLimits& limits = {});

  int pageCount() const;
  bool isForceLog() const;
  /// Pages are read once and kept.
  Result<const Page*> page(int number, const Progress& progress = {});
  /// Graphs of one page (or of all, without a number), reading order.
  Result<std::vector<ListedGraph>> list(std::optional<int> page = {}, Quality quality = Quality::standard,
                                        const ImportHints& hints = {}, const Progress& progress = {});
  /// `path` and `limits` of the request are those of the session.
  Result<ImportReport> importGraph(const ImportRequest& request, const Progress& progress = {});

  ImportSession(ImportSession&&) noexcept;
  ImportSession& operator=(ImportSession&&) noexcept;
  ~ImportSession();

 private:
  struct Impl;
  explicit ImportSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// One import from start to end. Failure codes as DESIGN.md's exit codes.
Result<ImportReport> importGraph(const ImportRequest& request, const Progress& progress = {});
Result<std::vector<ListedGraph>> listGraphs(const ImportRequest& request, const Progress& progress = {});

}  // namespace detent::importer
