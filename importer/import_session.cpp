// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <list>
#include <sstream>
#include <tuple>

#include "importer/assemble_report.h"
#include "importer/doubts.h"
#include "importer/drawn_strokes.h"
#include "importer/graph_copies.h"
#include "importer/graph_question.h"
#include "importer/graph_title.h"
#include "importer/importer.h"
#include "importer/locate_graphs.h"
#include "importer/rest_position.h"
#include "importer/rising_axes.h"
#include "importer/second_opinion.h"
#include "importer/strokes/spotted_name.h"
#include "importer/trace/plot_scene.h"
#include "importer/wider_frame.h"
#include "model/check.h"
#include "model/text.h"

namespace detent::importer {
namespace {

/// Adds the time of a scope to a step's sum.
class StepClock {
 public:
  StepClock(std::map<ImportStep, double>& seconds, ImportStep step)
      : seconds_(seconds), step_(step), start_(std::chrono::steady_clock::now()) {}
  ~StepClock() {
    seconds_[step_] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  StepClock(const StepClock&) = delete;
  StepClock& operator=(const StepClock&) = delete;

 private:
  std::map<ImportStep, double>& seconds_;
  ImportStep step_;
  std::chrono::steady_clock::time_point start_;
};

Message placeOf(int page) { return Message("page %1", page); }
Message placeOf(int page, int graph) { return Message("page %1, graph %2", page, graph); }

/// The inputs on which the graphs of a page and the first reading of their axes depend.
struct LocateKey {
  ViewOptions view;
  AxisHints axes;
  std::vector<Point> frame;
  double magnification = 1;
  bool operator==(const LocateKey&) const = default;
};

ViewOptions viewOptionsFor(const QualitySettings& settings, const ImportHints& hints, double magnification) {
  ViewOptions view = settings.view;
  if (hints.dpi) {  // a given resolution is used exactly, without widening or limit
    view.maxScale_px_per_unit = *hints.dpi / 72.0;
    view.minFrameWidth_px = 16384;
  }
  view.maxScale_px_per_unit *= magnification;
  view.minFrameWidth_px = std::min(16384.0, magnification * view.minFrameWidth_px);
  return view;
}

LocateKey locateKeyOf(const ImportRequest& request, double magnification = 1) {
  return {viewOptionsFor(settingsFor(request.quality), request.hints, magnification), request.hints.axes,
          request.hints.frame, magnification};
}

/// Converts masks from page units to view pixels.
TraceHints hintsInView(TraceHints hints, const PageView& view) {
  const Homography toView = view.viewToPage.inverse();
  for (Box& mask : hints.masks_px) mask = toView.boxOf(mask);
  return hints;
}

/// Expected noise of a stroke's points across the curve.
double noisePx(const StrokePoints& stroke, const LocatedGraph& graph, const QualitySettings& settings,
               double magnification) {
  if (!stroke.fromVector) return magnification * settings.traceNoise_px;
  const Box frame = graph.frame.value.box();
  return settings.vectorNoise_share * std::sqrt(frame.width() * frame.height());
}

FitOptions fitOptionsFor(double noise_px, const AxisCalibration& calibration,
                         const QualitySettings& settings) {
  FitOptions options =
      fitOptionsFor(settings.fit, {noise_px * calibration.mmPerPx(), noise_px * calibration.newtonPerPx()});
  options.noiseAtTactilePoints_share = 1.0 / 3;  // docs/develop/decisions/0200-choosing-knots.md
  return options;
}

/// The points of a stroke, with intermediate points so that no segment is longer than two pixels. A document
/// stores only the two ends of a straight section, but the fit needs points between them.
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

/// A fitted stroke that starts at 0 mm, where the key is free of force, or later. Points left of 0 mm are
/// noise of axis and trace.
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

/// Converts a stroke's points to other axes; a correction in mm and N that an earlier step made is kept.
void moveTo(const AxisCalibration& to, const AxisCalibration& from, StrokePoints& stroke) {
  for (std::size_t i = 0; i < stroke.points_px.size(); ++i) {
    const Point by = to.toUnits(stroke.points_px[i]) - from.toUnits(stroke.points_px[i]);
    stroke.points[i].displacement_mm += by.x;
    stroke.points[i].force_N += by.y;
  }
}

/// Replaces traced strokes by those that the user has drawn, and adds drawn ones that were not traced.
Result<Found<StrokePair>> withDrawn(Result<Found<StrokePair>> traced, const DrawnStrokes& drawn,
                                    const LocatedGraph& graph) {
  const auto strokeOf = [&](const std::vector<Point>& line, Stroke stroke) {
    return strokeFromDrawn(line, stroke, graph.view, graph.frame.value, graph.axes.calibration.value);
  };
  const StrokePoints press = strokeOf(drawn.press, Stroke::press);
  const StrokePoints release = strokeOf(drawn.release, Stroke::release);
  if (press.points.empty() && (release.points.empty() || !traced)) return traced;
  StrokePair pair;
  if (traced) pair = std::move(traced->value);
  pair.press = withDrawnPart(pair.press, press);
  if (!release.points.empty()) pair.release = withDrawnPart(pair.release.value_or(StrokePoints{}), release);
  return Found<StrokePair>{std::move(pair), 1, DecidedBy::given, {}};
}

/// Replaces the requested name by the number of its switch if the text engine did not read the name, but the
/// legend's picture resembles it.
StrokeHints asSeen(StrokeHints hints, const std::vector<CurveTrace>& curves, const PageView& view) {
  const std::vector<PlotSwitch> switches = switchesAmong(curves);
  if (chosenSwitch(switches, curves, hints.curve)) return hints;
  if (const auto index = switchSpotted(switches, curves, view.raster, hints.curve))
    hints.curve = std::to_string(*index + 1);
  return hints;
}

/// A falling scale that could not be mirrored is refused, unless a person gave it.
std::optional<Failure> stillFalling(const LocatedGraph& graph, const AxisHints& given) {
  const AxisCalibration& axes = graph.axes.calibration.value;
  const bool x = axes.x.max < axes.x.min && !given.xMin && !given.xMax;
  const bool y = axes.y.max < axes.y.min && !given.yMin && !given.yMax;
  if (!x && !y) return {};
  return failureOf({DoubtCode::rangeFalls,
                    {(x ? axes.x : axes.y).ticks.size()},
                    x ? RemedyKind::giveXAxis : RemedyKind::giveYAxis},
                   "plot frame", Message("%1 axis", x ? "x" : "y"));
}

/// The reason why no button can be read from a graph with these axes: they are exchanged, unevenly divided,
/// or measure something else, and no unit was given for them. Curves, units and ends need not be known for
/// it.
std::optional<Failure> ofOtherQuantities(const LocatedGraph& graph) {
  const std::vector<Doubt> doubts = otherQuantitiesOf(graph.axes.calibration.value);
  if (doubts.empty()) return {};
  return failureOf(doubts.front(), {}, "plot frame");
}

/// The reason why curves make no pair: with a second scale of forces it is that scale, and colours that tell
/// press from release do not tell which scale is theirs.
Failure ofTwoScales(const Failure& noPair, const LocatedGraph& graph) {
  if (noPair.reason != nameOf(DoubtCode::tooManyCurves) || graph.axes.rightScale != RightScale::otherForces)
    return noPair;
  return failureOf({DoubtCode::otherScale, {Message("measures forces too")}, graphWithOneScale()},
                   noPair.subject, noPair.place);
}

/// Axes of one graph: as found in the search of the page, and as read with the present hints.
struct AxesReading {
  AxisHints hints;
  std::optional<AxesFound> asLocated;  // empty if no other hints were used so far
};

/// The graphs of one page.
struct PageGraphs {
  LocateKey key;
  LocatedPage located;
  std::vector<AxesReading> axes;  // per graph
  PageUnit unit = PageUnit::pixel;
  std::uint64_t serial = 0;  // a new number each time the page is searched
  std::uint64_t usedAt = 0;

