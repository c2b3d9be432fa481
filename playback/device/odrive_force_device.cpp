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
constexpr double arming_s = 1, rearming_s = 0.15;
constexpr double velocityRoom = 1.25;    // ratio of the firmware's velocity limit to the engine's
constexpr double stateEvery_s = 0.02;    // between two requests for the axis's state
constexpr double feedEvery_s = 0.015;    // well below the watchdog's time
constexpr double positionLost_s = 0.02;  // a position that has not arrived by then was lost
constexpr double longestUnsure_s = 1;    // then a marker was lost as well, so the exchange starts again
// after this time without input nothing is under way any more
constexpr double quiet_s = 0.015, longestQuiet_s = 0.2;
constexpr double sameShare = 1e-3;  // relative tolerance, because the device reports values with few digits
constexpr int tries = 5;
constexpr int torqueControl = 1, passThrough = 1;  // CONTROL_MODE_TORQUE_CONTROL, INPUT_MODE_PASSTHROUGH
constexpr int closedLoop = 8, idle = 1;            // AXIS_STATE_...
// Firmware 0.5 truncates a property's answer to this many characters.
constexpr std::size_t longestAnswer = 9;

/// The text before a valid checksum, or the whole line if it has none; none if the checksum is wrong.
std::optional<std::string_view> payloadOf(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return line;
  unsigned sum = 0;
  const auto [end, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), sum);
  if (error != std::errc() || end != line.data() + line.size() || sum != lineChecksum(line.substr(0, star)))
    return {};
  return line.substr(0, star);
}

/// The answer to a question about a property: one number and nothing else.
std::optional<double> numberIn(std::string_view line) {
  double value = 0;
  if (line == "True" || line == "False") return line == "True" ? 1.0 : 0.0;
  const char* last = line.data() + line.size();
  const auto [end, error] = std::from_chars(line.data(), last, value);
  if (error != std::errc()) return {};
  for (const char* p = end; p != last; ++p) {
    if (*p != ' ') return {};
  }
  return value;
}

/// Returns true for a whole number that fills the answer, because further digits may have been truncated.
bool mayBeCut(std::string_view text) {
  return text.size() >= longestAnswer && text.find_first_not_of("0123456789-") == std::string_view::npos;
}

/// Position of "1.25 -0.5", with or without a checksum: position and velocity in turns.
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
                   Message("the axis or the travel per turn is not valid"),
                   Message("Give axis 0 or 1 and a travel that is not 0")};
  }
  Result<SerialLink> link = SerialLink::open(settings.port, settings.baud);
  if (!link) return link.failure();
  std::unique_ptr<OdriveForceDevice> device(new OdriveForceDevice(*std::move(link), settings));
  device->link_.forget();
  std::optional<double> turns;
  for (int i = 0; i < tries && !turns; ++i) {
    device->settle();
    turns = device->feedback_turns(now_s() + odriveAnswer_s);
  }
  if (!turns) {
    device->askPosition();
    const std::optional<std::string_view> line = device->link_.line(now_s() + odriveAnswer_s);
    const std::string quoted = line ? quotable(*line) : std::string();
    return Failure{
        FailureCode::deviceTrouble, settings.port, "",
        quoted.empty()
            ? Message("no ODrive answers on axis %1", settings.axis)
            : Message("the answer on axis %1 is not that of an ODrive: \"%2\"", settings.axis, quoted),
        Message(
            "Check power, cable and axis, and that the ASCII protocol is on (docs/guide/force-feedback.md)")};
  }
  const bool armed = device->arm(arming_s);
  if (!device->unheld_.empty()) {
    return Failure{FailureCode::deviceTrouble, settings.port, "",
                   Message("axis %1 does not keep the setting %2", settings.axis, device->unheld_),
                   Message("Make this setting with odrivetool, then try again")};
  }
  if (!armed) {
    return Failure{FailureCode::deviceTrouble, settings.port, "",
                   Message("axis %1 cannot be switched on: %2", settings.axis,
                           odriveErrorWords(device->counts_.fault, device->counts_.newerFaults)),
                   Message("Correct this with odrivetool (dump_errors), until closed-loop control runs")};
  }
  return device;
}

