// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The terminal of the live view: single keys without Enter, restored however the program ends, and Ctrl-C as
// a request.

#include <optional>

namespace detent::playback {

/// While an object exists, standard input delivers single keys. Has no effect if standard input is no
/// terminal.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  bool interactive() const { return interactive_; }
  /// A key pressed within `timeout_s` (>= 0), if any; waits with microsecond precision.
  std::optional<char> key(double timeout_s);

 private:
  bool interactive_ = false;
};

/// Restores the terminal's settings if a RawTerminal changed them. Any thread, even while one exists: for a
/// forced end.
void restoreTerminal();

/// Columns of the terminal behind standard error; 80 where unknown.
int terminalColumns();
bool errorIsTerminal();

}  // namespace detent::playback
