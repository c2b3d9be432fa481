// SPDX-License-Identifier: GPL-3.0-or-later
// C streams of this folder: closed when they go out of scope, with the system's reason for a failure.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

namespace detent {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using CFile = std::unique_ptr<std::FILE, CloseFile>;  ///< null if the file could not be opened

/// Text of the current errno, such as "Permission denied".
inline std::string systemReason() { return std::strerror(errno); }

}  // namespace detent
