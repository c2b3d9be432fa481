#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "importer/assemble_report.h"
#include "importer/importer.h"
#include "importer/locate_graphs.h"
#include "importer/overlay/overlay.h"
#include "importer/rest_position.h"
#include "model/check.h"

namespace detent::importer {
namespace {

/// Adds the time of a scope to a step's sum.
class StepClock {
 public:
  StepClock(std::map<std::string, double>& seconds, const char* step)
      : seconds_(seconds), step_(step), start_(std::chrono::steady_clock::now()) {}
  ~StepClock() {
    seconds_[step_] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  StepClock(const StepClock&) = delete;
  StepClock& operator=(const StepClock&) = delete;

 private:
  std::map<std::string, double>& seconds_;
  const char* step_;
  std::chrono::steady_clock::time_point start_;
};

bool hasSuffix(const std::string& path, std::string_view suffix) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == suffix;
}

std::string numbered(const char* what, int n) { return std::string(what) + " " + std::to_string(n); }

/// What decides which graphs a page has and how their axes read.
struct LocateKey {
  ViewOptions view;
  AxisHints axes;
  std::vector<Point> frame;
  bool operator==(const LocateKey&) const = default;
};

ViewOptions viewOptionsFor(const QualitySettings& settings, const ImportHints& hints) {
  ViewOptions view = settings.view;
  if (hints.dpi) {  // a given resolution is exact: nothing widens or caps it
    view.maxScale_px_per_unit = *hints.dpi / 72.0;
    view.minFrameWidth_px = 16384;
  }
  return view;
}

/// Masks are given on the page; tracing works in the view.
TraceHints inView(TraceHints hints, const PageView& view) {
  const Affine toView = view.viewToPage.inverse();
  for (Box& mask : hints.masks_px) {
    const Point a = toView({mask.x0, mask.y0}), b = toView({mask.x1, mask.y1});
    mask = {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
  }
  return hints;
}

/// Expected noise of a stroke's points across the curve.
double noisePx(const StrokePoints& stroke, const LocatedGraph& graph, const QualitySettings& settings) {
  if (!stroke.fromVector) return settings.traceNoise_px;
  const Box frame = graph.frame.value.box();
  return settings.vectorNoise_share * std::sqrt(frame.width() * frame.height());
}

FitOptions fitOptionsFor(double noise_px, const AxisCalibration& calibration,
                         const QualitySettings& settings) {
  return fitOptionsFor(settings.fit,
                       {noise_px * calibration.mmPerPx(), noise_px * calibration.newtonPerPx()});
}

/// The points of a stroke with none of its lines longer than two pixels: a document draws a straight stretch
/// with its two ends, and the fit must see what lies between them.
std::vector<CurvePoint> withoutGaps(const StrokePoints& stroke) {
  constexpr double longest_px = 2;
  if (!stroke.fromVector || stroke.points_px.size() != stroke.points.size()) return stroke.points;
  std::vector<CurvePoint> dense;
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    if (i > 0) {
      const CurvePoint a = stroke.points[i - 1], b = stroke.points[i];
      const Point p = stroke.points_px[i - 1], q = stroke.points_px[i];
      const int steps = static_cast<int>(std::min(std::hypot(q.x - p.x, q.y - p.y) / longest_px, 1e4));
      for (int k = 1; k < steps; ++k) {
        const double share = double(k) / steps;
        dense.push_back({a.displacement_mm + share * (b.displacement_mm - a.displacement_mm),
                         a.force_N + share * (b.force_N - a.force_N)});
      }
    }
    dense.push_back(stroke.points[i]);
  }
  return dense;
}

/// A fitted stroke that starts at the force-free key or later: what lies left of 0 mm is noise of axis and
/// trace.
Result<FittedStroke> fitAtRest(const std::vector<CurvePoint>& points, Stroke stroke,
                               const FitOptions& options) {
  auto fitted = fitStroke(points, stroke, options);
  if (!fitted) return fitted.failure();
  auto moved = startingAtRest(fitted->curve);
  if (!moved) return moved.failure();
  return FittedStroke{std::move(moved).value(), fitted->summary};
}

Result<FittedStrokes> fitBoth(const StrokePair& strokes, const FitOptions& press, const FitOptions& release) {
  auto fittedPress = fitAtRest(withoutGaps(strokes.press), Stroke::press, press);
  if (!fittedPress) return fittedPress.failure();
  FittedStrokes fitted{std::move(fittedPress).value(), {}};
  if (strokes.release) {
    auto fittedRelease = fitAtRest(withoutGaps(*strokes.release), Stroke::release, release);
    if (!fittedRelease) return fittedRelease.failure();
    fitted.release = std::move(fittedRelease).value();
  }
  return fitted;
}

}  // namespace

struct ImportSession::Impl {
  std::string path;
  PageLimits limits;
  std::optional<Document> document;  // empty: a force log
  std::map<int, Page> pages;
  std::map<int, std::vector<PrintedSpec>> specs;  // of every page read so far