  /// The graph as found in the search of the page, whatever was read with other hints since.
  ListedGraph listed(int page, std::size_t index) const {
    const LocatedGraph& graph = located.graphs[index];
    const Found<AxisCalibration>& found =
        axes[index].asLocated ? axes[index].asLocated->calibration : graph.axes.calibration;
    return {page,
            static_cast<int>(index) + 1,
            unit,
            graph.candidate.value.pageBox,
            graph.candidate.value.quarterTurns,
            found.value.x,
            found.value.y,
            std::min({graph.candidate.confidence, graph.frame.confidence, found.confidence})};
  }
};

std::size_t bytesOf(const PageView& view) {
  std::size_t bytes = view.raster.rgb.size();
  for (const VectorPath& path : view.paths) {
    for (const auto& line : path.polylines) bytes += line.size() * sizeof(Point);
  }
  return bytes;
}

}  // namespace

struct ImportSession::Impl {
  std::string path, fileName;
  PageLimits limits;
  std::optional<Document> document;  // empty: a force log

  struct KeptPage {
    Page page;
    std::uint64_t usedAt = 0;
  };
  std::map<int, KeptPage> pages;                  // the pages used last
  std::map<int, std::vector<PrintedSpec>> specs;  // of every page read so far
  std::map<int, std::vector<Remark>> remarks;     // parts of a page that could not be read

  using GraphsKey = std::tuple<int, bool, double>;  // page, whether its plot frame is given, magnification
  std::map<GraphsKey, PageGraphs> graphs;           // the memory of the views is bounded
  std::uint64_t clock = 0;

  /// Page, number and place of the chosen graph, and the remarks on the choice.
  struct GraphPlace {
    int page = 1, graph = 1;
    Box pageBox;
    std::vector<Remark> remarks;
  };

  // Tracings of a graph and of the possible copies it is compared with, kept as long as only later hints
  // change.
  static constexpr std::size_t mostRivals = 4, keptTracings = 1 + mostRivals;
  struct Traced {
    std::uint64_t locatedAs = 0;
    int graph = 0;
    TraceHints hints;
    double spacing_px = 0;
    std::vector<CurveTrace> traces;
    std::optional<trace::PlotScene> scene = {};  // of the latest tracing, until its remainders are explained
    // computed on request, because names and colours do not need it
    std::optional<Explanation> explanation = {};
  };
  std::list<Traced> traced;              // the latest is last
  std::optional<GraphPlace> lastRead;    // by readPlot
  std::map<ImportStep, double> seconds;  // of the steps that have run since the last import began

  const std::string& name() const { return fileName; }
  std::string stem() const { return std::filesystem::path(fileName).stem().string(); }

  Failure failure(FailureCode code, Message place, Message problem, Remedies remedies) const {
    return {code, name(), std::move(place), std::move(problem), std::move(remedies)};
  }

  Failure cancelled() const { return Failure::cancelled(name()); }

  static Remark remarkOn(int number, const Failure& unread) {
    return {RemarkCode::pageUnreadable, {number, unread.problem}, unread.remedies};
  }

  Result<const Page*> page(int number, const Progress& progress) {
    constexpr std::size_t keptPages = 2;
    if (const auto kept = pages.find(number); kept != pages.end()) {
      kept->second.usedAt = ++clock;
      return &kept->second.page;
    }
    if (number < 1 || number > document->pageCount()) {
      return failure(FailureCode::wrongUsage, placeOf(number), Message("there is no such page"),
                     {{RemedyKind::choosePage, Message("1 to %1", document->pageCount())}});
    }
    auto read = document->page(number, progress);
    if (!read) {
      if (read.failure().code == FailureCode::unreadableInput)
        remarks[number] = {remarkOn(number, read.failure())};
      return read.failure();
    }
    remarks[number] = read->remarks;
    specs.insert_or_assign(number, readPrintedSpecs(*read));
    const auto used = [](const auto& a, const auto& b) { return a.second.usedAt < b.second.usedAt; };
    while (pages.size() >= keptPages) pages.erase(std::min_element(pages.begin(), pages.end(), used));
    return &pages.emplace(number, KeptPage{std::move(read).value(), ++clock}).first->second.page;
  }

  std::vector<Remark> allRemarks() const {
    std::vector<Remark> all;
    for (const auto& onPage : remarks) all.insert(all.end(), onPage.second.begin(), onPage.second.end());
    return all;
  }

  std::vector<PrintedSpec> printedSpecs() const {
    std::vector<PrintedSpec> all;
    for (const auto& onPage : specs) all.insert(all.end(), onPage.second.begin(), onPage.second.end());
    return all;
  }

  /// Frees views, those of the least recently used pages first, until the rest is within the bound; never the
  /// view of `keep`. Findings on freed views are kept.
  void letViewsGo(const LocatedGraph* keep) {
    constexpr std::size_t mostBytes = std::size_t{24} << 20;
    std::vector<PageGraphs*> byAge;
    std::size_t bytes = 0;
    for (auto& each : graphs) {
      byAge.push_back(&each.second);
      for (const LocatedGraph& graph : each.second.located.graphs) bytes += bytesOf(graph.view);
    }
    std::sort(byAge.begin(), byAge.end(),
              [](const PageGraphs* a, const PageGraphs* b) { return a->usedAt < b->usedAt; });
    for (PageGraphs* onPage : byAge) {
      for (LocatedGraph& graph : onPage->located.graphs) {
        if (bytes <= mostBytes) return;
        if (&graph == keep) continue;
        bytes -= bytesOf(graph.view);
        graph.view = {};
      }
    }
  }

  /// Renders the view of a graph again if it was freed.
  Result<Done> restoreView(int number, PageGraphs& onPage, std::size_t index, const Progress& progress) {
    LocatedGraph& graph = onPage.located.graphs[index];
    if (!graph.view.raster.empty()) return Done{};
    StepClock time(seconds, ImportStep::view);
    auto itsPage = page(number, progress);
    if (!itsPage) return itsPage.failure();
    auto view = viewOf(*document, **itsPage, graph.candidate.value, onPage.key.view, progress);
    if (!view) return view.failure();
    graph.view = std::move(view).value();
    return Done{};
  }

