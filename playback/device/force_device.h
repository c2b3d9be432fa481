// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A force-feedback device as the loop sees it: one exchange per period. Everything that is particular to a device stays behind
// this.

#include <optional>
#include <string>

#include "playback/realtime/force_engine.h"

namespace detent::playback {

/// How the link is doing; counted since it was opened.
struct ForceLinkCounts {
  std::uint64_t exchanges = 0;      ///< asked for
  std::uint64_t late = 0;           ///< answers that did not come in their period
  std::uint64_t malformed = 0;      ///< answers that were none
  std::uint64_t repeated = 0;       ///< the same answer again
  std::uint64_t reconnects = 0;     ///< times the device came back
  std::uint64_t firmwareTries = 0;  ///< uploads of a firmware, the successful ones included
  std::uint64_t clearedFault = 0;   ///< the last one that was found and cleared
  std::uint64_t withdrawn =
      0;  ///< commands to a device that runs the law by itself to give no force, because its answers stopped
  bool newerFaults = false;  ///< an ODrive's faults are those of firmware 0.6
  std::uint64_t fault = 0;   ///< the device's own code of why it gives no force; 0: none
};

/// What keeps a device from rendering.
enum class ForceDeviceState : std::uint8_t {
  ready,
  homing,  ///< it does not know where it is: the person has to move the handle all the way out and in
  fault,   ///< it took the force away by itself and says why (`ForceLinkCounts::fault`); `rearm` clears it
  lost     ///< unplugged or reset; exchanges try to bring it back
};

/// One thread uses it, from opening to destruction. The destructor leaves the device without force.
class ForceDevice {
 public:
  virtual ~ForceDevice() = default;

  /// Sends a force and gives the newest reading; `fresh` is false where none came within the period.
  /// Never throws; a lost device gives no fresh reading until it is back.
  virtual ForceReading exchange(const ForceCommand& command) = 0;

  /// Time from a question to its answer, without force: nine of ten take no longer. None where the device has no link of its own, 0.1 s
  /// where it answers no sooner. Before the first `exchange`; takes a third of a second at most.
  virtual std::optional<double> measureRoundTrip_s() { return {}; }
  /// Another period. False where the device does not take it. Before the first `exchange`.
  virtual bool setPace(double /*period_s*/) { return true; }

  /// Longest silence of a device that runs the law by itself before it is commanded to give no force; 0: the host runs the law.
  virtual double longestUnheard_s() const { return 0; }

  /// Another button is under the finger. A device that runs the law itself takes it over some hundred exchanges, without force meanwhile,
  /// and its force rises from nothing. Not for every step: it may allocate.
  virtual void setProgram(const ForceProgram& /*program*/) {}

  /// A person wants force again after an emergency stop, a fault or a lost place: clears what the device itself holds against it. May
  /// wait a fifth of a second.
  virtual void rearm() {}

  virtual ForceDeviceState state() const { return ForceDeviceState::ready; }
  virtual ForceLinkCounts counts() const { return {}; }
};

}  // namespace detent::playback