  struct PageGraphs {
    LocateKey key;
    LocatedPage located;
  };
  std::map<int, PageGraphs> graphs;

  // The last graph's tracing and strokes, kept while only later hints change.
  struct Traced {
    int page = 0, graph = 0;
    LocateKey key;
    TraceHints hints;
    double spacing_px = 0;
    std::vector<CurveTrace> traces;
  };
  std::optional<Traced> traced;

  std::string name() const { return std::filesystem::path(path).filename().string(); }
  std::string stem() const { return std::filesystem::path(path).stem().string(); }

  Failure failure(FailureCode code, std::string place, std::string problem, std::string remedy) const {
    return {code, name(), std::move(place), std::move(problem), std::move(remedy)};
  }

  Result<const Page*> page(int number, const Progress& progress) {
    if (const auto kept = pages.find(number); kept != pages.end()) return &kept->second;
    if (number < 1 || number > document->pageCount()) {
      return failure(FailureCode::wrongUsage, numbered("page", number), "there is no such page",
                     "Pass --page 1 to " + std::to_string(document->pageCount()));
    }
    auto read = document->page(number, progress);
    if (!read) return read.failure();
    specs.emplace(number, readPrintedSpecs(*read));
    return &pages.emplace(number, std::move(read).value()).first->second;
  }

  std::vector<PrintedSpec> printedSpecs() const {
    std::vector<PrintedSpec> all;
    for (const auto& onPage : specs) all.insert(all.end(), onPage.second.begin(), onPage.second.end());
    return all;
  }

  Result<const LocatedPage*> located(int number, const LocateKey& key, const Progress& progress) {
    if (const auto kept = graphs.find(number); kept != graphs.end() && kept->second.key == key) {
      return &kept->second.located;
    }
    auto onPage = page(number, progress);
    if (!onPage) return onPage.failure();
    auto found = locateGraphs(*document, **onPage, {key.view, key.axes, key.frame}, progress);
    if (!found) return found.failure();
    return &graphs.insert_or_assign(number, PageGraphs{key, std::move(found).value()}).first->second.located;
  }

  struct Choice {
    int page = 1, graph = 1;
    const LocatedGraph* located = nullptr;
    std::vector<std::string> warnings;
  };

  /// Legend, callouts and titles of the chosen graph, read once; listing does without them.
  const LocatedGraph& withAllTexts(const Choice& choice, const Progress& progress) {
    LocatedGraph& graph = graphs.at(choice.page).located.graphs[static_cast<std::size_t>(choice.graph - 1)];
    if (!graph.textsComplete) readGraphTexts(graph.view, graph.frame.value, graph.axes, progress);
    graph.textsComplete = true;
    return graph;
  }

  /// The graph asked for, or the most certain one of the document.
  Result<Choice> choose(const ImportRequest& request, const LocateKey& key, const Progress& progress) {
    Choice best;
    std::optional<Failure> bestRejection;
    int graphCount = 0;
    const int first = request.page.value_or(1), last = request.page.value_or(document->pageCount());
    for (int number = first; number <= last; ++number) {
      auto onPage = located(number, key, progress);
      if (!onPage) {
        if (request.page || document->pageCount() == 1 || progress.isCancelled()) return onPage.failure();
        best.warnings.push_back(onPage.failure().sentence());  // one broken page costs that page only
        continue;
      }
      const auto& found = (*onPage)->graphs;
      if ((*onPage)->bestRejection && !bestRejection) bestRejection = (*onPage)->bestRejection;
      graphCount += static_cast<int>(found.size());
      for (int i = 0; i < static_cast<int>(found.size()); ++i) {
        if (request.graph && *request.graph != i + 1) continue;
        const LocatedGraph& graph = found[static_cast<std::size_t>(i)];
        if (!best.located || graph.confidence() > best.located->confidence()) {
          best.page = number, best.graph = i + 1, best.located = &graph;
        }
      }
    }
    if (!best.located) return nothingFound(request, graphCount, bestRejection);
    best.located = &withAllTexts(best, progress);
    if (graphCount > 1 && !request.graph) {
      best.warnings.push_back(std::to_string(graphCount) +
                              " graphs found; this is the most certain one (page " +
                              std::to_string(best.page) + ", graph " + std::to_string(best.graph) +
                              "). --list shows all, --page and --graph choose, --all imports each");
    }
    return best;
  }

