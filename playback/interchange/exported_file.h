// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an export writes.

#include <string>

namespace detent::playback {

/// One file of an export. Its path is the path asked for with `part` before the ending, and `ending` instead
/// of it where there is one.
struct ExportedFile {
  std::string part;    ///< ".press", ".release" or empty
  std::string ending;  ///< ".h" or empty
  std::string text;
};

}  // namespace detent::playback
