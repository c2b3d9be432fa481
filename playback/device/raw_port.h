// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A serial port or pty as bytes at any rate. In a separate file because the kernel's termios, which supports
// every rate, has names in common with the C library's.

namespace detent::playback {

inline constexpr unsigned slowestBaud = 1200, fastestBaud = 4'000'000;

/// Sets an open port to raw bytes, 8 bits, no parity, and discards waiting input. Returns 0 or an errno:
/// ENOTTY if it is no port, EINVAL if the port cannot run within 2.5 % of this rate.
int makeRaw(int descriptor, unsigned baud);

}  // namespace detent::playback
