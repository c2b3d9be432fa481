// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/curve_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "model/sampling.h"

namespace detent {
namespace {

constexpr std::string_view header = "stroke,displacement_mm,force_N";

/// `line` from 1; 0: the file as a whole.
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

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Cuts the next piece off the front, up to a separator.
std::string_view nextPart(std::string_view& rest, char separator) {
  const auto at = rest.find(separator);
  const std::string_view part = rest.substr(0, at);
  rest = at == std::string_view::npos ? std::string_view{} : rest.substr(at + 1);
  return part;
}

std::optional<double> numberFrom(std::string_view text) {
  double value = 0;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

struct Row {
  std::string_view stroke, displacement, force;
  bool complete = false;
};

Row rowFrom(std::string_view line) {
  Row row;
  const bool threeFields = std::count(line.begin(), line.end(), ',') == 2;
  row.stroke = trimmed(nextPart(line, ','));
  row.displacement = trimmed(nextPart(line, ','));
  row.force = trimmed(nextPart(line, ','));
  row.complete = threeFields;
  return row;
}

std::string quoted(std::string_view text) {
  std::string out(1, '"');
  out += text.substr(0, 40);
  return out += '"';
}

std::optional<Failure> appendRow(GraphPolylines& lines, std::string_view text, const std::string& subject,
                                 std::size_t number) {
  const auto refuse = [&](Message problem, Remedies remedies) {
    return csvFailure(FailureCode::unreadableInput, subject, number, std::move(problem), std::move(remedies));
  };
  const Row row = rowFrom(text);
  if (!row.complete)
    return refuse("does not have 3 fields: " + quoted(text), "Write stroke,displacement_mm,force_N");
  if (row.stroke != "press" && row.stroke != "release")
    return refuse("names the stroke " + quoted(row.stroke), "Write press or release");
  const auto x = numberFrom(row.displacement), force = numberFrom(row.force);
  if (!x)
    return refuse("displacement " + quoted(row.displacement) + " is not a finite number",
                  "Correct or remove it");
  if (!force) return refuse("force " + quoted(row.force) + " is not a finite number", "Correct or remove it");
  (row.stroke == "press" ? lines.press : lines.release).push_back({*x, *force});
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
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  const std::string_view first = trimmed(nextPart(text, '\n'));
  if (first != header)
    return csvFailure(FailureCode::unreadableInput, subject, 1,
                      "is " + quoted(first) + ", not the header \"" + std::string(header) + "\"",
                      "Use detent-import for a force meter's own CSV");
  GraphPolylines lines;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = trimmed(nextPart(text, '\n'));
    if (line.empty()) continue;
    if (auto problem = appendRow(lines, line, subject, number)) return *problem;
  }
  if (lines.press.empty() && lines.release.empty())
    return csvFailure(FailureCode::noForceGraph, subject, 0, "has a header but no rows",
                      "Give rows of a force graph");
  return lines;
}

Result<ForceGraph> graphFromCsv(std::string_view text, const std::string& subject) {
  auto lines = polylinesFromCsv(text, subject);
  if (!lines) return lines.failure();
  if (lines->press.empty())
    return csvFailure(FailureCode::noForceGraph, subject, 0, "has no press rows",
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
