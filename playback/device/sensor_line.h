// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The line protocol of a serial force sensor (docs/reference/serial-protocol.md). Pure text handling: takes
// bytes, returns readings. Any bytes are accepted; invalid ones are counted.

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
  bool newtons = false;       ///< true: newtons; false: counts of the converter
  bool timed = false;         ///< the line has a time stamp of the sensor
  std::uint32_t time_us = 0;  ///< the sensor's clock; wraps after 71.6 minutes
};

enum class LineVerdict : std::uint8_t { reading, comment, malformed, badChecksum };

/// `line` without its line end.
LineVerdict parseSensorLine(std::string_view line, SensorLine& out);

/// XOR of all bytes, as it follows '*' in a line.
std::uint8_t lineChecksum(std::string_view text);

/// The beginning of a line from other firmware, in a form fit for a message; empty if it is no text.
std::string quotable(std::string_view line);

struct LineCounts {
  std::uint64_t counts = 0;  ///< readings that were counts, not newtons
  std::uint64_t bytes = 0, readings = 0, malformed = 0, badChecksums = 0, overlong = 0;
};

/// Cuts a byte stream into lines. Bounded: a stream without line ends costs one line of memory.
class LineAssembler {
 public:
  static constexpr std::size_t longestLine = 96;
  /// Calls `onReading` for each good line.
  void feed(std::string_view bytes, const std::function<void(const SensorLine&)>& onReading);
  /// Discards an incomplete line: after a reconnection the next bytes may start anywhere.
  void restart();
  const LineCounts& counts() const { return counts_; }
  /// The last greeting of the firmware: "detent-force 1 fsr400 divider 1023"; empty if none arrived.
  const std::string& greeting() const { return greeting_; }

 private:
  void greet(std::string_view comment);

  void finishLine(const std::function<void(const SensorLine&)>& onReading);
  std::array<char, longestLine> line_{};
  std::size_t length_ = 0;
  bool skipping_ = true;  // the first line after a start may be incomplete
  bool overlong_ = false;
  std::string greeting_;
  LineCounts counts_;
};

/// Converts times of the sensor's clock to the host's. The smallest delay seen so far is the true offset;
/// anything above it is caused by the bus. Follows drift between the two clocks up to 500 ppm; after a jump
/// (sensor restarted) it starts again. A stamp that would lie later than its own arrival by more than a clock
/// drifts is taken as wrong until others agree with it.
class ClockAligner {
 public:
  /// Host time of the reading: not after `arrival_s`, except for the microseconds that keep the readings of
  /// one packet in order.
  double hostTime_s(std::uint32_t device_us, double arrival_s);
  void restart() { running_ = false; }
  /// Number of stamps that were rejected; their readings got the time of their arrival.
  std::uint64_t wrongStamps() const { return wrongStamps_; }

 private:
  bool believable(double offset_s);

  bool running_ = false;
  double suspect_s_ = 0;        // the offset that a rejected stamp would imply
  unsigned suspectsInRow_ = 0;  // number of consecutive stamps that imply the same
  std::uint64_t wrongStamps_ = 0;
  std::uint32_t last_us_ = 0;
  double device_s_ = 0;
  double offset_s_ = 0;
  double last_s_ = 0;
};

}  // namespace detent::playback
