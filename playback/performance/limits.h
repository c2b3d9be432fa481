// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Limits of standards for keys, each with its edition and clause as far as it was read, and a button held against them.

#include <optional>
#include <string>
#include <vector>

#include "model/button.h"

namespace detent::playback {

/// What a limit bounds.
enum class LimitedFigure {
  keyForce,  ///< N: the largest force of the press before the bottom-out; of a tactile key its peak
  travel     ///< mm: start of the press to the bottom-out
};

/// One clause. Bounds in the figure's unit; at least one is there.
struct Limit {
  std::string standard, edition, clause;
  std::string kind;  ///< "required" or "preferred"
  LimitedFigure figure = LimitedFigure::keyForce;
  std::optional<double> least, most;
  double tolerance = 0;  ///< of the measurement: so far beyond a bound a value neither passes nor fails; >= 0
};

/// Those that come with Detent.
const std::vector<Limit>& knownLimits();

enum class LimitOutcome { pass, fail, withinTolerance };

struct LimitFinding {
  Limit limit;
  double value = 0;
  LimitOutcome outcome = LimitOutcome::pass;
};

/// Every limit, in their order, for the button's first state.
std::vector<LimitFinding> holdAgainst(const std::vector<Limit>& limits, const Button& button);

}  // namespace detent::playback
