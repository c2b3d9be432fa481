// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whole files in, whole files out: an output is complete or not there.

#include <cstddef>
#include <string>
#include <string_view>

#include "model/result.h"

namespace detent {

/// Larger inputs are refused: no button or curve needs them.
constexpr std::size_t maxTextFileBytes = std::size_t{256} << 20;

/// Reads a regular file (or a pipe) as bytes. Failure unreadableInput names the file.
Result<std::string> readTextFile(const std::string& path);

/// Writes beside the target under a temporary name, checks the stream, then renames over it; an existing file
/// keeps its permissions, a symbolic link its target. On failure nothing is left and an existing file is as
/// before. Failure wrongUsage: the path is a folder, no regular file, or lies in no folder; internalFault:
/// the disk refused.
Result<Done> writeTextFileAtomically(const std::string& path, std::string_view text);

}  // namespace detent
