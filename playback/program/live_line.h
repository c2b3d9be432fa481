// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace detent::playback {

/// A line of the terminal behind standard error that is rewritten repeatedly; no output if there is no
/// terminal.
class LiveLine {
 public:
  void show(const std::string& text);
  /// Continues on the next line, if this one was begun.
  void end();

 private:
  bool begun_ = false;
};

}  // namespace detent::playback
