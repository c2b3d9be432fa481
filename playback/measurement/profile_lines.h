// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text files of one "key = value" per line, under a first line that says what they are and of which version.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent::playback {

inline constexpr std::size_t largestProfile_bytes = 1 << 20;

struct ProfileKind {
  std::string_view magic;  ///< first word of the first line
  int version = 1;         ///< newest that is read
  Message what;            ///< "a device profile"
};

/// Comments (#) and blank lines are passed over. `line` gives what is wrong with a line, empty if nothing.
/// Failure unreadableInput names the line.
Result<Done> readProfileLines(
    const std::string& text, const std::string& name, const ProfileKind& kind,
    const std::function<Message(std::string_view key, std::string_view value)>& line);

/// All numbers of a value; false if something else stands there.
bool numbersOf(std::string_view text, std::vector<double>& numbers);

}  // namespace detent::playback
