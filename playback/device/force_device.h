// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A force-feedback device as the force loop uses it: one exchange per period. Everything specific to a device
// is hidden behind this interface.

#include <optional>
#include <string>

#include "playback/realtime/force_engine.h"

namespace detent::playback {

/// Counts of the link since it was opened.
struct ForceLinkCounts {
  std::uint64_t exchanges = 0;      ///< readings that were requested
  std::uint64_t late = 0;           ///< answers that did not come in their period
  std::uint64_t malformed = 0;      ///< answers that could not be decoded
  std::uint64_t repeated = 0;       ///< answers that came again, or without a request
  std::uint64_t reconnects = 0;     ///< times the device came back
  std::uint64_t firmwareTries = 0;  ///< uploads of a firmware, the successful ones included
  std::uint64_t clearedFault = 0;   ///< the last fault that was found and cleared
  /// times the device, which runs the law itself, was commanded to give no force because its answers
  /// stopped
  std::uint64_t withdrawn = 0;
  bool newerFaults = false;  ///< an ODrive's faults are those of firmware 0.6
  std::uint64_t fault = 0;   ///< the device's own code for the reason why it gives no force; 0: none
};

/// Readiness of a device to give forces.
enum class ForceDeviceState : std::uint8_t {
  ready,
  homing,  ///< the position is unknown: the person has to move the handle all the way out and in
  /// the device removed the force itself and reports why (`ForceLinkCounts::fault`); `rearm` clears the
  /// fault
  fault,
  lost  ///< unplugged or reset; each exchange tries to connect again
};

/// One thread uses it, from opening to destruction. The destructor leaves the device without force.
class ForceDevice {
 public:
  virtual ~ForceDevice() = default;

  /// Sends a force and returns the newest reading; `fresh` is false if none arrived within the period. Never
  /// throws. A lost device gives no fresh reading until it is back.
  virtual ForceReading exchange(const ForceCommand& command) = 0;

  /// Time from a question to its answer, measured without force: nine of ten answers take no longer. None if
  /// the device has no link of its own; 0.1 s if it answers no sooner. Call before the first `exchange`;
  /// takes a third of a second at most.
  virtual std::optional<double> measureRoundTrip_s() { return {}; }
  /// Sets another period. Returns false if the device does not support it. Call before the first `exchange`.
  virtual bool setPace(double /*period_s*/) { return true; }

  /// Longest time without answers of a device that runs the law itself, before it is commanded to give no
  /// force; 0: the host runs the law.
  virtual double longestUnheard_s() const { return 0; }

  /// Prepares the device for another button. A device that runs the law itself receives it over some hundred
  /// exchanges, gives no force meanwhile, and then increases the force from zero. May allocate, so not for
  /// every step.
  virtual void setProgram(const ForceProgram& /*program*/) {}

  /// Called when a person wants force again after an emergency stop, a fault or a lost position. Clears the
  /// device's own faults. May wait a fifth of a second.
  virtual void rearm() {}

  virtual ForceDeviceState state() const { return ForceDeviceState::ready; }
  virtual ForceLinkCounts counts() const { return {}; }
};

}  // namespace detent::playback