namespace {

/// Bits of axis.error in firmware 0.5.
const std::pair<std::uint64_t, Message>* olderNames(std::size_t& count) {
  static const std::pair<std::uint64_t, Message> names[] = {
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
  count = std::size(names);
  return names;
}

/// Bits of axis.active_errors in firmware 0.6.
const std::pair<std::uint64_t, Message>* newerNames(std::size_t& count) {
  static const std::pair<std::uint64_t, Message> names[] = {
      {0x1, Message("initializing")},
      {0x2, Message("system level")},
      {0x4, Message("timing error")},
      {0x8, Message("missing estimate")},
      {0x10, Message("bad configuration")},
      {0x20, Message("gate driver fault")},
      {0x40, Message("missing input")},
      {0x100, Message("DC bus over-voltage")},
      {0x200, Message("DC bus under-voltage")},
      {0x400, Message("DC bus over-current")},
      {0x800, Message("DC bus over-regeneration current")},
      {0x1000, Message("current limit violation")},
      {0x2000, Message("motor over temperature")},
      {0x4000, Message("inverter over temperature")},
      {0x8000, Message("velocity limit violation")},
      {0x10000, Message("position limit violation")},
      {0x1000000, Message("watchdog timer expired")},
      {0x2000000, Message("emergency stop requested")},
      {0x4000000, Message("spinout detected")},
      {0x8000000, Message("brake resistor disarmed")},
      {0x10000000, Message("thermistor disconnected")},
      {0x40000000, Message("calibration error")},
  };
  count = std::size(names);
  return names;
}

constexpr std::uint64_t leastCut = 100000000;  // nine digits

}  // namespace

Message odriveErrorWords(std::uint64_t error, bool newer) {
  if (error == 0) return Message("the ODrive reports no error, but does not reach closed-loop control");
  std::size_t count = 0;
  const std::pair<std::uint64_t, Message>* names = newer ? newerNames(count) : olderNames(count);
  std::vector<Message> words;
  std::uint64_t unknown = error;
  for (std::size_t i = 0; i < count; ++i) {
    if ((error & names[i].first) == 0) continue;
    words.push_back(names[i].second);
    unknown &= ~names[i].first;
  }
  std::array<char, 32> number{};
  if (unknown != 0 && error >= leastCut && error < 10 * leastCut) {
    std::snprintf(number.data(), number.size(), "%llu", static_cast<unsigned long long>(error));
    return Message(
        "an error whose code begins with %1; the rest was cut off, but dump_errors in odrivetool shows it",
        std::string(number.data()));
  }
  std::snprintf(number.data(), number.size(), "0x%llX", static_cast<unsigned long long>(unknown));
  const std::string code = number.data();
  if (words.empty()) return Message("error %1", code);
  return unknown == 0 ? Message("%1", std::move(words)) : Message("%1; error %2", std::move(words), code);
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

// Commands reset the watchdog; this one requests no torque.
void OdriveForceDevice::feed() { say("c %u %.6f ", settings_.axis, 0.0); }

/// Value of a property as text; none if nothing came in time; empty if there is no such property. Answers
/// carry no name, but come in the order of the questions: this one's is the last that is due.
std::optional<std::string> OdriveForceDevice::askText(const char* property) {
  feed();
  say("r axis%u.%s ", settings_.axis, property);
  ++numbersDue_;
  const double deadline_s = now_s() + slowestRoundTrip_s;
  while (link_.isOpen() && now_s() < deadline_s) {
    const std::optional<std::string_view> line = link_.line(std::min(deadline_s, now_s() + feedEvery_s));
    if (!line) {
      feed();
      continue;
    }
    std::optional<std::string_view> text = payloadOf(*line);
    if (!text) break;  // garbled, so the question that it answered is unknown
    if (positionIn(*text)) {
      pending_ = false;
      continue;
    }
    if (--numbersDue_ > 0) continue;  // the answer to an earlier question
    while (text->ends_with(' ')) text->remove_suffix(1);
    return numberIn(*text) ? std::string(*text) : std::string();  // "invalid property"
  }
  settle();
  return {};
}

/// Repeats the question if an answer was lost or garbled.
std::optional<std::string> OdriveForceDevice::askAgain(const char* property) {
  std::optional<std::string> text;
  for (int i = 0; i < tries && !text && link_.isOpen(); ++i) text = askText(property);
  return text;
}

std::optional<double> OdriveForceDevice::ask(const char* property) {
  const std::optional<std::string> text = askText(property);
  return text ? numberIn(*text) : std::nullopt;
}

// The property is called error in firmware 0.5, active_errors in 0.6, and disarm_reason after disarming.
std::uint64_t OdriveForceDevice::error() {
  std::optional<double> bits;
  for (int i = 0; i < tries && !bits; ++i) {
    const std::optional<std::string> text = askText(olderNames_ ? "error" : "active_errors");
    if (!text) continue;
    bits = numberIn(*text);
    if (!bits) olderNames_ = !olderNames_;
  }
  if (!olderNames_ && bits == 0.0 && !armed_) {
    if (const std::optional<double> reason = ask("disarm_reason")) bits = reason;
  }
  counts_.newerFaults = !olderNames_;
  return bits && *bits >= 0 && *bits < 1e15 ? static_cast<std::uint64_t>(*bits) : 0;
}

// Reads a setting, remembers it, writes it and reads it back. A setting that the firmware does not have is
// skipped, unless the force depends on it.
bool OdriveForceDevice::hold(const char* property, double value, bool required) {
  const std::optional<std::string> before = askAgain(property);
  if (!before || (before->empty() && required)) {
    unheld_ = std::string(property) + ": it reports no value";
    return false;
  }
  if (before->empty()) return true;
  const auto same = [value](const std::optional<double>& reported) {
    return reported && std::abs(*reported - value) <= sameShare * std::max(std::abs(value), 1e-3);
  };
  if (same(numberIn(*before))) return true;
  if (mayBeCut(*before)) {
    unheld_ = std::string(property) + ": its value, " + *before + "..., is cut off and could not be put back";
    return false;
  }
  write(property, value);
  const std::optional<std::string> reread = askAgain(property);
  const std::optional<double> after = reread ? numberIn(*reread) : std::nullopt;
  if (!same(after)) {
    char reported[64];
    std::snprintf(reported, sizeof reported, ": asked for %.6g, it says %.6g", value,
                  after.value_or(std::nan("")));
    unheld_ = std::string(property) + reported;
    return false;
  }
  if (!configured_) kept_.push_back({property, *before});  // a later value may have been set by this program
  return true;
}

// A lower limit that the owner has set is kept.
bool OdriveForceDevice::allows(double torque_Nm) {
  for (const char* property : {"motor.config.torque_lim", "config.torque_soft_max"}) {
    const std::optional<std::string> text = askAgain(property);
    if (!text) {
      unheld_ = std::string(property) + ": it reports no value";
      return false;
    }
    const std::optional<double> least_Nm = numberIn(*text);
    if (!least_Nm || *least_Nm >= torque_Nm * (1 - sameShare)) continue;
    char reported[96];
    std::snprintf(reported, sizeof reported, ": it allows %.4g Nm, and the largest force needs %.4g Nm",
                  *least_Nm, torque_Nm);
    unheld_ = std::string(property) + reported;
    return false;
  }
  return true;
}

// Settings on which the torque depends. In torque control the firmware brakes above its velocity limit with a
// torque of its own, which is switched off. The limit beyond which it gives up is moved above a hand's speed;
// the engine's own speed limit removes the force before. Anticogging would add torque that was not requested.
bool OdriveForceDevice::configure() {
  const double most_Nm = settings_.force_N * std::abs(settings_.mmPerTurn) / (2 * std::numbers::pi * mmPerM);
  const double fastest = velocityRoom * settings_.speed_mm_per_s / std::abs(settings_.mmPerTurn);
  if (!configured_ && !allows(most_Nm)) return false;
  const bool limited = hold("motor.config.torque_lim", most_Nm, false) &&  // firmware 0.5
                       hold("config.torque_soft_max", most_Nm, false) &&   // 0.6
                       hold("config.torque_soft_min", -most_Nm, false);
  return limited && hold("controller.config.control_mode", torqueControl, true) &&
         hold("controller.config.input_mode", passThrough, true) &&
         hold("controller.config.vel_limit", fastest, true) &&
         hold("controller.config.enable_torque_mode_vel_limit", 0, false) &&
         hold("controller.config.anticogging.anticogging_enabled", 0, false) &&  // 0.5
         hold("config.anticogging.enabled", 0, false) &&                         // 0.6
         hold("config.watchdog_timeout", settings_.watchdog_s, true);
}

/// Waits until all answers that are due have arrived or were lost, and nothing else arrives.
void OdriveForceDevice::settle() {
  const double start_s = now_s();
  double heard_s = start_s;
  while (link_.isOpen() && now_s() < start_s + longestQuiet_s) {
    const std::optional<std::string_view> line = link_.line(now_s() + quiet_s);
    if (line) {
      heard_s = now_s();
      if (positionIn(payloadOf(*line).value_or(""))) {
        pending_ = false;
      } else {
        numbersDue_ = std::max(0, numbersDue_ - 1);
      }
      continue;
    }
    const bool due = pending_ || numbersDue_ > 0;
    if (!due || now_s() - heard_s >= slowestRoundTrip_s) break;
    feed();
  }
  pending_ = requestedNow_ = unsure_ = false;
  markersDue_ = numbersDue_ = 0;
}

// The watchdog starts when it is enabled, and an axis that is not armed receives no commands, so it is
// enabled last. Old errors, such as that of the watchdog in an earlier run, would keep the axis idle.
bool OdriveForceDevice::arm(double wait_s) {
  armed_ = false;
  const double deadline_s = now_s() + wait_s;
  settle();
  unheld_.clear();
  if (!hold("config.enable_watchdog", 0, true)) return false;
  counts_.fault = error();
  if (counts_.fault != 0) counts_.clearedFault = counts_.fault;
  say("%s ", "sc");
  if (!configure()) return false;
  configured_ = true;
  feed();
  write("requested_state", closedLoop);
  while (!armed_ && now_s() < deadline_s) armed_ = ask("current_state") == closedLoop;
  if (!armed_) {
    disarmed();
    return false;
  }
  feed();
  write("config.enable_watchdog", 1);
  const std::optional<double> turns = fedFeedback_turns();
  if (!turns) return armed_ = false;
  rest_turns_ = *turns;
  counts_.fault = 0;
  stateSent_s_ = now_s();
  return true;
}

void OdriveForceDevice::disarmed() {
  armed_ = false;
  settle();
  if (const std::uint64_t bits = error(); bits != 0) counts_.fault = bits;
}

void OdriveForceDevice::rearm() {
  if (link_.isOpen() && arm(rearming_s)) last_mm_ = 0;
}

void OdriveForceDevice::askPosition() {
  say("f %u ", settings_.axis);
  pending_ = requestedNow_ = true;
  requested_s_ = now_s();
}

// Answers arrive in order, so after the marker's answer no earlier position is under way any more. The
// marker's value cannot be confused with a state.
void OdriveForceDevice::askMarker() {
  if (!std::exchange(unsure_, true)) unsureSince_s_ = now_s();
  ++markersDue_;
  ++numbersDue_;
  markerSent_s_ = now_s();
  say("r axis%u.%s ", settings_.axis, "config.watchdog_timeout");
}

void OdriveForceDevice::noteState(double state) {
  if (state != closedLoop && armed_) armed_ = false, zeroLost_ = true;
}

/// Takes one line; `turns` is set if it is a fresh position.
OdriveForceDevice::Answer OdriveForceDevice::take(std::string_view line, double& turns) {
  const std::optional<std::string_view> text = payloadOf(line);
  const std::optional<double> position = text ? positionIn(*text) : std::nullopt;
  const std::optional<double> number = text && !position ? numberIn(*text) : std::nullopt;
  if (position) {
    if (unsure_) return Answer::late;
    if (!std::exchange(pending_, false)) {
      ++counts_.repeated;
      askMarker();  // not requested, so another one may follow
      return Answer::late;
    }
    turns = *position;
    return requestedNow_ ? Answer::fresh : Answer::late;
  }
  const bool marker = number && std::abs(*number - settings_.watchdog_s) <= sameShare * settings_.watchdog_s;
  if (marker) {
    numbersDue_ = std::max(0, numbersDue_ - 1);
    // A marker that was sent earlier does not prove anything about later requests.
    if (markersDue_ > 0 && --markersDue_ == 0 && unsure_) pending_ = unsure_ = false;
  } else if (number) {
    numbersDue_ = std::max(0, numbersDue_ - 1);
    noteState(*number);
  } else {
    ++counts_.malformed;
    if (pending_ && !unsure_) askMarker();  // the malformed answer may have been the position
  }
  return Answer::other;
}

/// Takes the lines that lie in the port before a position is requested: an answer too many would pass for
/// that position's answer, and each further one would make all positions a period older.
void OdriveForceDevice::takeArrived(double deadline_s) {
  requestedNow_ = false;
  while (now_s() < deadline_s) {
    const std::optional<std::string_view> line = link_.line(now_s());
    if (!line) return;
    double turns = 0;
    take(*line, turns);
  }
}

/// Requests the position until it arrives; only while no loop runs.
std::optional<double> OdriveForceDevice::feedback_turns(double deadline_s) {
  takeArrived(deadline_s);
  if (pending_ && now_s() - requested_s_ > slowestRoundTrip_s) askMarker();
  if (!pending_ && !unsure_) askPosition();
  requestedNow_ = true;
  for (;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return {};
    double turns = 0;
    if (take(*line, turns) == Answer::fresh) return turns;
    if (!unsure_ && !pending_) askPosition();
  }
}

/// Requests the position, and resets the watchdog until the answer arrives, without force.
std::optional<double> OdriveForceDevice::fedFeedback_turns() {
  std::optional<double> turns;
  for (const double end_s = now_s() + slowestRoundTrip_s; !turns && link_.isOpen() && now_s() < end_s;) {
    feed();
    turns = feedback_turns(now_s() + feedEvery_s);
  }
  return turns;
}

std::optional<double> OdriveForceDevice::measureRoundTrip_s() {
  RoundTrips trips;
  while (trips.goOn()) {
    const double requested_s = now_s();
    fedFeedback_turns();
    trips.add(now_s() - requested_s);
  }
  return trips.usual_s();
}

bool OdriveForceDevice::setPace(double period_s) {
  settings_.period_s = period_s;
  wait_s_ = answerWaitOfPeriod * period_s;
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
  const bool allowed = armed_ && !command.halted;
  const double torque_Nm =
      allowed ? -command.force_N * settings_.mmPerTurn / (2 * std::numbers::pi * mmPerM) : 0;
  say("c %u %.6f ", settings_.axis, torque_Nm);
  const bool wasArmed = armed_;
  const std::optional<double> turns = nextPosition();
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

/// The position of this period, if its answer arrives in time.
std::optional<double> OdriveForceDevice::nextPosition() {
  const double start_s = now_s();
  takeArrived(start_s + wait_s_);
  if (pending_ && !unsure_ && start_s - requested_s_ > positionLost_s) askMarker();
  if (unsure_ && start_s - markerSent_s_ > slowestRoundTrip_s) askMarker();
  if (unsure_ && start_s - unsureSince_s_ > longestUnsure_s) settle();
  if (!pending_ && !unsure_) askPosition();
  const bool stateDue = armed_ && start_s - stateSent_s_ > stateEvery_s;
  if (stateDue) {  // after the position, so that its answer cannot be mistaken for the marker's
    stateSent_s_ = start_s;
    say("r axis%u.current_state ", settings_.axis);
    ++numbersDue_;
  }
  for (const double deadline_s = start_s + wait_s_;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return {};
    double turns = 0;
    if (take(*line, turns) == Answer::fresh) return turns;
    if (!pending_ && !unsure_) askPosition();  // an outdated answer has arrived, so the link is free again
  }
}

OdriveForceDevice::~OdriveForceDevice() {
  feed();
  write("requested_state", idle);
  write("config.enable_watchdog", 0);
  feed();
  for (auto kept = kept_.rbegin(); kept != kept_.rend(); ++kept)
    say("w axis%u.%s %s ", settings_.axis, kept->property, kept->text.c_str());
}

}  // namespace detent::playback