  Failure nothingFound(const ImportRequest& request, int graphCount,
                       const std::optional<Failure>& rejection) const {
    if (request.graph && graphCount > 0) {
      return failure(FailureCode::wrongUsage, numbered("graph", *request.graph), "there is no such graph",
                     "--list shows the graphs that were found");
    }
    if (rejection) return *rejection;
    return failure(
        FailureCode::noForceGraph, request.page ? numbered("page", *request.page) : "",
        "no force graph found",
        "If there is one, pass its corners with --frame X0,Y0,X1,Y1, and --page if the document has several");
  }

  Result<const std::vector<CurveTrace>*> traces(const Choice& choice, const LocateKey& key,
                                                const TraceHints& hints, const TraceOptions& options,
                                                const Progress& progress) {
    if (traced && traced->page == choice.page && traced->graph == choice.graph && traced->key == key &&
        traced->hints == hints && traced->spacing_px == options.pointSpacing_px) {
      return &traced->traces;
    }
    const LocatedGraph& graph = *choice.located;
    auto found =
        traceCurves(graph.view, graph.frame.value, graph.axes, inView(hints, graph.view), options, progress);
    if (!found) return found.failure();
    traced = Traced{choice.page, choice.graph, key, hints, options.pointSpacing_px, std::move(found).value()};
    return &traced->traces;
  }

  Failure placed(Failure f, const Choice& choice) const {
    if (f.subject.empty()) f.subject = name();
    if (f.place.empty()) {
      f.place = document->pageCount() > 1
                    ? numbered("page", choice.page) + ", " + numbered("graph", choice.graph)
                    : numbered("graph", choice.graph);
    }
    return f;
  }

