// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the sample buttons: make_buttons FOLDER. MANIFEST.md beside this file says where each number comes
// from.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "model/check.h"
#include "model/file/button_file.h"
#include "model/templates.h"

namespace {

using namespace detent;

ForceGraph graphFrom(const StrokeSketch& press, const StrokeSketch& release) {
  auto pressCurve = strokeFrom(press);
  auto releaseCurve = strokeFrom(release);
  DETENT_CHECK(pressCurve && releaseCurve, "sketches of the samples are valid");
  auto graph = ForceGraph::fromCurves(*pressCurve, *releaseCurve);
  DETENT_CHECK(graph.ok(), "strokes of the samples belong together");
  return *graph;
}

Button buttonFrom(const std::string& name, std::vector<ButtonState> states) {
  auto button = Button::fromStates(name, std::move(states));
  DETENT_CHECK(button.ok(), "samples are valid buttons");
  return *button;
}

Button momentary(const std::string& name, const StrokeSketch& press, const StrokeSketch& release,
                 std::optional<double> operatingPoint_mm, std::optional<double> resetPoint_mm) {
  return buttonFrom(name, {{"", graphFrom(press, release), operatingPoint_mm, resetPoint_mm, {}}});
}

// ---- Kim & Lee 2013, Figure 9 and Table 3

Button buttonA() {
  return momentary("A: CHERRY MX black, linear", {{{0, 0.38}, {4, 0.82}, {4, 1.10}}, {0}},
                   {{{0, 0.32}, {4, 0.76}, {4, 1.10}}, {0}}, 2.0, 2.0);
}

Button buttonB() {
  const StrokeSketch press{
      {{0, 0.32}, {1.25, 0.55}, {1.75, 0.42}, {2.0, 0.45}, {2.3, 0.50}, {4, 0.60}, {4, 1.15}}, {4}};
  const StrokeSketch release{{{0, 0.20}, {1.05, 0.36}, {1.55, 0.215}, {2.2, 0.475}, {4, 0.585}, {4, 1.15}},
                             {3}};
  return momentary("B: CHERRY MX brown, tactile 55 cN", press, release, 2.0, 1.7);
}

Button buttonC() {
  const StrokeSketch press{{{0, 0.35}, {1.6, 0.65}, {2.0, 0.50}, {2.5, 0.56}, {4, 0.72}, {4, 0.98}}, {3}};
  const StrokeSketch release{{{0, 0.22}, {0.85, 0.42}, {1.35, 0.24}, {2.1, 0.50}, {4, 0.70}, {4, 0.98}}, {3}};
  return momentary("C: CHERRY MX white, tactile 65 cN", press, release, 2.0, 1.4);
}

Button buttonD() {
  const StrokeSketch press{
      {{0, 0.25}, {0.9, 0.80}, {1.25, 0.62}, {2.1, 1.60}, {2.5, 1.00}, {3.2, 1.75}, {3.2, 2.60}}, {}};
  const StrokeSketch release{
      {{0, 0.12}, {0.65, 0.50}, {1.0, 0.36}, {1.9, 1.00}, {2.25, 0.72}, {3.2, 1.62}, {3.2, 2.60}}, {}};
  return momentary("D: two-level button, camera shutter", press, release, 2.2, 2.0);
}

constexpr double lock_mm = 2.5;

ButtonState unlocked() {
  const StrokeSketch press{{{0, 0.35}, {1.4, 0.75}, {2.0, 0.55}, {4, 0.95}, {4, 1.15}}, {}};
  const StrokeSketch release{{{lock_mm, 0.05}, {2.75, 0.38}, {4, 0.85}, {4, 1.15}}, {1}};
  return {"unlocked", graphFrom(press, release), 3.6, {}, {}};
}

ButtonState locked() {
  const StrokeSketch press{
      {{lock_mm, 0.05}, {lock_mm, 0.60}, {2.95, 0.80}, {3.3, 0.69}, {4, 0.95}, {4, 1.15}}, {}};
  const StrokeSketch release{{{0, 0.22}, {2.5, 0.42}, {4, 0.82}, {4, 1.15}}, {0, 1}};
  return {"locked", graphFrom(press, release), 3.6, {}, {}};
}

// One state alone, as Kim & Lee's first experiment presents it.
Button alone(const std::string& name, ButtonState state) {
  state.name.clear();
  return buttonFrom(name, {std::move(state)});
}

// ---- Shrestha, models 1, 2

// F(x) = k(x) x with k(x) = least + bend (x - axis)^2: one cubic, so two knots hold it exactly.
Button elevatorButton() {
  constexpr double travel_mm = 5, axis_mm = 2.5, least_N_per_mm = 0.02, bend_N_per_mm3 = 0.05;
  constexpr double mostDamping_Ns_per_mm = 0.006, leastDamping_Ns_per_mm = 0.001;
  const auto stiffness = [&](double x) {
    return least_N_per_mm + bend_N_per_mm3 * (x - axis_mm) * (x - axis_mm);
  };
  const auto slope = [&](double x) { return stiffness(x) + x * 2 * bend_N_per_mm3 * (x - axis_mm); };
  const auto knot = [&](double x) { return Knot{x, stiffness(x) * x, slope(x), slope(x)}; };
  auto curve = StrokeCurve::fromKnots({knot(0), knot(travel_mm)});
  DETENT_CHECK(curve.ok(), "the parabola's force is a valid curve");
  auto graph = ForceGraph::fromCurves(*curve, *curve);  // a spring: both strokes have its force
  DETENT_CHECK(graph.ok(), "the parabola's force is a valid graph");
  std::vector<DampingPoint> damping;
  constexpr int steps = 20;
  for (int i = 0; i <= steps; ++i) {
    const double x = travel_mm * i / steps, off = (x - axis_mm) / axis_mm;
    damping.push_back(
        {x, mostDamping_Ns_per_mm - (mostDamping_Ns_per_mm - leastDamping_Ns_per_mm) * off * off});
  }
  return buttonFrom("Push button, parabolic stiffness and damping", {{"", *graph, {}, {}, damping}});
}

// Linear force; held at the on position until it is pressed beyond it again.
Button onOffButton() {
  constexpr double on_mm = 22.9, end_mm = 25.4, stiffness_N_per_mm = 0.1;
  const auto force = [&](double x) { return stiffness_N_per_mm * x; };
  const StrokeSketch fromOff{{{0, 0}, {end_mm, force(end_mm)}}, {0}};
  const StrokeSketch toOn{{{on_mm, 0}, {on_mm, force(on_mm)}, {end_mm, force(end_mm)}}, {1}};
  const ButtonState off{"off", graphFrom(fromOff, toOn), on_mm, {}, {}};
  const ButtonState on{"on", graphFrom(toOn, fromOff), on_mm, {}, {}};
  return buttonFrom("On/off click button, latched at 22.9 mm", {off, on});
}

struct Sample {
  const char* file;
  Button button;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("make_buttons FOLDER\n", stderr);
    return 2;
  }
  const std::vector<Sample> samples = {{"A", buttonA()},
                                       {"B", buttonB()},
                                       {"C", buttonC()},
                                       {"D", buttonD()},
                                       {"E", alone("E: self-locking button, unlocked", unlocked())},
                                       {"F", alone("F: self-locking button, locked", locked())},
                                       {"EF", buttonFrom("EF: self-locking button", {unlocked(), locked()})},
                                       {"push", elevatorButton()},
                                       {"latch", onOffButton()}};
  for (const Sample& sample : samples) {
    const std::string path = std::string(argv[1]) + "/" + sample.file + ".button.json";
    const auto written = writeButtonFile(path, sample.button);
    if (written) continue;
    std::fprintf(stderr, "%s\n", written.failure().sentence().c_str());
    return written.failure().exitCode();
  }
  return 0;
}
