// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Warnings that a person at the live view should see first: codes with values, and one clear sentence for
// each.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/message.h"
#include "playback/playback.h"
#include "playback/program/live_command.h"

namespace detent::playback {

/// Most urgent first.
enum class LiveWarningCode : std::uint8_t {
  deviceLost,
  sensorUnplugged,
  sensorSilent,
  sensorStuck,
  countsNotNewtons,
  xruns,
  readingsDropped,
  eventsDropped,
  readingsRejected,
  badLines,
  clipping,
  forcesTooRare
};
inline constexpr std::size_t liveWarningCodes = 12;

/// A condition that has just begun, or a count that has increased.
struct LiveWarning {
  LiveWarningCode code;
  std::uint64_t count = 0;  ///< increase since the last report; 0: a condition without a count
};

/// "sensor-unplugged": as scripts see it.
const char* nameOf(LiveWarningCode code);
/// Title in capitals, for a status line.
const char* titleOf(LiveWarningCode code);
Message messageOf(const LiveWarning& warning);

/// Requests of the command line that this button or device cannot fulfil.
std::vector<Message> doubtsAbout(const LiveArguments& arguments, const Button& button,
                                 const DeviceProfile& profile, const PreparedProgram& program);

/// Compares a player's status with the previous one. One owner.
class LiveWarnings {
 public:
  /// `calibrated`: the profile says what the sensor's counts are in newtons.
  explicit LiveWarnings(bool calibrated) : calibrated_(calibrated) {}

  /// Reads the status; returns new warnings, most urgent first.
  std::vector<LiveWarning> update(const PlayerStatus& status, double now_s);
  /// The most urgent present warning.
  std::optional<LiveWarningCode> mostUrgent() const { return mostUrgent_; }

 private:
  struct Watch {
    bool active = false;
    double until_s = -1, reported_s = -1e9;
    std::uint64_t seen = 0, reported = 0;
  };
  using Values = std::array<std::uint64_t, liveWarningCodes>;  // counts; 1 for a condition that is present

  Values valuesIn(const PlayerStatus& status, double now_s);
  std::optional<LiveWarning> newsOf(LiveWarningCode code, std::uint64_t value, double now_s);

  bool calibrated_;
  std::array<Watch, liveWarningCodes> watches_;
  double rateSince_s_ = -1, messageRate_Hz_ = 0;
  std::uint64_t messagesThen_ = 0;
  std::optional<LiveWarningCode> mostUrgent_;
};

}  // namespace detent::playback
