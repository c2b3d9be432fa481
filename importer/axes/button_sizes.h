// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sizes that tell a button from a number misread: no key, dome or tact switch at hand comes near them.

namespace detent::importer {

inline constexpr double mostForce_N = 50, leastForce_N = 0.04, mostTravel_mm = 25, leastTravel_mm = 0.04;

}  // namespace detent::importer
