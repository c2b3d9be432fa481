// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The program that holds a serial port, and devices that share the name of a port.

#include <filesystem>
#include <string>

namespace detent::playback {

/// Program that has a port open, as "detent-play (process 4711)"; empty where that cannot be seen.
std::string holderOf(const std::string& port);

/// Names under /dev/serial/by-id are made of serial numbers. For such a name the other connected port whose
/// device has the same number, as /dev/ttyACM1; empty where there is none. `ttys`: where the system lists its
/// ports.
std::string sameSerialNumber(const std::filesystem::path& port,
                             const std::filesystem::path& ttys = "/sys/class/tty");

}  // namespace detent::playback
