// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ends a cancelled program, whatever a library is busy with.

#include <functional>
#include <future>
#include <thread>

namespace detent::importer {

/// While one lives, the process ends `grace_s` after `cancelled` was first true: files that are not complete
/// are removed, the exit code is that of a cancelled import. Code that calls `cancelled` itself has that time
/// to end in order. `cancelled` is called from a thread of its own.
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
