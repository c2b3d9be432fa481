// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Normal equations of a chain of knots: a residual follows one knot and the next, so nothing else is coupled.

#include <array>
#include <cstddef>
#include <vector>

namespace detent::importer {

inline constexpr std::size_t perKnot = 4;              ///< parameters
inline constexpr std::size_t bandWidth = 2 * perKnot;  ///< parameters a residual can follow

/// One residual and its derivatives by the parameters of `knot` and, behind them, of the next one.
struct ResidualRow {
  std::size_t knot = 0;
  double value = 0;
  std::array<double, bandWidth> by{};
};

/// A symmetric matrix over all parameters of a chain. Kept of each column: the diagonal and what stands below it in the band.
class BandMatrix {
 public:
  /// Zero. Has one knot more than the chain, so that each of the chain's has a next.
  explicit BandMatrix(std::size_t knots) : columns_(perKnot * (knots + 1)) {}

  /// Adds weight * by * by'.
  void add(const ResidualRow& row, double weight = 1);

  /// Makes row and column i those of the identity.
  void separate(std::size_t i);

  std::size_t size() const { return columns_.size(); }
  double& diagonal(std::size_t i) { return columns_[i][0]; }
  double diagonal(std::size_t i) const { return columns_[i][0]; }
  double at(std::size_t i, std::size_t j) const;

  /// Solves A x = right for x, in place; uses the matrix up. False, and `right` worth nothing: A is not positive definite.
  bool solve(std::vector<double>& right);

 private:
  std::vector<std::array<double, bandWidth>> columns_;
};

}  // namespace detent::importer
