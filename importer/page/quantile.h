// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one definition of medians and other quantiles.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace detent::importer {

/// The smallest value that at least `share` (0..1) of the values do not exceed; the median of an even number
/// is the lower of the two middle ones. 0 for no values.
template <class T>
T quantileOf(std::vector<T> values, double share) {
  if (values.empty()) return T{};
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

template <class T>
T medianOf(std::vector<T> values) {
  return quantileOf(std::move(values), 0.5);
}

}  // namespace detent::importer
