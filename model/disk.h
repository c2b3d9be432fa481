// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What has been written waits in memory for the disk; here one waits for it.

#include <filesystem>
#include <system_error>

namespace detent {

/// Returns when the content of a file is on its disk. Any thread; waits for the disk.
std::error_code writeToDisk(const std::filesystem::path& file);

/// Returns when the name of a file (new or changed) is on the disk, where its folder can be asked for that: network folders may
/// refuse. Any thread; waits for the disk.
void writeFolderToDisk(const std::filesystem::path& file);

}  // namespace detent
