// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From wanted key figures to a button: the smallest change of the curve that gives them, or which of them contradict each
// other. Reading order: targets.h, bendable_state.h (what can move, and what it costs), quadratic_program.h.

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "model/button.h"
#include "model/key_figures.h"
#include "model/sections.h"

namespace detent {

/// A figure that is to have a value: one wanted, or one kept as it is.
struct FigureTarget {
  KeyFigure figure = KeyFigure::initialForce;
  double value = 0;  ///< mm, N, N/mm, mJ, or a share
};

/// Which targets cannot be met together. Without any one of them the others can be.
struct TargetConflict {
  std::vector<KeyFigure>
      figures;  ///< one: the button itself does not allow it; two or more: the first two, given the rest
  /// Of a single figure: the value nearest to the one asked for that could be had, found on the way to it, to 1 part in 64 of the way.
  std::optional<double> reachable;
  Failure failure;         ///< the same in words, for a single figure with what stands in the way
  bool undecided = false;  ///< it is not known whether they contradict, or whether fewer of them do
};

/// How long a solve goes on.
struct TargetPatience {
  std::function<bool()> givenUp = {};  ///< asked at every step, some 10 ms; true ends it, and nothing is told
  /// Curves that may be bent and measured, each counted by its knots; then what is known is told. Counted and not timed, so that
  /// every machine gives the same answer.
  std::size_t mostKnots = std::numeric_limits<std::size_t>::max();
};

/// Exactly one of the two is there; neither where it was given up.
struct TargetOutcome {
  std::optional<Button> button;
  std::optional<TargetConflict> conflict;
};

/// How near a figure has to come: a tenth of what the bars of a datasheet's last digit ask for.
struct TargetTolerance {
  double force_N = 1e-4;
  double length_mm = 1e-4;
};

/// Bends one state until its key figures have the values asked for. Of all curves that do, the one whose landmarks move
/// least (bendable_state.h); a figure that nobody asks for may move. What was true of the button stays true: no rule of
/// validation.h is broken that was kept. A figure the button does not have, and a value that is not finite, are conflicts of
/// their own; of a figure asked for twice the last counts. Milliseconds for a drawn button, up to seconds where many
/// targets contradict each other. Any thread.
TargetOutcome bentToTargets(const Button& button, std::size_t state, const std::vector<FigureTarget>& targets,
                            const TargetTolerance& tolerance = {}, const SectionSettings& settings = {},
                            const TargetPatience& patience = {});

}  // namespace detent
