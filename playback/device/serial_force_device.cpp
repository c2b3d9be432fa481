// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/serial_force_device.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "playback/device/sensor_line.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double answer_s = 0.5;     // to a question that is not part of the loop
constexpr double bootPause_s = 2.0;  // an Arduino resets when its port is opened
constexpr double micro = 1e-6, nmPerMm = 1e6;
constexpr double waitOfPeriod = 0.5;

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = text.find(',');
    fields.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    text.remove_prefix(comma + 1);
  }
}

template <class Integer>
bool read(std::string_view text, Integer& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

long long whole(double value) { return std::llround(value); }

}  // namespace

std::string forceLine(const std::string& body) {
  std::array<char, 8> sum{};
  std::snprintf(sum.data(), sum.size(), "*%02X\n", static_cast<unsigned>(lineChecksum(body)));
  return body + sum.data();
}

std::optional<std::string_view> forceLineBody(std::string_view line) {
  const std::size_t star = line.rfind('*');
  unsigned sum = 0;
  if (star == std::string_view::npos || line.size() != star + 3) return {};
  const auto [end, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), sum, 16);
  if (error != std::errc() || end != line.data() + line.size() || sum != lineChecksum(line.substr(0, star)))
    return {};
  return line.substr(0, star);
}

Result<std::unique_ptr<SerialForceDevice>> SerialForceDevice::open(const std::string& port, unsigned baud,
                                                                   double period_s) {
  Result<SerialLink> link = SerialLink::open(port, baud);
  if (!link) return link.failure();
  std::unique_ptr<SerialForceDevice> device(new SerialForceDevice(std::move(*link), period_s));
  std::string problem = "does not answer";
  for (const double deadline_s = now_s() + bootPause_s; now_s() < deadline_s;) {
    if (device->hello(problem)) return device;
  }
  return Failure{FailureCode::deviceTrouble, port, "", problem,
                 "Check that the firmware speaks docs/force-protocol.md and the baud rate is the same"};
}

bool SerialForceDevice::hello(std::string& problem) {
  link_.send(forceLine("?"));
  for (const double deadline_s = now_s() + answer_s;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return false;
    const std::optional<std::string_view> body = forceLineBody(*line);
    if (!body) {
      problem = "answers with something that is no line of the protocol";
      continue;
    }
    const std::vector<std::string_view> f = split(*body);
    long long step_nm = 0, force_uN = 0;
    std::uint32_t rate_Hz = 0;
    if (f.size() != 6 || f[0] != "I" || !read(f[2], step_nm) || !read(f[3], force_uN) ||
        !read(f[4], rate_Hz) || !read(f[5], info_.tableRows) || step_nm <= 0 || force_uN <= 0) {
      continue;
    }
    info_.name = f[1];
    info_.step_mm = static_cast<double>(step_nm) / nmPerMm;
    info_.force_N = static_cast<double>(force_uN) * micro;
    info_.rate_Hz = rate_Hz;
    return true;
  }
}

bool SerialForceDevice::acknowledged(const std::string& line) {
  link_.send(forceLine(line));
  for (const double deadline_s = now_s() + answer_s;;) {
    const std::optional<std::string_view> answer = link_.line(deadline_s);
    if (!answer) return false;
    const std::optional<std::string_view> body = forceLineBody(*answer);
    if (body && *body == "A") return true;
    if (body && body->starts_with("N")) return false;
  }
}

std::vector<std::string> forceTableLines(const ForceProgram& program, std::uint32_t mostRows) {
  const ForceStateTable& t = program.states[0];
  const std::uint32_t rows = std::min(mostRows, t.rowCount);
  const double spacing_mm = t.spacing_mm * (t.rowCount - 1) / (rows - 1);
  const auto text = [](long long value) { return "," + std::to_string(value); };
  std::vector<std::string> lines{
      "T" + text(rows) + text(whole(t.first_mm * nmPerMm)) + text(whole(spacing_mm * nmPerMm)) +
      text(whole(program.law.playRadius_mm * nmPerMm)) + text(whole(t.wallSlope_N_per_mm / micro))};
  for (std::uint32_t i = 0; i < rows; ++i) {
    const auto at =
        static_cast<std::uint32_t>(std::lround(static_cast<double>(i) * (t.rowCount - 1) / (rows - 1)));
    const ForceRow& r = t.rows[at];
    lines.push_back("R" + text(i) + text(whole(static_cast<double>(r.press_N) / micro)) +
                    text(whole(static_cast<double>(r.release_N) / micro)) +
                    text(whole(static_cast<double>(r.damping_Ns_per_mm) / micro)));
  }
  lines.push_back("G");
  return lines;
}

Result<Done> SerialForceDevice::upload(const ForceProgram& program) {
  Failure refused{FailureCode::deviceTrouble, info_.name, "", "does not take the force table",
                  "Check the firmware and the cable; without --upload the host runs the law"};
  if (program.stateCount != 1) {
    return Failure{FailureCode::wrongUsage, info_.name, "",
                   "runs one state only, and this button has " + std::to_string(program.stateCount),
                   "Leave --upload out: the host runs self-locking buttons"};
  }
  if (info_.tableRows < 2) {
    return Failure{FailureCode::wrongUsage, info_.name, "", "holds no force table",
                   "Leave --upload out: the host runs the law"};
  }
  for (const std::string& line : forceTableLines(program, info_.tableRows)) {
    if (!acknowledged(line)) return refused;
  }
  ownLaw_ = true;
  return Done{};
}

ForceReading SerialForceDevice::exchange(const ForceCommand& command) {
  ForceReading reading;
  reading.position_mm = last_mm_;
  reading.fresh = false;
  ++counts_.exchanges;
  if (!link_.isOpen()) {
    // A device that was away has no table and knows no sequence.
    if (link_.reopen()) {
      ++counts_.reconnects;
      ownLaw_ = false;
      lastTime_us_ = -1;
    }
    return reading;
  }
  ++sequence_;
  std::array<char, 64> body{};
  if (ownLaw_) {
    std::snprintf(body.data(), body.size(), "H,%u", sequence_);
  } else {
    std::snprintf(body.data(), body.size(), "F,%u,%lld", sequence_, whole(command.force_N / micro));
  }
  link_.send(forceLine(body.data()));
  for (const double deadline_s = now_s() + waitOfPeriod * period_s_;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) {
      ++counts_.late;
      return reading;
    }
    const std::optional<std::string_view> text = forceLineBody(*line);
    const std::vector<std::string_view> f = split(text.value_or(""));
    std::uint32_t sequence = 0;
    long long time_us = 0, position_nm = 0;
    if (!text || f.size() != 4 || f[0] != "P" || !read(f[1], sequence) || !read(f[2], time_us) ||
        !read(f[3], position_nm)) {
      ++counts_.malformed;
      continue;
    }
    // Of an earlier period, or twice; or a device whose clock stands still measures nothing anew.
    if (sequence != sequence_ || time_us == lastTime_us_) {
      ++counts_.repeated;
      continue;
    }
    lastTime_us_ = time_us;
    reading.position_mm = last_mm_ = static_cast<double>(position_nm) / nmPerMm;
    reading.fresh = true;
    return reading;
  }
}

SerialForceDevice::~SerialForceDevice() {
  link_.send(forceLine("X"));  // and where the link is gone, the firmware's own watchdog takes the force away
}

}  // namespace detent::playback
