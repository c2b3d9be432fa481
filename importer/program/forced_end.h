// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ends a cancelled program even if a library does not return.

#include <functional>
#include <future>
#include <thread>

namespace detent::importer {

/// While an object exists, the process ends `grace_s` seconds after `cancelled` first returned true.
/// Incomplete files are removed, and the exit code is that of a cancelled import. Code that polls `cancelled`
/// itself can end regularly within that time. `cancelled` is called from a separate thread.
class ForcedEnd {
 public:
  explicit ForcedEnd(std::function<bool()> cancelled, double grace_s = 0.3);
  ~ForcedEnd();
  ForcedEnd(const ForcedEnd&) = delete;
  ForcedEnd& operator=(const ForcedEnd&) = delete;

 private:
  std::promise<void> over_;
  std::thread watch_;
};

}  // namespace detent::importer
