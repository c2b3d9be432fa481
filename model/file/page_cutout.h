// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of a datasheet page behind a button's curves, optionally kept in its file.

#include <array>
#include <cstddef>
#include <string>

namespace detent {

/// Larger cut-outs are neither written nor read, because button files are mailed and versioned.
constexpr std::size_t largestCutout_bytes = std::size_t{1} << 20;

/// Shown if the sheet itself is not found. Plain value.
struct PageCutout {
  std::string png;  ///< PNG file, at most largestCutout_bytes
  /// Row by row: maps (x, y, 1) of a pixel's centre, (0, 0) at the top left, to w times (mm, N, 1). Finite.
  std::array<double, 9> pixelToAxes{};
  friend bool operator==(const PageCutout&, const PageCutout&) = default;
};

}  // namespace detent
