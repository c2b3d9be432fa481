// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace detent::playback {

/// One line of the terminal behind standard error that is written over and over; nothing where there is no
/// terminal.
class LiveLine {
 public:
  void show(const std::string& text);
  /// Moves on to the next line, if one was begun.
  void end();

 private:
  bool begun_ = false;
};

}  // namespace detent::playback
