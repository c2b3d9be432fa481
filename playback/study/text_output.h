// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Writing a text file whole or not at all.

#include <filesystem>
#include <string>

#include "model/result.h"

namespace detent::playback {

/// Written beside the target and renamed. Failure: unreadableInput with the reason.
Result<Done> writeWholeFile(const std::filesystem::path& file, const std::string& text);

/// Shortest text that reads back as the same double.
std::string exact(double value);

}  // namespace detent::playback
