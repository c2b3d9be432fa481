// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/plant/pty_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <pty.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

namespace detent::test {
namespace {

double clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr double notYet_s = 1e6;
// Longest sleep: the loop of a punctual device is well within the wait of a program at 1 kHz.
constexpr double sleep_s = 0.0004;
// The program takes an answer as missing after this share of its period (answerWaitOfPeriod in
// playback/device/round_trips.h). A question waits at most as long as the device's loop takes; and the
// kernel passes it on when it finds time, which a byte through a port of the device's own shows.
constexpr double awaitedOfPeriod = 0.85;
// This many missing answers in a row are bridged (heldReadings in playback/realtime/force_program.h). A
// punctual answer between late ones does not make the force rise at once.
constexpr int harmless = 3, row_periods = 2 * (harmless + 1);
// As many of 40 answers may be slow without effect on the delay of the link, which the program measures for
// up to 0.2 s after the greeting (RoundTrips::usual_s).
constexpr int measured_periods = 40;
constexpr double measuredUntil_s = 0.25;

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
  termios raw{};
  ::cfmakeraw(&raw);
  if (::openpty(&witness_[0], &witness_[1], nullptr, &raw, nullptr) != 0)
    throw std::runtime_error("no pseudo terminal can be had");
  ::fcntl(witness_[0], F_SETFL, O_NONBLOCK);
  for (const int end : witness_) ::fcntl(end, F_SETFD, FD_CLOEXEC);
}

PtyDevice::~PtyDevice() {
  halt();
  for (const int end : witness_) ::close(end);
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

void PtyDevice::watch(double loop_s) {
  char byte = '.';
  if (sent_s_ >= 0 && ::read(witness_[0], &byte, 1) == 1) {
    loop_s = std::max(loop_s, now_s_ - sent_s_);
    sent_s_ = -1;
  }
  if (sent_s_ < 0 && ::write(witness_[1], &byte, 1) == 1) sent_s_ = now_s_;
  if (firstLine_s_ < 0 || loop_s <= awaitedOfPeriod * settings_.period_s) return;
  const int periods = static_cast<int>(std::ceil(loop_s / settings_.period_s));
  late_.push_back({now_s_, periods});
  const auto within = [&](int window_periods) {
    return std::accumulate(late_.begin(), late_.end(), 0, [&](int sum, const Late& late) {
      return sum + (now_s_ - late.at_s < window_periods * settings_.period_s ? late.periods : 0);
    });
  };
  while (now_s_ - late_.front().at_s >= measured_periods * settings_.period_s) late_.pop_front();
  const bool measured = now_s_ - firstLine_s_ < measuredUntil_s;
  if (within(measured ? measured_periods : row_periods) > harmless) punctual_ = false;
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
    const double before_s = std::exchange(now_s_, clock_s() - start_s);
    watch(now_s_ - before_s);
    move();
    events();
    if (master_ >= 0) read();
    while (!waiting_.empty() && waiting_.front().due_s <= now_s_) {
      if (master_ >= 0 && ::write(master_, waiting_.front().text.data(), waiting_.front().text.size()) < 0)
        break;
      waiting_.pop_front();
    }
    const double left_s =
        waiting_.empty() ? sleep_s : std::clamp(waiting_.front().due_s - now_s_, 0.0, sleep_s);
    timespec wait{0, static_cast<long>(left_s * 1e9)};
    pollfd watched{master_, POLLIN, 0};
    // Without a partner a pty reports a hang-up at once, and for ever: sleep instead.
    if (master_ >= 0 && ::ppoll(&watched, 1, &wait, nullptr) > 0 && (watched.revents & POLLIN) == 0) {
      timespec moment{0, static_cast<long>(sleep_s * 1e9)};
      ::nanosleep(&moment, nullptr);
    } else if (master_ < 0) {
      ::nanosleep(&wait, nullptr);
    }
  }
}

}  // namespace detent::test
