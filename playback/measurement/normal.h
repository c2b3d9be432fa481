// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The normal distribution, and Student's for a spread that was estimated from few values. Any thread.

#include <cstddef>

namespace detent::playback {

/// P(Z <= z).
double normalCdf(double z);

/// The z with normalCdf(z) == p; p in (0, 1), else -infinity or +infinity at the ends.
double normalQuantile(double p);

/// P(T <= t) of Student's t with so many degrees of freedom, >= 1 (Abramowitz & Stegun 26.7.3 and 26.7.4:
/// finite sums).
double studentCdf(double t, std::size_t degrees);

/// The t with studentCdf(t, degrees) == p; p in (0, 1), else -infinity or +infinity at the ends.
double studentQuantile(double p, std::size_t degrees);

}  // namespace detent::playback
