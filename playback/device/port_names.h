// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The program that holds a serial port, and devices that share the name of a port.

#include <filesystem>
#include <string>

namespace detent::playback {

/// Program that has a port open, as "detent-play (process 4711)"; empty if that is not visible.
std::string holderOf(const std::string& port);

/// Names under /dev/serial/by-id contain serial numbers. For such a name, returns another connected port
/// whose device has the same number, as /dev/ttyACM1; empty if there is none. `ttys`: the folder in which the
/// system lists its ports.
std::string sameSerialNumber(const std::filesystem::path& port,
                             const std::filesystem::path& ttys = "/sys/class/tty");

}  // namespace detent::playback
