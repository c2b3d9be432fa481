// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public interface of the importer.
//
// In:  a picture, a PDF or SVG page, or a force meter's CSV, and what the user decided by hand
// (ImportRequest). Out: a Button, its strokes as traced, and what was found with which confidence
// (ImportReport); or a Failure.
//
// Reading order: page/page.h, frame/plot_frame.h, axes/axis_calibration.h, trace/curve_trace.h,
// strokes/stroke_pair.h, callouts/callouts.h, fit/fit_stroke.h; specs/printed_spec.h checks against the
// page's own words, log/force_log.h reads CSV, overlay/overlay.h draws it all back.

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/callouts/callouts.h"
#include "importer/fit/fit_stroke.h"
#include "importer/log/force_log.h"
#include "importer/page/confidence_bar.h"
#include "importer/page/document.h"
#include "importer/page/page.h"
#include "importer/page/page_class.h"
#include "importer/page/progress.h"
#include "importer/quality.h"
#include "importer/specs/printed_spec.h"
#include "importer/strokes/stroke_pair.h"
#include "importer/strokes/switches.h"
#include "importer/trace/explanation.h"
#include "model/button.h"

namespace detent::importer {

/// Strokes drawn by hand along the curve on the page: points in page units, from the start of the press (the
/// end of the release) to the other end; empty if none was drawn. Between the points the line follows the
/// curve's pixels (trace/follow_drawn.h). A line over part of a traced stroke replaces that part.
struct DrawnStrokes {
  std::vector<Point> press, release;
  bool operator==(const DrawnStrokes&) const = default;
};

/// Values given by the user; everything else is found. Given values are kept while the rest is recomputed.
struct ImportHints {
  std::vector<Point> frame;  ///< empty, 2 (opposite) or 4 corners (tl, tr, br, bl), page units
  AxisHints axes;
  TraceHints trace;  ///< masks here in page units
  StrokeHints strokes;
  DrawnStrokes drawn;
  ColumnHints columns;        ///< columns of a table
  std::string releasePath;    ///< a second file with the release of the first one's press; empty: none
  std::optional<double> dpi;  ///< render documents at this resolution; (0, 1200]

  bool operator==(const ImportHints&) const = default;
};

/// Returns true if a person decided this stroke: its colour, its line, or that there is no release. An answer
/// settles only the question it answers: the other stroke is still found, with all doubts about that choice.
bool strokeIsGiven(const ImportHints& hints, Stroke stroke);

/// Remedies that the user has not supplied yet. A remedy that was supplied and did not remove the doubt is
/// not offered again. If none is left: drawing the strokes by hand, unless only axes can help, then
/// accepting the doubt.
Remedies leftToTry(const Remedies& remedies, const ImportHints& hints);

/// Wall-clock time that the imports of one input may take together.
struct TimeLimit {
  /// Starts now. A share below 1 ends it earlier, which leaves time for work on the results.
  explicit TimeLimit(double limit_s, double share = 1)
      : seconds(limit_s),
        end(std::chrono::steady_clock::now() +
            std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                std::chrono::duration<double>(share * limit_s))) {}
  bool passed() const { return std::chrono::steady_clock::now() >= end; }

  double seconds = 0;  ///< > 0
  std::chrono::steady_clock::time_point end;
};

/// The graph to import, the quality, and the given hints.
struct ImportRequest {
  std::string path;
  std::optional<int> page;   ///< from 1
  std::optional<int> graph;  ///< from 1 on its page, reading order
  Quality quality = Quality::standard;
  ImportHints hints;
  PageLimits limits;
  double sure = confidenceBar;  ///< 0..1: an import with less confidence is refused
  /// For callers that show doubts to a person: a result below `sure` comes back as a report with its `doubt`,
  /// not as a Failure.
  bool acceptDoubt = false;
  /// When this limit has passed, the best result so far is returned with a remark. If there is none, the
  /// failure is unreadableInput.
  std::optional<TimeLimit> timeLimit;
  /// A refused graph comes back with the question whose answer would make it acceptable. Each choice is tried
  /// by an import that repeats only the steps it changes.
  bool asks = false;
};

/// One graph of a document, as `--list` prints it.
struct ListedGraph {
  int page = 1, graph = 1;
  PageUnit unit = PageUnit::pixel;
  Box frame;  ///< page units
  int quarterTurns = 0;
  AxisReading x, y;
  double confidence = 0;
};

/// A rectangle of lines that could hold a graph but was not listed, with the reason.
struct RejectedFrame {
  Box frame;  ///< page units
  int quarterTurns = 0;
  Failure why;
};

/// The graphs of pages. If several pages were requested, an unreadable one becomes a remark; if only one was
/// requested, it is a Failure.
struct GraphList {
  std::vector<ListedGraph> graphs;      ///< reading order
  std::vector<RejectedFrame> rejected;  ///< examined and not listed
  std::vector<Remark> remarks;  ///< parts of the document that could not be read: broken images, broken pages
};

/// Confidence of one step, with its subject.
struct StepFinding {
  ImportStep step = ImportStep::locate;  ///< locate, axes or strokes
  double confidence = 0;
  DecidedBy by = DecidedBy::found;
  std::vector<EvidenceItem> evidence;
};

/// Evidence of an import, for drawing it back over the page. Shared, never changed.
struct GraphEvidence {
  PageView view;
  PlotFrame frame;
  AxesFound axes;
  std::vector<CurveTrace> traces;  ///< empty if the import failed before tracing
  std::vector<PlotSwitch>
      switches;             ///< among the traces, numbered from 1; several: StrokeHints::curve takes one
  Explanation explanation;  ///< pixels of the plot that neither curves nor its lines nor words explain
  /// the steps that ran, in flow order; the import's confidence is that of the least certain one
  std::vector<StepFinding> steps;
};

