// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/band_matrix.h"

#include <algorithm>

namespace detent::importer {

void BandMatrix::add(const ResidualRow& row, double weight) {
  const std::array<double, bandWidth> by = row.by;  // a copy, because columns may alias it
  for (std::size_t i = 0; i < bandWidth; ++i) {
    if (by[i] == 0) continue;
    const double factor = weight * by[i];
    std::array<double, bandWidth>& column = columns_[perKnot * row.knot + i];
    for (std::size_t j = i; j < bandWidth; ++j) column[j - i] += factor * by[j];
  }
}

void BandMatrix::separate(std::size_t i) {
  columns_[i] = {1};
  for (std::size_t back = 1; back < std::min(bandWidth, i + 1); ++back) columns_[i - back][back] = 0;
}

double BandMatrix::at(std::size_t i, std::size_t j) const {
  const std::size_t first = std::min(i, j), below = std::max(i, j) - first;
  return below < bandWidth ? columns_[first][below] : 0;
}

// Square-root-free Cholesky: A = L D L'; the columns of D L' replace those of A.
bool BandMatrix::solve(std::vector<double>& right) {
  const std::size_t n = columns_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<double, bandWidth>& column = columns_[i];
    if (!(column[0] > 0)) return false;
    const std::size_t reach = std::min(bandWidth, n - i);
    for (std::size_t j = 1; j < reach; ++j) {
      if (column[j] == 0) continue;
      const double factor = column[j] / column[0];
      for (std::size_t k = j; k < reach; ++k) columns_[i + j][k - j] -= factor * column[k];
      right[i + j] -= factor * right[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = 1; j < std::min(bandWidth, n - i); ++j) right[i] -= columns_[i][j] * right[i + j];
    right[i] /= columns_[i][0];
  }
  return true;
}

}  // namespace detent::importer
