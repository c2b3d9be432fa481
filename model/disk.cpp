// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/disk.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace detent {

std::error_code writeToDisk(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {errno, std::generic_category()};
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return {error, std::generic_category()};
}

void writeFolderToDisk(const std::filesystem::path& file) {
  writeToDisk(file.has_parent_path() ? file.parent_path() : std::filesystem::path("."));
}

}  // namespace detent
