// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A finger without a sensor: a key or mouse button drives a human-like force profile; a recorded trace is
// played back.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "playback/device/serial_sensor.h"

namespace detent::playback {

/// How a key press becomes force. Press and release follow the minimum-jerk profile of reaching movements
/// (Flash & Hogan, J. Neurosci. 1985); while held, the force carries the 8-12 Hz physiological tremor,
/// without chance: a given sequence of key times gives one sequence of readings.
struct FingerProfile {
  double peak_N = 2;        ///< > 0
  double press_s = 0.08;    ///< time from touch to the full force; > 0
  double release_s = 0.06;  ///< > 0
  double tremorOfForce = 0.01;
  double tremor_Hz = 10;
  double rate_Hz = 1000;  ///< readings per second while a key moves; 100..10000
};

/// Force `t_s` after the key went down, if it stays down; starts from `from_N`.
double pressedForce(const FingerProfile& profile, double from_N, double t_s);
/// Force `t_s` after the key went up.
double releasedForce(const FingerProfile& profile, double from_N, double t_s);

/// A thread that sends readings while a virtual finger presses.
class VirtualFinger {
 public:
  VirtualFinger(const FingerProfile& profile, SerialSensor::Receiver receiver);
  ~VirtualFinger();
  void down();  ///< any thread
  void up();
  /// Full press and release, for terminals that tell no key-up.
  void tap(double hold_s);
  bool isDown() const;
  double force_N() const;

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace detent::playback
