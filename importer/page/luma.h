// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace detent::importer {

/// Shares of red, green and blue in brightness, as JPEG and OpenCV weigh them (ITU-R BT.601-7, 2.5.1).
inline constexpr double lumaOfRed = 0.299, lumaOfGreen = 0.587, lumaOfBlue = 0.114;

/// Brightness of a colour, or of the difference of two; in the unit of its channels.
constexpr double luma(double r, double g, double b) {
  return lumaOfRed * r + lumaOfGreen * g + lumaOfBlue * b;
}

}  // namespace detent::importer
