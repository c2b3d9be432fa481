// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one serial port (or pty) of the device room: bytes as they come, or question and answer in whole lines; nothing waits longer
// than it is told. Survives unplugging.

#include <optional>
#include <string>
#include <string_view>

#include "model/result.h"

namespace detent::playback {

/// One thread. Allocates nothing once it is open, unless a line is longer than 250 characters.
class SerialLink {
 public:
  /// Opens a port raw, 8 bits, no parity, for this program alone. Failure where it cannot be opened now, another program holds it (named
  /// where that can be seen), or a baud rate is none.
  static Result<SerialLink> open(const std::string& port, unsigned baud, double reopenPause_s = 0.2);
  SerialLink(SerialLink&& other) noexcept;
  SerialLink& operator=(SerialLink&& other) noexcept;
  ~SerialLink() { close(); }

  /// False once the port was lost; `reopen` then tries again, at most every `reopenPause_s`.
  bool isOpen() const { return descriptor_ >= 0; }
  bool reopen();

  /// Sends text as it is. A port that takes nothing within a millisecond, or is gone, counts as lost.
  void send(std::string_view text);
  /// What came, as soon as something came, until `deadline_s` (on now_s()); empty where nothing did. Not to be mixed with `line`.
  std::string_view bytes(double deadline_s);
  /// The next whole line without its end, read until `deadline_s`; none where none came.
  std::optional<std::string_view> line(double deadline_s);
  /// Forgets what came and was not asked for.
  void forget();

 private:
  SerialLink() = default;
  bool openPort();
  void close();
  bool fill(double deadline_s);

  std::string port_;
  unsigned baud_ = 0;
  int descriptor_ = -1;
  double reopenPause_s_ = 0, lastTry_s_ = 0;
  std::string received_, line_;
};

}  // namespace detent::playback
