// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The normal distribution. Any thread.

namespace detent::playback {

/// P(Z <= z).
double normalCdf(double z);

/// The z with normalCdf(z) == p; p in (0, 1), else -infinity or +infinity at the ends.
double normalQuantile(double p);

}  // namespace detent::playback
