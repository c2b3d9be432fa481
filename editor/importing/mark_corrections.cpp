// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/mark_corrections.h"

#include <algorithm>
#include <cmath>

#include "model/edits.h"

namespace detent::editor {
namespace {

// size of an added jump: share of the travel, and of the force there
constexpr double newJumpWidth = 0.05, newJumpDrop = 0.1;

using CorrectionKind = MarkCorrection::Kind;

// Converts positions on the page to mm and N.
class PageUnits {
 public:
  explicit PageUnits(const importer::GraphEvidence& evidence)
      : toView_(evidence.view.viewToPage.inverse()), calibration_(evidence.axes.calibration.value) {}
  importer::Point view(importer::Point page) const { return toView_(page); }
  CurvePoint at(importer::Point page) const {
    const importer::Point p = calibration_.toUnits(toView_(page));
    return {p.x, p.y};
  }
  /// Distance of two points on the page, in pixels of the view.
  double distance_px(CurvePoint a, CurvePoint b) const {
    const importer::Point p = calibration_.toView({a.displacement_mm, a.force_N}),
                          q = calibration_.toView({b.displacement_mm, b.force_N});
    return std::hypot(p.x - q.x, p.y - q.y);
  }

 private:
  importer::Homography toView_;
  const importer::AxisCalibration& calibration_;
};

Result<Button> editStrokeOf(const Button& button, Stroke stroke, const CurveEdit& edit) {
  return editGraph(button, 0, [&](const ForceGraph& graph) { return editStroke(graph, stroke, edit); });
}

std::optional<std::size_t> nearestTactile(const StrokeCurve& curve, Stroke stroke, CurvePoint at,
                                          const PageUnits& units) {
  const std::vector<TactilePoint> points = tactilePoints(curve, stroke);
  std::optional<std::size_t> nearest;
  double best_px = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = units.distance_px(at, {points[i].displacement_mm, points[i].force_N});
    if (!nearest || d < best_px) nearest = i, best_px = d;
  }
  return nearest;
}

Result<StrokeCurve> withTactileMoved(const StrokeCurve& curve, Stroke stroke, const PageUnits& units,
                                     CurvePoint from, std::optional<CurvePoint> to) {
  const auto index = nearestTactile(curve, stroke, from, units);
  if (!index) return curve;  // the point is not found any more, so there is nothing to move
  return to ? moveTactilePoint(curve, stroke, *index, *to) : removeJump(curve, stroke, *index);
}

Result<StrokeCurve> withTactileAdded(const StrokeCurve& curve, Stroke stroke, const PageUnits& units,
                                     CurvePoint to) {
  const double travel_mm = curve.end_mm() - curve.start_mm();
  const NewJump jump{to.displacement_mm, newJumpWidth * travel_mm,
                     newJumpDrop * std::abs(curve.force_N(to.displacement_mm))};
  auto added = addJump(curve, stroke, jump);
  if (!added) return added;
  const auto index = nearestTactile(*added, stroke, to, units);
  return index ? moveTactilePoint(*added, stroke, *index, to) : added;
}

Result<Button> withMarkIn(const Button& button, const MarkCorrection& mark, const PageUnits& units) {
  const auto to = mark.to ? std::optional(units.at(*mark.to)) : std::nullopt;
  const auto to_mm = to ? std::optional(to->displacement_mm) : std::nullopt;
  if (mark.kind == CorrectionKind::operating) return setOperatingPoint(button, 0, to_mm);
  if (mark.kind == CorrectionKind::reset) return setResetPoint(button, 0, to_mm);
  if (!mark.from && !to) return button;
  return editStrokeOf(button, mark.stroke, [&](const StrokeCurve& curve) {
    return mark.from ? withTactileMoved(curve, mark.stroke, units, units.at(*mark.from), to)
                     : withTactileAdded(curve, mark.stroke, units, *to);
  });
}

const char* kindName(CorrectionKind kind) {
  switch (kind) {
    case CorrectionKind::operating:
      return "operating point";
    case CorrectionKind::reset:
      return "reset point";
    case CorrectionKind::tactile:
      break;
  }
  return "tactile point";
}

Result<Button> withGiven(const Button& button, const std::vector<MarkCorrection>& marks) {
  auto provenance = button.provenance();
  if (!provenance) return button;
  for (const MarkCorrection& mark : marks)
    if (std::find(provenance->given.begin(), provenance->given.end(), kindName(mark.kind)) ==
        provenance->given.end())
      provenance->given.emplace_back(kindName(mark.kind));
  return Button::fromStates(button.name(), button.states(), std::move(provenance));
}

// Points that were not moved keep their errors; a given point has none.
std::vector<importer::FittedTactilePoint> tactileOf(const StrokeCurve& curve, Stroke stroke,
                                                    const std::vector<importer::FittedTactilePoint>& before) {
  std::vector<importer::FittedTactilePoint> now;
  for (const TactilePoint& point : tactilePoints(curve, stroke)) {
    const auto same = std::find_if(before.begin(), before.end(), [&](const auto& each) {
      return each.point.displacement_mm == point.displacement_mm && each.point.force_N == point.force_N;
    });
    now.push_back(same != before.end() ? *same : importer::FittedTactilePoint{point, 0, 0});
  }
  return now;
}

void placeCallout(importer::ImportReport& report, const MarkCorrection& mark, const PageUnits& units) {
  const auto kind = mark.kind == CorrectionKind::operating ? importer::CalloutKind::operatingPoint
                                                           : importer::CalloutKind::resetPoint;
  std::erase_if(report.callouts, [&](const importer::Callout& callout) { return callout.kind == kind; });
  const auto said = mark.kind == CorrectionKind::operating ? importer::RemarkCode::operatingPointNotPlaced
                                                           : importer::RemarkCode::resetPointNotPlaced;
  std::erase_if(report.remarks, [&](const importer::Remark& remark) { return remark.code == said; });
  if (!mark.to) return;
  const Stroke stroke = mark.kind == CorrectionKind::operating ? Stroke::press : Stroke::release;
  const CurvePoint at = units.at(*mark.to);
  const double force_N = report.button.states()[0].graph.curve(stroke).force_N(at.displacement_mm);
  report.callouts.push_back({kind, {at.displacement_mm, force_N}, {}, 1, {}});
}

void takeButton(importer::ImportReport& report, Button button, const importer::GraphEvidence& evidence,
                const std::vector<MarkCorrection>& marks) {
  report.button = std::move(button);
  const ForceGraph& graph = report.button.states()[0].graph;
  report.press.fit.tactilePoints = tactileOf(graph.press(), Stroke::press, report.press.fit.tactilePoints);
  if (report.release && graph.release())
    report.release->fit.tactilePoints =
        tactileOf(*graph.release(), Stroke::release, report.release->fit.tactilePoints);
  const PageUnits units(evidence);
  for (const MarkCorrection& mark : marks)
    if (mark.kind != CorrectionKind::tactile) placeCallout(report, mark, units);
  for (importer::Callout& callout : report.callouts)
    callout.at_px = evidence.axes.calibration.value.toView({callout.at.displacement_mm, callout.at.force_N});
  std::vector<importer::PrintedSpec> specs;
  for (const importer::SpecCheck& check : report.specChecks) specs.push_back(check.spec);
  report.specChecks = importer::checkAgainst(specs, report.button);
}

bool isSamePlace(importer::Point a, importer::Point b) {
  return std::abs(a.x - b.x) < 1e-6 && std::abs(a.y - b.y) < 1e-6;
}

}  // namespace

