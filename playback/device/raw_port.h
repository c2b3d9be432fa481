// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A serial port or pty as bytes at any rate. In a file of its own: the kernel's termios, which knows every
// rate, shares names with the C library's.

namespace detent::playback {

inline constexpr unsigned slowestBaud = 1200, fastestBaud = 4'000'000;

/// Makes an open port raw, 8 bits, no parity, and forgets what waited in it. Returns 0, or an errno: ENOTTY
/// for what is no port, EINVAL where the port cannot run within 2.5 % of this rate.
int makeRaw(int descriptor, unsigned baud);

}  // namespace detent::playback