  /// The graphs of a page, searched with these hints.
  Result<PageGraphs*> located(int number, const LocateKey& key, const Progress& progress) {
    const GraphsKey at{number, !key.frame.empty(), key.magnification};
    if (const auto kept = graphs.find(at); kept != graphs.end() && kept->second.key == key) {
      kept->second.usedAt = ++clock;
      return &kept->second;
    }
    StepClock time(seconds, ImportStep::locate);
    auto onPage = page(number, progress);
    if (!onPage) return onPage.failure();
    auto found =
        locateGraphs(*document, **onPage, {key.view, key.axes, key.frame, key.magnification}, progress);
    if (!found) return found.failure();
    if (progress.isCancelled()) return cancelled();  // an interrupted search must not be stored as complete
    PageGraphs fresh{key, std::move(found).value(), {}, (*onPage)->unit, ++clock, clock};
    for (std::size_t i = 0; i < fresh.located.graphs.size(); ++i) fresh.axes.push_back({key.axes, {}});
    return &graphs.insert_or_assign(at, std::move(fresh)).first->second;
  }

  /// Reads the axes of one graph again if its hints changed; its frame and texts stay as they are.
  Result<Done> readAxesWith(const AxisHints& hints, PageGraphs& onPage, std::size_t index,
                            const Progress& progress) {
    LocatedGraph& graph = onPage.located.graphs[index];
    AxesReading& reading = onPage.axes[index];
    if (reading.hints == hints) return Done{};
    if (!reading.asLocated) reading.asLocated = graph.axes;
    AxesFound axes = *reading.asLocated;
    if (!(hints == onPage.key.axes)) {
      StepClock time(seconds, ImportStep::axes);
      auto read = readAxes(graph.view, graph.frame.value, hints, progress);
      if (!read) return read.failure();
      axes = std::move(read).value();
      useNoTicksOfGivenRanges(axes.calibration.value, hints);
    }
    axes.texts = std::move(graph.axes.texts);
    axes.otherLines = std::move(graph.axes.otherLines);
    graph.axes = std::move(axes);
    reading.hints = hints;
    return Done{};
  }

  struct Choice {
    int page = 1, graph = 1;
    PageGraphs* onPage = nullptr;
    std::size_t index = 0;
    std::vector<Remark> remarks;
    int graphCount = 1;                               // number of graphs to choose from
    std::vector<std::pair<int, std::size_t>> rivals;  // page and index of other graphs with equal axes
    // the mirrored graph that is traced if the numbers fall
    std::shared_ptr<LocatedGraph> mirrored = nullptr;
    LocatedGraph& located() const { return mirrored ? *mirrored : asRead(); }
    // the graph as printed, not mirrored
    LocatedGraph& asRead() const { return onPage->located.graphs[index]; }
  };

  /// Name of the button. In a document with several graphs it contains the graph's title, so that their names
  /// differ.
  std::string buttonName(const Choice& choice) const {
    const bool alone = document->pageCount() == 1 && choice.onPage->located.graphs.size() == 1;
    const std::string title = alone ? std::string() : titleAbove(choice.asRead());
    return title.empty() ? stem() : stem() + " " + title;
  }

  /// Reads legend, callouts and titles of the chosen graph, once. Listing graphs does not need them.
  void readAllTexts(LocatedGraph& graph, const Progress& progress) {
    if (graph.textsComplete) return;
    StepClock time(seconds, ImportStep::texts);
    readGraphTexts(graph.view, graph.frame.value, graph.axes, progress);
    graph.textsComplete = !progress.isCancelled();
  }

  /// Prepares a graph for tracing: reads its texts and mirrors it if its axes fall.
  void makeReady(Choice& choice, const Progress& progress) {
    readAllTexts(choice.located(), progress);
    if (choice.mirrored) return;
    if (auto rising = mirroredToRise(choice.located()))
      choice.mirrored = std::make_shared<LocatedGraph>(std::move(*rising));
  }

  /// The graphs of a page to which axis hints apply: those found without axis hints, or that of the given
  /// frame.
  Result<PageGraphs*> locatedBeforeHints(int number, LocateKey key, const Progress& progress) {
    const bool frameGiven = !key.frame.empty();
    const auto kept = graphs.find({number, frameGiven, key.magnification});
    if (frameGiven && kept != graphs.end() && !kept->second.located.graphs.empty()) {
      LocateKey asKept = key;
      asKept.axes = kept->second.key.axes;
      if (asKept == kept->second.key) return located(number, asKept, progress);
    }
    if (!frameGiven) key.axes = {};
    return located(number, key, progress);
  }

  /// One numbered graph of a page, with its axes read by the request's hints; nothing if the page without
  /// hints does not have it.
  Result<std::optional<Choice>> chooseNumbered(const ImportRequest& request, const LocateKey& key,
                                               const Progress& progress) {
    auto onPage = locatedBeforeHints(*request.page, key, progress);
    if (!onPage) return onPage.failure();
    const auto index = key.frame.empty() ? static_cast<std::size_t>(*request.graph - 1) : std::size_t{0};
    if (index >= (*onPage)->located.graphs.size()) return std::optional<Choice>{};
    if (auto made = restoreView(*request.page, **onPage, index, progress); !made) return made.failure();
    if (auto read = readAxesWith(key.axes, **onPage, index, progress); !read) return read.failure();
    return std::optional<Choice>{Choice{*request.page, *request.graph, *onPage, index, {}, 1, {}}};
  }

  /// The graph of a page at the place where another search found it.
  std::optional<Choice> chooseAt(const GraphPlace& place, const LocateKey& key, const Progress& progress) {
    auto onPage = located(place.page, key, progress);
    if (!onPage) return {};
    const auto& onIt = (*onPage)->located.graphs;
    const auto shared = [&](const LocatedGraph& graph) {
      const Box box = graph.candidate.value.pageBox, common = box.common(place.pageBox);
      return common.empty() ? 0 : common.area() / box.joined(place.pageBox).area();
    };
    const auto best = std::ranges::max_element(onIt, {}, shared);
    constexpr double sameFrame = 0.5;  // share of the joint area of both frames
    if (best == onIt.end() || shared(*best) < sameFrame) return {};
    const auto index = static_cast<std::size_t>(best - onIt.begin());
    if (!restoreView(place.page, **onPage, index, progress)) return {};
    return Choice{place.page, place.graph, *onPage, index, place.remarks, 1, {}};
  }

  /// The requested graph, or the one of the document with the highest confidence.
  Result<Choice> choose(const ImportRequest& request, const LocateKey& key, const Progress& progress) {
    if (request.page && request.graph && *request.graph > 0) {
      auto numbered = chooseNumbered(request, key, progress);
      if (!numbered) return numbered.failure();
      if (*numbered) return std::move(**numbered);
    }
    return chooseBest(request, key, progress);
  }

