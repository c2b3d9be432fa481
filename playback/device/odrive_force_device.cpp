// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/odrive_force_device.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>
#include <utility>

#include "playback/device/sensor_line.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double answer_s = 0.3, waitOfPeriod = 0.5, mmPerM = 1000;
constexpr int tries = 5;
constexpr int torqueControl = 1, closedLoop = 8, idle = 1;  // CONTROL_MODE_TORQUE_CONTROL, AXIS_STATE_...

/// "c 0 0.0125 *57\n": the checksum is decimal, over everything before the star.
std::string odriveLine(const std::string& command) {
  const std::string body = command + " ";
  return body + "*" + std::to_string(lineChecksum(body)) + "\n";
}

/// "1.25 -0.5", with or without a checksum: position and velocity in turns.
std::optional<double> positionIn(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star != std::string_view::npos) {
    unsigned sum = 0;
    const auto [end, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), sum);
    if (error != std::errc() || end != line.data() + line.size() || sum != lineChecksum(line.substr(0, star)))
      return {};
    line = line.substr(0, star);
  }
  double position = 0, velocity = 0;
  const char* last = line.data() + line.size();
  const auto first = std::from_chars(line.data(), last, position);
  if (first.ec != std::errc() || first.ptr == last || *first.ptr != ' ') return {};
  const auto second = std::from_chars(first.ptr + 1, last, velocity);
  if (second.ec != std::errc()) return {};
  for (const char* p = second.ptr; p != last; ++p) {
    if (*p != ' ') return {};
  }
  return position;
}

}  // namespace

Result<std::unique_ptr<OdriveForceDevice>> OdriveForceDevice::open(const OdriveSettings& settings) {
  if (settings.axis > 1 || settings.mmPerTurn == 0 || !std::isfinite(settings.mmPerTurn)) {
    return Failure{FailureCode::wrongUsage, settings.port, "", "axis or travel per turn mean nothing",
                   "Give axis 0 or 1 and a travel that is not 0"};
  }
  Result<SerialLink> link = SerialLink::open(settings.port, settings.baud);
  if (!link) return link.failure();
  std::unique_ptr<OdriveForceDevice> device(new OdriveForceDevice(std::move(*link), settings));
  device->configure();
  for (int i = 0; i < tries; ++i) {
    if (const std::optional<double> turns = device->feedback_turns(now_s() + answer_s)) {
      device->rest_turns_ = *turns;
      return device;
    }
  }
  return Failure{FailureCode::deviceTrouble, settings.port, "",
                 "no ODrive answers on axis " + std::to_string(settings.axis),
                 "Check power, cable and axis, and that the ASCII protocol is on (docs/force-feedback.md)"};
}

void OdriveForceDevice::configure() {
  const std::string axis = "axis" + std::to_string(settings_.axis);
  const auto write = [&](const std::string& property, const std::string& value) {
    link_.send(odriveLine("w " + axis + "." + property + " " + value));
  };
  link_.forget();
  write("controller.config.control_mode", std::to_string(torqueControl));
  write("config.watchdog_timeout", std::to_string(settings_.watchdog_s));
  write("config.enable_watchdog", "1");
  write("requested_state", std::to_string(closedLoop));
}

std::optional<double> OdriveForceDevice::feedback_turns(double deadline_s) {
  link_.send(odriveLine("f " + std::to_string(settings_.axis)));
  for (;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return {};
    if (const std::optional<double> position = positionIn(*line)) return position;
    ++counts_.malformed;
  }
}

ForceReading OdriveForceDevice::exchange(const ForceCommand& command) {
  ForceReading reading;
  reading.position_mm = last_mm_;
  reading.fresh = false;
  ++counts_.exchanges;
  if (!link_.isOpen()) {
    if (link_.reopen()) {
      ++counts_.reconnects;
      configure();
    }
    return reading;
  }
  // An answer of the period before, come late, would be taken for this one's.
  link_.forget();
  const double torque_Nm = -command.force_N * settings_.mmPerTurn / (2 * std::numbers::pi * mmPerM);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "c %u %.6f", settings_.axis, torque_Nm);
  link_.send(odriveLine(text.data()));
  const std::optional<double> turns = feedback_turns(now_s() + waitOfPeriod * settings_.period_s);
  if (!turns) {
    ++counts_.late;
    return reading;
  }
  reading.position_mm = last_mm_ = (*turns - rest_turns_) * settings_.mmPerTurn;
  reading.fresh = true;
  return reading;
}

OdriveForceDevice::~OdriveForceDevice() {
  link_.send(odriveLine("c " + std::to_string(settings_.axis) + " 0"));
  link_.send(
      odriveLine("w axis" + std::to_string(settings_.axis) + ".requested_state " + std::to_string(idle)));
}

}  // namespace detent::playback
