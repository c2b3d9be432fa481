// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/terminal.h"

#include <atomic>
#include <cmath>
#include <ctime>

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

termios savedMode{};
std::atomic<bool> modeSaved{false};

}  // namespace

void restoreTerminal() {
  if (modeSaved.exchange(false)) ::tcsetattr(STDIN_FILENO, TCSANOW, &savedMode);
}

RawTerminal::RawTerminal() {
  if (::isatty(STDIN_FILENO) == 0 || ::tcgetattr(STDIN_FILENO, &savedMode) != 0) return;
  termios raw = savedMode;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  interactive_ = ::tcsetattr(STDIN_FILENO, TCSANOW, &raw) == 0;
  modeSaved = interactive_;
}

RawTerminal::~RawTerminal() { restoreTerminal(); }

std::optional<char> RawTerminal::key(double timeout_s) {
  if (!interactive_) {
    sleepUntil(now_s() + timeout_s);
    return {};
  }
  pollfd input{STDIN_FILENO, POLLIN, 0};
  timespec timeout{};
  timeout.tv_sec = static_cast<std::time_t>(timeout_s);
  timeout.tv_nsec = static_cast<long>(1e9 * (timeout_s - std::floor(timeout_s)));
  if (::ppoll(&input, 1, &timeout, nullptr) <= 0) return {};
  char key = 0;
  if (::read(STDIN_FILENO, &key, 1) == 1) return key;
  sleepUntil(now_s() + timeout_s);  // at the end of input, avoids a busy loop
  return {};
}

int terminalColumns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

bool errorIsTerminal() { return ::isatty(STDERR_FILENO) != 0; }

}  // namespace detent::playback
