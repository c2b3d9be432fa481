// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Buttons of known shape for the playback tests: the kinds of Kim & Lee's Figure 9, drawn here.

#include <string>
#include <utility>
#include <vector>

#include "model/button.h"
#include "playback/prepare/prepare_program.h"

namespace detent::test {

inline StrokeCurve curveThrough(const std::vector<CurvePoint>& points) {
  Result<StrokeCurve> curve = StrokeCurve::throughPoints(points);
  if (!curve) throw std::runtime_error(curve.failure().sentence());
  return *std::move(curve);
}

inline Button buttonOf(const std::string& name, std::vector<ButtonState> states) {
  Result<Button> button = Button::fromStates(name, std::move(states));
  if (!button) throw std::runtime_error(button.failure().sentence());
  return *std::move(button);
}

inline ButtonState stateOf(const std::string& name, const std::vector<CurvePoint>& press,
                           const std::vector<CurvePoint>& release) {
  Result<ForceGraph> graph = ForceGraph::fromCurves(
      curveThrough(press), release.empty() ? std::optional<StrokeCurve>{} : curveThrough(release));
  if (!graph) throw std::runtime_error(graph.failure().sentence());
  return ButtonState{name, *std::move(graph), {}, {}, {}};
}

/// A: linear, 4 mm.
inline Button linearButton() {
  return buttonOf("linear", {stateOf("", {{0, 0.1}, {2, 0.4}, {4, 0.7}}, {{0, 0.05}, {2, 0.35}, {4, 0.65}})});
}

/// B/C: one tactile point on both strokes.
inline Button tactileButton() {
  return buttonOf("tactile", {stateOf("", {{0, 0.1}, {1.2, 0.55}, {1.8, 0.38}, {3.0, 0.56}, {4, 0.8}},
                                      {{0, 0.05}, {1.0, 0.5}, {1.6, 0.25}, {3.0, 0.48}, {4, 0.78}})});
}

/// D: two levels, like a camera shutter.
inline Button twoLevelButton() {
  return buttonOf(
      "two-level",
      {stateOf("", {{0, 0}, {0.4, 1.2}, {0.6, 0.7}, {1.0, 1.6}, {1.4, 2.8}, {1.6, 1.5}, {2.0, 3.2}},
               {{0, 0}, {0.35, 1.0}, {0.6, 0.5}, {1.0, 1.3}, {1.3, 2.3}, {1.6, 1.1}, {2.0, 3.1}})});
}

/// EF: self-locking; no tactile point on the unlocked state's release.
inline Button lockingButton() {
  return buttonOf("locking", {stateOf("unlocked", {{0, 0.1}, {1.5, 0.9}, {2.0, 0.5}, {3.0, 1.2}, {3.5, 1.6}},
                                      {{0, 0.05}, {1.5, 0.4}, {3.5, 1.5}}),
                              stateOf("locked", {{0, 0.2}, {2.0, 0.8}, {3.5, 1.7}},
                                      {{0, 0.1}, {1.2, 0.6}, {1.8, 0.3}, {3.5, 1.6}})});
}

inline playback::HapticProgram programOf(const Button& button,
                                         const playback::PlaybackSettings& settings = {},
                                         const playback::DeviceProfile& profile = {}) {
  Result<playback::PreparedProgram> prepared = playback::prepareProgram(button, profile, settings);
  if (!prepared) throw std::runtime_error(prepared.failure().sentence());
  return prepared->program;
}

}  // namespace detent::test