struct StrokeReport {
  FitSummary fit;
  double rms_px = 0;  ///< orthogonal, of the traced points to the fitted curve; 0 for force logs
};

/// One reading of a graph and its result. `precise` reads more than once (importer/second_opinion.h).
struct ReadingSummary {
  double magnification =
      1;  ///< magnification of this reading: pictures are enlarged, documents drawn finer by this factor
  double confidence = 0;  ///< 0..1; 0 if the reading failed
  /// travel and highest force of the press; empty if the reading failed
  std::optional<double> travel_mm, highest_N;
  bool release = false;
  Message problem;     ///< the reason why it was not certain; empty if it was certain
  bool taken = false;  ///< the report is of this reading
};

/// The result of an import. It is usable as it is: a result below the required confidence is a Failure, or is
/// named in `doubt` if the request allowed that.
struct ImportReport {
  explicit ImportReport(Button imported) : button(std::move(imported)) {}

  Button button;
  StrokePair strokes;  ///< as traced, before the fit
  int page = 1, graph = 1;
  std::optional<std::size_t> curve;  ///< number of the switch that was taken, from 1, if the plot has several
  std::optional<AxisReading> x, y;   ///< empty for force logs
  StrokeReport press;
  std::optional<StrokeReport> release;
  std::vector<Callout> callouts;       ///< operating and reset points that callouts of the page mark
  std::vector<SpecCheck> specChecks;   ///< values printed on the page, compared with those of the graph
  std::optional<PageClass> pageClass;  ///< empty for force logs
  double confidence = 0;
  /// only with ImportRequest::acceptDoubt: the reason for the doubt, and what to do
  std::optional<Doubt> doubt;
  Quality quality = Quality::standard;
  std::map<ImportStep, double> seconds;  ///< per step that ran; steps whose result was kept are not in it
  std::vector<ReadingSummary> readings;  ///< in the order they were made; empty if one reading was enough
  bool endedByTimeLimit = false;         ///< ImportRequest::timeLimit passed before all work was done
  std::vector<Remark> remarks;
  std::optional<StrokeSpeed> pressSpeed, releaseSpeed;  ///< speeds in force logs with a column of times
  std::shared_ptr<const GraphEvidence> evidence;        ///< null for force logs
  std::string brief() const;                            ///< one line for people
};

/// Adds the option of a question's choice to the hints. Returns false if no question offers this option.
bool takeUp(const Choice& choice, ImportHints& hints);

/// An import and its evidence, which is present even if the import failed.
struct ImportAttempt {
  Result<ImportReport> report;
  /// Evidence of the report; of a failed import what was found before it failed: frame and axes, and curves
  /// if they were traced. Null if no frame was found, and for force logs.
  std::shared_ptr<const GraphEvidence> evidence;
  /// A question whose answer would settle the failure. Each choice was tried and leads to an accepted result.
  /// For graphs on pages only if ImportRequest::asks.
  std::optional<Question> question = {};
  std::vector<ExplainedInterpretation> interpretations = {};  ///< the best three of a force log
};

/// An open input that is imported repeatedly while hints change: a step is recomputed only if something it
/// depends on has changed. Results are kept; the memory for pages and pixels is bounded
/// (docs/develop/decisions/1020-memory-of-imports.md). One thread at a time; `Progress::cancelled` may be
/// called from it.
class ImportSession {
 public:
  static Result<ImportSession> open(const std::string& path, const PageLimits& limits = {});
  /// A picture or document from memory (pasted); `name` is used in messages and as the button's name.
  static Result<ImportSession> fromBytes(std::vector<unsigned char> bytes, const std::string& name,
                                         const PageLimits& limits = {});

  int pageCount() const;
  bool isForceLog() const;
  /// Valid until the next call of any function: the pages used last are kept.
  Result<const Page*> page(int number, const Progress& progress = {});
  /// Records of a force log, for choosing one by StrokeHints::curve.
  Result<std::vector<ListedRecord>> records(const ImportHints& hints = {}, const Progress& progress = {});
  /// Graphs of one page, or of all without a number.
  Result<GraphList> list(std::optional<int> page = {}, Quality quality = Quality::standard,
                         const ImportHints& hints = {}, const Progress& progress = {});
  /// The switches that a listed graph shows (usually one), for choosing one by StrokeHints::curve; empty if
  /// it is not clear which curves belong together. Traces the graph and keeps the result for a later import.
  Result<std::vector<PlotSwitch>> switches(const ListedGraph& graph, Quality quality = Quality::standard,
                                           const ImportHints& hints = {}, const Progress& progress = {});
  /// `path` and `limits` of the request are ignored: the session has its own. With `page` and `graph`, the
  /// axis hints apply to that graph alone, and graphs are numbered as by `list` without hints; with a given
  /// frame, `graph` only names it.
  Result<ImportReport> importGraph(const ImportRequest& request, const Progress& progress = {});
  /// The same with the evidence, for programs that show people where an import failed.
  ImportAttempt attempt(const ImportRequest& request, const Progress& progress = {});

  ImportSession(ImportSession&&) noexcept;
  ImportSession& operator=(ImportSession&&) noexcept;
  ~ImportSession();

 private:
  struct Impl;
  explicit ImportSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Loads the engine that reads text from pictures for this thread (about 60 ms). Otherwise the first import
/// that needs it does so. Processes forked afterwards share it.
void loadTextEngine();

}  // namespace detent::importer
