// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/sensor_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "model/text.h"

namespace detent::playback {

namespace {

bool wholeNumber(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    value = std::numeric_limits<double>::infinity();
    return true;
  }
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::uint8_t lineChecksum(std::string_view text) {
  unsigned sum = 0;
  for (char c : text) sum ^= static_cast<unsigned char>(c);
  return static_cast<std::uint8_t>(sum);
}

std::string quotable(std::string_view line) {
  constexpr std::size_t mostCharacters = 60;
  const bool isText =
      std::all_of(line.begin(), line.end(), [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
  return isText ? std::string(trimmed(line.substr(0, mostCharacters))) : std::string();
}

LineVerdict parseSensorLine(std::string_view line, SensorLine& out) {
  out = SensorLine{};
  line = trimmed(line);
  if (line.empty() || line.front() == '#') return LineVerdict::comment;
  if (const std::size_t star = line.rfind('*'); star != std::string_view::npos) {
    const std::string_view digits = line.substr(star + 1);
    unsigned sum = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), sum, 16);
    if (error != std::errc() || end != digits.data() + digits.size() || digits.size() != 2)
      return LineVerdict::malformed;
    line = line.substr(0, star);
    if (sum != lineChecksum(line)) return LineVerdict::badChecksum;
  }
  if (const std::size_t comma = line.find(','); comma != std::string_view::npos) {
    const std::string_view time = trimmed(line.substr(0, comma));
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), out.time_us);
    if (error != std::errc() || end != time.data() + time.size()) return LineVerdict::malformed;
    out.timed = true;
    line = trimmed(line.substr(comma + 1));
  }
  if (!line.empty() && line.back() == 'N' && line.size() > 1) {
    out.newtons = true;
    line = trimmed(line.substr(0, line.size() - 1));
  }
  return wholeNumber(line, out.value) ? LineVerdict::reading : LineVerdict::malformed;
}

void LineAssembler::restart() {
  length_ = 0;
  skipping_ = true;
  overlong_ = false;
}

void LineAssembler::feed(std::string_view bytes, const std::function<void(const SensorLine&)>& onReading) {
  counts_.bytes += bytes.size();
  for (char c : bytes) {
    if (c == '\n') {
      finishLine(onReading);
    } else if (length_ < longestLine) {
      line_[length_++] = c;
    } else {
      overlong_ = true;
    }
  }
}

void LineAssembler::finishLine(const std::function<void(const SensorLine&)>& onReading) {
  const std::string_view line(line_.data(), length_);
  const bool overlong = overlong_, first = skipping_;
  length_ = 0;
  overlong_ = skipping_ = false;
  if (overlong) {
    ++counts_.overlong;
    return;
  }
  SensorLine reading;
  switch (parseSensorLine(line, reading)) {
    case LineVerdict::reading:
      // The rest of a truncated number is a number too, so the first line after a start is accepted only with
      // a time stamp or checksum.
      if (first && !reading.timed && line.find('*') == std::string_view::npos) return;
      ++counts_.readings;
      if (!reading.newtons) ++counts_.counts;
      onReading(reading);
      return;
    case LineVerdict::comment:
      greet(trimmed(line));
      return;
    case LineVerdict::malformed:
      if (!first) ++counts_.malformed;
      return;
    case LineVerdict::badChecksum:
      if (!first) ++counts_.badChecksums;
      return;
  }
}

void LineAssembler::greet(std::string_view comment) {
  constexpr std::string_view mark = "# detent-force ";
  if (comment.substr(0, mark.size()) == mark) greeting_ = comment.substr(2);
}

bool ClockAligner::believable(double offset_s) {
  constexpr double plausible_s = 0.02;  // a first reading may have waited in a buffer
  constexpr unsigned enough = 4;
  if (offset_s > offset_s_ - plausible_s) {
    suspectsInRow_ = 0;
    return true;
  }
  const bool same = suspectsInRow_ > 0 && std::fabs(offset_s - suspect_s_) < plausible_s;
  suspectsInRow_ = same ? suspectsInRow_ + 1 : 1;
  suspect_s_ = offset_s;
  if (suspectsInRow_ < enough) return false;
  suspectsInRow_ = 0;
  return true;
}

double ClockAligner::hostTime_s(std::uint32_t device_us, double arrival_s) {
  constexpr double restartStep_s = 0.5;
  constexpr double drift = 500e-6;
  constexpr double apart_s = 1e-6;
  if (!running_) {
    running_ = true;
    device_s_ = 0;
    offset_s_ = arrival_s;
    last_us_ = device_us;
    return last_s_ = arrival_s;
  }
  // modulo 2^32, so that a wrap is a small step forwards
  const std::uint32_t forward_us = device_us - last_us_;
  const auto step_us = static_cast<std::int32_t>(forward_us);
  last_us_ = device_us;
  const double step_s = 1e-6 * static_cast<double>(step_us);
  device_s_ += step_s;
  const double offset_s = arrival_s - device_s_;
  if (std::fabs(offset_s - offset_s_) > restartStep_s) {
    offset_s_ = offset_s;
    return last_s_ = arrival_s;
  }
  if (!believable(offset_s)) {
    ++wrongStamps_;
    return last_s_ = std::fmax(arrival_s, last_s_ + apart_s);
  }
  if (offset_s < offset_s_) {
    offset_s_ = offset_s;
  } else if (step_s > 0) {
    offset_s_ += std::fmin(offset_s - offset_s_, drift * step_s);
  }
  double host_s = std::fmin(device_s_ + offset_s_, arrival_s);
  // A smaller delay moves the offset back; successive readings of the sensor must stay in order.
  if (step_s > 0 && host_s <= last_s_) host_s = last_s_ + apart_s;
  return last_s_ = host_s;
}

}  // namespace detent::playback
