// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Correlation of the ranks of two lists.

#include <vector>

namespace detent::playback {

/// Spearman's rank correlation with mean ranks for ties, -1..1; 0 where one list is constant or shorter than
/// two. Both of one length.
double spearman(const std::vector<double>& x, const std::vector<double>& y);

/// P(at least this correlation by chance), one-sided, from 9,999 shuffles of `y` with a fixed seed; 1 where
/// there is none.
double spearmanP(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace detent::playback
