// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>
#include <string_view>

#include "playback/force_feedback.h"

namespace detent::playback {

namespace {

constexpr unsigned mostFalcons = 127;  // devices on a USB bus
constexpr unsigned serialBaud = 230400, odriveBaud = 115200;

/// Parses a whole text as a number, independent of the locale.
template <class Number>
std::optional<Number> numberIn(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

Failure unknownDevice(const std::string& text, Message problem) {
  return {FailureCode::wrongUsage, "--device " + text, "", std::move(problem),
          Message("Name the force device as one of these: sim, sim:falcon, sim:rig, serial:PORT, "
                  "odrive:PORT, falcon or falcon:N")};
}

Result<ForceDeviceChoice> simulatedFrom(const std::string& text, std::string_view preset) {
  ForceDeviceChoice choice;
  if (preset.empty()) {
    choice.profile = simulatedDevice();
  } else if (preset == "falcon") {
    choice.profile = falconDevice();
  } else if (preset == "rig") {
    choice.profile = voiceCoilRig();
  } else {
    return unknownDevice(text, Message("there is no such simulated device"));
  }
  return choice;
}

Result<ForceDeviceChoice> falconFrom(const std::string& text, bool numbered, std::string_view number) {
  ForceDeviceChoice choice;
  choice.kind = ForceDeviceKind::falcon;
  choice.profile = falconDevice();
  if (!numbered) return choice;
  const auto value = numberIn<unsigned>(number);
  if (!value || *value > mostFalcons)
    return unknownDevice(text, Message("in falcon:N, N is the number of the Falcon, starting with 0"));
  choice.number = *value;
  return choice;
}

}  // namespace

Result<ForceDeviceChoice> forceDeviceFrom(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const bool detailed = colon != std::string::npos;
  const std::string detail = detailed ? text.substr(colon + 1) : "";
  if (kind == "sim" && !(detailed && detail.empty())) return simulatedFrom(text, detail);
  if (kind == "falcon") return falconFrom(text, detailed, detail);
  if (kind != "serial" && kind != "odrive") return unknownDevice(text, Message("there is no such device"));
  if (detail.empty())
    return unknownDevice(
        text, Message("the name of the serial port is missing; an example is %1:/dev/ttyACM0", kind));
  ForceDeviceChoice choice;
  choice.kind = kind == "serial" ? ForceDeviceKind::serial : ForceDeviceKind::odrive;
  choice.port = detail;
  choice.baud = kind == "serial" ? serialBaud : odriveBaud;
  choice.profile = voiceCoilRig();
  choice.profile.provesDirection = choice.profile.watchesEncoder = true;
  choice.profile.name = text;
  return choice;
}

Result<FingerChoice> fingerFrom(const std::string& text) {
  FingerChoice choice;
  if (text == "press") return choice;
  constexpr std::string_view holdAt = "hold=";
  if (text == "hold" || text.starts_with(holdAt)) {
    choice.kind = FingerChoice::Kind::hold;
    if (text == "hold") return choice;
    choice.hold_mm = numberIn<double>(std::string_view(text).substr(holdAt.size()));
    if (choice.hold_mm && std::isfinite(*choice.hold_mm)) return choice;
    return Failure{FailureCode::wrongUsage, "--finger " + text, "", Message("the position is not a number"),
                   Message("Give the position in mm with a point, for example hold=1.25")};
  }
  Result<PressTrace> trace = readPressTrace(text);
  if (!trace) return trace.failure();
  choice.kind = FingerChoice::Kind::trace;
  choice.trace = *std::move(trace);
  return choice;
}

}  // namespace detent::playback
