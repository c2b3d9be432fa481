// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/render_command.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "model/program/command_line.h"
#include "playback/measurement/exact_number.h"
#include "playback/offline/press_speed.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/felt_level.h"
#include "playback/program/json_output.h"
#include "playback/program/shared_options.h"

namespace detent::playback {

namespace {

constexpr auto formats = named<SampleFormat>(
    {{"16", SampleFormat::bits16}, {"24", SampleFormat::bits24}, {"float", SampleFormat::float32}});

struct RenderArguments {
  std::string button;
  FeelOptions feel;
  std::string pressFile;
  bool standardPress = false;
  std::string outputFile, eventsFile;
  double sampleRate_Hz = 48000;
  SampleFormat format = SampleFormat::standard;
  bool json = false;
};

void addRenderOptions(CLI::App& app, RenderArguments& a) {
  app.add_option("BUTTON", a.button, "*.button.json")->required();
  auto* press =
      app.add_option("--press", a.pressFile, "Press trace CSV: time_s,force_N or time_s,displacement_mm");
  app.add_flag("--standard-press", a.standardPress, "Instead of a trace: a human-like press of 0.3 s")
      ->excludes(press);
  app.add_option("-o,--output", a.outputFile, "*.wav or *.flac")->required();
  addChoice(app, "--bits", a.format, formats, "Samples: 16 or 24 bit, or 32 bit float (WAV only)",
            "float; 24 in a FLAC");
  app.add_option("--events", a.eventsFile, "Also write the events as CSV");
  app.add_option("--rate", a.sampleRate_Hz, "Samples per second, 8000..192000")->capture_default_str();
  addFeelOptions(app, a.feel);
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

const char* eventName(EventKind kind) {
  switch (kind) {
    case EventKind::grain:
      return "grain";
    case EventKind::pressJump:
      return "press_jump";
    case EventKind::releaseJump:
      return "release_jump";
    case EventKind::bottomOut:
      return "bottom_out";
    case EventKind::contactClosed:
      return "contact_closed";
    case EventKind::contactOpened:
      return "contact_opened";
    case EventKind::trigger:
      break;
  }
  return "trigger";
}

std::string eventsCsv(const std::vector<EngineEvent>& events, double sampleRate_Hz) {
  std::string text = "time_s,event,state,jump,grains,displacement_mm\n";
  for (const EngineEvent& e : events) {
    text += exact(static_cast<double>(e.frame) / sampleRate_Hz) + "," + eventName(e.kind) + "," +
            std::to_string(e.state) + "," + std::to_string(e.jump) + "," +
            std::to_string(e.kind == EventKind::grain ? e.count : 0) + "," + exact(e.displacement_mm) + "\n";
  }
  return text;
}

void warnOfSize(const ExpectedSize& size) {
  constexpr double muchTime_s = 600, muchSpace_bytes = 1e9;
  if (size.duration_s <= muchTime_s && size.bytes <= muchSpace_bytes) return;
  std::fprintf(stderr,
               "warning: the press lasts %.3g minutes, the file will have up to %.3g GB; Ctrl-C stops\n",
               size.duration_s / 60, size.bytes / 1e9);
}

int runRender(const RenderArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileOf(a.feel.profileFile);
  if (!profile) return fail(profile.failure());
  Result<Button> button = readButtonFile(a.button);
  if (!button) return fail(button.failure());
  Result<PreparedProgram> prepared = prepareProgram(*button, *profile, a.feel.settings);
  if (!prepared) return fail(prepared.failure());
  Json warnings = Json::array(), warningCodes = Json::array();
  for (const PrepareWarning& w : prepared->summary.warnings) {
    const std::string words = english(w.message);
    std::fprintf(stderr, "warning: %s\n", words.c_str());
    warnings.push_back(words);
    warningCodes.push_back(nameOf(w.code));
  }
  Result<PressTrace> trace =
      a.standardPress ? Result<PressTrace>(standardPress(prepared->program)) : readPressTrace(a.pressFile);
  if (!trace) return fail(trace.failure());
  Result<PressedButton> felt = asPressed(*button, *prepared, *trace, *profile, a.feel.settings);
  if (!felt) return fail(felt.failure());
  prepared = felt->prepared;
  const std::optional<double> speed = felt->speed_mm_per_s;
  tellSpeed(*button, speed);
  RenderSettings settings;
  settings.sampleRate_Hz = a.sampleRate_Hz;
  settings.format = a.format;
  settings.cancelled = cancelled;
  if (Result<Done> ok = checkRendering(*trace, settings); !ok) return fail(ok.failure());
  warnOfSize(expectedSize(*trace, settings, a.outputFile));
  Result<RenderSummary> summary = renderPressToFile(prepared->program, *trace, settings, a.outputFile);
  if (!summary) return fail(summary.failure());
  if (!a.eventsFile.empty()) {
    if (Result<Done> w = writeTextFileAtomically(a.eventsFile, eventsCsv(summary->events, a.sampleRate_Hz));
        !w)
      return fail(w.failure());
  }
  const ConditionerCounts& c = summary->sensor;
  const auto rejected = c.notFinite + c.outOfRange + c.outOfOrder + c.glitches;
  if (rejected > 0) {
    std::fprintf(
        stderr,
        "warning: %llu of %zu readings were left out (no number, out of range or order, or a glitch)\n",
        static_cast<unsigned long long>(rejected), trace->readings.size());
  }
  if (std::isfinite(summary->felt_dB)) {
    std::fprintf(stderr, "felt: strongest 10 ms %.0f dB above threshold, on a device %s\n", summary->felt_dB,
                 profile->fullScale_dB ? "as measured" : "whose level nobody measured (45 dB assumed)");
  }
  const EngineCounts& n = summary->counts;
  std::fprintf(stderr,
               "%s\n%s: %.3f s, peak %.3f, %llu grains, %llu press jumps, %llu release jumps, %llu "
               "bottom-outs, %.0f x real time\n",
               prepared->summary.line().c_str(), a.outputFile.c_str(), summary->duration_s,
               static_cast<double>(summary->peak), static_cast<unsigned long long>(n.grains),
               static_cast<unsigned long long>(n.pressJumps), static_cast<unsigned long long>(n.releaseJumps),
               static_cast<unsigned long long>(n.bottomOuts), summary->timesRealTime());
  if (a.json) {
    Json json = {{"status", "ok"},
                 {"output", a.outputFile},
                 {"sample_rate_Hz", a.sampleRate_Hz},
                 {"duration_s", summary->duration_s},
                 {"peak", summary->peak},
                 {"felt_dB", std::isfinite(summary->felt_dB) ? Json(summary->felt_dB) : Json(nullptr)},
                 {"full_scale_dB", fullScale_dB(*profile)},
                 {"full_scale_measured", profile->fullScale_dB.has_value()},
                 {"grains", n.grains},
                 {"press_jumps", n.pressJumps},
                 {"release_jumps", n.releaseJumps},
                 {"bottom_outs", n.bottomOuts},
                 {"suppressed", n.suppressed},
                 {"rejected_readings", rejected},
                 {"table_error_N", prepared->summary.tableError_N},
                 {"warnings", warnings},
                 {"warning_codes", warningCodes},
                 {"times_real_time", summary->timesRealTime()}};
    if (speed) json["press_speed_mm_per_s"] = *speed;
    print(json);
  }
  return 0;
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& chosen) {
  CLI::App* app =
      program.add_subcommand("render", "Render a press to a sound file, sample for sample as live playback");
  const auto arguments = std::make_shared<RenderArguments>();
  addRenderOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    if (arguments->pressFile.empty() && !arguments->standardPress)
      throw CLI::RequiredError("--press or --standard-press");
    chosen = [arguments](const Cancelled& cancelled) { return runRender(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