MarkedImport withMarks(const ImportedGraph& imported, const std::vector<MarkCorrection>& marks) {
  MarkedImport marked{imported, {}};
  if (marks.empty() || !imported.report || !imported.evidence) return marked;
  const PageUnits units(*imported.evidence);
  Button button = imported.report->button;
  std::vector<MarkCorrection> taken;
  for (const MarkCorrection& mark : marks) {
    auto next = withMarkIn(button, mark, units);
    if (!next) {
      marked.refused.push_back(next.failure());
      continue;
    }
    button = *std::move(next);
    taken.push_back(mark);
  }
  if (auto corrected = withGiven(button, taken)) button = *std::move(corrected);
  auto report = std::make_shared<importer::ImportReport>(*imported.report);
  takeButton(*report, std::move(button), *imported.evidence, taken);
  marked.imported.report = std::move(report);
  return marked;
}

std::vector<MarkCorrection> withMark(std::vector<MarkCorrection> given, MarkCorrection next) {
  if (next.kind != CorrectionKind::tactile) {
    std::erase_if(given, [&](const MarkCorrection& mark) { return mark.kind == next.kind; });
    given.push_back(next);
    return given;
  }
  // A point that was moved before starts from its corrected place.
  for (std::size_t i = 0; i < given.size(); ++i) {
    MarkCorrection& mark = given[i];
    if (mark.kind != CorrectionKind::tactile || mark.stroke != next.stroke || !mark.to || !next.from ||
        !isSamePlace(*mark.to, *next.from))
      continue;
    mark.to = next.to;
    if (!mark.to && !mark.from) given.erase(given.begin() + static_cast<std::ptrdiff_t>(i));
    return given;
  }
  given.push_back(next);
  return given;
}

}  // namespace detent::editor
