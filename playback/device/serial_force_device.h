// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A microcontroller with motor and encoder behind our own line protocol (docs/force-protocol.md): the host runs the law, or
// uploads it as a table.

#include <memory>
#include <string>
#include <vector>

#include "playback/device/force_device.h"
#include "playback/device/serial_link.h"
#include "playback/realtime/force_program.h"

namespace detent::playback {

/// What the device says of itself.
struct SerialForceInfo {
  std::string name;
  double step_mm = 0, force_N = 0, rate_Hz = 0;
  std::uint32_t tableRows = 0;  ///< most it can hold; 0: it runs no law
};

class SerialForceDevice : public ForceDevice {
 public:
  /// Opens a port and asks who is there. Trouble where nobody answers as the protocol says.
  static Result<std::unique_ptr<SerialForceDevice>> open(const std::string& port, unsigned baud,
                                                         double period_s);
  ~SerialForceDevice() override;

  const SerialForceInfo& info() const { return info_; }

  /// Sends a law that the device then runs at its own rate; `exchange` only listens from then on, and its force is ignored.
  /// Trouble where the table does not fit (the device says how many rows it takes) or a row is not acknowledged.
  Result<Done> upload(const ForceProgram& program);

  ForceReading exchange(const ForceCommand& command) override;
  ForceDeviceState state() const override {
    return link_.isOpen() ? ForceDeviceState::ready : ForceDeviceState::lost;
  }
  ForceLinkCounts counts() const override { return counts_; }

 private:
  SerialForceDevice(SerialLink link, double period_s) : link_(std::move(link)), period_s_(period_s) {}
  bool hello(std::string& problem);
  bool acknowledged(const std::string& line);

  SerialLink link_;
  double period_s_;
  SerialForceInfo info_;
  ForceLinkCounts counts_;
  bool ownLaw_ = false;
  std::uint32_t sequence_ = 0;
  long long lastTime_us_ = -1;  ///< of the device, at its last answer
  double last_mm_ = 0;
};

/// The lines, without checksum, that tell a device to run the first state of a program by itself: the table thinned to at most `mostRows` >= 2, its first and
/// last row included, and the command to begin.
std::vector<std::string> forceTableLines(const ForceProgram& program, std::uint32_t mostRows);

/// A line of the protocol with its checksum and end: "F,17,120000*5A\n".
std::string forceLine(const std::string& body);
/// The fields of a received line; none where it has no checksum or a wrong one.
std::optional<std::string_view> forceLineBody(std::string_view line);

}  // namespace detent::playback
