// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/odrive_force_device.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "playback/device/round_trips.h"
#include "playback/device/sensor_line.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double odriveAnswer_s = 0.3, mmPerM = 1000;
constexpr double arming_s = 1, rearming_s = 0.15, shortAnswer_s = 0.02;
constexpr double velocityRoom = 1.25;  // of the firmware's velocity limit above the engine's
constexpr double stateAsked_s = 0.02;  // between two looks at the axis's state
constexpr double feedEvery_s = 0.015;  // well within the watchdog
constexpr int tries = 5;
constexpr int torqueControl = 1, closedLoop = 8, idle = 1;  // CONTROL_MODE_TORQUE_CONTROL, AXIS_STATE_...

/// The text before a good checksum, or all of one that carries none; none where the checksum is wrong.
std::optional<std::string_view> payloadOf(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return line;
  unsigned sum = 0;
  const auto [end, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), sum);
  if (error != std::errc() || end != line.data() + line.size() || sum != lineChecksum(line.substr(0, star)))
    return {};
  return line.substr(0, star);
}

/// One number and nothing else: what a question about a property gives.
std::optional<double> numberIn(std::string_view line) {
  double value = 0;
  const char* last = line.data() + line.size();
  const auto [end, error] = std::from_chars(line.data(), last, value);
  if (error != std::errc()) return {};
  for (const char* p = end; p != last; ++p) {
    if (*p != ' ') return {};
  }
  return value;
}

/// "1.25 -0.5", with or without a checksum: position and velocity in turns.
std::optional<double> positionIn(std::string_view line) {
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
    return Failure{FailureCode::wrongUsage, settings.port, "",
                   Message("axis or travel per turn mean nothing"),
                   Message("Give axis 0 or 1 and a travel that is not 0")};
  }
  Result<SerialLink> link = SerialLink::open(settings.port, settings.baud);
  if (!link) return link.failure();
  std::unique_ptr<OdriveForceDevice> device(new OdriveForceDevice(*std::move(link), settings));
  device->link_.forget();
  std::optional<double> turns;
  for (int i = 0; i < tries && !turns; ++i) turns = device->feedback_turns(now_s() + odriveAnswer_s);
  if (!turns) {
    return Failure{
        FailureCode::deviceTrouble, settings.port, "", Message("no ODrive answers on axis %1", settings.axis),
        Message(
            "Check power, cable and axis, and that the ASCII protocol is on (docs/guide/force-feedback.md)")};
  }
  if (!device->arm(arming_s)) {
    return Failure{
        FailureCode::deviceTrouble, settings.port, "",
        Message("axis %1 does not arm: %2", settings.axis, odriveErrorWords(device->counts_.fault)),
        Message("Mend that with odrivetool (dump_errors), until closed-loop control runs")};
  }
  return device;
}

Message odriveErrorWords(std::uint64_t error) {
  if (error == 0) return Message("it tells no error, and does not reach closed-loop control");
  const std::pair<std::uint64_t, Message> names[] = {
      {0x1, Message("invalid state")},
      {0x40, Message("motor failed")},
      {0x80, Message("sensorless estimator failed")},
      {0x100, Message("encoder failed")},
      {0x200, Message("controller failed")},
      {0x800, Message("watchdog timer expired")},
      {0x1000, Message("end stop pressed (low)")},
      {0x2000, Message("end stop pressed (high)")},
      {0x4000, Message("emergency stop requested")},
      {0x20000, Message("homing without end stop")},
      {0x40000, Message("over temperature")},
      {0x80000, Message("unknown position")},
  };
  std::vector<Message> words;
  for (const auto& [bit, name] : names)
    if ((error & bit) != 0) words.push_back(name);
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "0x%llX", static_cast<unsigned long long>(error));
  const std::string code = number.data();
  return words.empty() ? Message("error %1", code) : Message("error %1 (%2)", code, std::move(words));
}

// "c 0 0.0125 *57\n": the checksum is decimal, over everything before the star.
template <class... Values>
void OdriveForceDevice::say(const char* pattern, Values... values) {
  std::array<char, 110> text{};
  const int length = std::snprintf(text.data(), text.size() - 8, pattern, values...);
  if (length < 0 || static_cast<std::size_t>(length) > text.size() - 9) return;
  const auto end = static_cast<std::size_t>(length);
  const int tail = std::snprintf(text.data() + end, text.size() - end, "*%u\n",
                                 static_cast<unsigned>(lineChecksum({text.data(), end})));
  link_.send({text.data(), end + static_cast<std::size_t>(tail)});
}

void OdriveForceDevice::write(const char* property, double value) {
  say("w axis%u.%s %g ", settings_.axis, property, value);
}

// Commands feed the watchdog; this one asks for nothing.
void OdriveForceDevice::feed() { say("c %u %.6f ", settings_.axis, 0.0); }

std::optional<double> OdriveForceDevice::ask(const char* property, double wait_s) {
  feed();
  say("r axis%u.%s ", settings_.axis, property);
  for (const double deadline_s = now_s() + wait_s;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return {};
    const std::optional<std::string_view> text = payloadOf(*line);
    if (text && numberIn(*text)) return numberIn(*text);
    if (text && !positionIn(*text)) return {};  // "invalid property"
  }
}

