// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/targets/quadratic_program.h"

#include <random>

#include <catch2/catch.hpp>

using namespace detent;

namespace {

double cost(const Eigen::VectorXd& z, const Eigen::MatrixXd& weight) { return z.dot(weight * z); }

bool keeps(const Eigen::VectorXd& z, const std::vector<LinearRule>& rules) {
  for (const LinearRule& rule : rules) {
    const double over = rule.normal.dot(z) - rule.bound;
    if (over < -1e-7 || (rule.equal && over > 1e-7)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("without rules nothing moves, an equality is met by the nearest point") {
  const Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(2, 2);
  REQUIRE(leastUnder({}, inverse));
  CHECK(leastUnder({}, inverse)->norm() == Approx(0));
  const LinearRule line{Eigen::Vector2d(3, 4), 10, true};  // distance 2 from the origin, at (1.2, 1.6)
  const auto nearest = leastUnder({line}, inverse);
  REQUIRE(nearest);
  CHECK((*nearest)(0) == Approx(1.2));
  CHECK((*nearest)(1) == Approx(1.6));
}

TEST_CASE("rules that contradict have no answer") {
  const Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(2, 2);
  const Eigen::Vector2d x(1, 0);
  CHECK_FALSE(leastUnder({{x, 1, false}, {-x, 0, false}}, inverse));
  CHECK_FALSE(leastUnder({{x, 1, true}, {x, 2, true}}, inverse));
}

TEST_CASE("no point that keeps the rules is cheaper") {
  std::mt19937 chance(11);
  std::normal_distribution<double> any;
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::VectorXd spread(4);
    for (int i = 0; i < 4; ++i) spread(i) = 0.2 + std::abs(any(chance));
    std::vector<LinearRule> rules;
    Eigen::VectorXd inside(4);
    for (int i = 0; i < 4; ++i) inside(i) = any(chance);
    for (int r = 0; r < 5; ++r) {
      Eigen::VectorXd normal(4);
      for (int i = 0; i < 4; ++i) normal(i) = any(chance);
      const double slack = r == 0 ? 0 : std::abs(any(chance));
      rules.push_back({normal, normal.dot(inside) - slack, r == 0});
    }
    const Eigen::MatrixXd inverse = spread.cwiseInverse().asDiagonal(), weight = spread.asDiagonal();
    const auto least = leastUnder(rules, inverse);
    REQUIRE(least);
    REQUIRE(keeps(*least, rules));
    // Convex: a cheaper point would be found on the way to any point that keeps the rules.
    for (const double step : {1e-3, 1e-2, 0.1, 0.5, 1.0})
      CHECK(cost(*least + step * (inside - *least), weight) >= cost(*least, weight) - 1e-9);
  }
}
