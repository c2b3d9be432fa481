// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/plant/odrive_emulator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace detent::test {
namespace {

constexpr unsigned encoderFailed = 0x100, controllerFailed = 0x200, watchdogError = 0x800;
constexpr int idle = 1, closedLoop = 8;

}  // namespace

OdriveEmulator::OdriveEmulator(const OdriveEmulatorSettings& settings)
    : PtyDevice(settings.pty), settings_(settings) {
  defaults();
  error_ = settings.errorAtStart;
  begin();
}

void OdriveEmulator::defaults() {
  properties_ = {{"vbus_voltage", 24},
                 {"axis0.error", 0},
                 {"axis0.motor.error", 0},
                 {"axis0.encoder.error", 0},
                 {"axis0.controller.error", 0},
                 {"axis0.requested_state", 0},
                 {"axis0.current_state", idle},
                 {"axis0.config.enable_watchdog", 0},
                 {"axis0.config.watchdog_timeout", 0},
                 {"axis0.motor.config.torque_lim", 1e9},
                 {"axis0.motor.config.torque_constant", 0.04},
                 {"axis0.motor.config.current_lim", 10},
                 {"axis0.motor.is_calibrated", 1},
                 {"axis0.motor.is_armed", 0},
                 {"axis0.encoder.is_ready", 1},
                 {"axis0.encoder.pos_estimate", 0},
                 {"axis0.encoder.vel_estimate", 0},
                 {"axis0.controller.input_torque", 0},
                 {"axis0.controller.config.control_mode", 3},
                 {"axis0.controller.config.input_mode", 1},
                 {"axis0.controller.config.vel_limit", settings_.velocityLimit},
                 {"axis0.controller.config.vel_limit_tolerance", 1.2},
                 {"axis0.controller.config.vel_gain", 1.0 / 6},
                 {"axis0.controller.config.enable_torque_mode_vel_limit", 1},
                 {"axis0.controller.config.enable_overspeed_error", 1}};
  armed_ = false;
  torque_Nm_ = 0;
}

double OdriveEmulator::property(const std::string& name) const {
  const auto found = properties_.find(name);
  return found == properties_.end() ? std::nan("") : found->second;
}

// A torque that turns forwards drives the handle in, so it is negative against pressing.
double OdriveEmulator::forceOf_N(double torque_Nm) const {
  return -torque_Nm * 2 * std::numbers::pi * 1000 / settings_.mmPerTurn;
}

double OdriveEmulator::torqueLimit_N() const {
  return std::abs(forceOf_N(std::min(settings_.largestTorque_Nm, property("axis0.motor.config.torque_lim"))));
}

double OdriveEmulator::velocityLimit_mm_per_s() const {
  const std::string config = "axis0.controller.config.";
  const bool limits = property(config + "enable_torque_mode_vel_limit") != 0 ||
                      property(config + "enable_overspeed_error") != 0;
  return limits ? property(config + "vel_limit") * settings_.mmPerTurn : 1e9;
}

void OdriveEmulator::say(const std::string& text, bool checksum) {
  if (!checksum) return answer(text + "\r\n");
  unsigned sum = 0;
  for (const char c : text) sum ^= static_cast<unsigned char>(c);
  answer(text + "*" + std::to_string(sum) + "\r\n");
}

void OdriveEmulator::fail(unsigned error) {
  error_ |= error;
  armed_ = false;
}

void OdriveEmulator::request(int state) {
  if (state == closedLoop && error_ == 0) {
    armed_ = everArmed_ = true;
  } else {
    armed_ = false;
  }
}

void OdriveEmulator::write(const std::string& name, double value) {
  if (name == "axis0.config.enable_watchdog" && value != 0 && properties_[name] == 0) fed_s_ = now_s();
  properties_[name] = value;
  if (name == "axis0.requested_state") request(static_cast<int>(value));
  if (name == "axis0.error" && value == 0) error_ = 0;
  if (name == "axis0.controller.input_torque") torque_Nm_ = value;
  if (!armed_) return;
  armedTorqueLimit_N_ = std::max(armedTorqueLimit_N_, torqueLimit_N());
  armedVelocityLimit_mm_per_s_ = std::min(armedVelocityLimit_mm_per_s_, velocityLimit_mm_per_s());
}

