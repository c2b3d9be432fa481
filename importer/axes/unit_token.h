// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads the unit at the end of a title separately: in every language units are written with the same few
// letters.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/axes/read_text.h"

namespace detent::importer {

/// A unit at the end of a line.
struct UnitToken {
  std::string symbol;
  bool apart = false;  ///< brackets, a stroke or a comma separate it from the words; false: only a blank does
  std::size_t lettersBefore = 0, lettersOfLine = 0;  ///< blobs

  /// The line with this unit in place of what was read there.
  std::string endOf(const std::string& line) const;
};

/// The unit at the end of a line. `letters`: the line's blobs, turned so that the line reads along +x;
/// `quarterTurns`: the clockwise turns that did this; `angle_deg` of the line's baseline in the view. nullopt
/// if the line does not end in one of the known units.
std::optional<UnitToken> unitAtEnd(TextReader& reader, std::vector<Box> letters, int quarterTurns,
                                   double angle_deg);

}  // namespace detent::importer
