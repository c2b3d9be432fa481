// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/graph_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "importer/assemble_report.h"
#include "importer/doubts.h"
#include "importer/drawn_strokes.h"
#include "importer/page/polyline.h"
#include "importer/page/same_colour.h"
#include "importer/session/better_copy.h"
#include "importer/session/fit_strokes.h"
#include "importer/wider_frame.h"

namespace detent::importer {
namespace {

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

/// Converts a stroke's points to other axes; a correction in mm and N that an earlier step made is kept.
void moveTo(const AxisCalibration& to, const AxisCalibration& from, StrokePoints& stroke) {
  for (std::size_t i = 0; i < stroke.points_px.size(); ++i) {
    const Point by = to.toUnits(stroke.points_px[i]) - from.toUnits(stroke.points_px[i]);
    stroke.points[i].displacement_mm += by.x;
    stroke.points[i].force_N += by.y;
  }
}

/// The curves, of which the one along a line is named this stroke. A person drew the line, so its curve is
/// certain; another curve that was named so is the other stroke.
std::vector<CurveTrace> namedByLine(std::vector<CurveTrace> curves, const StrokePoints& line, Stroke stroke) {
  constexpr double near_px = 3, most = 0.5;  // share of the line
  const auto shareAlong = [&](const CurveTrace& curve) {
    const auto along = std::ranges::count_if(line.points_px, [&](Point p) {
      return curve.points_px.size() >= 2 && distance(nearestOn(curve.points_px, p), p) <= near_px;
    });
    return static_cast<double>(along) / static_cast<double>(line.points_px.size());
  };
  if (curves.empty() || line.points_px.empty()) return curves;
  const auto drawn = std::ranges::max_element(curves, {}, shareAlong);
  if (shareAlong(*drawn) < most) return curves;
  const Stroke other = stroke == Stroke::press ? Stroke::release : Stroke::press;
  for (CurveTrace& curve : curves)
    if (curve.stroke == stroke) curve.stroke = other;
  drawn->stroke = stroke;
  drawn->confidence = 1;
  return curves;
}

/// The curves of the release's given colour beside a drawn press.
std::vector<const CurveTrace*> givenReleases(const std::vector<CurveTrace>& curves, Rgb color) {
  std::vector<const CurveTrace*> releases;
  for (const CurveTrace& curve : curves) {
    const bool hasColour = curve.stroke ? curve.stroke == Stroke::release : isSameColour(curve.color, color);
    if (curve.points_px.size() >= 2 && hasColour) releases.push_back(&curve);
  }
  return releases;
}

Failure noReleaseOfColour(Rgb color) {
  return {
      FailureCode::notCertain,
      "plot frame",
      "",
      Message("no curve beside the press has the colour %1 that was given for the release", nameOf(color)),
      {{RemedyKind::pickRelease, {}}, {RemedyKind::noRelease, {}}}};
}

/// A failure if no curve has a colour that a person picked, beside a line or on a gridline.
std::optional<Failure> colourWithoutCurve(const std::vector<CurveTrace>& curves, const ImportHints& hints) {
  const auto isLine = [](const CurveTrace& curve) {
    const auto isBeyond = [&](Point p) { return distance(p, curve.points_px.front()) >= 1; };  // a pixel
    return std::ranges::any_of(curve.points_px, isBeyond);
  };
  const auto isMissing = [&](const std::optional<Rgb>& color, Stroke stroke) {
    return color && std::ranges::none_of(curves, [&](const CurveTrace& curve) {
             return isLine(curve) && (curve.stroke == stroke || isSameColour(curve.color, *color));
           });
  };
  const TraceHints& given = hints.trace;
  Failure failure{FailureCode::notCertain, "plot frame", "", {}, {}};
  if (isMissing(given.pressColor, Stroke::press)) {
    failure.problem =
        Message("no curve has the colour %1 that was given for the press", nameOf(*given.pressColor));
    failure.remedies = RemedyKind::pickPress;
  } else if (isMissing(given.releaseColor, Stroke::release)) {
    failure.problem =
        Message("no curve has the colour %1 that was given for the release", nameOf(*given.releaseColor));
    failure.remedies = {{RemedyKind::pickRelease, {}}, {RemedyKind::noRelease, {}}};
  } else {
    return {};
  }
  return failure;
}

/// Press and release among the curves, with those that a person drew in place of traced ones. A drawn stroke
/// is certain. The choice of the other one is as certain as it is beside the drawn one.
Result<Found<StrokePair>> strokesOf(std::vector<CurveTrace> curves, const LocatedGraph& graph,
                                    const ImportHints& hints) {
  const AxisCalibration& axes = graph.axes.calibration.value;
  if (auto failure = colourWithoutCurve(curves, hints)) return std::move(*failure);
  auto traced = strokesAmong(curves, graph, hints.strokes);
  const auto drawnAs = [&](const std::vector<Point>& line, Stroke stroke) {
    return strokeFromDrawn(line, stroke, graph.view, graph.frame.value, axes);
  };
  const StrokePoints press = drawnAs(hints.drawn.press, Stroke::press);
  const StrokePoints release = drawnAs(hints.drawn.release, Stroke::release);
  if (press.points.empty() && (release.points.empty() || !traced)) return traced;
  // A line over a part of a traced stroke says which stroke that part belongs to: the traced one.
  const auto wholeOf = [](const StrokePoints* whole, const StrokePoints& drawn) {
    if (!whole || drawn.points.empty() || drawsWhole(*whole, drawn)) return drawn;
    return *whole;
  };
  const StrokePair before = traced ? traced->value : StrokePair{};
  curves = namedByLine(std::move(curves), wholeOf(traced ? &before.press : nullptr, press), Stroke::press);
  curves = namedByLine(std::move(curves), wholeOf(before.release ? &*before.release : nullptr, release),
                       Stroke::release);
  StrokeHints beside = hints.strokes;
  if (!release.points.empty() && !before.release) beside.noRelease = true;  // none but the drawn one
  traced = strokesAmong(curves, graph, beside);
  if (!traced && press.points.empty()) return traced;

  Found<StrokePair> found{{before.press, {}}, 1, DecidedBy::given, {}};
  if (traced) found = std::move(*traced);
  StrokePair& pair = found.value;
  const bool byColour = !press.points.empty() && hints.trace.releaseColor;
  const auto given =
      byColour ? givenReleases(curves, *hints.trace.releaseColor) : std::vector<const CurveTrace*>();
  if (byColour && given.empty()) return noReleaseOfColour(*hints.trace.releaseColor);
  pair.press = given.size() == 1 && !pair.release ? press : withDrawnPart(pair.press, press);
  if (given.size() == 1) pair.release = strokeOf(*given.front(), Stroke::release, axes);
  if (!release.points.empty()) pair.release = withDrawnPart(pair.release.value_or(StrokePoints{}), release);
  if (hints.strokes.noRelease) pair.release.reset();
  if (strokeIsGiven(hints, Stroke::press) && strokeIsGiven(hints, Stroke::release))
    found.confidence = 1, found.by = DecidedBy::given, found.evidence.clear();
  return found;
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
/// press from release do not tell which scale is theirs, nor do switches that no legend names.
Failure ofTwoScales(const Failure& noPair, const std::vector<CurveTrace>& curves, const LocatedGraph& graph) {
  const bool unnamed = std::ranges::all_of(curves, [](const CurveTrace& each) { return each.label.empty(); });
  const bool isOfCurves = noPair.reason == nameOf(DoubtCode::tooManyCurves) ||
                          (unnamed && noPair.reason == nameOf(DoubtCode::severalSwitches));
  if (!isOfCurves || graph.axes.rightScale != RightScale::otherForces) return noPair;
  return failureOf({DoubtCode::otherScale, {Message("it also measures forces")}, graphWithOneScale()},
                   noPair.subject, noPair.place);
}

/// Progress that reports a cancellation once the limit has passed, for steps without which there is no
/// result.
Progress limited(const Progress& progress, const std::optional<TimeLimit>& limit) {
  Progress bothSteps = progress;
  if (limit) bothSteps.cancelled = [progress, limit] { return progress.isCancelled() || limit->passed(); };
  return bothSteps;
}

/// The settings of a level, reduced to the necessary steps after its time has ended.
QualitySettings cutShort(QualitySettings settings) {
  settings.refineAxes = false;
  settings.fit = FitEffort::draft;
  return settings;
}

/// The axes as their whole lines show them, and the graph with these axes if they differ from those read.
struct Refinement {
  std::optional<RefinedAxes> axes;
  std::optional<LocatedGraph> graph;
};

/// Refines the axes of a graph and moves its strokes to them. `wider`: the same graph in a wider frame; may
/// be null.
Refinement refined(const LocatedGraph& graph, const LocatedGraph* wider, StrokePair& strokes,
                   const Progress& progress) {
  const AxisCalibration& asRead = graph.axes.calibration.value;
  Refinement made{refineAxes(graph.view, graph.frame.value, asRead, progress), {}};
  if (!made.axes || made.axes->shape == SheetShape::asRead) return made;
  made.graph = wider ? *wider : graph;
  AxisCalibration& calibration = made.graph->axes.calibration.value;
  calibration = made.axes->calibration;
  if (wider) {
    calibration.x.max = wider->axes.calibration.value.x.max;
    calibration.y.max = wider->axes.calibration.value.y.max;
  }
  moveTo(made.axes->calibration, asRead, strokes.press);
  if (strokes.release) moveTo(made.axes->calibration, asRead, *strokes.release);
  return made;
}

}  // namespace

GraphReader::GraphReader(Document document, std::string fileName)
    : pages_(std::move(document), std::move(fileName)), graphs_(pages_, seconds_), tracings_(seconds_) {}

/// The attempt of an import that stops here, with the evidence that shows a person where it failed.
ImportAttempt GraphReader::stopped(Failure why, const ChosenGraph& choice,
                                   const std::vector<CurveTrace>& curves, Explanation explanation) const {
  const LocatedGraph& graph = choice.located();
  return {placed(std::move(why), choice, pages_),
          std::make_shared<const GraphEvidence>(GraphEvidence{graph.view, graph.frame.value, graph.axes,
                                                              curves, switchesAmong(curves),
                                                              std::move(explanation), graph.findings()})};
}

/// Class of the page that contains the choice. A levelled view is a photograph, although its evened light
/// hides that. Averaged views show no grain, so the page's own pixels decide.
PageClass GraphReader::classOf(const ChosenGraph& choice, const StrokePair& strokes,
                               const Progress& progress) {
  const PageView& view = choice.located().view;
  if (strokes.press.fromVector) return PageClass::vector;
  if (!view.viewToPage.isAffine()) return PageClass::photo;
  const bool averaged = choice.onPage->unit == PageUnit::pixel && view.viewToPage.scaleAt({}) > 1.5;
  const auto page = averaged ? pages_.page(choice.page, progress) : Result<const Page*>(nullptr);
  return classOfPixels(page && *page ? (*page)->overview : view.raster);
}

Result<std::vector<PlotSwitch>> GraphReader::switches(const ImportRequest& request,
                                                      const Progress& progress) {
  const QualitySettings settings = settingsFor(request.quality);
  auto choice = chooseGraph(graphs_, request, locateKeyOf(request.quality, request.hints), progress);
  if (!choice) return choice.failure();
  graphs_.freeViews(&choice->asRead());
  makeReady(*choice, graphs_, progress);
  auto curves = tracings_.traces(*choice, request.hints.trace, settings.trace, progress);
  if (!curves) return placed(curves.failure(), *choice, pages_);
  return switchesAmong(**curves);
}

Result<ChosenGraph> GraphReader::choose(const ImportRequest& request, double magnification,
                                        const std::optional<GraphPlace>& place, const Progress& progress) {
  const LocateKey key = locateKeyOf(request.quality, request.hints, magnification);
  if (place) return chooseGraphAt(graphs_, *place, key, progress);
  auto choice = chooseGraph(graphs_, request, key, progress);
  if (!choice) return choice;
  preferBetterCopy(*choice, request, key, graphs_, tracings_, seconds_, progress);
  remarkOnOtherGraphs(*choice);
  return choice;
}

std::optional<GraphReader::Wider> GraphReader::readWider(const LocatedGraph& graph,
                                                         const std::vector<CurveTrace>& curves,
                                                         const ImportRequest& request,
                                                         const TraceOptions& options,
                                                         const Progress& progress) {
  auto widened = widenedToItsCurves(graph, curves);
  if (!widened) return {};
  StepClock time(seconds_, ImportStep::trace);
  const TraceHints onView = hintsInView(request.hints.trace, graph.view);
  const trace::PlotScene scene = sceneOf(*widened, onView);
  auto followed = traceCurves(widened->view, scene, widened->axes, onView, options, progress);
  if (!followed || progress.isCancelled()) return {};
  auto strokes = strokesAmong(*followed, *widened, request.hints.strokes);
  if (!strokes) return {};
  Explanation explanation = explain(scene, *followed);
  return Wider{std::move(*widened), std::move(*followed), std::move(strokes), std::move(explanation)};
}

PlacedAttempt GraphReader::read(const ImportRequest& request, double magnification,
                                const std::optional<GraphPlace>& place, const Progress& untimed) {
  const Progress progress = limited(untimed, request.timeLimit);
  if (progress.report) progress.report(0.05, ImportStep::locate);
  auto choice = choose(request, magnification, place, progress);
  if (!choice) return {{choice.failure(), {}}, {}};
  GraphPlace chosen{choice->page, choice->graph, choice->located().candidate.value.pageBox, choice->remarks};
  return {readChosen(*choice, request, magnification, untimed, progress), std::move(chosen)};
}

/// `progress` is cancelled by the request's time limit too, `untimed` by the caller alone.
ImportAttempt GraphReader::readChosen(ChosenGraph& choice, const ImportRequest& request, double magnification,
                                      const Progress& untimed, const Progress& progress) {
  QualitySettings settings = settingsFor(request.quality);
  const auto step = [&](double fraction, ImportStep what) {
    if (progress.report) progress.report(fraction, what);
  };
  graphs_.freeViews(&choice.asRead());
  makeReady(choice, graphs_, progress);
  const LocatedGraph& graph = choice.located();
  if (auto other = ofOtherQuantities(graph)) return stopped(*other, choice, {}, {});
  if (auto falling = stillFalling(graph, request.hints.axes)) return stopped(*falling, choice, {}, {});

  step(0.5, ImportStep::trace);
  const std::vector<CurveTrace> none;
  auto curves = tracings_.traces(choice, request.hints.trace, settings.trace, progress);
  if (!curves && request.hints.drawn.press.empty()) return stopped(curves.failure(), choice, none, {});
  if (!curves) curves = &none;  // the person has drawn what could not be traced
  step(0.7, ImportStep::strokes);
  auto strokes = [&] {
    StepClock time(seconds_, ImportStep::strokes);
    return strokesOf(**curves, graph, request.hints);
  }();
  std::optional<Wider> wider;
  // Strokes that the frame cuts may resemble those of two switches, so a wider frame is tried.
  if (request.hints.frame.empty() && request.hints.drawn.press.empty() && request.hints.drawn.release.empty())
    wider = readWider(graph, **curves, request, settings.trace, progress);
  const Explanation explanation =
      wider ? std::move(wider->explanation) : tracings_.explanationOf(*curves, choice);
  if (wider) {
    curves = &wider->curves;
    strokes = std::move(wider->strokes);
  }
  if (!strokes)
    return stopped(ofTwoScales(strokes.failure(), **curves, graph), choice, **curves, explanation);
  if (request.timeLimit && request.timeLimit->passed()) settings = cutShort(settings);

  step(0.75, ImportStep::refine);
  Refinement refinement;
  if (settings.refineAxes && !strokes->value.press.fromVector) {
    StepClock time(seconds_, ImportStep::refine);
    refinement = refined(graph, wider ? &wider->graph : nullptr, strokes->value, progress);
  }
  // The session keeps the graph as it was first read.
  const LocatedGraph& seen = refinement.graph ? *refinement.graph : wider ? wider->graph : graph;

  step(0.8, ImportStep::fit);
  const StrokePair& pair = strokes->value;
  const AxisCalibration& calibration = seen.axes.calibration.value;
  const double press_px = noisePx(pair.press, graph, settings, magnification);
  const double release_px = pair.release ? noisePx(*pair.release, graph, settings, magnification) : press_px;
  auto fitted = [&] {
    StepClock time(seconds_, ImportStep::fit);
    return fitBoth(pair, fitOptionsFor(press_px, calibration, settings),
                   fitOptionsFor(release_px, calibration, settings));
  }();
  if (!fitted) return stopped(fitted.failure(), choice, **curves, explanation);
  if (untimed.isCancelled()) return {pages_.cancelled(), {}};

  auto callouts = [&] {
    StepClock time(seconds_, ImportStep::callouts);
    return readCallouts(seen.view, seen.frame.value, seen.axes, pair);
  }();
  const std::vector<Remark> unread = pages_.remarksOn(choice.page);
  choice.remarks.insert(choice.remarks.end(), unread.begin(), unread.end());
  const PageClass pageClass = classOf(choice, pair, progress);
  const GraphSource source{
      pages_.fileName(), buttonName(choice, pages_), pages_.document().sha256(), choice.page, choice.graph,
      choice.remarks};
  auto report = assembleReport(
      {seen, **curves, std::move(strokes).value(), std::move(fitted).value(), press_px, release_px,
       std::move(callouts), pages_.printedSpecs(), pageClass, explanation, std::move(refinement.axes)},
      source, request);
  if (!report) return stopped(report.failure(), choice, **curves, explanation);
  report->seconds = seconds_;
  step(1, ImportStep::fit);
  std::shared_ptr<const GraphEvidence> evidence = report->evidence;
  return {std::move(report), std::move(evidence)};
}

}  // namespace detent::importer
