// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Options whose value is a number.

#include <cmath>
#include <string>

#include <CLI/CLI.hpp>

namespace detent::playback {

/// A number from `low` to `high`, both included, and nothing else: CLI::Range lets "nan" pass, which is neither.
inline CLI::Validator numberWithin(double low, double high) {
  std::string range = CLI::detail::to_string(low) + ".." + CLI::detail::to_string(high);
  return CLI::Validator(
      [low, high, range](std::string& text) {
        double value = 0;
        const bool number = CLI::detail::lexical_cast(text, value);
        if (number && value >= low && value <= high) return std::string();
        return text + " is not a number from " + range;
      },
      range);
}

}  // namespace detent::playback
