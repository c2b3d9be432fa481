// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/reference_command.h"

#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "model/program/command_line.h"
#include "playback/interchange/reference_signal.h"
#include "playback/offline/press_files.h"
#include "playback/program/json_output.h"

namespace detent::playback {

namespace {

struct ReferenceArguments {
  std::string file, outputFile;
  bool json = false;
};

int runReference(const ReferenceArguments& a, const Cancelled& cancelled) {
  Result<ReferenceSignal> signal = readReference(a.file);
  if (!signal) return fail(signal.failure());
  if (cancelled && cancelled()) return fail(Failure::cancelled("reference"));
  if (!a.outputFile.empty())
    if (Result<Done> written = writeSoundFile(signal->samples, referenceRate_Hz, a.outputFile); !written)
      return fail(written.failure());
  const std::string format(referenceFormats.word(signal->format));
  std::fprintf(stderr, "%s: %s, %.3f s, peak %.3f of full scale\n", a.file.c_str(), format.c_str(),
               signal->duration_s(), signal->peak);
  Json notes = Json::array();
  for (const Message& note : signal->notes) {
    std::fprintf(stderr, "note: %s\n", english(note).c_str());
    notes.push_back(english(note));
  }
  if (a.json)
    print({{"status", "ok"},
           {"format", format},
           {"duration_s", signal->duration_s()},
           {"sample_rate_Hz", referenceRate_Hz},
           {"peak", signal->peak},
           {"events", signal->events},
           {"notes", notes}});
  return 0;
}

}  // namespace

void addReferenceCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "reference", "Describe a signal of another program (AHAP, .haptic, HJIF, WAV), or convert it to sound");
  const auto arguments = std::make_shared<ReferenceArguments>();
  app->add_option("FILE", arguments->file, "AHAP, .haptic, HJIF, or a sound file, recognised by content")
      ->required();
  app->add_option("-o,--output", arguments->outputFile,
                  "WAV or FLAC file to write, 48000 samples per second");
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runReference(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
