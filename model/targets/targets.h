// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From requested key figures to a button: the smallest change of the curve that gives them, or which of them
// contradict. Reading order: targets.h, bendable_state.h (unknowns and cost), quadratic_program.h.

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "model/button.h"
#include "model/key_figures.h"
#include "model/sections.h"

namespace detent {

/// A figure with a required value, requested or kept.
struct FigureTarget {
  KeyFigure figure = KeyFigure::initialForce;
  double value = 0;  ///< mm, N, N/mm, mJ, or a share
};

/// Targets that cannot be met together. Without any one of them the others can be met.
struct TargetConflict {
  /// one figure: impossible by itself; two or more: the first two contradict, given the rest
  std::vector<KeyFigure> figures;
  /// For a single figure: the nearest possible value on the way to the requested one, to 1/64 of the way.
  std::optional<double> reachable;
  Failure failure;         ///< the same as a Failure; for a single figure with the limiting rule
  bool undecided = false;  ///< the search ended before it was known which targets contradict
};

/// Limits of a solve.
struct TargetPatience {
  std::function<bool()> givenUp = {};  ///< polled at every step, about every 10 ms; true ends the solve
                                       ///< without a result
  /// Limit of bent and measured curves, counted by their knots. Counted, not timed, so that every machine
  /// gives the same answer.
  std::size_t mostKnots = std::numeric_limits<std::size_t>::max();
};

/// Exactly one of the two is set; neither if the solve was given up.
struct TargetOutcome {
  std::optional<Button> button;
  std::optional<TargetConflict> conflict;
};

/// Required accuracy of a figure: a tenth of the last digit of a datasheet.
struct TargetTolerance {
  double force_N = 1e-4;
  double length_mm = 1e-4;
};

/// Changes one state until its key figures have the requested values. Of all such curves it returns the one
/// whose landmarks move least (bendable_state.h); other figures may change. Rules of validation.h that held
/// stay valid. A figure that the button does not have, and a value that is not finite, are conflicts; of a
/// figure requested twice the last counts. Milliseconds for a drawn button, up to seconds with many
/// contradicting targets. Any thread.
TargetOutcome bentToTargets(const Button& button, std::size_t state, const std::vector<FigureTarget>& targets,
                            const TargetTolerance& tolerance = {}, const SectionSettings& settings = {},
                            const TargetPatience& patience = {});

}  // namespace detent
