// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plots of a run under force: the felt force beside the drawn curve, and the figures of Shrestha's paper.

#include <string>
#include <vector>

#include "playback/force_feedback.h"

namespace detent::playback {

/// Force over displacement with the button's curves, force and position over time.
std::string runSvg(const Button& button, const std::vector<ForceStep>& steps, double period_s);

/// Shrestha's Figures 4 (damping over displacement), 5 (stiffness) and 6 (force, from the run), with the
/// equations used. Parts that the button does not have are left out.
std::string paperFiguresSvg(const Button& button, const std::vector<ForceStep>& steps);

}  // namespace detent::playback
