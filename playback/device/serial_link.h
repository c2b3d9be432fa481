// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A serial port (or a pty) for question and answer within a deadline: whole lines out, whole lines in, nothing waits longer than it
// is told. Survives unplugging.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playback/device/device_trouble.h"

namespace detent::playback {

/// One thread. Allocates nothing once it is open, unless a line is longer than 250 characters.
class SerialLink {
 public:
  /// Opens a port raw. Trouble where it cannot be opened now, or a baud rate is none.
  static DeviceResult<SerialLink> open(const std::string& port, unsigned baud);
  SerialLink(SerialLink&& other) noexcept;
  SerialLink& operator=(SerialLink&& other) noexcept;
  ~SerialLink();

  /// False once the port was lost; `reopen` then tries again, at most every 0.2 s.
  bool isOpen() const { return descriptor_ >= 0; }
  bool reopen();

  /// Sends text as it is. A port that takes nothing within a millisecond, or is gone, counts as lost.
  void send(std::string_view text);
  /// The next whole line without its end, read until `deadline_s` (on now_s()); none where none came.
  std::optional<std::string_view> line(double deadline_s);
  /// Forgets what came and was not asked for.
  void forget();

 private:
  SerialLink(std::string port, unsigned baud, int descriptor);
  static int openPort(const std::string& port, unsigned baud);
  void close();
  bool fill(double deadline_s);

  std::string port_;
  unsigned baud_ = 0;
  int descriptor_ = -1;
  double lastTry_s_ = 0;
  std::string received_, line_;
};

/// XOR of all bytes, as both line protocols use it.
std::uint8_t xorOf(std::string_view text);

}  // namespace detent::playback
