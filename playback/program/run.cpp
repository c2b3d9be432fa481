// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/run.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "model/program/command_line.h"
#include "model/version.h"
#include "playback/program/calibrate_command.h"
#include "playback/program/devices_command.h"
#include "playback/program/export_command.h"
#include "playback/program/force_command.h"
#include "playback/program/identify_command.h"
#include "playback/program/identify_device_command.h"
#include "playback/program/latency_command.h"
#include "playback/program/live_command.h"
#include "playback/program/magnetic_command.h"
#include "playback/program/page_command.h"
#include "playback/program/performance_command.h"
#include "playback/program/reference_command.h"
#include "playback/program/render_command.h"
#include "playback/program/sweep_command.h"
#include "playback/study/program/study_commands.h"

namespace detent::playback {

int run(int argc, char** argv, const Cancelled& cancelled) {
  CLI::App program{
      "Plays a button: force sensor in, vibration out. Displacement in mm, force in N, time in s."};
  program.name("detent-play");
  program.formatter(std::make_shared<PlainHelp<CLI::Formatter, CLI::Option>>());
  program.set_version_flag("--version", std::string("detent-play ") + version(),
                           "Print the version and exit");
  Action chosen;
  addLiveCommand(program, chosen);
  addRenderCommand(program, chosen);
  addPageCommand(program, chosen);
  addExportCommand(program, chosen);
  addReferenceCommand(program, chosen);
  addPerformanceCommand(program, chosen);
  addMagneticCommand(program, chosen);
  addDevicesCommand(program, chosen);
  addSweepCommand(program, chosen);
  addLatencyCommand(program, chosen);
  addCalibrateCommand(program, chosen);
  addStudyCommands(program, chosen);
  addForceCommand(program, chosen);
  addIdentifyCommand(program, chosen);
  addIdentifyDeviceCommand(program, chosen);
  program.require_subcommand(0, 1);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : static_cast<int>(FailureCode::wrongUsage);
  }
  return chosen(cancelled);
}

}  // namespace detent::playback
