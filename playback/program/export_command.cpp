// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/export_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/program/command_line.h"
#include "playback/interchange/export_loss_json.h"
#include "playback/interchange/export_press.h"
#include "playback/offline/press_files.h"
#include "playback/offline/press_speed.h"
#include "playback/program/json_output.h"
#include "playback/program/shared_options.h"

namespace detent::playback {

namespace {

struct ExportArguments {
  std::string button, press = "standard", outputFile;
  FeelOptions feel;
  ExportSettings settings;
  bool json = false;
};

void addExportOptions(CLI::App& app, ExportArguments& a) {
  app.add_option("BUTTON", a.button, "*.button.json")->required();
  addChoice(app, "--format", a.settings.format, exportFormats,
            "Target format (docs/reference/export-formats.md)", "")
      ->required();
  app.add_option("--press", a.press,
                 "standard, human:120ms (a human-like press with a downstroke of 10 ms to 10 s), or a press "
                 "trace CSV")
      ->capture_default_str();
  app.add_option("-o,--output", a.outputFile,
                 "The file; ahap writes two, with .press and .release before the ending")
      ->required();
  app.add_option("--rate", a.settings.sampleRate_Hz, "Samples per second of pcm, 8000..192000")
      ->capture_default_str();
  app.add_option("--bits", a.settings.bits, "Bits per sample of pcm, 8 or 16")->capture_default_str();
  addFeelOptions(app, a.feel);
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

Result<PressTrace> pressOf(const std::string& press, const HapticProgram& program) {
  return namesPress(press) ? namedPress(press, program) : readPressTrace(press);
}

/// Warns if source code is written with an extension by which the including program cannot find it.
void warnOfEnding(ExportFormat format, const std::string& file) {
  const char* ending = nullptr;
  switch (format) {
    case ExportFormat::cHeader:
    case ExportFormat::bos1921:
    case ExportFormat::da728x:
    case ExportFormat::drv2605:
    case ExportFormat::pcm:
      ending = ".h";
      break;
    case ExportFormat::android:
      ending = ".kt";
      break;
    default:
      return;
  }
  if (std::filesystem::path(file).extension() != ending)
    std::fprintf(stderr, "warning: %s holds %s: give it the ending %s\n", file.c_str(),
                 format == ExportFormat::android ? "Kotlin" : "C", ending);
}

int runExport(const ExportArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileOf(a.feel.profileFile);
  if (!profile) return fail(profile.failure());
  Result<Button> button = readButtonFile(a.button);
  if (!button) return fail(button.failure());
  Result<PreparedProgram> prepared = prepareProgram(*button, *profile, a.feel.settings);
  if (!prepared) return fail(prepared.failure());
  for (const PrepareWarning& w : prepared->summary.warnings)
    std::fprintf(stderr, "warning: %s\n", english(w.message).c_str());
  Result<PressTrace> trace = pressOf(a.press, prepared->program);
  if (!trace) return fail(trace.failure());
  ExportSettings settings = a.settings;
  settings.pressName = pressInWords(a.press);
  settings.feel = a.feel.settings.feel;
  Result<PressedButton> felt = asPressed(*button, *prepared, *trace, *profile, a.feel.settings);
  if (!felt) return fail(felt.failure());
  tellSpeed(*button, felt->speed_mm_per_s);
  Result<Exported> exported = exportPress(felt->button, felt->prepared.program, *trace, settings);
  if (!exported) return fail(exported.failure());
  if (cancelled && cancelled()) return fail(Failure::cancelled("export"));
  Result<std::vector<std::string>> paths = writeExported(*exported, a.outputFile);
  if (!paths) return fail(paths.failure());
  for (const std::string& path : *paths) std::fprintf(stderr, "%s\n", path.c_str());
  warnOfEnding(settings.format, a.outputFile);
  for (const std::string& line : linesOf(exported->loss)) std::fprintf(stderr, "  %s\n", line.c_str());
  if (a.json) {
    Json json = {{"status", "ok"},
                 {"format", exportFormats.word(settings.format)},
                 {"outputs", *paths},
                 {"press", settings.pressName},
                 {"feel", feels.word(settings.feel)},
                 {"loss", jsonOf(exported->loss)}};
    if (felt->speed_mm_per_s) json["press_speed_mm_per_s"] = *felt->speed_mm_per_s;
    print(json);
  }
  return 0;
}

}  // namespace

void addExportCommand(CLI::App& program, Action& chosen) {
  CLI::App* app =
      program.add_subcommand("export", "Export a press for phones, headsets, driver chips and touchpads");
  const auto arguments = std::make_shared<ExportArguments>();
  addExportOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runExport(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
