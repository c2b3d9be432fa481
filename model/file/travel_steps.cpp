// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/travel_steps.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "model/sections.h"

namespace detent {
namespace {

constexpr double endRounding_mm = 1e-3;  // a travel of 3.9998 mm was printed as 4 mm

void appendRounded(std::string& out, double value) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 12).ptr);
}

// Appends one row, or two in the order travelled where the curve is vertical.
void appendSample(std::string& csv, const ForceGraph& graph, Stroke stroke, double at_mm, bool isLast) {
  const StrokeCurve& curve = graph.curve(stroke);
  // The last step may be rounded away from the end by less than the page was read to.
  if (at_mm < curve.start_mm() || at_mm > curve.end_mm() + endRounding_mm) return;
  const bool isEnd = isLast && at_mm > curve.end_mm() - endRounding_mm;
  const double on_mm = isEnd ? curve.end_mm() : at_mm;
  std::pair forces_N(curve.forceBefore_N(on_mm), curve.force_N(on_mm));
  if (stroke == Stroke::release) std::swap(forces_N.first, forces_N.second);
  const auto append = [&](double force_N) {
    csv += stroke == Stroke::press ? "press," : "release,";
    appendRounded(csv, at_mm);
    csv += ',';
    appendRounded(csv, force_N);
    csv += '\n';
  };
  append(forces_N.first);
  if (forces_N.second != forces_N.first) append(forces_N.second);
}

Failure refusal(const Message& problem, const Message& remedy) {
  return {FailureCode::wrongUsage, "", "", problem, remedy};
}

}  // namespace

Result<std::vector<double>> travelsAtEach(double step_mm, const ForceGraph& graph) {
  const double start_mm = graph.press().start_mm(), end_mm = graph.press().end_mm();
  if (!(step_mm > 0) || !std::isfinite(step_mm))
    return refusal(Message("the step is not above 0"), Message("Give a step such as 0.1 mm"));
  if ((end_mm - start_mm) / step_mm > static_cast<double>(mostTravelSteps))
    return refusal(Message("the step is too small: the table would have more than 100000 rows"),
                   Message("Give a larger step"));
  std::vector<double> travels_mm;
  const double last = std::floor(end_mm / step_mm);
  for (double count = std::ceil(start_mm / step_mm); count <= last; ++count)
    travels_mm.push_back(count * step_mm);
  // An end that differs from a multiple by the reading's rounding alone is that multiple.
  const double next_mm = std::round(end_mm / step_mm) * step_mm;
  const bool isRounded = std::abs(end_mm - next_mm) <= std::min(endRounding_mm, 0.1 * step_mm);
  if (isRounded && !travels_mm.empty() && travels_mm.back() == next_mm) travels_mm.pop_back();
  travels_mm.push_back(isRounded ? next_mm : end_mm);
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !graph.release()) continue;
    const double bottomOut_mm = bottomOutOf(graph.curve(stroke)).displacement_mm;
    const auto next = std::lower_bound(travels_mm.begin(), travels_mm.end(), bottomOut_mm);
    if (next != travels_mm.end() && *next != bottomOut_mm && bottomOut_mm < end_mm)
      travels_mm.insert(next, bottomOut_mm);
  }
  return travels_mm;
}

Result<std::vector<double>> travelsWithin(std::vector<double> travels_mm, const ForceGraph& graph) {
  const double start_mm = graph.press().start_mm(), end_mm = graph.press().end_mm();
  if (travels_mm.empty()) return refusal(Message("no travel is given"), Message("Give at least one travel"));
  const auto length = [](double at_mm) { return MessageValue(at_mm, Measure::displacement_mm); };
  for (const double at_mm : travels_mm)
    if (!(at_mm >= start_mm && at_mm <= end_mm + endRounding_mm))
      return refusal(Message("%1 lies outside the travel", length(at_mm)),
                     Message("Give travels from %1 to %2", length(start_mm), length(end_mm)));
  return travels_mm;
}

std::string csvAtTravels(const std::vector<double>& travels_mm, const ForceGraph& graph) {
  std::string csv = "stroke,displacement_mm,force_N\n";
  const double last_mm = *std::max_element(travels_mm.begin(), travels_mm.end());
  for (const double at_mm : travels_mm) appendSample(csv, graph, Stroke::press, at_mm, at_mm == last_mm);
  if (graph.release())
    for (auto at = travels_mm.rbegin(); at != travels_mm.rend(); ++at)
      appendSample(csv, graph, Stroke::release, *at, *at == last_mm);
  return csv;
}

}  // namespace detent
