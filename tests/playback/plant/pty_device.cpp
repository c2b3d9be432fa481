// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/plant/pty_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

namespace detent::test {
namespace {

double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr double notYet_s = 1e6;

// A device keeps time by itself; where the system grants it, this one does too.
void keepTime() {
  sched_param priority{};
  priority.sched_priority = 85;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

}  // namespace

PtyDevice::PtyDevice(const PtySettings& settings)
    : settings_(settings),
      sceneFrom_s_(settings.sceneWaits ? notYet_s : 0),
      world_(
          settings.handle, settings.finger,
          [this](double time_s) { return settings_.plan(time_s - sceneFrom_s_); }, settings.start_mm),
      chance_(settings.seed) {
  static std::atomic<int> made{0};
  port_ = (std::filesystem::current_path() /
           ("plant-" + std::to_string(::getpid()) + "-" + std::to_string(++made) + ".port"))
              .string();
  plug();
}

PtyDevice::~PtyDevice() {
  halt();
  std::error_code ignored;
  std::filesystem::remove(port_, ignored);
}

void PtyDevice::begin() {
  thread_ = std::thread([this] { run(); });
}

void PtyDevice::halt() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
  unplug();
}

void PtyDevice::beginScene() {
  if (sceneFrom_s_ == notYet_s) sceneFrom_s_ = now_s_ - firstLine_s_;
}

double PtyDevice::largestMotor_N() const {
  double largest_N = 0;
  for (const PtyMoment& moment : moments_) largest_N = std::max(largest_N, std::abs(moment.motor_N));
  return largest_N;
}

void PtyDevice::plug() {
  // Not for the program under test: a master that it holds too would never hang up.
  master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0)
    throw std::runtime_error("no pseudo terminal can be had");
  termios raw{};
  ::tcgetattr(master_, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(master_, TCSANOW, &raw);
  std::error_code ignored;
  std::filesystem::remove(port_, ignored);
  std::filesystem::create_symlink(::ptsname(master_), port_);
}

void PtyDevice::unplug() {
  if (master_ >= 0) ::close(master_);
  master_ = -1;
  std::error_code ignored;
  std::filesystem::remove(port_, ignored);
}

void PtyDevice::answer(std::string line) {
  if (chance_.once(settings_.brokenAnswers) && !line.empty()) {
    char& hit = line[chance_.below(line.size() - 1)];
    hit = hit == '7' ? '4' : '7';
  }
  const double due_s = now_s_ + settings_.replyDelay_s + chance_.between(0, settings_.replyJitter_s);
  waiting_.push_back({waiting_.empty() ? due_s : std::max(due_s, waiting_.back().due_s), std::move(line)});
}

void PtyDevice::read() {
  char bytes[512];
  for (ssize_t got = ::read(master_, bytes, sizeof bytes); got > 0;
       got = ::read(master_, bytes, sizeof bytes)) {
    for (ssize_t i = 0; i < got; ++i) {
      if (bytes[i] != '\n' && bytes[i] != '\r') {
        partial_.push_back(bytes[i]);
        continue;
      }
      if (partial_.empty()) continue;
      if (firstLine_s_ < 0) firstLine_s_ = now_s_;
      heard_.push_back(partial_);
      hear(partial_);
      partial_.clear();
    }
  }
}

void PtyDevice::move() {
  if (firstLine_s_ < 0) return;
  while (world_.time_s() < now_s_ - firstLine_s_) {
    world_.advance(command_N());
    if (world_.time_s() < nextMoment_s_) continue;
    nextMoment_s_ += 0.001;
    moments_.push_back({world_.time_s() - sceneFrom_s_, world_.position_mm(), world_.motorForce_N(),
                        world_.fingerForce_N()});
  }
}

void PtyDevice::events() {
  const double since_s = scene_s();
  if (since_s < 0) return;
  if (settings_.resetAt_s >= 0 && since_s >= settings_.resetAt_s && !resetDone_) {
    resetDone_ = true;
    waiting_.clear();
    reset();
  }
  if (settings_.unplugAt_s >= 0 && since_s >= settings_.unplugAt_s && !unplugDone_) {
    unplugDone_ = true;
    unplugged_s_ = now_s_;
    waiting_.clear();
    unplug();
  }
  if (master_ < 0 && settings_.pluggedAgain_s > 0 && now_s_ - unplugged_s_ >= settings_.pluggedAgain_s)
    plug();
}

void PtyDevice::run() {
  keepTime();
  const double start_s = clock_s();
  while (!ending_) {
    now_s_ = clock_s() - start_s;
    move();
    events();
    if (master_ >= 0) read();
    while (!waiting_.empty() && waiting_.front().due_s <= now_s_) {
      if (master_ >= 0 && ::write(master_, waiting_.front().text.data(), waiting_.front().text.size()) < 0)
        break;
      waiting_.pop_front();
    }
    double sleep_s = waiting_.empty() ? 0.001 : std::clamp(waiting_.front().due_s - now_s_, 0.0, 0.001);
    timespec wait{0, static_cast<long>(sleep_s * 1e9)};
    pollfd watched{master_, POLLIN, 0};
    // Without a partner a pty reports a hang-up at once, and for ever: sleep instead.
    if (master_ >= 0 && ::ppoll(&watched, 1, &wait, nullptr) > 0 && (watched.revents & POLLIN) == 0) {
      timespec moment{0, 500000};
      ::nanosleep(&moment, nullptr);
    } else if (master_ < 0) {
      ::nanosleep(&wait, nullptr);
    }
  }
}

}  // namespace detent::test
