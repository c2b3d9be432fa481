// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text files with one "key = value" per line, below a first line that states kind and version.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent::playback {

inline constexpr std::size_t largestProfile_bytes = 1 << 20;

struct ProfileKind {
  std::string_view magic;  ///< first word of the first line
  int version = 1;         ///< newest version that can be read
  Message what;            ///< "a device profile"
};

/// Skips comments (#) and blank lines. `line` returns the error of a line, empty if there is none. Failure
/// unreadableInput names the line.
Result<Done> readProfileLines(
    const std::string& text, const std::string& name, const ProfileKind& kind,
    const std::function<Message(std::string_view key, std::string_view value)>& line);

/// All numbers of a value; returns false if it contains anything else.
bool numbersOf(std::string_view text, std::vector<double>& numbers);

}  // namespace detent::playback
