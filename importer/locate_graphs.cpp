// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/locate_graphs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "importer/axes/frame_by_numbers.h"
#include "importer/page/crop.h"

namespace detent::importer {
namespace {

/// Below this confidence a listed graph would more often be a dimension drawing than a force graph
/// (docs/develop/decisions/0800-import-confidence.md).
constexpr double listBar = 0.3;

/// Reads the graph again in the frame that its numbers indicate, if that explains more of them.
std::optional<LocatedGraph> readWider(const LocatedGraph& graph, const Page& page,
                                      const LocateOptions& options, const Progress& progress) {
  const auto widened = frameByNumbers(graph.view, graph.frame.value, graph.axes.calibration.value);
  if (!widened) return {};
  LocatedGraph wider = graph;
  const Homography& levelToPage = graph.candidate.value.levelToPage;
  wider.candidate.value.uprightBox = levelToPage.inverse().after(graph.view.viewToPage).boxOf(*widened);
  wider.candidate.value.pageBox = levelToPage.boxOf(wider.candidate.value.uprightBox);
  wider.candidate.value.byNumbers = true;
  wider.candidate.evidence.push_back({EvidenceCode::widenedToNumbers});
  auto frame = locatePlotFrame(wider.view, page, wider.candidate.value, progress);
  if (!frame) return {};
  auto axes = readAxes(wider.view, frame->value, options.axes, progress);
  if (!axes) return {};
  const auto used = [](const AxesFound& found) {
    const auto& c = found.calibration.value;
    const auto count = [](const AxisReading& a) {
      return std::count_if(a.ticks.begin(), a.ticks.end(), [](const TickLabel& t) { return t.used; });
    };
    return count(c.x) + count(c.y);
  };
  if (used(*axes) <= used(graph.axes) ||
      axes->calibration.confidence < 0.8 * graph.axes.calibration.confidence)
    return {};
  wider.frame = std::move(frame).value();
  wider.axes = std::move(axes).value();
  return wider;
}

/// The same frame in another upright view of its page.
PlotFrame frameInView(const PlotFrame& frame, const Homography& toView) {
  PlotFrame moved = frame;
  const Box box = frame.box();
  for (Point& corner : moved.corners) corner = toView(corner);
  for (GridLine& line : moved.xLines) line.position_px = toView({line.position_px, box.y1}).x;
  for (GridLine& line : moved.yLines) line.position_px = toView({box.x0, line.position_px}).y;
  return moved;
}

/// Pixels that remain of a frame in a large picture: with 1000 x 700, lines and numbers are as sharp as in
/// most pictures of plots.
constexpr double leastFramePixels = 7e5;

/// View of a region around the candidate. The pixels of a picture are averaged if its frame is larger than
/// tracing needs.
Result<PageView> viewOf(const Document& document, const Page& page, const Box& region,
                        const FrameCandidate& candidate, const ViewOptions& options,
                        const Progress& progress) {
  auto view = document.view(page, region, candidate.quarterTurns, options, candidate.levelToPage, progress);
  if (!view || page.unit != PageUnit::pixel) return view;
  const double scale = view->viewToPage.scaleAt({0.5 * view->raster.width_px, 0.5 * view->raster.height_px});
  const int factor = static_cast<int>(std::sqrt(candidate.uprightBox.area() / leastFramePixels) / scale);
  if (factor < 2) return view;
  const PixelRect all{0, 0, view->raster.width_px, view->raster.height_px};
  view->raster = reducedCrop(view->raster, all, factor);
  view->viewToPage = view->viewToPage.after(reducedCropToRaster(all, factor));
  view->nativePixels = false;
  return view;
}

/// Searches for missing units farther out, because titles may lie outside the plot's own view.
void searchFartherForUnits(LocatedGraph& graph, const Document& document, const Page& page,
                           const LocateOptions& options, const Progress& progress) {
  constexpr double farther = 0.4;  // share of the region's size, on every side
  const AxisCalibration& cal = graph.axes.calibration.value;
  const FrameCandidate& candidate = graph.candidate.value;
  if (cal.x.unitFound && cal.y.unitFound) return;
  const Box region = candidate.regionBox.grown(farther * candidate.regionBox.width(),
                                               farther * candidate.regionBox.height());
  const Box whole = candidate.levelToPage.inverse().boxOf({-0.5, -0.5, page.width, page.height});
  if (candidate.regionBox.contains(region.common(whole))) return;
  const auto widened = viewOf(document, page, region.common(whole), candidate, options.view, progress);
  if (!widened) return;
  const Homography toWide = widened->viewToPage.inverse().after(graph.view.viewToPage);
  readMissingUnits(graph.axes, *widened, frameInView(graph.frame.value, toWide), toWide, options.axes);
}

Result<LocatedGraph> readCandidate(const Document& document, const Page& page,
                                   Found<FrameCandidate> candidate, const LocateOptions& options,
                                   const Progress& progress) {
  auto view = viewOf(document, page, candidate.value, options.view, progress);
  if (!view) return view.failure();
  auto frame = locatePlotFrame(*view, page, candidate.value, progress);
  if (!frame) return frame.failure();
  auto axes = readAxes(*view, frame->value, options.axes, progress);
  if (!axes) return axes.failure();
  LocatedGraph graph{std::move(candidate), std::move(view).value(), std::move(frame).value(),
                     std::move(axes).value()};
  if (graph.candidate.by != DecidedBy::given)
    if (auto wider = readWider(graph, page, options, progress)) graph = std::move(*wider);
  useNoTicksOfGivenRanges(graph.axes.calibration.value, options.axes);
  searchFartherForUnits(graph, document, page, options, progress);
  return graph;
}

/// A doubt about what the axes of a graph measure, that of y first; nullopt without one.
std::optional<Doubt> otherQuantityOf(const LocatedGraph& graph) {
  std::vector<Doubt> doubts = otherQuantitiesOf(graph.axes.calibration.value);
  return doubts.empty() ? std::nullopt : std::optional(std::move(doubts.back()));
}

RejectedFrame rejection(const FrameCandidate& candidate, const Result<LocatedGraph>& graph,
                        const std::string& source) {
  if (!graph) return {candidate.pageBox, candidate.quarterTurns, graph.failure()};
  if (const auto other = otherQuantityOf(*graph))
    return {candidate.pageBox, candidate.quarterTurns, failureOf(*other, source, "plot frame")};
  return {candidate.pageBox, candidate.quarterTurns,
          failureOf({DoubtCode::ratherADrawing,
                     {messagesOf(graph->axes.calibration.evidence)},
                     {{RemedyKind::giveFrame, "if it is a force graph"}}},
                    source, "plot frame")};
}

/// Candidates at places where no graph was located.
std::vector<Found<FrameCandidate>> besideLocated(std::vector<Found<FrameCandidate>> candidates,
                                                 const std::vector<LocatedGraph>& graphs) {
  std::erase_if(candidates, [&](const Found<FrameCandidate>& candidate) {
    return std::any_of(graphs.begin(), graphs.end(), [&](const LocatedGraph& graph) {
      return !candidate.value.pageBox.common(graph.candidate.value.pageBox).empty();
    });
  });
  return candidates;
}

/// Reading order: from the top of the page to the bottom, and from left to right.
bool readsBefore(const LocatedGraph& a, const LocatedGraph& b) {
  const Box &p = a.candidate.value.pageBox, &q = b.candidate.value.pageBox;
  return p.y1 <= q.y0 || (q.y1 > p.y0 && p.x0 < q.x0);
}

/// Returns true if opposite edges have different tilts: the sheet was photographed.
bool anyKeystoned(const std::vector<LocatedGraph>& graphs) {
  constexpr double leastApart = 0.006;  // difference of slopes; scanners and rounding cause less
  return std::any_of(graphs.begin(), graphs.end(), [](const LocatedGraph& graph) {
    const auto& c = graph.frame.value.corners;
    const Box box = graph.frame.value.box();
    const double plumb = (c[0].x - c[3].x) - (c[1].x - c[2].x), level = (c[1].y - c[0].y) - (c[2].y - c[3].y);
    return std::abs(plumb) > leastApart * box.height() || std::abs(level) > leastApart * box.width();
  });
}

/// Of two rejections, returns true if the first is more informative: a doubt about numbers that were read
/// rather than "no numbers".
bool moreTelling(const Failure& a, const std::optional<Failure>& b) {
  return !b || (a.code == FailureCode::notCertain && b->code != FailureCode::notCertain);
}

}  // namespace

Result<PageView> viewOf(const Document& document, const Page& page, const FrameCandidate& candidate,
                        const ViewOptions& options, const Progress& progress) {
  return viewOf(document, page, candidate.regionBox, candidate, options, progress);
}

double LocatedGraph::confidence() const {
  return std::min({candidate.confidence, frame.confidence, axes.calibration.confidence});
}

std::vector<StepFinding> LocatedGraph::findings() const {
  return {{ImportStep::locate, std::min(candidate.confidence, frame.confidence), frame.by, frame.evidence},
          {ImportStep::axes, axes.calibration.confidence, axes.calibration.by, axes.calibration.evidence}};
}

Result<LocatedPage> locateGraphs(const Document& document, const Page& page, const LocateOptions& options,
                                 const Progress& progress) {
  const bool frameGiven = !options.frameCorners.empty(), picture = page.unit == PageUnit::pixel;
  const double magnification = picture ? options.magnification : 1;
  std::vector<Found<FrameCandidate>> candidates;
  if (frameGiven) {
    auto given = frameFromCorners(options.frameCorners, page);
    if (!given) return given.failure();
    candidates.push_back(std::move(given).value());
    if (magnification != 1) candidates.front().value = magnified(candidates.front().value, magnification);
  } else {
    candidates = findPlotFrames(page, {PaperBy::page, {}, magnification}, progress);
  }

  LocatedPage located;
  const auto readAll = [&](const std::vector<Found<FrameCandidate>>& found) {
    for (const auto& candidate : found) {
      if (progress.isCancelled()) return;
      auto graph = readCandidate(document, page, candidate, options, progress);
      if (graph && (frameGiven || graph->confidence() >= listBar)) {
        located.graphs.push_back(std::move(graph).value());
        continue;
      }
      located.rejected.push_back(rejection(candidate.value, graph, page.source));
      const bool isNamed = !graph || otherQuantityOf(*graph);
      const Failure& reason = located.rejected.back().why;
      if (isNamed && moreTelling(reason, located.bestRejection)) located.bestRejection = reason;
    }
  };
  readAll(candidates);
  const auto readByRegion = [&](const std::optional<Homography>& levelToPage) {
    const FrameSearch search{PaperBy::region, levelToPage, magnification};
    readAll(findPlotFrames(page, search, progress));
    // On a page with such faint lines, the lines of a second graph may not have been found.
    readAll(besideLocated(findPlotsByNumbers(page, search, progress), located.graphs));
    std::stable_sort(located.graphs.begin(), located.graphs.end(), readsBefore);
  };
  const FrameSearch upright{PaperBy::region, Homography{}, magnification};
  // Not for documents: they have many pages without graphs, and no known vendor uses paper of two colours.
  if (located.graphs.empty() && picture && frameGiven) {
    for (auto& candidate : candidates) candidate.value.paper = PaperBy::region;
    readAll(candidates);
  } else if (picture && (located.graphs.empty() || anyKeystoned(located.graphs))) {
    const std::vector<LocatedGraph> askew = std::exchange(located.graphs, {});
    if (const auto sheet = photographedSheet(page)) readByRegion(sheet);
    if (located.graphs.empty()) located.graphs = askew;
    if (located.graphs.empty()) readByRegion({});
    // The page has no drawn axis, so its tilt was measured from the curves and is wrong.
    if (located.graphs.empty()) readAll(findPlotsByNumbers(page, upright, progress));
  } else if (located.graphs.empty() && !frameGiven && document.pageCount() == 1) {
    readAll(findPlotsByNumbers(page, upright, progress));
    // A sheet without a graph may have numbers in rows and columns too.
    std::erase_if(located.graphs, [](const LocatedGraph& graph) {
      const AxisCalibration& c = graph.axes.calibration.value;
      return !c.x.unitFound || !c.y.unitFound;
    });
  }
  if (progress.isCancelled()) return Failure::cancelled(page.source);
  return located;
}

}  // namespace detent::importer
