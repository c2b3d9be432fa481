// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The line protocol of a serial force sensor (docs/serial-protocol.md). Pure text handling: bytes in,
// readings out; any bytes at all are survived and counted.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace detent::playback {

/// One line as sent.
struct SensorLine {
  double value = 0;
  bool newtons = false;       ///< else counts of the converter
  bool timed = false;         ///< the sensor stamped it
  std::uint32_t time_us = 0;  ///< the sensor's clock; wraps after 71.6 minutes
};

enum class LineVerdict : std::uint8_t { reading, comment, malformed, badChecksum };

/// `line` without its line end.
LineVerdict parseSensorLine(std::string_view line, SensorLine& out);

/// XOR of all bytes, as behind '*' in a line.
std::uint8_t lineChecksum(std::string_view text);

struct LineCounts {
  std::uint64_t bytes = 0, readings = 0, malformed = 0, badChecksums = 0, overlong = 0;
};

/// Cuts a byte stream into lines. Bounded: a stream without line ends costs one line of memory.
class LineAssembler {
 public:
  static constexpr std::size_t longestLine = 96;
  /// Calls `onReading` for each good line.
  void feed(std::string_view bytes, const std::function<void(const SensorLine&)>& onReading);
  /// Forgets a half line: after an unplug the next bytes start anywhere.
  void restart();
  const LineCounts& counts() const { return counts_; }

 private:
  void finishLine(const std::function<void(const SensorLine&)>& onReading);
  std::array<char, longestLine> line_{};
  std::size_t length_ = 0;
  bool skipping_ = true;  // the first line after a start may be half
  bool overlong_ = false;
  LineCounts counts_;
};

/// From the sensor's clock to the host's: the smallest delay ever seen is the true offset, anything above it
/// is the bus. Follows drift between the two clocks up to 500 ppm; a jump (sensor restarted) starts anew.
class ClockAligner {
 public:
  /// Host time of the reading: not after `arrival_s`, but for the microseconds that keep a packet's readings
  /// in order.
  double hostTime_s(std::uint32_t device_us, double arrival_s);
  void restart() { running_ = false; }

 private:
  bool running_ = false;
  std::uint32_t last_us_ = 0;
  double device_s_ = 0;
  double offset_s_ = 0;
  double last_s_ = 0;
};

}  // namespace detent::playback