void OdriveEmulator::watch() {
  if (properties_["axis0.config.enable_watchdog"] == 0) return;
  if (now_s() - fed_s_ <= properties_["axis0.config.watchdog_timeout"]) return;
  if (armed_) watchdogExpired_ = true;
  fail(watchdogError);
}

void OdriveEmulator::hear(const std::string& received) {
  if (firstHeard_s_ < 0) firstHeard_s_ = now_s();
  std::string line = received.substr(0, received.find(';'));
  const std::size_t star = line.find('*');
  const bool checksum = star != std::string::npos;
  if (checksum) {
    unsigned sum = 0, stated = 0;
    for (std::size_t i = 0; i < star; ++i) sum ^= static_cast<unsigned char>(line[i]);
    if (std::sscanf(line.c_str() + star + 1, "%u", &stated) != 1 || stated != sum) return;
    line.resize(star);
  }
  watch();
  unsigned axis = 0;
  double value = 0;
  char name[256], text[256];
  if (std::sscanf(line.c_str(), "r %255s", name) == 1) {
    properties_["axis0.error"] = error_;
    properties_["axis0.current_state"] = armed_ ? closedLoop : idle;
    properties_["axis0.motor.is_armed"] = armed_;
    const auto found = properties_.find(name);
    if (found == properties_.end()) return say("invalid property", checksum);
    char shown[32];
    std::snprintf(shown, sizeof shown, "%.9g", found->second);
    say(shown, checksum);
  } else if (std::sscanf(line.c_str(), "w %255s %255s", name, text) == 2) {
    if (properties_.count(name) == 0) return say("invalid property", checksum);
    write(name, std::strtod(text, nullptr));
  } else if (std::sscanf(line.c_str(), "c %u %lf", &axis, &value) == 2) {
    if (axis > 1) return say("invalid motor " + std::to_string(axis), checksum);
    if (axis == 1) return;
    properties_["axis0.controller.config.control_mode"] = 1;
    torque_Nm_ = value;
    fed_s_ = now_s();
  } else if (std::sscanf(line.c_str(), "u %u", &axis) == 1) {
    if (axis == 0) fed_s_ = now_s();
  } else if (std::sscanf(line.c_str(), "f %u", &axis) == 1) {
    const double turns = settings_.restTurns + (truePosition_mm() - resetAt_mm_) / settings_.mmPerTurn;
    std::snprintf(text, sizeof text, "%f %f", turns, trueSpeed_mm_per_s() / settings_.mmPerTurn);
    say(text, checksum);
  } else if (line.starts_with("sc")) {
    error_ = 0;
    fed_s_ = now_s();
  } else if (line.starts_with("sr")) {
    reset();
  } else if (!line.empty()) {
    say("unknown command", checksum);
  }
}

double OdriveEmulator::command_N() {
  watch();
  if (settings_.errorAt_s >= 0 && firstHeard_s_ >= 0 && now_s() - firstHeard_s_ > settings_.errorAt_s) {
    settings_.errorAt_s = -1;
    fail(encoderFailed);
  }
  if (!armed_) return 0;
  const double speed = trueSpeed_mm_per_s() / settings_.mmPerTurn;
  const double limit = properties_["axis0.controller.config.vel_limit"];
  if (properties_["axis0.controller.config.enable_overspeed_error"] != 0 &&
      std::abs(speed) > limit * properties_["axis0.controller.config.vel_limit_tolerance"]) {
    fail(controllerFailed);
    return 0;
  }
  double torque_Nm = properties_["axis0.controller.config.control_mode"] == 1 ? torque_Nm_ : 0;
  if (properties_["axis0.controller.config.enable_torque_mode_vel_limit"] != 0) {
    const double gain = properties_["axis0.controller.config.vel_gain"];
    torque_Nm = std::clamp(torque_Nm, (-limit - speed) * gain, (limit - speed) * gain);
  }
  const double most_Nm = std::min(settings_.largestTorque_Nm, properties_["axis0.motor.config.torque_lim"]);
  return forceOf_N(std::clamp(torque_Nm, -most_Nm, most_Nm));
}

// Restarts: unsaved settings are lost, and the encoder counts from its present position.
void OdriveEmulator::reset() {
  resetAt_mm_ = truePosition_mm();
  error_ = 0;
  defaults();
}

}  // namespace detent::test
