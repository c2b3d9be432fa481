// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is allowed but odd. Rules that must hold are checked where values are born (StrokeCurve, ForceGraph,
// Button) and are Failures; what stands here are warnings: the button can be used, and a person should look.

#include <string>
#include <string_view>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

enum class Rule {
  releaseAbovePress,     ///< the release needs more force than the press: energy out of nothing, or strokes
                         ///< exchanged
  strokesDoNotMeet,      ///< press and release end at different displacements at the bottom
  noRelease,             ///< one stroke only
  negativeForce,         ///< the button pulls
  fallsAtStart,          ///< the press begins with a falling force: cannot be held at its start
  hiddenTactilePoint,    ///< a tactile point inside an earlier jump: force never rests there
  resetBeyondOperating,  ///< the contact would open deeper than where it closes
  statesDoNotMeet,       ///< self-locking: one state's release ends elsewhere than the other's press starts
  dampingOutsideTravel,  ///< damping points where the button cannot be
  manyKnots,             ///< more than a hand can edit
  lowConfidence,         ///< the import was not sure
  speedsGiveEnergy,  ///< a release at one speed needs more force than the press at another: pressed at that and released at this, the
                     ///< button would give more than it took
};

/// Name of a rule as printed and in JSON: "release-above-press".
std::string_view nameOf(Rule rule);

/// Where a finding is, as far as it has a place.
struct WarningPlace {
  std::optional<std::size_t> state;  ///< index; none: the button as a whole
  std::optional<Stroke> stroke;
  std::optional<double> at_mm;
  std::optional<double> speed_mm_per_s = {};  ///< of the graph, where the button has several
  friend bool operator==(const WarningPlace&, const WarningPlace&) = default;
};

/// One finding: which rule, where, with which value.
struct Warning {
  Rule rule;
  std::string place;      ///< "state \"locked\", press curve, 1.25 mm"
  double value = 0;       ///< the offending value, in `unit`
  std::string_view unit;  ///< "N", "mm", "" for counts and shares
  std::string problem;    ///< the sentence, without the place
  WarningPlace spot;      ///< the place again, for those who lead a person there
  double against =
      0;  ///< what `value` was held against (the other end, the operating point), mm; of speeds that of the press, mm/s
  std::string sentence() const { return place + ": " + problem + "."; }
};

/// All warnings, in the order of states and rules. Any thread.
std::vector<Warning> validate(const Button& button, const SectionSettings& settings = {});

}  // namespace detent
