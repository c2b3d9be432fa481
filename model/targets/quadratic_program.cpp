// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/targets/quadratic_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace detent {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double violated = 1e-10;  // a smaller violation counts as kept; unknowns are of the order of 1
constexpr double dependent = 1e-9;  // a normal spanned by others leaves less than this share of itself

// The active rules with their multipliers, in the order of activation.
class Binding {
 public:
  Binding(const std::vector<LinearRule>& rules, const Eigen::MatrixXd& inverseCost)
      : rules_(rules), inverseCost_(inverseCost), z_(Eigen::VectorXd::Zero(inverseCost.rows())) {}

  const Eigen::VectorXd& place() const { return z_; }
  double slackOf(std::size_t rule) const { return rules_[rule].normal.dot(z_) - rules_[rule].bound; }

  /// Moves until a broken rule holds, dropping others if that is cheaper. Returns false if impossible.
  bool take(std::size_t rule) {
    double slack = slackOf(rule);
    const double sign = rules_[rule].equal && slack > 0 ? -1 : 1;
    const Eigen::VectorXd normal = sign * rules_[rule].normal;
    slack *= sign;
    const Eigen::VectorXd across = inverseCost_ * normal;
    double multiplier = 0;
    for (std::size_t guard = 0; guard <= 2 * rules_.size() + 2; ++guard) {
      const auto [along, pressing] = directions(across);
      const double gain = along.dot(normal);
      const bool free = gain > dependent * across.dot(normal);
      if (!free && slack >= -violated) return true;  // the active rules imply this one
      const double whole = free ? -slack / gain : infinity;
      const auto [first, limit] = firstToLetGo(pressing);
      const double step = std::min(whole, limit);
      if (std::isinf(step)) return false;
      for (std::size_t i = 0; i < active_.size(); ++i)
        multipliers_[i] -= step * pressing[static_cast<Eigen::Index>(i)];
      multiplier += step;
      if (free) {
        z_ += step * along;
        slack += step * gain;
      }
      if (whole <= limit) {
        active_.push_back(rule);
        normals_.push_back(normal);
        multipliers_.push_back(multiplier);
        return true;
      }
      letGo(first);
    }
    return false;
  }

 private:
  struct Directions {
    Eigen::VectorXd along, pressing;
  };

  // Direction in which z may move for a rule without leaving the active ones, and its effect on their
  // multipliers.
  Directions directions(const Eigen::VectorXd& across) const {
    const auto count = static_cast<Eigen::Index>(active_.size());
    if (count == 0) return {across, Eigen::VectorXd()};
    Eigen::MatrixXd normals(inverseCost_.rows(), count);
    for (Eigen::Index i = 0; i < count; ++i) normals.col(i) = normals_[static_cast<std::size_t>(i)];
    const Eigen::MatrixXd weighed = inverseCost_ * normals;
    const Eigen::VectorXd pressing =
        (normals.transpose() * weighed).ldlt().solve(normals.transpose() * across);
    return {across - weighed * pressing, pressing};
  }

  struct Limit {
    std::size_t first;
    double step;
  };
  Limit firstToLetGo(const Eigen::VectorXd& pressing) const {
    Limit limit{0, infinity};
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const double pressed = pressing[static_cast<Eigen::Index>(i)];
      if (rules_[active_[i]].equal || pressed <= 1e-14) continue;
      if (const double step = std::max(0.0, multipliers_[i]) / pressed; step < limit.step) limit = {i, step};
    }
    return limit;
  }
  void letGo(std::size_t which) {
    const auto at = static_cast<std::ptrdiff_t>(which);
    active_.erase(active_.begin() + at);
    normals_.erase(normals_.begin() + at);
    multipliers_.erase(multipliers_.begin() + at);
  }

  const std::vector<LinearRule>& rules_;
  const Eigen::MatrixXd& inverseCost_;
  Eigen::VectorXd z_;
  std::vector<std::size_t> active_;
  std::vector<Eigen::VectorXd> normals_;
  std::vector<double> multipliers_;
};

}  // namespace

std::optional<Eigen::VectorXd> leastUnder(const std::vector<LinearRule>& rules,
                                          const Eigen::MatrixXd& inverseCost) {
  Binding binding(rules, inverseCost);
  for (std::size_t i = 0; i < rules.size(); ++i)
    if (rules[i].equal && !binding.take(i)) return {};
  for (std::size_t round = 0; round <= 4 * rules.size() + 10; ++round) {
    std::size_t worst = rules.size();
    double least = -violated;
    for (std::size_t i = 0; i < rules.size(); ++i) {
      if (rules[i].equal) continue;
      if (const double slack = binding.slackOf(i); slack < least) {
        least = slack;
        worst = i;
      }
    }
    if (worst == rules.size()) return binding.place();
    if (!binding.take(worst)) return {};
  }
  return {};
}

}  // namespace detent
