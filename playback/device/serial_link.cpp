// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/serial_link.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "playback/device/port_names.h"
#include "playback/device/raw_port.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double longestWrite_s = 0.001;
constexpr std::size_t longestLine = 250, reserved = 4096;

bool ready(int descriptor, short events, double wait_s) {
  pollfd poll{descriptor, events, 0};
  timespec time{};
  time.tv_sec = static_cast<time_t>(std::max(0.0, wait_s));
  time.tv_nsec = static_cast<long>((std::max(0.0, wait_s) - static_cast<double>(time.tv_sec)) * 1e9);
  return ::ppoll(&poll, 1, &time, nullptr) > 0;
}

}  // namespace

bool SerialLink::openPort() {
  lastTry_s_ = now_s();
  received_.clear();
  descriptor_ = ::open(port_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (!isOpen()) return false;
  if (::isatty(descriptor_) == 0) {
    ::close(std::exchange(descriptor_, -1));
    errno = ENOTTY;
    return false;
  }
  // Two programs on one port would each receive half of the answers, and send conflicting forces.
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    ::close(std::exchange(descriptor_, -1));
    errno = EBUSY;
    return false;
  }
  ::ioctl(descriptor_, TIOCEXCL);
  if (const int error = makeRaw(descriptor_, baud_); error != 0) {
    close();
    errno = error;
    return false;
  }
  return true;
}

Result<SerialLink> SerialLink::open(const std::string& port, unsigned baud, double reopenPause_s) {
  if (baud < slowestBaud || baud > fastestBaud) {
    return Failure{FailureCode::wrongUsage, port, "", Message("a speed of %1 baud is not supported", baud),
                   Message("Give a rate from %1 to %2", slowestBaud, fastestBaud)};
  }
  if (const std::string other = sameSerialNumber(port); !other.empty()) {
    return Failure{
        FailureCode::deviceTrouble, port, "",
        Message("two devices have this name, because their serial numbers are the same; the other one is %1",
                other),
        Message("Unplug one of them, or give a name under /dev/serial/by-path")};
  }
  SerialLink link;
  link.port_ = port;
  link.baud_ = baud;
  link.reopenPause_s_ = reopenPause_s;
  link.received_.reserve(reserved);
  link.line_.reserve(reserved);
  if (link.openPort()) return link;
  if (errno == EBUSY) {
    const std::string holder = holderOf(port);
    return Failure{FailureCode::deviceTrouble, port, "",
                   holder.empty() ? Message("the device is in use by another program")
                                  : Message("the device is in use by %1", holder),
                   Message("End that program, then try again")};
  }
  if (errno == EINVAL) {
    return Failure{FailureCode::deviceTrouble,
                   port,
                   "",
                   Message("the port cannot run at %1 baud", baud),
                   {{RemedyKind::advice, Message("Choose another baud rate, and set it in the firmware too")},
                    {RemedyKind::advice, Message("On the command line: --baud")}}};
  }
  return Failure{FailureCode::deviceTrouble, port, "",
                 Message("the device cannot be opened (%1)", std::strerror(errno)),
                 Message("Check the name, the cable and your permission to use the port (group dialout)")};
}

SerialLink::SerialLink(SerialLink&& other) noexcept { *this = std::move(other); }

SerialLink& SerialLink::operator=(SerialLink&& other) noexcept {
  std::swap(port_, other.port_);
  std::swap(baud_, other.baud_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(reopenPause_s_, other.reopenPause_s_);
  std::swap(lastTry_s_, other.lastTry_s_);
  std::swap(received_, other.received_);
  std::swap(line_, other.line_);
  return *this;
}

void SerialLink::close() {
  if (isOpen()) {
    // otherwise the lock would remain while another process has the port open
    ::ioctl(descriptor_, TIOCNXCL);
    ::close(descriptor_);
  }
  descriptor_ = -1;
  lastTry_s_ = now_s();
}

bool SerialLink::reopen() { return now_s() - lastTry_s_ >= reopenPause_s_ && openPort(); }

void SerialLink::send(std::string_view text) {
  const double deadline_s = now_s() + longestWrite_s;
  while (isOpen() && !text.empty()) {
    const ssize_t sent = ::write(descriptor_, text.data(), text.size());
    if (sent > 0) {
      text.remove_prefix(static_cast<std::size_t>(sent));
    } else if (sent < 0 && errno == EAGAIN && now_s() < deadline_s) {
      ready(descriptor_, POLLOUT, deadline_s - now_s());
    } else if (!(sent < 0 && errno == EINTR)) {
      close();
    }
  }
}

bool SerialLink::fill(double deadline_s) {
  std::array<char, 512> bytes{};
  if (!isOpen() || !ready(descriptor_, POLLIN, deadline_s - now_s())) return false;
  const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
  if (count > 0) {
    received_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) close();
  return isOpen();
}

std::string_view SerialLink::bytes(double deadline_s) {
  received_.clear();
  fill(deadline_s);
  return received_;
}

std::optional<std::string_view> SerialLink::line(double deadline_s) {
  for (;;) {
    const std::size_t end = received_.find('\n');
    if (end != std::string::npos) {
      line_.assign(received_, 0, end);
      received_.erase(0, end + 1);
      while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ')) line_.pop_back();
      return line_;
    }
    // A line without an end is discarded, so that a faulty device cannot fill the memory.
    if (received_.size() > longestLine) received_.clear();
    if (!fill(deadline_s)) return {};
  }
}

void SerialLink::forget() {
  received_.clear();
  while (fill(now_s())) received_.clear();
}

}  // namespace detent::playback