// Firmware 0.5 calls it error, 0.6 active_errors.
std::uint64_t OdriveForceDevice::error() {
  for (int i = 0; i < 2; ++i, olderNames_ = !olderNames_) {
    const std::optional<double> bits = ask(olderNames_ ? "error" : "active_errors", shortAnswer_s);
    if (bits && *bits >= 0 && *bits < 1e15) return static_cast<std::uint64_t>(*bits);
  }
  return 0;
}

// The watchdog counts from the moment it is switched on, and an axis that is not armed yet is not fed: so it comes last. Old errors, one of
// them the watchdog's own from a run before, would keep the axis idle.
bool OdriveForceDevice::arm(double wait_s) {
  armed_ = false;
  const double deadline_s = now_s() + wait_s;
  link_.forget();
  write("config.enable_watchdog", 0);
  counts_.fault = error();
  if (counts_.fault != 0) counts_.clearedFault = counts_.fault;
  say("%s ", "sc");
  write("controller.config.control_mode", torqueControl);
  limit();
  write("config.watchdog_timeout", settings_.watchdog_s);
  feed();
  write("requested_state", closedLoop);
  while (!armed_ && now_s() < deadline_s) armed_ = ask("current_state", shortAnswer_s) == closedLoop;
  if (!armed_) {
    disarmed();
    return false;
  }
  feed();
  write("config.enable_watchdog", 1);
  const std::optional<double> turns = feedback_turns(now_s() + shortAnswer_s * tries);
  if (!turns) return armed_ = false;
  rest_turns_ = *turns;
  counts_.fault = 0;
  asked_s_ = now_s();
  return true;
}

// What the motor can give whatever it is asked for. In torque control the firmware brakes above its velocity limit with torque of its own:
// that limit is moved out of a hand's reach, the engine's own speed limit takes the force away below it.
void OdriveForceDevice::limit() {
  const double most_Nm = settings_.force_N * std::abs(settings_.mmPerTurn) / (2 * std::numbers::pi * mmPerM);
  write("motor.config.torque_lim", most_Nm);  // firmware 0.5
  write("config.torque_soft_max", most_Nm);   // 0.6
  write("config.torque_soft_min", -most_Nm);
  write("controller.config.vel_limit",
        velocityRoom * settings_.speed_mm_per_s / std::abs(settings_.mmPerTurn));
  link_.forget();
}

void OdriveForceDevice::disarmed() {
  armed_ = false;
  if (const std::uint64_t bits = error(); bits != 0) counts_.fault = bits;
}

void OdriveForceDevice::rearm() {
  if (link_.isOpen() && arm(rearming_s)) last_mm_ = 0;
}

std::optional<double> OdriveForceDevice::feedback_turns(double deadline_s) {
  say("f %u ", settings_.axis);
  return nextFeedback_turns(deadline_s);
}

std::optional<double> OdriveForceDevice::nextFeedback_turns(double deadline_s) {
  for (;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return {};
    const std::optional<std::string_view> text = payloadOf(*line);
    if (text) {
      if (const std::optional<double> position = positionIn(*text)) return position;
      if (const std::optional<double> state = numberIn(*text)) {  // what was asked about the axis
        if (*state != closedLoop && armed_) armed_ = false, zeroLost_ = true;
        continue;
      }
    }
    ++counts_.malformed;
  }
}

// What is asked is as long as in the loop, a force with each question; feeding goes on while the answer is awaited.
std::optional<double> OdriveForceDevice::measureRoundTrip_s() {
  RoundTrips trips;
  while (trips.goOn()) {
    const double asked_s = now_s();
    feed();
    std::optional<double> turns = feedback_turns(asked_s + feedEvery_s);
    while (!turns && now_s() < asked_s + slowestRoundTrip_s) {
      feed();
      turns = nextFeedback_turns(now_s() + feedEvery_s);
    }
    trips.add(now_s() - asked_s);
  }
  return trips.usual_s();
}

bool OdriveForceDevice::setPace(double period_s, double wait_s) {
  settings_.period_s = period_s;
  wait_s_ = wait_s;
  return true;
}

ForceReading OdriveForceDevice::exchange(const ForceCommand& command) {
  ForceReading reading;
  reading.position_mm = last_mm_;
  reading.fresh = false;
  ++counts_.exchanges;
  if (!link_.isOpen()) {
    if (link_.reopen()) {
      ++counts_.reconnects;
      zeroLost_ = true;
      arm(rearming_s);
    }
    return reading;
  }
  // An answer of the period before, come late, would be taken for this one's.
  link_.forget();
  const bool allowed = armed_ && !command.halted;
  const double torque_Nm =
      allowed ? -command.force_N * settings_.mmPerTurn / (2 * std::numbers::pi * mmPerM) : 0;
  say("c %u %.6f ", settings_.axis, torque_Nm);
  if (armed_ && now_s() - asked_s_ > stateAsked_s) {
    asked_s_ = now_s();
    say("r axis%u.current_state ", settings_.axis);
  }
  const bool wasArmed = armed_;
  const std::optional<double> turns = feedback_turns(now_s() + wait_s_);
  if (wasArmed && !armed_) disarmed();
  if (!turns) {
    ++counts_.late;
    return reading;
  }
  reading.position_mm = last_mm_ = (*turns - rest_turns_) * settings_.mmPerTurn;
  reading.fresh = true;
  if (std::exchange(zeroLost_, false)) reading.zero = ForceReading::Zero::lost;
  return reading;
}

OdriveForceDevice::~OdriveForceDevice() {
  feed();
  write("requested_state", idle);
  write("config.enable_watchdog", 0);
}

}  // namespace detent::playback
