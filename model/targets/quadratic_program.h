// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Minimises a quadratic cost under linear equalities and inequalities: Goldfarb & Idnani, "A numerically
// stable dual method for solving strictly convex quadratic programs" (Mathematical Programming 27, 1983).

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace detent {

/// normal · z == bound, or >= bound.
struct LinearRule {
  Eigen::VectorXd normal;
  double bound = 0;
  bool equal = false;
};

/// Returns the z that minimises z' H z and keeps every rule, given H's inverse (symmetric, positive
/// definite). nullopt if the rules contradict. For some hundred unknowns. Any thread.
std::optional<Eigen::VectorXd> leastUnder(const std::vector<LinearRule>& rules,
                                          const Eigen::MatrixXd& inverseCost);

}  // namespace detent
