// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Warnings about a valid button: unusual, but usable. Rules that must hold are checked on construction
// (StrokeCurve, ForceGraph, Button) and are Failures.

#include <string>
#include <string_view>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

enum class Rule {
  releaseAbovePress,     ///< the release needs more force than the press: energy from nothing, or exchanged
                         ///< strokes
  strokesDoNotMeet,      ///< press and release end at different displacements
  noRelease,             ///< only one stroke
  negativeForce,         ///< the button pulls
  fallsAtStart,          ///< the press begins with a falling force, so it cannot be held at its start
  hiddenTactilePoint,    ///< a tactile point inside an earlier jump, which the force never reaches
  resetBeyondOperating,  ///< the contact would open deeper than it closes
  statesDoNotMeet,       ///< self-locking: the release of one state does not end where the press of the other
                         ///< starts
  dampingOutsideTravel,  ///< damping points outside the travel
  manyKnots,             ///< more knots than can be edited by hand
  lowConfidence,         ///< the import had low confidence
  speedsGiveEnergy,  ///< a release at one speed needs more force than a press at another: together they would
                     ///< give energy
};

/// Name of a rule in text and JSON: "release-above-press".
std::string_view nameOf(Rule rule);

/// Place of a finding, as far as known.
struct WarningPlace {
  std::optional<std::size_t> state;  ///< index; nullopt: the button as a whole
  std::optional<Stroke> stroke;
  std::optional<double> at_mm;
  std::optional<double> speed_mm_per_s = {};  ///< speed of the graph, if the button has several
  friend bool operator==(const WarningPlace&, const WarningPlace&) = default;
};

/// One finding: rule, place and value.
struct Warning {
  Rule rule;
  std::string place;      ///< "state \"locked\", press curve, 1.25 mm"
  double value = 0;       ///< the offending value, in `unit`
  std::string_view unit;  ///< "N", "mm", "" for counts and shares
  std::string problem;    ///< sentence, without the place
  WarningPlace spot;      ///< the place as data
  /// the value that `value` is compared with (the other end, the operating point), mm; for speeds that of the
  /// press, mm/s
  double against = 0;
  std::string sentence() const { return place + ": " + problem + "."; }
};

/// All warnings, in the order of states and rules. Any thread.
std::vector<Warning> validate(const Button& button, const SectionSettings& settings = {});

}  // namespace detent
