// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/signal_watch.h"

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include "playback/device/steady_clock.h"
#include "playback/device/terminal.h"

namespace detent::playback {

namespace {

constexpr int exitCodeOfSignals = 128;

sigset_t endingSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) sigaddset(&set, number);
  return set;
}

std::mutex emergencyMutex;
std::function<void()> emergencyDeed;

bool emergency() {
  const std::lock_guard lock(emergencyMutex);
  if (emergencyDeed) emergencyDeed();
  return static_cast<bool>(emergencyDeed);
}

}  // namespace

void setEmergencyDeed(std::function<void()> deed) {
  const std::lock_guard lock(emergencyMutex);
  emergencyDeed = std::move(deed);
}

class SignalWatch::Listener {
 public:
  Listener(double grace_s, void (*lastDeed)())
      : set_(endingSignals()), grace_s_(grace_s), lastDeed_(lastDeed) {
    ::pthread_sigmask(SIG_BLOCK, &set_, &before_);
    thread_ = std::thread([this] { listen(); });
  }
  ~Listener() {
    ended_ = true;
    // The signal is blocked in that thread, where `sigwait` takes it.
    ::pthread_kill(thread_.native_handle(), SIGTERM);  // NOLINT(bugprone-bad-signal-to-kill-thread)
    thread_.join();
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

  bool seen() const { return seen_; }

 private:
  void listen() {
    int number = 0;
    do {
      ::sigwait(&set_, &number);
      if (ended_) return;
    } while (emergency() && number == SIGUSR1);
    seen_ = true;
    const double deadline_s = now_s() + grace_s_;
    while (!ended_) {
      const double left_s = deadline_s - now_s();
      if (left_s <= 0) endByForce(number);
      timespec wait{};
      wait.tv_nsec = static_cast<long>(1e9 * left_s);
      ::sigtimedwait(&set_, nullptr, &wait);  // another signal, or that of the destructor
    }
  }

  [[noreturn]] void endByForce(int number) const {
    lastDeed_();
    restoreTerminal();
    ::_exit(exitCodeOfSignals + number);
  }

  sigset_t set_, before_{};
  const double grace_s_;
  void (*const lastDeed_)();
  std::atomic<bool> seen_{false}, ended_{false};
  std::thread thread_;
};

SignalWatch::SignalWatch(double grace_s, void (*lastDeed)())
    : listener_(std::make_unique<Listener>(grace_s, lastDeed)) {}
SignalWatch::~SignalWatch() = default;
bool SignalWatch::seen() const { return listener_->seen(); }

}  // namespace detent::playback
