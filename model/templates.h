// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Templates for new buttons. Defaults make a plausible key switch; every value is free.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"

namespace detent {

/// One stroke as points joined by monotone cubics: extrema of the points are extrema of the curve, without
/// overshoot.
struct StrokeSketch {
  std::vector<CurvePoint> points;     ///< by increasing displacement; equal displacements make a vertical
                                      ///< piece
  std::vector<std::size_t> straight;  ///< pieces (i: from point i to i + 1) that are straight
};
Result<StrokeCurve> strokeFrom(const StrokeSketch& sketch);

/// Force rises in a straight line; no tactile point ("linear button", Kim & Lee 2013).
struct LinearTemplate {
  std::string name = "linear";
  double travel_mm = 4;
  double startForce_N = 0.30;
  double endForce_N = 0.80;
  double hysteresis_N = 0.05;              ///< release below press; >= 0
  std::optional<double> bottomOutForce_N;  ///< force at the top of a vertical bottom-out; nullopt: none
  std::optional<double> operatingPoint_mm = 2.0, resetPoint_mm = 1.9;
};
Result<Button> linearButton(const LinearTemplate& values = {});

/// One tactile point and valley on the way down.
struct PressLevel {
  CurvePoint tactile, valley;
};
/// One tactile point (a minimum) and the hump beyond it on the way up.
struct ReleaseLevel {
  CurvePoint tactile, hump;
};

/// A button with one or more jumps per stroke: the press goes start, (tactile, valley)..., end, bottom-out;
/// the release goes end, (tactile, hump)..., start. A release without levels is smooth.
struct TactileTemplate {
  std::string name = "tactile";
  double travel_mm = 4;
  double startForce_N = 0.30;
  std::vector<PressLevel> press = {{{1.3, 0.55}, {1.9, 0.42}}};
  double endForce_N = 0.60;
  double releaseStartForce_N = 0.20;
  std::vector<ReleaseLevel> release = {
      {{1.6, 0.22}, {1.1, 0.36}}};  ///< in the order travelled: from deep to shallow
  double releaseEndForce_N = 0.58;  ///< force of the release at the end of the travel
  std::optional<double> bottomOutForce_N = 1.2;
  std::optional<double> operatingPoint_mm = 2.0, resetPoint_mm = 1.7;
};
Result<Button> tactileButton(const TactileTemplate& values = {});

/// A tactile button whose force drops within `collapse_mm` after the tactile point, in a corner, on both
/// strokes.
struct ClickyTemplate {
  std::string name = "clicky";
  double travel_mm = 4;
  double startForce_N = 0.30;
  CurvePoint tactile = {1.7, 0.60};
  double collapse_mm = 0.08;  ///< > 0
  double valleyForce_N = 0.45;
  double endForce_N = 0.62;
  double releaseStartForce_N = 0.20;
  CurvePoint releaseTactile = {1.2, 0.20};
  double releaseHumpForce_N = 0.38;
  double releaseEndForce_N = 0.60;
  std::optional<double> bottomOutForce_N = 1.2;
  std::optional<double> operatingPoint_mm = 1.9, resetPoint_mm = 1.1;
};
Result<Button> clickyButton(const ClickyTemplate& values = {});

/// Two tactile points per stroke, the second one stronger (a camera shutter).
TactileTemplate twoLevelValues();
Result<Button> twoLevelButton();

/// Two states that alternate at each actuation: "unlocked" starts at 0 and returns to `lock_mm` once pressed;
/// "locked" starts there and returns to 0.
struct SelfLockingTemplate {
  std::string name = "self-locking";
  double travel_mm = 4;
  double lock_mm = 2.5;  ///< in (valley of the tactile point, travel)
  double startForce_N = 0.35;
  PressLevel press = {{1.4, 0.75}, {2.0, 0.55}};  ///< press of the unlocked state
  double endForce_N = 0.95;
  double lockForce_N = 0.05;                          ///< force left at the lock, carried by the latch
  double lockedStartForce_N = 0.60;                   ///< force where the locked press leaves the latch, at
                                                      ///< lock_mm
  ReleaseLevel release = {{1.8, 0.30}, {1.2, 0.50}};  ///< release of the locked state, on its way back to 0
  double releaseStartForce_N = 0.20;
  double hysteresis_N = 0.05;
  std::optional<double> bottomOutForce_N = 1.6;
};
Result<Button> selfLockingButton(const SelfLockingTemplate& values = {});

}  // namespace detent
