// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/drawn_result.h"

#include <cmath>

#include "editor/importing/import_state.h"

namespace detent::editor {
namespace {

class OnPage {
 public:
  explicit OnPage(const importer::GraphEvidence& evidence)
      : calibration_(evidence.axes.calibration.value), toPage_(evidence.view.viewToPage) {}

  QPointF view(importer::Point view_px) const {
    const importer::Point p = toPage_(view_px);
    return {p.x, p.y};
  }
  QPointF units(double mm, double N) const { return view(calibration_.toView({mm, N})); }

 private:
  const importer::AxisCalibration& calibration_;
  const importer::Homography& toPage_;
};

QPolygonF fitOnPage(const StrokeCurve& curve, const OnPage& onPage) {
  constexpr int samplesPerPiece = 24;
  QPolygonF line;
  const auto& knots = curve.knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    line << onPage.units(knots[i].displacement_mm, knots[i].force_N);
    const double width_mm = knots[i + 1].displacement_mm - knots[i].displacement_mm;
    for (int s = 1; s < samplesPerPiece && width_mm > 0; ++s) {
      const double at_mm = knots[i].displacement_mm + width_mm * s / samplesPerPiece;
      line << onPage.units(at_mm, curve.force_N(at_mm));
    }
  }
  line << onPage.units(knots.back().displacement_mm, knots.back().force_N);
  return line;
}

QPolygonF lineOnPage(const std::vector<importer::Point>& points_px, const OnPage& onPage) {
  QPolygonF line;
  for (const auto& p : points_px) line << onPage.view(p);
  return line;
}

std::vector<DrawnTick> ticksOf(GraphAxis axis, const importer::GraphEvidence& evidence) {
  const auto& calibration = evidence.axes.calibration.value;
  std::vector<DrawnTick> ticks;
  for (const auto& tick : (axis == GraphAxis::x ? calibration.x : calibration.y).ticks) {
    ticks.push_back({placeOfTick(axis, evidence, tick.position_px), tick.value,
                     QString::fromStdString(tick.text), tick.agrees});
  }
  return ticks;
}

// The pixels of a tilted edge form steps that resemble ticks, so only whole gridlines are reliable there.
std::vector<QPointF> linesOf(GraphAxis axis, const importer::GraphEvidence& evidence) {
  constexpr double level_px = 1.5;
  const auto& corners = evidence.frame.corners;
  const bool leans =
      std::abs(corners[2].y - corners[3].y) > level_px || std::abs(corners[0].x - corners[3].x) > level_px;
  std::vector<QPointF> points;
  for (const auto& line : axis == GraphAxis::x ? evidence.frame.xLines : evidence.frame.yLines) {
    if (leans && !line.spansFrame) continue;
    const importer::Point p = placeOfTick(axis, evidence, line.position_px);
    points.emplace_back(p.x, p.y);
  }
  return points;
}

void addTactile(DrawnResult& drawn, Stroke stroke, const importer::FitSummary& summary,
                const OnPage& onPage) {
  for (const auto& fitted : summary.tactilePoints) {
    const TactilePoint& p = fitted.point;
    drawn.marks.push_back({DrawnMark::Kind::tactile,
                           stroke,
                           onPage.units(p.displacement_mm, p.force_N),
                           {p.displacement_mm, p.force_N}});
  }
}

void addReport(DrawnResult& drawn, const importer::ImportReport& report, const OnPage& onPage) {
  const ForceGraph& graph = report.button.states().front().graph;
  drawn.press =
      DrawnStroke{fitOnPage(graph.press(), onPage), lineOnPage(report.strokes.press.points_px, onPage)};
  addTactile(drawn, Stroke::press, report.press.fit, onPage);
  if (graph.release() && report.strokes.release) {
    drawn.release = DrawnStroke{fitOnPage(*graph.release(), onPage),
                                lineOnPage(report.strokes.release->points_px, onPage)};
    if (report.release) addTactile(drawn, Stroke::release, report.release->fit, onPage);
  }
  for (const auto& callout : report.callouts) {
    const bool operating = callout.kind == importer::CalloutKind::operatingPoint;
    drawn.marks.push_back({operating ? DrawnMark::Kind::operating : DrawnMark::Kind::reset,
                           operating ? Stroke::press : Stroke::release, onPage.view(callout.at_px),
                           callout.at});
  }
}

}  // namespace

DrawnResult drawnFrom(const ImportedGraph& imported) {
  DrawnResult drawn;
  if (!imported.evidence) return drawn;
  const importer::GraphEvidence& evidence = *imported.evidence;
  const OnPage onPage(evidence);
  drawn.xTicks = ticksOf(GraphAxis::x, evidence);
  drawn.yTicks = ticksOf(GraphAxis::y, evidence);
  drawn.xLines = linesOf(GraphAxis::x, evidence);
  drawn.yLines = linesOf(GraphAxis::y, evidence);
  if (imported.report) {
    addReport(drawn, *imported.report, onPage);
  } else {
    for (const auto& trace : evidence.traces) drawn.traces.push_back(lineOnPage(trace.points_px, onPage));
  }
  return drawn;
}

}  // namespace detent::editor
