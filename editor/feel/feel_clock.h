// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The clock of everything the feel panel draws over time.

#include <chrono>

namespace detent::editor {

/// Seconds of a clock that never goes back; its zero is arbitrary.
inline double steadyTime_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace detent::editor
