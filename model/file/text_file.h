// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reading and writing complete text files.

#include <cstddef>
#include <string>
#include <string_view>

#include "model/result.h"

namespace detent {

/// Larger inputs are refused.
constexpr std::size_t maxTextFileBytes = std::size_t{256} << 20;

/// Reads a regular file or a pipe as bytes. Failure unreadableInput names the file.
Result<std::string> readTextFile(const std::string& path);

/// Writes under a temporary name, checks the stream, then renames; an existing file keeps its permissions, a
/// symbolic link its target. On failure nothing changes. Failure wrongUsage: the path is a folder, no regular
/// file, or in no folder; internalFault: the disk refused.
Result<Done> writeTextFileAtomically(const std::string& path, std::string_view text);

}  // namespace detent
