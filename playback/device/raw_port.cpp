// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/raw_port.h"

#include <cerrno>
#include <cmath>

#include <linux/termios.h>

// <sys/ioctl.h> and <linux/termios.h> define the same structures.
extern "C" int ioctl(int descriptor, unsigned long request, ...) noexcept;

namespace detent::playback {

namespace {

// With a larger deviation a UART samples the last bits of a byte wrongly.
constexpr double mostOff = 0.025;

}  // namespace

int makeRaw(int descriptor, unsigned baud) {
  termios2 mode{};
  if (::ioctl(descriptor, TCGETS2, &mode) != 0) return ENOTTY;
  mode.c_iflag &= ~static_cast<tcflag_t>(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON);
  mode.c_oflag &= ~static_cast<tcflag_t>(OPOST);
  mode.c_lflag &= ~static_cast<tcflag_t>(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
  mode.c_cflag &= ~static_cast<tcflag_t>(CSIZE | PARENB | CBAUD | (CBAUD << IBSHIFT));
  mode.c_cflag |= static_cast<tcflag_t>(CS8 | CLOCAL | CREAD | BOTHER | (BOTHER << IBSHIFT));
  mode.c_ispeed = mode.c_ospeed = baud;
  if (::ioctl(descriptor, TCSETS2, &mode) != 0 || ::ioctl(descriptor, TCGETS2, &mode) != 0) return EINVAL;
  if (std::abs(static_cast<double>(mode.c_ospeed) - baud) > mostOff * baud) return EINVAL;
  ::ioctl(descriptor, TCFLSH, TCIOFLUSH);  // waiting input is outdated
  return 0;
}

}  // namespace detent::playback