  Result<Choice> chooseBest(const ImportRequest& request, const LocateKey& key, const Progress& progress) {
    Choice best;
    std::optional<Failure> bestRejection;
    int graphCount = 0;
    struct Seen {
      int page;
      std::size_t index;
      AxisCalibration axes;
    };
    std::vector<Seen> seen;
    const int first = request.page.value_or(1), last = request.page.value_or(document->pageCount());
    for (int number = first; number <= last; ++number) {
      auto onPage = located(number, key, progress);
      if (!onPage) {
        if (request.page || document->pageCount() == 1 || progress.isCancelled()) return onPage.failure();
        // an unreadable page is reported and does not end the search
        best.remarks.push_back(remarkOn(number, onPage.failure()));
        continue;
      }
      const auto& found = (*onPage)->located.graphs;
      const auto& rejection = (*onPage)->located.bestRejection;
      if (rejection && !bestRejection) bestRejection = rejection;
      graphCount += static_cast<int>(found.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        const bool frameGiven = !key.frame.empty();
        if (request.graph && *request.graph != static_cast<int>(i) + 1 && !frameGiven) continue;
        seen.push_back({number, i, found[i].axes.calibration.value});
        if (!best.onPage || found[i].confidence() > best.located().confidence()) {
          best.page = number, best.graph = static_cast<int>(i) + 1, best.onPage = *onPage, best.index = i;
          if (frameGiven) best.graph = request.graph.value_or(1);
        }
      }
      letViewsGo(best.onPage ? &best.located() : nullptr);
    }
    if (!best.onPage) return nothingFound(request, graphCount, bestRejection);
    if (auto made = restoreView(best.page, *best.onPage, best.index, progress); !made) return made.failure();
    best.graphCount = request.graph ? 1 : graphCount;
    for (const Seen& other : seen)
      if (best.graphCount > 1 && (other.page != best.page || other.index != best.index) &&
          haveSameAxes(best.located().axes.calibration.value, other.axes))
        best.rivals.emplace_back(other.page, other.index);
    return best;
  }

  Failure nothingFound(const ImportRequest& request, int graphCount,
                       const std::optional<Failure>& rejection) const {
    if (request.graph && graphCount > 0) {
      return failure(FailureCode::wrongUsage, Message("graph %1", *request.graph),
                     Message("there is no such graph"), RemedyKind::chooseGraph);
    }
    if (rejection) return *rejection;
    const std::vector<Remark> unread = allRemarks();
    return failure(FailureCode::noForceGraph, request.page ? placeOf(*request.page) : Message(),
                   unread.empty() ? Message("no force graph found")
                                  : Message("no force graph found (%1)", messageOf(unread.front())),
                   {{RemedyKind::giveFrame, "if there is one"},
                    {RemedyKind::choosePage, "if the document has several"}});
  }

  static trace::PlotScene sceneOf(const LocatedGraph& graph, const TraceHints& onView) {
    return {graph.view.raster, graph.frame.value, graph.axes.texts, onView.masks_px};
  }

  Result<const std::vector<CurveTrace>*> traces(const Choice& choice, const TraceHints& hints,
                                                const TraceOptions& options, const Progress& progress) {
    const auto kept = std::find_if(traced.begin(), traced.end(), [&](const Traced& each) {
      return each.locatedAs == choice.onPage->serial && each.graph == choice.graph && each.hints == hints &&
             each.spacing_px == options.pointSpacing_px;
    });
    if (kept != traced.end()) return &kept->traces;
    const LocatedGraph& graph = choice.located();
    StepClock time(seconds, ImportStep::trace);
    const TraceHints onView = hintsInView(hints, graph.view);
    for (Traced& each : traced) each.scene.reset();
    trace::PlotScene scene = sceneOf(graph, onView);
    auto found = traceCurves(graph.view, scene, graph.axes, onView, options, progress);
    if (!found) return found.failure();
    if (progress.isCancelled()) return cancelled();  // an interrupted tracing must not be stored as complete
    if (traced.size() == keptTracings) traced.pop_front();
    traced.push_back(
        {choice.onPage->serial, choice.graph, hints, options.pointSpacing_px, std::move(found).value()});
    traced.back().scene = std::move(scene);
    return &traced.back().traces;
  }

  /// Unexplained pixels of these tracings of the chosen graph, if they are kept; empty otherwise.
  Explanation explanationOf(const std::vector<CurveTrace>* curves, const Choice& choice) {
    const auto kept =
        std::ranges::find_if(traced, [&](const Traced& each) { return &each.traces == curves; });
    if (kept == traced.end()) return {};
    if (!kept->explanation) {
      StepClock time(seconds, ImportStep::strokes);
      const LocatedGraph& graph = choice.located();
      if (!kept->scene) kept->scene = sceneOf(graph, hintsInView(kept->hints, graph.view));
      kept->explanation = explain(*kept->scene, kept->traces);
      kept->scene.reset();
    }
    return *kept->explanation;
  }

  /// A graph read up to its strokes, for comparing copies.
  struct CopyReading {
    Choice choice;
    StrokePair strokes;
    CopyRank rank;
  };

  std::optional<CopyReading> readCopy(Choice choice, const ImportRequest& request,
                                      const TraceOptions& options, const Progress& progress) {
    makeReady(choice, progress);
    const LocatedGraph& graph = choice.located();
    const auto curves = traces(choice, request.hints.trace, options, progress);
    if (!curves) return {};
    StepClock time(seconds, ImportStep::copies);
    auto strokes = separateStrokes(**curves, graph.axes, asSeen(request.hints.strokes, **curves, graph.view));
    if (!strokes) return {};
    const Box frame = graph.frame.value.box();
    const CopyRank rank{std::min(graph.confidence(), strokes->confidence), strokes->value.press.fromVector,
                        frame.width() * frame.height()};
    return CopyReading{choice, std::move(strokes->value), rank};
  }

  /// Finds graphs on equal axes with the same curves: copies. Chooses the better one and adds a remark.
  void preferBetterCopy(Choice& choice, const ImportRequest& request, const LocateKey& key,
                        const TraceOptions& options, const Progress& progress) {
    if (choice.rivals.empty()) return;
    const auto first = readCopy(choice, request, options, progress);
    if (!first) return;
    CopyReading best = *first;
    std::vector<std::pair<int, int>> positions{{choice.page, choice.graph}};
    for (std::size_t i = 0; i < std::min(choice.rivals.size(), mostRivals); ++i) {
      const auto [number, index] = choice.rivals[i];
      auto onPage = located(number, key, progress);
      if (!onPage || index >= (*onPage)->located.graphs.size() || progress.isCancelled()) continue;
      if (!restoreView(number, **onPage, index, progress)) continue;
      Choice rival = choice;
      rival.page = number, rival.graph = static_cast<int>(index) + 1;
      rival.onPage = *onPage, rival.index = index;
      const auto reading = readCopy(rival, request, options, progress);
      if (!reading) continue;
      const auto apart = distanceBetween(first->strokes, reading->strokes);
      if (!apart || *apart > copiesWithin) continue;
      positions.emplace_back(rival.page, rival.graph);
      if (isBetterCopy(reading->rank, best.rank)) best = *reading;
    }
    if (positions.size() == 1) return;
    std::sort(positions.begin(), positions.end());
    std::vector<Message> all;
    for (const auto& [number, graph] : positions) all.push_back(placeOf(number, graph));
    best.choice.graphCount -= static_cast<int>(positions.size()) - 1;
    best.choice.remarks.push_back(
        {RemarkCode::sameGraphSeveralTimes, {positions.size(), std::move(all), best.choice.page}});
    choice = std::move(best.choice);
  }

