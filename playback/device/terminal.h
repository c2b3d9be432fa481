// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The terminal of the live view: single keys without Enter, restored however the program ends, and Ctrl-C as
// a request.

#include <optional>

namespace detent::playback {

/// While one lives, standard input gives single keys. Does nothing where standard input is not a terminal.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  bool interactive() const { return interactive_; }
  /// A key pressed within `timeout_s` (>= 0), if any; waits to the microsecond.
  std::optional<char> key(double timeout_s);

 private:
  bool interactive_ = false;
};

/// Gives the terminal back as it was, if a RawTerminal took it. Any thread, also while one lives: for the end
/// by force.
void restoreTerminal();

/// Columns of the terminal behind standard error; 80 where unknown.
int terminalColumns();
bool errorIsTerminal();

}  // namespace detent::playback
