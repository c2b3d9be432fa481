// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Normal equations of a chain of knots. A residual depends on one knot and the next only, so the matrix is a
// band.

#include <array>
#include <cstddef>
#include <vector>

namespace detent::importer {

inline constexpr std::size_t perKnot = 4;              ///< parameters per knot
inline constexpr std::size_t bandWidth = 2 * perKnot;  ///< parameters that a residual may depend on

/// One residual and its derivatives by the parameters of `knot` and of the next knot.
struct ResidualRow {
  std::size_t knot = 0;
  double value = 0;
  std::array<double, bandWidth> by{};
};

/// A symmetric band matrix over all parameters of a chain. Stored per column: the diagonal and the band below
/// it.
class BandMatrix {
 public:
  /// Zero matrix. Has one knot more than the chain, so that every knot of the chain has a next one.
  explicit BandMatrix(std::size_t knots) : columns_(perKnot * (knots + 1)) {}

  /// Adds weight * by * by'.
  void add(const ResidualRow& row, double weight = 1);

  /// Replaces row and column i by those of the identity.
  void separate(std::size_t i);

  std::size_t size() const { return columns_.size(); }
  double& diagonal(std::size_t i) { return columns_[i][0]; }
  double diagonal(std::size_t i) const { return columns_[i][0]; }
  double at(std::size_t i, std::size_t j) const;

  /// Solves A x = right in place and destroys the matrix. Returns false if A is not positive definite;
  /// `right` is then invalid.
  bool solve(std::vector<double>& right);

 private:
  std::vector<std::array<double, bandWidth>> columns_;
};

}  // namespace detent::importer
