// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/press_source.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "playback/device/steady_clock.h"
#include "playback/realtime/finger_profile.h"

namespace detent::playback {

namespace {

constexpr int fingerPriority = 55;

}  // namespace

class VirtualFinger::Worker {
 public:
  Worker(const FingerProfile& profile, SerialSensor::Receiver receiver)
      : profile_(profile), receiver_(std::move(receiver)), thread_([this] { run(); }) {}
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }

  void set(bool down, double upAt_s) {
    {
      const std::lock_guard lock(mutex_);
      upAt_s_ = upAt_s;
      if (down != down_) {
        down_ = down;
        movedAt_s_ = now_s();
        from_N_ = force_N_;
      }
    }
    wake_.notify_all();
  }

  bool isDown() const {
    const std::lock_guard lock(mutex_);
    return down_;
  }
  double force_N() const { return force_N_; }

 private:
  void run() {
    requestRealtime(fingerPriority);
    double next_s = now_s();
    bool fresh = true;
    std::unique_lock lock(mutex_);
    while (!stopping_) {
      const double time_s = now_s();
      if (down_ && upAt_s_ > 0 && time_s >= upAt_s_) {
        down_ = false;
        movedAt_s_ = time_s;
        from_N_ = force_N_;
      }
      const bool resting = !down_ && time_s - movedAt_s_ > profile_.release_s && force_N_ == 0;
      if (resting && !fresh) {
        wake_.wait(lock);
        next_s = now_s();
        continue;
      }
      force_N_ = down_ ? pressedForce(profile_, from_N_, time_s - movedAt_s_)
                       : releasedForce(profile_, from_N_, time_s - movedAt_s_);
      SensorReading reading{time_s, force_N_, force_N_, fresh};
      fresh = false;
      lock.unlock();
      receiver_(reading);
      next_s += 1 / profile_.rate_Hz;
      if (next_s < now_s()) next_s = now_s();
      sleepUntil(next_s);
      lock.lock();
    }
  }

  FingerProfile profile_;
  SerialSensor::Receiver receiver_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false, down_ = false;
  double movedAt_s_ = 0, upAt_s_ = 0, from_N_ = 0;
  std::atomic<double> force_N_{0};
  std::thread thread_;
};

VirtualFinger::VirtualFinger(const FingerProfile& profile, SerialSensor::Receiver receiver)
    : worker_(std::make_unique<Worker>(profile, std::move(receiver))) {}
VirtualFinger::~VirtualFinger() = default;
void VirtualFinger::down() { worker_->set(true, 0); }
void VirtualFinger::up() { worker_->set(false, 0); }
void VirtualFinger::tap(double hold_s) { worker_->set(true, now_s() + hold_s); }
bool VirtualFinger::isDown() const { return worker_->isDown(); }
double VirtualFinger::force_N() const { return worker_->force_N(); }

}  // namespace detent::playback
