#pragma once
// Front door of the importer.
// In:  a picture, a PDF or SVG page, or a force meter's CSV, and whatever the user decided by hand (ImportRequest).
// Out: a Button, its strokes as traced, and what was found with which confidence (ImportReport); or a Failure.
// Reading order: page/page.h -> frame/plot_frame.h -> axes/axis_calibration.h -> trace/curve_trace.h ->
//                strokes/stroke_pair.h -> fit/fit_stroke.h; log/force_log.h for CSV; overlay/overlay.h draws it all back.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "importer/fit/fit_stroke.h"
#include "importer/log/force_log.h"
#include "importer/page/page.h"
#include "importer/strokes/stroke_pair.h"
#include "model/button.h"

namespace detent::importer {

enum class Quality { draft, standard, precise };

/// What the user settled by hand; everything else is found. Given values are kept while the rest is recomputed.
struct ImportHints {
  std::optional<std::vector<Point>> frame;   ///< 2 (opposite) or 4 corners, page units
  AxisHints axes;
  TraceHints trace;                          ///< masks here in page units
  StrokeHints strokes;
  std::optional<double> dpi;
};

struct ImportRequest {
  std::string path;
  std::optional<int> page;                   ///< from 1
  std::optional<int> graph;                  ///< from 1 on its page
  Quality quality = Quality::standard;
  ImportHints hints;
  PageLimits limits;
  bool wantOverlay = false;
};

/// Below this confidence an import says notCertain (exit 5) and what to pass. Set from the corpus (docs/decisions).
inline constexpr double confidenceBar = 0.5;

/// One graph of a document, as `--list` prints it.
struct ListedGraph {
  int page = 1, graph = 1;
  PageUnit unit = PageUnit::pixel;
  Box frame;                                 ///< page units
  int quarterTurns = 0;
  AxisReading x, y;
  double confidence = 0;
};

struct StrokeReport {
  FitSummary fit;
  double rms_px = 0;                         ///< orthogonal, of the traced points to the fitted curve; 0 for force logs
};

struct ImportReport {
  Button button;
  StrokePair strokes;                        ///< as traced, before the fit
  int page = 1, graph = 1;
  std::optional<AxisReading> x, y;           ///< empty for force logs
  StrokeReport press;
  std::optional<StrokeReport> release;
  double confidence = 0;
  Quality quality = Quality::standard;
  std::map<std::string, double> seconds;     ///< per step
  std::vector<std::string> warnings;
  std::optional<Raster> overlay;             ///< if asked for
  std::string brief() const;                 ///< one line for people
};

Result<ImportReport> importGraph(const ImportRequest& request, const Progress& progress = {});
Result<std::vector<ListedGraph>> listGraphs(const ImportRequest& request, const Progress& progress = {});

}  // namespace detent::importer
