// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The line protocol of a serial force sensor (docs/reference/serial-protocol.md). Pure text handling: bytes in,
// readings out; any bytes at all are survived and counted.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
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

/// The beginning of a line of another firmware, fit for a message; empty where it is no text.
std::string quotable(std::string_view line);

struct LineCounts {
  std::uint64_t counts = 0;  ///< readings that were no newtons
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
  /// What the firmware last said of itself: "detent-force 1 fsr400 divider 1023"; empty if nothing.
  const std::string& greeting() const { return greeting_; }

 private:
  void greet(std::string_view comment);

  void finishLine(const std::function<void(const SensorLine&)>& onReading);
  std::array<char, longestLine> line_{};
  std::size_t length_ = 0;
  bool skipping_ = true;  // the first line after a start may be half
  bool overlong_ = false;
  std::string greeting_;
  LineCounts counts_;
};

/// From the sensor's clock to the host's: the smallest delay ever seen is the true offset, anything above it
/// is the bus. Follows drift between the two clocks up to 500 ppm; a jump (sensor restarted) starts anew. A
/// stamp that would lie ahead of its own arrival by more than a clock drifts is wrong until others agree with
/// it.
class ClockAligner {
 public:
  /// Host time of the reading: not after `arrival_s`, but for the microseconds that keep a packet's readings
  /// in order.
  double hostTime_s(std::uint32_t device_us, double arrival_s);
  void restart() { running_ = false; }
  /// Stamps not believed so far; their readings got the time of their arrival.
  std::uint64_t wrongStamps() const { return wrongStamps_; }

 private:
  bool believable(double offset_s);

  bool running_ = false;
  double suspect_s_ = 0;        // the offset that a stamp not believed would mean
  unsigned suspectsInRow_ = 0;  // how many meant the same
  std::uint64_t wrongStamps_ = 0;
  std::uint32_t last_us_ = 0;
  double device_s_ = 0;
  double offset_s_ = 0;
  double last_s_ = 0;
};

}  // namespace detent::playback
