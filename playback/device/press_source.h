// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A finger without a sensor: a key or mouse button drives a human-like force profile; a recorded trace is
// played back.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "playback/device/serial_sensor.h"
#include "playback/realtime/finger_profile.h"

namespace detent::playback {

/// A thread that sends readings while a virtual finger presses.
class VirtualFinger {
 public:
  VirtualFinger(const FingerProfile& profile, SerialSensor::Receiver receiver);
  ~VirtualFinger();
  void down();  ///< any thread
  void up();
  /// Full press and release, for terminals, which do not report the release of a key.
  void tap(double hold_s);
  bool isDown() const;
  double force_N() const;

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace detent::playback
