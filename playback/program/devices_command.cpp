// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/devices_command.h"

#include <cstdio>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

#include "playback/playback.h"
#include "playback/program/json_output.h"

namespace detent::playback {

namespace {

int runDevices(bool json) {
  Result<std::vector<SoundDevice>> devices = listSoundDevices();
  if (!devices) return fail(devices.failure());
  Json list = Json::array();
  for (const SoundDevice& d : *devices) {
    list.push_back({{"name", d.name},
                    {"outputs", d.outputChannels},
                    {"inputs", d.inputChannels},
                    {"sample_rate_Hz", d.sampleRate_Hz},
                    {"default_output", d.defaultOutput},
                    {"default_input", d.defaultInput}});
    if (!json) {
      std::printf("%-50s %3d out %3d in %7.0f Hz%s%s\n", d.name.c_str(), d.outputChannels, d.inputChannels,
                  d.sampleRate_Hz, d.defaultOutput ? "  default output" : "",
                  d.defaultInput ? "  default input" : "");
    }
  }
  if (json) print({{"status", "ok"}, {"devices", list}});
  if (devices->empty()) {
    return fail({FailureCode::deviceTrouble, "sound devices", "", "none is there",
                 "Connect a sound device, or start a JACK server"});
  }
  return 0;
}

}  // namespace

void addDevicesCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand("devices", "List sound devices");
  const auto json = std::make_shared<bool>(false);
  app->add_flag("--json", *json, "One JSON object on stdout");
  app->callback([&chosen, json] { chosen = [json](const Cancelled&) { return runDevices(*json); }; });
}

}  // namespace detent::playback
