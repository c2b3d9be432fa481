// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that an export writes.

#include <string>

namespace detent::playback {

/// One file of an export. Its path is the requested path with `part` inserted before the extension, and with
/// `ending` in place of the extension if it is not empty.
struct ExportedFile {
  std::string part;    ///< ".press", ".release" or empty
  std::string ending;  ///< ".h" or empty
  std::string text;
};

}  // namespace detent::playback
