// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Range of travel and force of real buttons. A value outside of it is a misread number: no known key, dome or
// tact switch comes near the limits.

namespace detent::importer {

inline constexpr double mostForce_N = 50, leastForce_N = 0.04, mostTravel_mm = 25, leastTravel_mm = 0.04;

}  // namespace detent::importer
