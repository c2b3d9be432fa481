// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The serial port (or pty) of all devices in this folder: bytes as they arrive, or questions and answers in
// whole lines. No call waits beyond its deadline. Survives unplugging.

#include <optional>
#include <string>
#include <string_view>

#include "model/result.h"

namespace detent::playback {

/// One thread. Allocates nothing after opening, unless a line is longer than 250 characters.
class SerialLink {
 public:
  /// Opens a port raw, 8 bits, no parity, for this program alone. Failure if it cannot be opened now, if
  /// another program has it open (which is named if possible), or if the baud rate is invalid.
  static Result<SerialLink> open(const std::string& port, unsigned baud, double reopenPause_s = 0.2);
  SerialLink(SerialLink&& other) noexcept;
  SerialLink& operator=(SerialLink&& other) noexcept;
  ~SerialLink() { close(); }

  /// Returns false after the port was lost; `reopen` then tries again, at most every `reopenPause_s`.
  bool isOpen() const { return descriptor_ >= 0; }
  bool reopen();

  /// Sends text unchanged. A port that accepts nothing within a millisecond, or is gone, counts as lost.
  void send(std::string_view text);
  /// Waits until `deadline_s` (on now_s()) for bytes and returns those that arrived; empty if none did. Must
  /// not be mixed with `line`.
  std::string_view bytes(double deadline_s);
  /// Waits until `deadline_s` for the next whole line, without its line end; none if none arrived.
  std::optional<std::string_view> line(double deadline_s);
  /// Discards input that arrived without a request.
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
