// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The part of a datasheet page that lies behind a button's curves, as its file may keep it.

#include <array>
#include <cstddef>
#include <string>

namespace detent {

/// Larger ones are neither written nor read: a button's file is mailed and put under version control.
constexpr std::size_t largestCutout_bytes = std::size_t{1} << 20;

/// Kept by choice, for where the sheet itself is not found. Plain value.
struct PageCutout {
  std::string png;  ///< the picture's file, at most largestCutout_bytes
  /// Row by row: takes (x, y, 1) of a pixel's centre, (0, 0) at the top left, to w times (mm, N, 1). Finite.
  std::array<double, 9> pixelToAxes{};
  friend bool operator==(const PageCutout&, const PageCutout&) = default;
};

}  // namespace detent
