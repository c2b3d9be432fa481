// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/force_plots.h"

#include <algorithm>
#include <cstdio>

#include "model/damping.h"
#include "playback/program/xy_plot.h"

namespace detent::playback {

namespace {

constexpr const char *blue = "#1f5fa8", *red = "#b3261e", *grey = "#888888";
constexpr int curvePlaces = 400;

template <class Value>
PlotLine lineOver(const StrokeCurve& curve, const char* name, const char* color, bool dashed,
                  const Value& value) {
  PlotLine line{name, color, {}, dashed};
  for (int i = 0; i <= curvePlaces; ++i) {
    const double x_mm = curve.start_mm() + curve.travel_mm() * i / curvePlaces;
    line.points.push_back({x_mm, value(x_mm)});
  }
  return line;
}

PlotLine drawnLine(const StrokeCurve& curve, const char* name, const char* color) {
  return lineOver(curve, name, color, true, [&](double x_mm) { return curve.force_N(x_mm); });
}

PlotLine feltLine(const std::vector<ForceStep>& steps, const char* name) {
  PlotLine line{name, blue, {}};
  for (const ForceStep& s : steps) line.points.push_back({s.position_mm, s.force_N});
  return line;
}

void addDrawn(const Button& button, XyPlot& plot) {
  for (const ButtonState& state : button.states()) {
    plot.lines.push_back(drawnLine(state.graph.press(), plot.lines.empty() ? "press, as drawn" : "", red));
    if (state.graph.release() && !(*state.graph.release() == state.graph.press())) {
      plot.lines.push_back(
          drawnLine(*state.graph.release(), plot.lines.size() == 1 ? "release, as drawn" : "", grey));
    }
  }
}

std::string fact(const char* format, double a, double b = 0) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

XyPlot dampingFigure(const ButtonState& state) {
  const StrokeCurve& press = state.graph.press();
  const auto damping = [&](double x_mm) { return dampingAt(state.damping, x_mm); };
  const auto most = std::max_element(
      state.damping.begin(), state.damping.end(),
      [](const DampingPoint& a, const DampingPoint& b) { return a.damping_Ns_per_mm < b.damping_Ns_per_mm; });
  return {
      "Figure 4: damping over the distance from equilibrium",
      "distance x [mm]",
      "b [N s/mm]",
      {fact("b(x) is largest, %.4g N s/mm, at x = %.3g mm", most->damping_Ns_per_mm, most->displacement_mm)},
      {lineOver(press, "", blue, false, damping)}};
}

XyPlot stiffnessFigure(const ButtonState& state) {
  const StrokeCurve& press = state.graph.press();
  const double nearest_mm =
      press.start_mm() + press.travel_mm() / curvePlaces;  // at displacement 0 the quotient is the slope
  const auto stiffness = [&](double x_mm) {
    return x_mm < nearest_mm ? press.slope_N_per_mm(press.start_mm()) : press.force_N(x_mm) / x_mm;
  };
  return {
      "Figure 5: stiffness over the distance from equilibrium",
      "distance x [mm]",
      "k [N/mm]",
      {fact("k(x) = F(x) / x; k(%.3g mm) = %.4g N/mm", press.end_mm() / 2, stiffness(press.end_mm() / 2))},
      {lineOver(press, "", blue, false, stiffness)}};
}

}  // namespace

std::string runSvg(const Button& button, const std::vector<ForceStep>& steps, double period_s) {
  XyPlot graph{"Force over displacement: " + button.name(), "displacement [mm]", "force [N]", {}, {}};
  addDrawn(button, graph);
  graph.lines.push_back(feltLine(steps, "felt"));
  PlotLine force{"", blue, {}}, position{"", blue, {}};
  for (const ForceStep& s : steps) {
    const double time_s = static_cast<double>(s.index - 1) * period_s;
    force.points.push_back({time_s, s.force_N});
    position.points.push_back({time_s, s.position_mm});
  }
  return svgOf({graph,
                {"Force over time", "time [s]", "force [N]", {}, {force}},
                {"Displacement over time", "time [s]", "displacement [mm]", {}, {position}}});
}

std::string paperFiguresSvg(const Button& button, const std::vector<ForceStep>& steps) {
  const ButtonState& state = button.states().front();
  std::vector<XyPlot> plots;
  if (!state.damping.empty()) plots.push_back(dampingFigure(state));
  plots.push_back(stiffnessFigure(state));
  XyPlot felt{"Figure 6: force over the distance from equilibrium, from this run",
              "distance x [mm]",
              "force [N]",
              {},
              {}};
  addDrawn(button, felt);
  felt.lines.push_back(feltLine(steps, "felt"));
  felt.notes.push_back(state.damping.empty() ? "F = k(x) x"
                                             : "F = k(x) x + b(x) v, x and v along pressing, F against it");
  if (button.selfLocking() && state.operatingPoint_mm) {
    felt.notes.push_back(
        fact("on position at %.4g mm: the state changes there, and the way back is restricted",
             *state.operatingPoint_mm));
  }
  plots.push_back(std::move(felt));
  return svgOf(plots);
}

}  // namespace detent::playback
