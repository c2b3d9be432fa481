// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/exact_number.h"

#include <array>
#include <charconv>

namespace detent::playback {

std::string exact(double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() ? std::string(digits.data(), end) : "0";
}

}  // namespace detent::playback