  static void sayWhichOfSeveral(Choice& choice) {
    if (choice.graphCount <= 1) return;
    choice.remarks.push_back({RemarkCode::severalGraphs,
                              {choice.graphCount, choice.page, choice.graph},
                              {{RemedyKind::choosePage, {}},
                               {RemedyKind::chooseGraph, "for another"},
                               {RemedyKind::importAll, "for each"}}});
  }

  /// The attempt of an import that stops here, with the evidence that shows a person where it failed.
  ImportAttempt stopped(Failure why, const Choice& choice, const std::vector<CurveTrace>& curves,
                        Explanation explanation) const {
    const LocatedGraph& graph = choice.located();
    return {placed(std::move(why), choice),
            std::make_shared<const GraphEvidence>(GraphEvidence{graph.view, graph.frame.value, graph.axes,
                                                                curves, switchesAmong(curves),
                                                                std::move(explanation), graph.findings()})};
  }

  Failure placed(Failure f, const Choice& choice) const {
    if (f.subject.empty()) f.subject = name();
    if (f.place.empty()) {
      f.place =
          document->pageCount() > 1 ? placeOf(choice.page, choice.graph) : Message("graph %1", choice.graph);
    }
    return f;
  }

  /// Class of the page that contains the choice. A levelled view is a photograph, although its evened light
  /// hides that. Averaged views show no grain, so the page's own pixels decide.
  PageClass classOf(const Choice& choice, const StrokePair& strokes, const Progress& progress) {
    const PageView& view = choice.located().view;
    if (strokes.press.fromVector) return PageClass::vector;
    if (!view.viewToPage.isAffine()) return PageClass::photo;
    const bool averaged = choice.onPage->unit == PageUnit::pixel && view.viewToPage.scaleAt({}) > 1.5;
    const auto itsPage = averaged ? page(choice.page, progress) : Result<const Page*>(nullptr);
    return classOfPixels(itsPage && *itsPage ? (*itsPage)->overview : view.raster);
  }

