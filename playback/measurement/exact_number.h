// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers in files that are read back.

#include <string>

namespace detent::playback {

/// Shortest text that reads back as the same double.
std::string exact(double value);

}  // namespace detent::playback
