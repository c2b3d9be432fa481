// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/curve_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "model/number_table.h"
#include "model/sampling.h"

namespace detent {
namespace {

constexpr std::string_view header = "stroke,displacement_mm,force_N";

/// `line` from 1; 0: the whole file.
Failure csvFailure(FailureCode code, const std::string& subject, std::size_t line, Message problem,
                   Remedies remedies) {
  return {code, subject, line == 0 ? Message() : Message("line %1", line), std::move(problem),
          std::move(remedies)};
}

void appendNumber(std::string& out, double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  out.append(buffer, end);
}

void appendRows(std::string& out, std::string_view stroke, const std::vector<CurvePoint>& points) {
  for (const CurvePoint& p : points) {
    out += stroke;
    out += ',';
    appendNumber(out, p.displacement_mm);
    out += ',';
    appendNumber(out, p.force_N);
    out += '\n';
  }
}

std::optional<Failure> appendRow(GraphPolylines& lines, const NumberTable& row, const std::string& subject) {
  const auto refuse = [&](Message problem, Remedies remedies) {
    return Failure{FailureCode::unreadableInput, subject, row.place(), std::move(problem),
                   std::move(remedies)};
  };
  if (row.fields().size() != 3)
    return refuse("the line does not have 3 fields: " + quotedBegin(row.line()),
                  "Write stroke,displacement_mm,force_N");
  const std::string_view stroke = row.fields()[0];
  if (stroke != "press" && stroke != "release")
    return refuse("the line names the stroke " + quotedBegin(stroke), "Write press or release");
  const auto x = row.finite(1), force = row.finite(2);
  if (!x)
    return refuse("displacement " + quotedBegin(row.fields()[1]) + " is not a usable number",
                  "Correct or remove it");
  if (!force)
    return refuse("force " + quotedBegin(row.fields()[2]) + " is not a usable number",
                  "Correct or remove it");
  (stroke == "press" ? lines.press : lines.release).push_back({*x, *force});
  return {};
}

Result<StrokeCurve> strokeThrough(StrokePolyline points, Stroke stroke, double tolerance_N,
                                  const std::string& subject) {
  const bool travelledBack = stroke == Stroke::release;
  if (travelledBack) std::reverse(points.begin(), points.end());
  if (const auto fault = faultOf(points)) {
    const std::size_t row = travelledBack ? points.size() - fault->index : fault->index + 1;
    return Failure{
        FailureCode::unreadableInput, subject,
        travelledBack ? Message("release rows, point %1", row) : Message("press rows, point %1", row),
        fault->problem, fault->remedies};
  }
  auto curve = curveThroughDensePoints(points, tolerance_N);
  if (curve) return curve;
  Failure failure = curve.failure();
  failure.subject = subject;
  failure.place = travelledBack ? Message("release rows") : Message("press rows");
  return failure;
}

double forceRange(const GraphPolylines& lines) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const StrokePolyline* stroke : {&lines.press, &lines.release})
    for (const CurvePoint& p : *stroke) {
      low = std::min(low, p.force_N);
      high = std::max(high, p.force_N);
    }
  return high - low;
}

}  // namespace

std::string csvFrom(const ForceGraph& graph) {
  std::string out(header);
  out += '\n';
  appendRows(out, "press", travelledSamples(graph, Stroke::press));
  if (graph.release()) appendRows(out, "release", travelledSamples(graph, Stroke::release));
  return out;
}

Result<GraphPolylines> polylinesFromCsv(std::string_view text, const std::string& subject) {
  NumberTable table(text);
  if (!table.next() || !table.is({"stroke", "displacement_mm", "force_N"}))
    return csvFailure(
        FailureCode::unreadableInput, subject, std::max<std::size_t>(1, table.number()),
        "the line is " + quotedBegin(table.line()) + ", not the header \"" + std::string(header) + "\"",
        "Use detent-import for a force meter's own CSV");
  GraphPolylines lines;
  while (table.next())
    if (auto problem = appendRow(lines, table, subject)) return *problem;
  if (lines.press.empty() && lines.release.empty())
    return csvFailure(FailureCode::noForceGraph, subject, 0, "the file has a header but no rows",
                      "Give rows of a force graph");
  return lines;
}

Result<ForceGraph> graphFromCsv(std::string_view text, const std::string& subject) {
  auto lines = polylinesFromCsv(text, subject);
  if (!lines) return lines.failure();
  if (lines->press.empty())
    return csvFailure(FailureCode::noForceGraph, subject, 0, "the file has no press rows",
                      "Give the press stroke as well");
  const double tolerance_N =
      std::max(samplingTolerance * forceRange(*lines), std::numeric_limits<double>::min());
  auto press = strokeThrough(lines->press, Stroke::press, tolerance_N, subject);
  if (!press) return press.failure();
  std::optional<StrokeCurve> release;
  if (!lines->release.empty()) {
    auto curve = strokeThrough(lines->release, Stroke::release, tolerance_N, subject);
    if (!curve) return curve.failure();
    release = *std::move(curve);
  }
  auto graph = ForceGraph::fromCurves(*std::move(press), std::move(release));
  if (graph) return graph;
  Failure failure = graph.failure();
  failure.subject = subject;
  return failure;
}

}  // namespace detent
