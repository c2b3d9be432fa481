// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/device/pty_sensor.h"

#include <atomic>

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

namespace detent::test {

PtySensor::PtySensor() {
  static std::atomic<int> sensors{0};
  link_ = "/tmp/detent-sensor-" + std::to_string(::getpid()) + "-" + std::to_string(sensors++);
  plugIn();
}

PtySensor::~PtySensor() { unplug(); }

void PtySensor::plugIn() {
  master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) {
    unplug();
    return;
  }
  // Without raw mode the line discipline would echo and buffer.
  termios mode{};
  ::tcgetattr(master_, &mode);
  ::cfmakeraw(&mode);
  ::tcsetattr(master_, TCSANOW, &mode);
  ::unlink(link_.c_str());
  if (::symlink(::ptsname(master_), link_.c_str()) != 0) unplug();
}

void PtySensor::unplug() {
  if (master_ >= 0) ::close(master_);
  master_ = -1;
  ::unlink(link_.c_str());
}

bool PtySensor::send(std::string_view bytes) {
  return ::write(master_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

}  // namespace detent::test
