// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Detects that the person wants the program to end: Ctrl-C, SIGTERM, a closed terminal.

#include <memory>

namespace detent::playback {

/// One per program, made first. interruption.cpp receives signals on a thread; without devices
/// (no_device_interruption.cpp) a plain signal handler does, and the second signal ends the program.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool requested() const;

 private:
  struct Hearing;
  std::unique_ptr<Hearing> hearing_;
};

}  // namespace detent::playback
