// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/own_delay.h"

#include <array>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "playback/device/round_trips.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

/// Both ends of a raw pseudo terminal.
class OwnTerminal {
 public:
  OwnTerminal() : near_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    std::array<char, 64> name{};
    if (near_ < 0 || ::grantpt(near_) != 0 || ::unlockpt(near_) != 0 ||
        ::ptsname_r(near_, name.data(), name.size()) != 0)
      return;
    far_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    termios mode{};
    if (far_ < 0 || ::tcgetattr(far_, &mode) != 0) return;
    ::cfmakeraw(&mode);
    ::tcsetattr(far_, TCSANOW, &mode);
  }
  ~OwnTerminal() {
    if (far_ >= 0) ::close(far_);
    if (near_ >= 0) ::close(near_);
  }
  OwnTerminal(const OwnTerminal&) = delete;
  OwnTerminal& operator=(const OwnTerminal&) = delete;

  /// Sends a line and waits until it has arrived at the other end.
  bool passesLine() const {
    constexpr std::array<char, 8> line{'P', ',', '1', ',', '2', ',', '3', '\n'};
    constexpr int longest_ms = static_cast<int>(1000 * slowestRoundTrip_s);
    if (far_ < 0 || ::write(near_, line.data(), line.size()) < 0) return false;
    pollfd poll{far_, POLLIN, 0};
    std::array<char, 64> come{};
    return ::poll(&poll, 1, longest_ms) > 0 && ::read(far_, come.data(), come.size()) > 0;
  }

 private:
  int near_, far_ = -1;
};

constexpr double pause_s =
    0.0005;  // about a device's response time, so that the computer does other work meanwhile

}  // namespace

double ownTerminalDelay_s() {
  const OwnTerminal terminal;
  RoundTrips trips;
  while (trips.goOn()) {
    sleepUntil(now_s() + pause_s);
    const double from_s = now_s();
    if (!terminal.passesLine()) return 0;
    trips.add(now_s() - from_s);
  }
  return trips.usual_s();
}

}  // namespace detent::playback