  Result<ImportReport> importPlot(const ImportRequest& request, const Progress& progress);
  Result<ImportReport> importLog(const ImportRequest& request, const Progress& progress);
};

Result<ImportReport> ImportSession::Impl::importPlot(const ImportRequest& request, const Progress& progress) {
  const QualitySettings settings = settingsFor(request.quality);
  const LocateKey key{viewOptionsFor(settings, request.hints), request.hints.axes, request.hints.frame};
  std::map<std::string, double> seconds;
  const auto step = [&](double fraction, std::string_view what) {
    if (progress.report) progress.report(fraction, what);
  };

  step(0.05, "finding graphs and reading axes");
  auto choice = [&] {
    StepClock clock(seconds, "locate");
    return choose(request, key, progress);
  }();
  if (!choice) return choice.failure();
  const LocatedGraph& graph = *choice->located;

  step(0.5, "tracing curves");
  auto curves = [&] {
    StepClock clock(seconds, "trace");
    return traces(*choice, key, request.hints.trace, settings.trace, progress);
  }();
  if (!curves) return placed(curves.failure(), *choice);

  step(0.7, "telling press from release");
  auto strokes = [&] {
    StepClock clock(seconds, "strokes");
    return separateStrokes(**curves, graph.axes, graph.frame.value, request.hints.strokes);
  }();
  if (!strokes) return placed(strokes.failure(), *choice);

  step(0.8, "fitting");
  const StrokePair& pair = strokes->value;
  const AxisCalibration& calibration = graph.axes.calibration.value;
  const double press_px = noisePx(pair.press, graph, settings);
  const double release_px = pair.release ? noisePx(*pair.release, graph, settings) : press_px;
  auto fitted = [&] {
    StepClock clock(seconds, "fit");
    return fitBoth(pair, fitOptionsFor(press_px, calibration, settings),
                   fitOptionsFor(release_px, calibration, settings));
  }();
  if (!fitted) return placed(fitted.failure(), *choice);
  if (progress.isCancelled()) return failure(FailureCode::wrongUsage, "", "cancelled", "");

  auto callouts = [&] {
    StepClock clock(seconds, "callouts");
    return readCallouts(graph.view, graph.frame.value, graph.axes, pair);
  }();
  const GraphSource source{name(), stem(), document->sha256(), choice->page, choice->graph, choice->warnings};
  auto report = assembleReport({graph, **curves, std::move(strokes).value(), std::move(fitted).value(),
                                press_px, release_px, std::move(callouts), printedSpecs()},
                               source, request);
  if (!report) return placed(report.failure(), *choice);
  if (request.wantOverlay) {
    StepClock clock(seconds, "overlay");
    report->overlay = drawOverlay(*report->evidence, report->strokes, report->button);
  }
  report->seconds = std::move(seconds);
  step(1, "done");
  return report;
}

Result<ImportReport> ImportSession::Impl::importLog(const ImportRequest& request, const Progress& progress) {
  std::map<std::string, double> seconds;
  auto log = [&] {
    StepClock clock(seconds, "read");
    return readForceLog(
        path, {request.hints.axes.xUnit, request.hints.axes.yUnit, request.hints.strokes.swap}, progress);
  }();
  if (!log) return log.failure();
  const QualitySettings settings = settingsFor(request.quality);
  const FitOptions options = fitOptionsFor(settings.fit, {log->noise_mm, log->noise_N});
  auto fitted = [&] {
    StepClock clock(seconds, "fit");
    return fitBoth(log->strokes, options, options);
  }();
  if (!fitted) {
    Failure f = fitted.failure();
    f.subject = name();
    return f;
  }
  Provenance provenance;
  provenance.sourceFile = name();
  provenance.quality = nameOf(request.quality);
  provenance.confidence = 1;
  provenance.given = givenByHand(request.hints);
  provenance.warnings = log->warnings;
  auto button = buttonFrom(stem(), *fitted, {}, provenance);
  if (!button) return button.failure();
  ImportReport report(std::move(button).value());
  report.strokes = std::move(log->strokes);
  report.press = {fitted->press.summary, 0};
  if (fitted->release) report.release = StrokeReport{fitted->release->summary, 0};
  report.confidence = 1;
  report.quality = request.quality;
  report.warnings = provenance.warnings;
  report.seconds = std::move(seconds);
  return report;
}

ImportSession::ImportSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ImportSession::ImportSession(ImportSession&&) noexcept = default;
ImportSession& ImportSession::operator=(ImportSession&&) noexcept = default;
ImportSession::~ImportSession() = default;

Result<ImportSession> ImportSession::open(const std::string& path, const PageLimits& limits) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->limits = limits;
  if (!hasSuffix(path, ".csv")) {
    auto document = Document::open(path, limits);
    if (!document) return document.failure();
    impl->document = std::move(document).value();
  }
  return ImportSession(std::move(impl));
}

int ImportSession::pageCount() const { return impl_->document ? impl_->document->pageCount() : 0; }
bool ImportSession::isForceLog() const { return !impl_->document; }

Result<const Page*> ImportSession::page(int number, const Progress& progress) {
  if (isForceLog()) {
    return impl_->failure(FailureCode::wrongUsage, "", "a force log has no pages",
                          "Import it without --page");
  }
  return impl_->page(number, progress);
}

Result<std::vector<ListedGraph>> ImportSession::list(std::optional<int> page, Quality quality,
                                                     const ImportHints& hints, const Progress& progress) {
  if (isForceLog()) {
    return impl_->failure(FailureCode::wrongUsage, "", "a force log has no pages to list",
                          "Import it without --list");
  }
  const LocateKey key{viewOptionsFor(settingsFor(quality), hints), hints.axes, hints.frame};
  std::vector<ListedGraph> listed;
  const int first = page.value_or(1), last = page.value_or(pageCount());
  for (int number = first; number <= last; ++number) {
    if (progress.report) progress.report(double(number - first) / (last - first + 1), "finding graphs");
    auto located = impl_->located(number, key, progress);
    if (!located) return located.failure();
    int graphNumber = 0;
    for (const LocatedGraph& graph : (*located)->graphs) {
      const AxisCalibration& calibration = graph.axes.calibration.value;
      listed.push_back({number, ++graphNumber, impl_->pages.at(number).unit, graph.candidate.value.pageBox,
                        graph.candidate.value.quarterTurns, calibration.x, calibration.y,
                        graph.confidence()});
    }
    // A long document's pages are not all kept: only what was found on them.
    if (!page) impl_->pages.erase(number);
  }
  return listed;
}

Result<ImportReport> ImportSession::importGraph(const ImportRequest& request, const Progress& progress) {
  return isForceLog() ? impl_->importLog(request, progress) : impl_->importPlot(request, progress);
}

}  // namespace detent::importer