  Result<std::vector<PlotSwitch>> switches(const ImportRequest& request, const Progress& progress);
  /// Settings of one reading of a page: magnification, and the place of the graph if it is given.
  struct PlotSettings {
    double magnification = 1;
    std::optional<GraphPlace> place;
  };
  ImportAttempt importPlot(const ImportRequest& request, const Progress& progress);
  ImportAttempt readAgain(const ImportRequest& request, const Progress& progress);
  ImportAttempt readPlot(const ImportRequest& request, const PlotSettings& plotSettings,
                         const Progress& progress);
  /// A graph whose curves leave its frame, read again in a wider one.
  struct Wider {
    LocatedGraph graph;
    std::vector<CurveTrace> curves;
    Result<Found<StrokePair>> strokes;
    Explanation explanation;
  };
  std::optional<Wider> readWider(const LocatedGraph& graph, const std::vector<CurveTrace>& curves,
                                 const ImportRequest& request, const TraceOptions& options,
                                 const Progress& progress);
  Result<Choice> chosen(const ImportRequest& request, const PlotSettings& plotSettings,
                        const Progress& progress);
  Failure tookTooLong(const TimeLimit& limit) const;
  ImportAttempt withDoubtsJudged(ImportAttempt attempt, const ImportRequest& request) const;
  ImportAttempt importLog(const ImportRequest& request, const Progress& progress);
  Result<ImportReport> reportOfLog(Result<ForceLog> log, const std::optional<Question>& question,
                                   const ImportRequest& request);
  std::optional<Question> tried(const Question& question, const ImportRequest& request,
                                const Progress& progress,
                                const std::function<bool(const ImportRequest&)>& isAccepted);
  std::optional<Question> triedOnLog(const Question& question, const ImportRequest& request,
                                     const Progress& progress);
  std::optional<Question> openQuestion(const ImportAttempt& attempt, const ImportRequest& request,
                                       const Progress& progress);
};

Result<std::vector<PlotSwitch>> ImportSession::Impl::switches(const ImportRequest& request,
                                                              const Progress& progress) {
  const QualitySettings settings = settingsFor(request.quality);
  auto choice = choose(request, locateKeyOf(request), progress);
  if (!choice) return choice.failure();
  letViewsGo(&choice->asRead());
  makeReady(*choice, progress);
  auto curves = traces(*choice, request.hints.trace, settings.trace, progress);
  if (!curves) return placed(curves.failure(), *choice);
  return switchesAmong(**curves);
}

/// Progress that reports a cancellation once the limit has passed, for steps without which there is no
/// result.
Progress limited(const Progress& progress, const std::optional<TimeLimit>& limit) {
  Progress bothSteps = progress;
  if (limit) bothSteps.cancelled = [progress, limit] { return progress.isCancelled() || limit->passed(); };
  return bothSteps;
}

Failure ImportSession::Impl::tookTooLong(const TimeLimit& limit) const {
  return failure(
      FailureCode::unreadableInput, {},
      Message("nothing was read within the limit of %1 s", MessageValue(limit.seconds)),
      {{RemedyKind::advice, Message("Choose a lower level of quality")}, {RemedyKind::raiseLimit, {}}});
}

/// The settings of a level, reduced to the necessary steps after its time has ended.
QualitySettings cutShort(QualitySettings settings) {
  settings.refineAxes = false;
  settings.fit = FitEffort::draft;
  return settings;
}

Result<ImportSession::Impl::Choice> ImportSession::Impl::chosen(const ImportRequest& request,
                                                                const PlotSettings& plotSettings,
                                                                const Progress& progress) {
  const LocateKey key = locateKeyOf(request, plotSettings.magnification);
  if (plotSettings.place) {
    auto choice = chooseAt(*plotSettings.place, key, progress);
    if (!choice) return failure(FailureCode::noForceGraph, {}, "no force graph found", {});
    return std::move(*choice);
  }
  auto choice = choose(request, key, progress);
  if (!choice) return choice;
  preferBetterCopy(*choice, request, key, settingsFor(request.quality).trace, progress);
  sayWhichOfSeveral(*choice);
  return choice;
}

ImportAttempt ImportSession::Impl::importPlot(const ImportRequest& request, const Progress& progress) {
  seconds.clear();
  lastRead.reset();
  ImportAttempt attempt = settingsFor(request.quality).secondOpinion ? readAgain(request, progress)
                                                                     : readPlot(request, {}, progress);
  const bool late = request.timeLimit && request.timeLimit->passed() && !progress.isCancelled();
  if (!late) return attempt;
  if (attempt.report) {
    attempt.report->endedByTimeLimit = true;
    attempt.report = withRemark(std::move(*attempt.report),
                                {RemarkCode::endedByTimeLimit, {MessageValue(request.timeLimit->seconds)}});
  } else if (attempt.report.failure().code == FailureCode::cancelled) {
    attempt.report = tookTooLong(*request.timeLimit);
  }
  return attempt;
}

/// Reads the page as it is and at other sizes, and combines the readings.
ImportAttempt ImportSession::Impl::readAgain(const ImportRequest& request, const Progress& progress) {
  ImportRequest openly = request;
  openly.acceptDoubt = true;
  double from = 0;
  Progress half = progress;
  if (progress.report)
    half.report = [&](double share, ImportStep step) { progress.report(from + 0.5 * share, step); };
  const auto looked = [&](double magnification, const std::optional<GraphPlace>& place) {
    return PageReading{magnification, readPlot(openly, {magnification, place}, half)};
  };
  PageReading first = looked(1, {});
  if (progress.isCancelled()) return {cancelled(), {}};
  const std::optional<GraphPlace> place = lastRead;
  if (!anotherMaySettle(first.attempt)) return withDoubtsJudged(std::move(first.attempt), request);
  auto itsPage = page(place ? place->page : request.page.value_or(1), progress);
  // If a reading did not find the graph's page of a document, another size does not find it either.
  const bool anywhere = !place && !request.page && document->pageCount() > 1;
  if (anywhere || !itsPage) return withDoubtsJudged(std::move(first.attempt), request);
  const OtherSizes sizes = otherSizesOf(**itsPage);
  from = 0.5;
  PageReading second = looked(sizes.second, place);
  const auto third = [&] { return looked(sizes.third, place); };
  ImportAttempt best = settled(std::move(first), std::move(second), third, request.sure);
  if (progress.isCancelled()) return {cancelled(), {}};
  if (best.report) best.report->seconds = seconds;
  return withDoubtsJudged(std::move(best), request);
}

/// Judges a reading that was made with doubts accepted, for a caller who does not accept them.
ImportAttempt ImportSession::Impl::withDoubtsJudged(ImportAttempt attempt,
                                                    const ImportRequest& request) const {
  if (!attempt.report || !attempt.report->doubt || request.acceptDoubt) return attempt;
  Failure why = failureOf(*attempt.report->doubt, name());
  const int page = attempt.report->page, graph = attempt.report->graph;
  why.place = document->pageCount() > 1 ? placeOf(page, graph) : Message("graph %1", graph);
  attempt.report = std::move(why);
  return attempt;
}

std::optional<ImportSession::Impl::Wider> ImportSession::Impl::readWider(
    const LocatedGraph& graph, const std::vector<CurveTrace>& curves, const ImportRequest& request,
    const TraceOptions& options, const Progress& progress) {
  auto widened = widenedToItsCurves(graph, curves);
  if (!widened) return {};
  StepClock time(seconds, ImportStep::trace);
  const TraceHints onView = hintsInView(request.hints.trace, graph.view);
  const trace::PlotScene scene = sceneOf(*widened, onView);
  auto followed = traceCurves(widened->view, scene, widened->axes, onView, options, progress);
  if (!followed || progress.isCancelled()) return {};
  auto strokes =
      separateStrokes(*followed, widened->axes, asSeen(request.hints.strokes, *followed, widened->view));
  if (!strokes) return {};
  Explanation explanation = explain(scene, *followed);
  return Wider{std::move(*widened), std::move(*followed), std::move(strokes), std::move(explanation)};
}

ImportAttempt ImportSession::Impl::readPlot(const ImportRequest& request, const PlotSettings& plotSettings,
                                            const Progress& untimed) {
  QualitySettings settings = settingsFor(request.quality);
  const Progress progress = limited(untimed, request.timeLimit);
  const auto step = [&](double fraction, ImportStep what) {
    if (progress.report) progress.report(fraction, what);
  };

  step(0.05, ImportStep::locate);
  auto choice = chosen(request, plotSettings, progress);
  if (!choice) return {choice.failure(), {}};
  lastRead = {choice->page, choice->graph, choice->located().candidate.value.pageBox, choice->remarks};
  letViewsGo(&choice->asRead());
  makeReady(*choice, progress);
  const LocatedGraph& graph = choice->located();
  if (auto other = ofOtherQuantities(graph)) return stopped(*other, *choice, {}, {});
  if (auto falling = stillFalling(graph, request.hints.axes)) return stopped(*falling, *choice, {}, {});

  step(0.5, ImportStep::trace);
  const std::vector<CurveTrace> none;
  auto curves = traces(*choice, request.hints.trace, settings.trace, progress);
  if (!curves && request.hints.drawn.press.empty()) return stopped(curves.failure(), *choice, none, {});
  if (!curves) curves = &none;  // the person has drawn what could not be traced
  step(0.7, ImportStep::strokes);
  auto strokes = [&] {
    StepClock time(seconds, ImportStep::strokes);
    return withDrawn(
        separateStrokes(**curves, graph.axes, asSeen(request.hints.strokes, **curves, graph.view)),
        request.hints.drawn, graph);
  }();
  std::optional<Wider> wider;
  // Strokes that the frame cuts may resemble those of two switches, so a wider frame is tried.
  if (request.hints.frame.empty() && request.hints.drawn.press.empty() && request.hints.drawn.release.empty())
    wider = readWider(graph, **curves, request, settings.trace, progress);
  const Explanation explanation = wider ? std::move(wider->explanation) : explanationOf(*curves, *choice);
  if (wider) {
    curves = &wider->curves;
    strokes = std::move(wider->strokes);
  }
  if (!strokes) return stopped(ofTwoScales(strokes.failure(), graph), *choice, **curves, explanation);
  if (request.timeLimit && request.timeLimit->passed()) settings = cutShort(settings);

  step(0.75, ImportStep::refine);
  const LocatedGraph* const read = wider ? &wider->graph : &graph;
  std::optional<RefinedAxes> refined;
  std::optional<LocatedGraph> refinedGraph;  // the session keeps the graph as it was first read
  if (settings.refineAxes && !strokes->value.press.fromVector) {
    StepClock time(seconds, ImportStep::refine);
    refined = refineAxes(graph.view, graph.frame.value, graph.axes.calibration.value, progress);
    if (refined && refined->shape != SheetShape::asRead) {
      refinedGraph = *read;
      refinedGraph->axes.calibration.value = refined->calibration;
      if (wider) {
        refinedGraph->axes.calibration.value.x.max = wider->graph.axes.calibration.value.x.max;
        refinedGraph->axes.calibration.value.y.max = wider->graph.axes.calibration.value.y.max;
      }
      moveTo(refined->calibration, graph.axes.calibration.value, strokes->value.press);
      if (strokes->value.release)
        moveTo(refined->calibration, graph.axes.calibration.value, *strokes->value.release);
    }
  }
  const LocatedGraph* const seen = refinedGraph ? &*refinedGraph : read;

  step(0.8, ImportStep::fit);
  const StrokePair& pair = strokes->value;
  const AxisCalibration& calibration = seen->axes.calibration.value;
  const double press_px = noisePx(pair.press, graph, settings, plotSettings.magnification);
  const double release_px =
      pair.release ? noisePx(*pair.release, graph, settings, plotSettings.magnification) : press_px;
  auto fitted = [&] {
    StepClock time(seconds, ImportStep::fit);
    return fitBoth(pair, fitOptionsFor(press_px, calibration, settings),
                   fitOptionsFor(release_px, calibration, settings));
  }();
  if (!fitted) return stopped(fitted.failure(), *choice, **curves, explanation);
  if (untimed.isCancelled()) return {cancelled(), {}};

  auto callouts = [&] {
    StepClock time(seconds, ImportStep::callouts);
    return readCallouts(seen->view, seen->frame.value, seen->axes, pair);
  }();
  const auto& unread = remarks[choice->page];
  choice->remarks.insert(choice->remarks.end(), unread.begin(), unread.end());
  const PageClass pageClass = classOf(*choice, pair, progress);
  const GraphSource source{name(),       buttonName(*choice), document->sha256(),
                           choice->page, choice->graph,       choice->remarks};
  auto report = assembleReport(
      {*seen, **curves, std::move(strokes).value(), std::move(fitted).value(), press_px, release_px,
       std::move(callouts), printedSpecs(), pageClass, explanation, std::move(refined)},
      source, request);
  if (!report) return stopped(report.failure(), *choice, **curves, explanation);
  report->seconds = seconds;
  step(1, ImportStep::fit);
  std::shared_ptr<const GraphEvidence> evidence = report->evidence;
  return {std::move(report), std::move(evidence)};
}

namespace {

/// The contact points recorded in a log, in the form of a page's callouts.
std::vector<Callout> contactPointsOf(const ForceLog& log) {
  std::vector<Callout> contacts;
  if (log.operatingPoint_mm)
    contacts.push_back({CalloutKind::operatingPoint, {*log.operatingPoint_mm, 0}, {}, 1, {}});
  if (log.resetPoint_mm) contacts.push_back({CalloutKind::resetPoint, {*log.resetPoint_mm, 0}, {}, 1, {}});
  return contacts;
}

LogHints logHintsOf(const ImportHints& hints) {
  return {hints.axes.xUnit,    hints.axes.yUnit, hints.strokes.swap,
          hints.strokes.curve, hints.columns,    hints.releasePath};
}

/// Mean distance of a stroke's samples from its fit, in force, as a share of its force span.
double misfitOf(const StrokePoints& stroke, const StrokeCurve& fitted) {
  if (stroke.points.size() < 2) return 0;
  const auto [lowest, highest] = std::ranges::minmax(stroke.points, {}, &CurvePoint::force_N);
  const double span_N = highest.force_N - lowest.force_N;
  if (!(span_N > 0)) return 0;
  const std::size_t every = std::max<std::size_t>(1, stroke.points.size() / 1000);
  double sum_N = 0, count = 0;
  for (std::size_t i = 0; i < stroke.points.size(); i += every) {
    const CurvePoint& p = stroke.points[i];
    if (p.displacement_mm < fitted.start_mm() || p.displacement_mm > fitted.end_mm()) continue;
    // At a jump the forces of both sides are right.
    sum_N += std::min(std::abs(fitted.force_N(p.displacement_mm) - p.force_N),
                      std::abs(fitted.forceBefore_N(p.displacement_mm) - p.force_N));
    count += 1;
  }
  return count > 0 ? sum_N / count / span_N : 1;
}

/// Misfit as a factor of the confidence: 1 up to a hundredth of the span, 0 from a twentieth on.
double fitConfidence(const StrokePair& strokes, const FittedStrokes& fitted) {
  constexpr double right = 0.01, wrong = 0.05;  // share of the force span
  double misfit = misfitOf(strokes.press, fitted.press.curve);
  if (strokes.release && fitted.release)
    misfit = std::max(misfit, misfitOf(*strokes.release, fitted.release->curve));
  return std::clamp((wrong - misfit) / (wrong - right), 0.0, 1.0);
}

}  // namespace

bool takeUp(const Choice& choice, ImportHints& hints) {
  std::istringstream words(choice.option);
  for (std::string name, value; words >> name;) {
    if (!(words >> value)) return false;
    if (name == "--record" || name == "--curve")
      hints.strokes.curve = value;
    else if (name == "--press-color")
      hints.trace.pressColor = colorFrom(value);
    else if (name == "--release-color")
      hints.trace.releaseColor = colorFrom(value);
    else if (name == "--x-unit")
      hints.axes.xUnit = lengthUnitFrom(value);
    else if (name == "--y-unit")
      hints.axes.yUnit = forceUnitFrom(value);
    else if (name == "--displacement-column")
      hints.columns.displacement = value;
    else if (name == "--force-column")
      hints.columns.force = value;
    else if (name == "--release-displacement-column")
      hints.columns.releaseDisplacement = value;
    else if (name == "--release-force-column")
      hints.columns.releaseForce = value;
    else
      return false;
  }
  return true;
}

ImportAttempt ImportSession::Impl::importLog(const ImportRequest& request, const Progress& progress) {
  seconds.clear();
  LogReading reading = [&] {
    StepClock time(seconds, ImportStep::read);
    return readLog(path, logHintsOf(request.hints), progress);
  }();
  ImportAttempt attempt{
      reportOfLog(std::move(reading.log), reading.question, request), {}, {}, std::move(reading.best)};
  const bool unsettled = attempt.report ? attempt.report->doubt.has_value()
                                        : attempt.report.failure().code == FailureCode::notCertain;
  if (unsettled && reading.question && !progress.isCancelled())
    attempt.question = triedOnLog(*reading.question, request, progress);
  return attempt;
}

/// Keeps the choices of a question that lead to an accepted result; `isAccepted` tries each with its hints.
/// nullopt if none does.
std::optional<Question> ImportSession::Impl::tried(
    const Question& question, const ImportRequest& request, const Progress& progress,
    const std::function<bool(const ImportRequest&)>& isAccepted) {
  Question left{question.what, {}};
  const std::map<ImportStep, double> before = seconds;
  for (const auto& choice : question.choices) {
    ImportRequest answered = request;
    answered.acceptDoubt = false;
    if (progress.isCancelled()) return {};
    if (takeUp(choice, answered.hints) && isAccepted(answered)) left.choices.push_back(choice);
  }
  seconds = before;
  return left.choices.empty() ? std::nullopt : std::optional(std::move(left));
}

/// The question about a refused log. Choices are tried as drafts, because the level changes how a log is
/// fitted, not how it is read.
std::optional<Question> ImportSession::Impl::triedOnLog(const Question& question,
                                                        const ImportRequest& request,
                                                        const Progress& progress) {
  return tried(question, request, progress, [&](ImportRequest answered) {
    answered.quality = Quality::draft;
    LogReading reading = readLog(path, logHintsOf(answered.hints), progress);
    return reportOfLog(std::move(reading.log), reading.question, answered).ok();
  });
}

/// The question about a refused graph.
std::optional<Question> ImportSession::Impl::openQuestion(const ImportAttempt& attempt,
                                                          const ImportRequest& request,
                                                          const Progress& progress) {
  if (attempt.report) return {};
  const auto question = questionAbout(attempt.report.failure(), attempt.evidence.get());
  if (!question) return {};
  Progress silent;
  silent.cancelled = progress.cancelled;
  return tried(*question, request, progress,
               [&](const ImportRequest& answered) { return importPlot(answered, silent).report.ok(); });
}

Result<ImportReport> ImportSession::Impl::reportOfLog(Result<ForceLog> log,
                                                      const std::optional<Question>& question,
                                                      const ImportRequest& request) {
  if (!log) return log.failure();
  const QualitySettings settings = settingsFor(request.quality);
  const FitOptions options = fitOptionsFor(settings.fit, {log->noise_mm, log->noise_N});
  auto fitted = [&] {
    StepClock time(seconds, ImportStep::fit);
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
  provenance.confidence = log->confidence * fitConfidence(log->strokes, *fitted);
  provenance.given = givenByHand(request.hints);
  const bool isAmbiguous = question && log->confidence < request.sure;
  const bool isNoLog = log->confidence < request.sure, isBadFit = provenance.confidence < request.sure;
  std::optional<Doubt> gravest;
  for (const WeighedDoubt& each : doubtsOfLog(log->strokes, *fitted, request.hints)) {
    if (each.confidence < request.sure && (!gravest || each.confidence < provenance.confidence))
      gravest = each.doubt;
    if (each.confidence >= request.sure)
      log->remarks.push_back({RemarkCode::doubted, {messageOf(each.doubt)}, each.doubt.remedies});
    provenance.confidence = std::min(provenance.confidence, each.confidence);
  }
  // Impossible values are a better reason for a refusal than an unlikely log. Ambiguity comes first, because
  // the user can resolve it.
  if (isAmbiguous)
    gravest = Doubt{DoubtCode::assumed,
                    {Message("the table can be read in several ways: %1", question->what)},
                    Message("Pass one of the choices")};
  else if (!gravest && (isNoLog || isBadFit))
    gravest = Doubt{DoubtCode::assumed,
                    {isNoLog ? Message("the table is hardly a record of a button")
                             : Message("the fitted curve leaves the samples")},
                    Message("Check the values, or ask for a lower confidence")};
  if (gravest && !request.acceptDoubt) {
    return failureOf(*gravest, name());
  }
  provenance.warnings = recorded(log->remarks);
  auto button = buttonFrom(stem(), *fitted, contactPointsOf(*log), provenance);
  if (!button) return button.failure();
  ImportReport report(std::move(button).value());
  report.strokes = std::move(log->strokes);
  report.press = {fitted->press.summary, 0};
  if (fitted->release) report.release = StrokeReport{fitted->release->summary, 0};
  report.confidence = report.button.provenance()->confidence;
  report.doubt = std::move(gravest);
  report.quality = request.quality;
  report.remarks = std::move(log->remarks);
  report.pressSpeed = log->pressSpeed, report.releaseSpeed = log->releaseSpeed;
  report.seconds = seconds;
  return report;
}

ImportSession::ImportSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ImportSession::ImportSession(ImportSession&&) noexcept = default;
ImportSession& ImportSession::operator=(ImportSession&&) noexcept = default;
ImportSession::~ImportSession() = default;

Result<ImportSession> ImportSession::open(const std::string& path, const PageLimits& limits) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->fileName = std::filesystem::path(path).filename().string();
  impl->limits = limits;
  if (!isForceLogPath(path)) {
    auto document = Document::open(path, limits);
    if (!document) return document.failure();
    impl->document = std::move(document).value();
  }
  return ImportSession(std::move(impl));
}

Result<ImportSession> ImportSession::fromBytes(std::vector<unsigned char> bytes, const std::string& name,
                                               const PageLimits& limits) {
  auto impl = std::make_unique<Impl>();
  impl->fileName = name;
  impl->limits = limits;
  auto document = Document::fromBytes(std::move(bytes), name, limits);
  if (!document) return document.failure();
  impl->document = std::move(document).value();
  return ImportSession(std::move(impl));
}

int ImportSession::pageCount() const { return impl_->document ? impl_->document->pageCount() : 0; }
bool ImportSession::isForceLog() const { return !impl_->document; }

Result<const Page*> ImportSession::page(int number, const Progress& progress) {
  if (isForceLog()) {
    return impl_->failure(FailureCode::wrongUsage, "", Message("a force log has no pages"),
                          Message("Import it without a page number"));
  }
  return impl_->page(number, progress);
}

Result<std::vector<ListedRecord>> ImportSession::records(const ImportHints& hints, const Progress& progress) {
  if (!isForceLog())
    return impl_->failure(FailureCode::wrongUsage, "", Message("a page has no records"),
                          Message("List its graphs"));
  LogReading reading = readLog(impl_->path, logHintsOf(hints), progress);
  if (reading.records.empty() && !reading.log) return reading.log.failure();
  return std::move(reading.records);
}

Result<GraphList> ImportSession::list(std::optional<int> page, Quality quality, const ImportHints& hints,
                                      const Progress& progress) {
  if (isForceLog()) {
    return impl_->failure(FailureCode::wrongUsage, "", Message("a force log has no pages to list"),
                          Message("Import it without listing"));
  }
  const LocateKey key{viewOptionsFor(settingsFor(quality), hints, 1), hints.axes, hints.frame};
  GraphList listed;
  const int first = page.value_or(1), last = page.value_or(pageCount());
  std::optional<Failure> firstFault;
  int unreadable = 0;
  for (int number = first; number <= last; ++number) {
    if (progress.report) progress.report(double(number - first) / (last - first + 1), ImportStep::locate);
    auto located = impl_->located(number, key, progress);
    const auto& unread = impl_->remarks[number];
    listed.remarks.insert(listed.remarks.end(), unread.begin(), unread.end());
    if (!located) {
      const bool onlyThisPage = located.failure().code == FailureCode::unreadableInput && first < last;
      if (!onlyThisPage || progress.isCancelled()) return located.failure();
      if (!firstFault) firstFault = located.failure();
      ++unreadable;
      continue;  // an unreadable page is named and does not end the list
    }
    const LocatedPage& onPage = (*located)->located;
    for (std::size_t i = 0; i < onPage.graphs.size(); ++i)
      listed.graphs.push_back((*located)->listed(number, i));
    listed.rejected.insert(listed.rejected.end(), onPage.rejected.begin(), onPage.rejected.end());
    impl_->letViewsGo(nullptr);
  }
  if (unreadable == last - first + 1) return *firstFault;
  return listed;
}

Result<std::vector<PlotSwitch>> ImportSession::switches(const ListedGraph& graph, Quality quality,
                                                        const ImportHints& hints, const Progress& progress) {
  if (isForceLog())
    return impl_->failure(FailureCode::wrongUsage, "", Message("a force log shows no switches"), {});
  ImportRequest request;
  request.page = graph.page, request.graph = graph.graph;
  request.quality = quality;
  request.hints = hints;
  return impl_->switches(request, progress);
}

ImportAttempt ImportSession::attempt(const ImportRequest& request, const Progress& progress) {
  ImportAttempt made =
      isForceLog() ? impl_->importLog(request, progress) : impl_->importPlot(request, progress);
  if (request.asks && !isForceLog() && !request.acceptDoubt)
    made.question = impl_->openQuestion(made, request, progress);
  const auto restOf = [&](Remedies& remedies) { remedies = leftToTry(remedies, request.hints); };
  if (!made.report && !made.report.failure().reason.empty()) {
    Failure doubted = made.report.failure();
    restOf(doubted.remedies);
    made.report = std::move(doubted);
  } else if (made.report && made.report->doubt) {
    restOf(made.report->doubt->remedies);
  }
  return made;
}

Result<ImportReport> ImportSession::importGraph(const ImportRequest& request, const Progress& progress) {
  return attempt(request, progress).report;
}

}  // namespace detent::importer
