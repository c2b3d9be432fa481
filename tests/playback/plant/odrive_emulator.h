// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An ODrive as its public firmware 0.5 behaves on the ASCII protocol (odriverobotics/ODrive,
// Firmware/communication/ascii_protocol.cpp, MotorControl/axis.cpp and controller.cpp): only c, p, v and u
// feed the watchdog; properties are not answered when they are written; an axis with an error does not arm;
// sc clears errors. In torque control a velocity limit of the firmware's own is on by default: it brakes
// above vel_limit and takes the axis off above 1.2 times of it.

#include <map>
#include <string>

#include "tests/playback/plant/pty_device.h"

namespace detent::test {

struct OdriveEmulatorSettings {
  PtySettings pty;
  double mmPerTurn = 60;
  double restTurns = 0.37;        ///< encoder turns at the handle's 0
  unsigned errorAtStart = 0;      ///< error of the axis at the start; 0x200: controller failed
  double errorAt_s = -1;          ///< an encoder fails (0x100) so long after the first line; < 0: never
  double velocityLimit = 1e9;     ///< turns/s; the firmware's default is 2
  double largestTorque_Nm = 0.2;  ///< limit of motor and supply
};

class OdriveEmulator : public PtyDevice {
 public:
  explicit OdriveEmulator(const OdriveEmulatorSettings& settings);
  ~OdriveEmulator() override { halt(); }

  bool watchdogExpired() const { return watchdogExpired_; }
  bool everArmed() const { return everArmed_; }
  /// Largest force that its own limits let through (N), and the lowest speed at which it interferes, at any
  /// time while the axis was armed: before and after, its settings are its owner's.
  double armedTorqueLimit_N() const { return armedTorqueLimit_N_; }
  double armedVelocityLimit_mm_per_s() const { return armedVelocityLimit_mm_per_s_; }
  double property(const std::string& name) const;

 private:
  void hear(const std::string& line) override;
  double command_N() override;
  void reset() override;
  void say(const std::string& text, bool checksum);
  void defaults();
  void write(const std::string& name, double value);
  void request(int state);
  void fail(unsigned error);
  void watch();
  double torqueLimit_N() const;
  double velocityLimit_mm_per_s() const;
  double forceOf_N(double torque_Nm) const;

  OdriveEmulatorSettings settings_;
  std::map<std::string, double> properties_;
  unsigned error_ = 0;
  bool armed_ = false, watchdogExpired_ = false, everArmed_ = false;
  double armedTorqueLimit_N_ = 0, armedVelocityLimit_mm_per_s_ = 1e9;
  double fed_s_ = 0, torque_Nm_ = 0, resetAt_mm_ = 0, firstHeard_s_ = -1;
};

}  // namespace detent::test
