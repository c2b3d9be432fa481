// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Correlation of the ranks of two lists.

#include <vector>

namespace detent::playback {

/// Spearman's rank correlation with mean ranks for ties, -1..1; 0 if one list is constant or shorter than
/// two. Both lists have the same length.
double spearman(const std::vector<double>& x, const std::vector<double>& y);

/// One-sided p of at least this correlation by chance, from 9,999 shuffles of `y` with a fixed seed; 1 if
/// there is no correlation.
double spearmanP(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace detent::playback
