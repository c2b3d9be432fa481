// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The command line of detent-play as a plain struct.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "playback/playback.h"
#include "playback/study/calibrate.h"
#include "playback/study/sweep.h"

namespace detent::playback {

enum class Command { live, render, devices, sweep, latency, calibrate };

struct Arguments {
  Command command = Command::live;
  std::vector<std::string> buttons;
  PlaybackSettings settings;
  std::optional<EventPlacement> placement;
  std::string profileFile;
  PlayerSettings player;
  double gain = 1;
  bool json = false;

  // live
  std::string sensorPort;
  unsigned baud = 230400;
  int udpPort = -1, oscPort = -1;
  std::string signalTarget;  ///< HOST:PORT
  double fingerPeak_N = 0;   ///< 0: a quarter more than the button needs
  double seconds = 0;        ///< 0: until q or Ctrl-C

  // live and render
  std::string pressFile;

  // render
  bool standardPress = false;
  std::string outputFile;
  std::string eventsFile;
  double sampleRate_Hz = 48000;

  // sweep, latency
  std::string inputDevice;
  std::string plotFile, csvFile;
  SweepSettings sweep;
  std::size_t trials = 50;
  double sensorRate_Hz = 425;
  double threshold = 0;

  // calibrate
  std::string weightsFile;
  CalibrationSettings calibration;
};

/// Either arguments, or the exit code of a finished parse (0 after --help, 2 after a wrong use that was
/// explained).
struct ParsedArguments {
  std::optional<Arguments> arguments;
  int exitCode = 0;
};
ParsedArguments parseArguments(int argc, char** argv);

}  // namespace detent::playback
