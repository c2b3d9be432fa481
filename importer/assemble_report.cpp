// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/assemble_report.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "importer/doubts.h"

namespace detent::importer {
namespace {

/// Displacement of the callout of a kind, limited to the stroke's travel (a leader may end on the outer edge
/// of the bottom-out).
std::optional<double> calloutAt(const std::vector<Callout>& callouts, CalloutKind kind,
                                const StrokeCurve& curve) {
  for (const Callout& callout : callouts) {
    if (callout.kind == kind) return std::clamp(callout.at.displacement_mm, curve.start_mm(), curve.end_mm());
  }
  return {};
}

AxisProvenance provenanceOf(const AxisReading& axis, bool given) {
  return {axis.unit, axis.min, axis.max, axis.residual_px, given ? DecidedBy::given : DecidedBy::found};
}

Provenance provenanceOf(const GraphFindings& findings, const GraphSource& source,
                        const ImportRequest& request) {
  const AxisCalibration& calibration = findings.graph.axes.calibration.value;
  const AxisHints& axes = request.hints.axes;
  // The axes' ends lie on the frame, which may be wider or narrower than the candidate it was found in.
  const Box frame = findings.graph.view.viewToPage.boxOf(findings.graph.frame.value.box());
  Provenance p;
  p.sourceFile = source.fileName;
  p.sourceSha256 = source.sha256;
  p.page = source.page, p.graph = source.graph;
  p.frame = {frame.x0, frame.y0, frame.x1, frame.y1};
  p.xAxis = provenanceOf(calibration.x, axes.xMin && axes.xMax);
  p.yAxis = provenanceOf(calibration.y, axes.yMin && axes.yMax);
  p.quality = nameOf(request.quality);
  p.pressRms_px = findings.fitted.press.summary.rmsSigma * findings.pressNoise_px;
  if (findings.fitted.release)
    p.releaseRms_px = findings.fitted.release->summary.rmsSigma * findings.releaseNoise_px;
  p.given = givenByHand(request.hints);
  return p;
}

/// The first printed value that differs from the graph by more than a factor of two, if all printed values of
/// its axis do, which means that the axis was misread. Null if the page prints no value of an axis, or one of
/// them agrees.
const SpecCheck* grossConflict(const std::vector<SpecCheck>& checks) {
  for (const bool force : {false, true}) {
    const SpecCheck* worst = nullptr;
    bool anyNear = false;
    for (const SpecCheck& check : checks) {
      if (check.spec.isForce() != force) continue;
      const double factor = check.read / check.spec.nominal;
      const bool near = check.agrees || (factor > 0.5 && factor < 2);
      anyNear = anyNear || near;
      if (!near) worst = &check;
    }
    if (worst && !anyNear) return worst;
  }
  return nullptr;
}

/// Index of the switch that was taken; empty if the plot shows only one.
std::optional<std::size_t> chosenAmongSeveral(const std::vector<PlotSwitch>& switches,
                                              const std::vector<CurveTrace>& traces,
                                              const std::string& requestedName) {
  if (switches.size() < 2) return {};
  const auto chosen = chosenSwitch(switches, traces, requestedName);
  return chosen ? std::optional(*chosen) : std::nullopt;  // none: the strokes were drawn by hand
}

double worstRms_px(const GraphFindings& findings) {
  const double press_px = findings.fitted.press.summary.rmsSigma * findings.pressNoise_px;
  if (!findings.fitted.release) return press_px;
  return std::max(press_px, findings.fitted.release->summary.rmsSigma * findings.releaseNoise_px);
}

/// Errors of a graph's axes in mm and N. All of its points share them.
PointNoise axisError(const GraphFindings& findings) {
  // A drawing program rounds lines to whole pixels but not curves. In which direction it rounded is unknown
  // unless the frame shows it (docs/develop/decisions/0401-finding-plot-frames.md).
  constexpr double roundedLine_px = 0.5;
  const bool exact =
      findings.pageClass == PageClass::vector || findings.graph.frame.value.drawnOffset_px != Point{};
  const AxisCalibration& axes = findings.graph.axes.calibration.value;
  const auto error_px = [&](const AxisReading& axis) {
    const auto used =
        std::count_if(axis.ticks.begin(), axis.ticks.end(), [](const TickLabel& tick) { return tick.used; });
    const double ofTicks_px = axis.residual_px / std::sqrt(std::max<double>(1, static_cast<double>(used)));
    return std::hypot(exact ? 0 : roundedLine_px, ofTicks_px);
  };
  return {error_px(axes.x) * std::abs(axes.mmPerPx()), error_px(axes.y) * std::abs(axes.newtonPerPx())};
}

/// The error at one point. If the axes were refined from whole lines, it follows from their covariance.
PointNoise axisErrorAt(const GraphFindings& findings, const TactilePoint& point) {
  const PointNoise byRule = axisError(findings);
  if (!findings.refined || findings.refined->shape == SheetShape::asRead) return byRule;
  return findings.refined->sigmaAt({point.displacement_mm, point.force_N});
}

StrokeReport strokeReport(FitSummary fit, double rms_px, const GraphFindings& findings) {
  for (FittedTactilePoint& point : fit.tactilePoints) {
    const PointNoise axes = axisErrorAt(findings, point.point);
    point.sigma_mm = std::hypot(point.sigma_mm, axes.sigma_mm);
    point.sigma_N = std::hypot(point.sigma_N, axes.sigma_N);
  }
  return {std::move(fit), rms_px};
}

double diagonal_px(const PlotFrame& frame) {
  const Box box = frame.box();
  return std::hypot(box.width(), box.height());
}

Remedies giveAxes() {
  return {{RemedyKind::giveXAxis, {}},
          {RemedyKind::giveYAxis, "(values at the frame's edges)"},
          {RemedyKind::giveFrame, "if the frame was missed"}};
}

/// The doubt about the axes with its remedies. An axis that measures something else is named whatever else
/// is uncertain. If both ranges were given, only a unit or the frame can still be wrong.
Doubt axesInDoubt(const GraphFindings& findings, const std::vector<WeighedDoubt>& doubts) {
  const auto& calibration = findings.graph.axes.calibration;
  const bool given = calibration.by == DecidedBy::given;
  const auto stated = std::ranges::find_if(doubts, [&](const WeighedDoubt& each) {
    const DoubtCode code = each.doubt.code;
    return code == DoubtCode::otherQuantity || code == DoubtCode::axesExchanged ||
           (given && code == DoubtCode::unitMissing);
  });
  if (stated != doubts.end()) return stated->doubt;
  return {DoubtCode::axesUncertain,
          {messagesOf(calibration.evidence)},
          given ? Remedies{{RemedyKind::giveFrame, "if the frame was missed"}} : giveAxes()};
}

std::optional<Doubt> doubt(const GraphFindings& findings, const std::vector<SpecCheck>& checks,
                           const std::vector<WeighedDoubt>& doubts, bool axesGiven, double sure) {
  const Remedy mask{RemedyKind::addMask, "over what is not a curve"};
  if (findings.graph.confidence() < sure) return axesInDoubt(findings, doubts);
  if (findings.strokes.confidence < sure)
    return Doubt{
        DoubtCode::curvesUncertain,
        {messagesOf(findings.strokes.evidence)},
        {{RemedyKind::pickPress, {}}, {RemedyKind::pickRelease, {}}, {RemedyKind::noRelease, {}}, mask}};
  if (const double rms_px = worstRms_px(findings); rms_px > 0.01 * diagonal_px(findings.graph.frame.value))
    return Doubt{DoubtCode::pointsMakeNoCurve,
                 {std::lround(rms_px)},
                 {mask, {RemedyKind::setResolution, "to trace a picture of the page"}}};
  const auto gravest = std::min_element(
      doubts.begin(), doubts.end(), [](const auto& x, const auto& y) { return x.confidence < y.confidence; });
  if (gravest != doubts.end() && gravest->confidence < sure) return gravest->doubt;
  const SpecCheck* conflict = grossConflict(checks);
  if (conflict && !axesGiven) return Doubt{DoubtCode::valueContradicts, {messageOf(*conflict)}, giveAxes()};
  return {};
}

}  // namespace

std::vector<std::string> givenByHand(const ImportHints& hints) {
  std::vector<std::string> given;
  if (!hints.frame.empty()) given.emplace_back("--frame");
  if (hints.axes.xMin || hints.axes.xMax) given.emplace_back("--x-axis");
  if (hints.axes.yMin || hints.axes.yMax) given.emplace_back("--y-axis");
  if (hints.axes.xUnit) given.emplace_back("--x-unit " + std::string(symbolOf(*hints.axes.xUnit)));
  if (hints.axes.yUnit) given.emplace_back("--y-unit " + std::string(symbolOf(*hints.axes.yUnit)));
  if (hints.trace.pressColor) given.emplace_back("--press-color");
  if (hints.trace.releaseColor) given.emplace_back("--release-color");
  if (!hints.trace.masks_px.empty()) given.emplace_back("--mask");
  if (hints.strokes.swap) given.emplace_back("--swap-strokes");
  if (hints.strokes.noRelease) given.emplace_back("--no-release");
  if (!hints.strokes.curve.empty()) given.emplace_back("--curve " + hints.strokes.curve);
  const ColumnHints& columns = hints.columns;
  const auto column = [&](const char* option, const std::string& name) {
    if (!name.empty()) given.emplace_back(std::string(option) + " " + name);
  };
  column("--displacement-column", columns.displacement), column("--force-column", columns.force);
  column("--release-displacement-column", columns.releaseDisplacement);
  column("--release-force-column", columns.releaseForce);
  column("--stroke-column", columns.stroke), column("--cycle-column", columns.cycle);
  if (!hints.releasePath.empty()) given.emplace_back("--pair");
  if (!hints.drawn.press.empty()) given.emplace_back("--press-line");
  if (!hints.drawn.release.empty()) given.emplace_back("--release-line");
  if (hints.dpi) given.emplace_back("--dpi");
  return given;
}

std::vector<RecordedWarning> recorded(const std::vector<Remark>& remarks,
                                      const std::vector<Doubt>& accepted) {
  std::vector<RecordedWarning> warnings;
  const auto add = [&](const Remark& remark) {
    warnings.push_back({std::string(nameOf(remark.code)), commandLineWords(remark)});
  };
  for (const Remark& remark : remarks) add(remark);
  for (const Doubt& doubt : accepted) add({RemarkCode::doubted, {messageOf(doubt)}, {}});
  return warnings;
}

Result<Button> buttonFrom(const std::string& name, const FittedStrokes& fitted,
                          const std::vector<Callout>& callouts, Provenance provenance) {
  std::optional<StrokeCurve> release;
  if (fitted.release) release = fitted.release->curve;
  auto graph = ForceGraph::fromCurves(fitted.press.curve, std::move(release));
  if (!graph) return graph.failure();
  const auto operating_mm = calloutAt(callouts, CalloutKind::operatingPoint, graph->press());
  const auto reset_mm = calloutAt(callouts, CalloutKind::resetPoint, graph->curve(Stroke::release));
  std::vector<ButtonState> states;
  states.push_back({"", std::move(graph).value(), operating_mm, reset_mm, {}});
  return Button::fromStates(name, std::move(states), std::move(provenance));
}

Result<ImportReport> assembleReport(GraphFindings findings, const GraphSource& source,
                                    const ImportRequest& request) {
  std::vector<Remark> remarks = source.remarks;
  remarks.insert(remarks.end(), findings.graph.axes.remarks.begin(), findings.graph.axes.remarks.end());
  Provenance provenance = provenanceOf(findings, source, request);
  provenance.warnings = recorded(remarks, {});
  provenance.confidence = std::min(findings.graph.confidence(), findings.strokes.confidence);
  const std::vector<PlotSwitch> switches = switchesAmong(findings.traces);
  const auto curve = chosenAmongSeveral(switches, findings.traces, request.hints.strokes.curve);
  const std::string name =
      curve && !switches[*curve].name.empty() ? source.stem + " " + switches[*curve].name : source.stem;
  auto button = buttonFrom(name, findings.fitted, findings.callouts, provenance);
  if (!button) return button.failure();
  const AxisHints& axes = request.hints.axes;
  const auto checks = checkAgainst(findings.specs, *button);
  const auto doubts = doubtsOf(findings, checks, request.hints);
  std::set<DoubtCode> said;  // each doubt is reported once, even if both strokes cause it
  for (const WeighedDoubt& each : doubts) {
    provenance.confidence = std::min(provenance.confidence, each.confidence);
    if (each.confidence >= request.sure && said.insert(each.doubt.code).second)
      remarks.push_back({RemarkCode::doubted, {messageOf(each.doubt)}, each.doubt.remedies});
  }
  const auto uncertain = doubt(findings, checks, doubts, axes.xMin && axes.yMin, request.sure);
  if (uncertain && !request.acceptDoubt) return failureOf(*uncertain);
  if (uncertain || !doubts.empty()) {
    std::vector<Doubt> accepted;  // the gravest first
    if (uncertain) accepted.push_back(*uncertain);
    for (const WeighedDoubt& each : doubts) {
      const std::string words = english(messageOf(each.doubt));
      const auto same = [&](const Doubt& d) { return english(messageOf(d)) == words; };
      if (each.confidence < request.sure && std::ranges::none_of(accepted, same))
        accepted.push_back(each.doubt);
    }
    provenance.warnings = recorded(remarks, accepted);
    button = Button::fromStates(button->name(), button->states(), provenance);
    if (!button) return button.failure();
  }

  const AxisCalibration& calibration = findings.graph.axes.calibration.value;
  ImportReport report(std::move(button).value());
  report.pageClass = findings.pageClass;
  report.page = source.page, report.graph = source.graph;
  if (curve) report.curve = *curve + 1;
  report.x = calibration.x, report.y = calibration.y;
  report.press = strokeReport(findings.fitted.press.summary, provenance.pressRms_px, findings);
  if (findings.fitted.release)
    report.release = strokeReport(findings.fitted.release->summary, provenance.releaseRms_px, findings);
  report.callouts = std::move(findings.callouts);
  report.confidence = provenance.confidence;
  report.doubt = uncertain;
  report.quality = request.quality;
  report.remarks = std::move(remarks);
  for (const SpecCheck& check : checks) {
    if (!check.agrees) report.remarks.push_back({RemarkCode::printedValueDiffers, {messageOf(check)}});
  }
  report.specChecks = checks;
  for (const CalloutKind kind : printedCallouts(findings.graph.frame.value, findings.graph.axes))
    if (std::ranges::none_of(report.callouts, [&](const Callout& each) { return each.kind == kind; }))
      report.remarks.push_back({kind == CalloutKind::operatingPoint ? RemarkCode::operatingPointNotPlaced
                                                                    : RemarkCode::resetPointNotPlaced});
  for (const CurveTrace& trace : findings.traces)
    if (trace.errorBars > 0) {
      report.remarks.push_back({RemarkCode::errorBarsLeftOut, {trace.errorBars}});
      break;
    }
  auto steps = findings.graph.findings();
  steps.push_back(
      {ImportStep::strokes, findings.strokes.confidence, findings.strokes.by, findings.strokes.evidence});
  report.evidence = std::make_shared<const GraphEvidence>(
      GraphEvidence{findings.graph.view, findings.graph.frame.value, findings.graph.axes, findings.traces,
                    switches, std::move(findings.explanation), std::move(steps)});
  report.strokes = std::move(findings.strokes.value);
  return report;
}

}  // namespace detent::importer
