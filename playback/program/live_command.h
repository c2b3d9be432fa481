// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// `detent-play BUTTON`: press and feel. It is the root command, so it has no name of its own.

#include <optional>
#include <string>
#include <vector>

#include "playback/program/endpoint.h"
#include "playback/program/shared_options.h"

namespace detent::playback {

struct LiveArguments {
  std::vector<std::string> buttons;
  FeelOptions feel;
  PlayerSettings player;
  SensorOptions sensor;
  std::optional<Endpoint> udp, osc;  ///< none: closed
  std::optional<Endpoint> signalTarget;
  std::string pressFile;
  double fingerPeak_N = 0;  ///< 0: a quarter more than the button needs
  double gain = 1;
  double seconds = 0;  ///< 0: until q or Ctrl-C
  bool json = false;
};

/// Runs if the command line names no other command.
void addLiveCommand(CLI::App& program, Action& chosen);

/// The live view (live_view.cpp; in builds without devices it reports that).
int runLive(const LiveArguments& arguments, const std::vector<Button>& buttons, const DeviceProfile& profile,
            const Cancelled& cancelled);

}  // namespace detent::playback
