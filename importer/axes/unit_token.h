// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last word of a title by itself: whatever language stands before it, units are written with few letters.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/axes/read_text.h"

namespace detent::importer {

/// A unit at the end of a line.
struct UnitToken {
  std::string symbol;
  bool apart = false;  ///< brackets, a stroke or a comma say that a unit stands there; else a blank alone
  std::size_t lettersBefore = 0, lettersOfLine = 0;  ///< blobs

  /// The line with this unit in place of what was read there.
  std::string endOf(const std::string& line) const;
};

/// The unit that a line ends in. `letters`: the line's blobs, turned so that the line reads along +x;
/// `quarterTurns` clockwise that turned them; `angle_deg` of the line's baseline in the view. nullopt where
/// nothing of the closed list of units stands there.
std::optional<UnitToken> unitAtEnd(TextReader& reader, std::vector<Box> letters, int quarterTurns,
                                   double angle_deg);

}  // namespace detent::importer
