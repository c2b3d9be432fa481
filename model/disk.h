// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Waiting until written data has reached the disk.

#include <filesystem>
#include <system_error>

namespace detent {

/// Returns when the contents of a file are on its disk. Any thread; blocks.
std::error_code writeToDisk(const std::filesystem::path& file);

/// Returns when the name of a new or changed file is on the disk. Network folders may not support this. Any
/// thread; blocks.
void writeFolderToDisk(const std::filesystem::path& file);

}  // namespace detent
