// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a person at the live view should know before anything else, one clear sentence each.

#include <array>
#include <string>
#include <vector>

#include "model/button.h"
#include "playback/playback.h"
#include "playback/program/live_command.h"

namespace detent::playback {

/// What the command line asks for that this button or device cannot give.
std::vector<std::string> doubtsAbout(const LiveArguments& arguments, const Button& button,
                                     const DeviceProfile& profile, const PreparedProgram& program);

/// Watches a player's status from one look to the next. One owner.
class LiveWarnings {
 public:
  /// `calibrated`: the profile says what the sensor's counts are in newtons.
  explicit LiveWarnings(bool calibrated) : calibrated_(calibrated) {}

  /// Looks at the status; gives what is new, most urgent first.
  std::vector<std::string> look(const PlayerStatus& status, double now_s);
  /// The most urgent thing that is wrong right now, in capitals for a status line; empty: nothing.
  const std::string& mostUrgent() const { return mostUrgent_; }

 private:
  static constexpr std::size_t kinds = 12;

  struct Watch {
    bool active = false;
    double until_s = -1, told_s = -1e9;
    std::uint64_t seen = 0, told = 0;
  };
  struct Finding;

  std::vector<Finding> findingsIn(const PlayerStatus& status, double now_s);

  bool calibrated_;
  std::array<Watch, kinds> watches_;
  double rateSince_s_ = -1, messageRate_Hz_ = 0;
  std::uint64_t messagesThen_ = 0;
  std::string mostUrgent_;
};

}  // namespace detent::playback
