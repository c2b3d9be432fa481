// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/sweep_command.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/text_file.h"
#include "playback/measurement/profile_file.h"
#include "playback/measurement/sweep.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/program/shared_options.h"
#include "playback/program/xy_plot.h"

namespace detent::playback {

namespace {

struct SweepArguments {
  PlayerSettings player;
  std::string inputDevice;
  std::string outputFile, plotFile, csvFile;
  SweepSettings sweep;
  double inputFullScale_m_per_s2 = 0;
  bool json = false;
};

constexpr std::size_t mostRuns = 8;

void addSweepOptions(CLI::App& app, SweepArguments& a) {
  addDeviceOptions(app, a.player);
  app.add_option("--input", a.inputDevice, "Accelerometer or microphone; default: the device's own input");
  app.add_option("-o,--output", a.outputFile, "Device profile to write; an existing one keeps its sensor")
      ->required();
  app.add_option("--plot", a.plotFile, "Response as SVG");
  app.add_option("--csv", a.csvFile, "Response as CSV");
  app.add_option("--from-hz", a.sweep.from_Hz, "Lowest frequency in Hz")
      ->capture_default_str()
      ->check(numberWithin(1, 96000));
  app.add_option("--to-hz", a.sweep.to_Hz, "Highest frequency in Hz")
      ->capture_default_str()
      ->check(numberWithin(1, 96000));
  app.add_option("--seconds", a.sweep.duration_s, "Length of the sweep in s")
      ->capture_default_str()
      ->check(numberWithin(0.5, 120));
  app.add_option("--level", a.sweep.level, "Share of full scale")
      ->capture_default_str()
      ->check(numberWithin(0.001, 1));
  app.add_option("--input-full-scale", a.inputFullScale_m_per_s2,
                 "Acceleration at the input's full scale, m/s2; the profile then has levels in dB above a "
                 "fingertip's threshold")
      ->check(numberWithin(0.001, 1e6));
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

XyPlot responsePlot(const FrequencyResponse& response, const std::string& title) {
  XyPlot plot{title, "frequency [Hz]", "gain [dB]", {}, {{"", "#1f5fa8", {}}}, XScale::decades, {}};
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i)
    plot.lines[0].points.push_back({response.frequency_Hz[i], response.gain_dB[i]});
  for (const Resonance& peak : response.resonances) {
    char name[32];
    std::snprintf(name, sizeof name, "%.0f Hz", peak.frequency_Hz);
    plot.marks.push_back({peak.frequency_Hz, name});
  }
  return plot;
}

/// The device's own rate; if the device is not found, a common rate (playing will then report the failure).
double ownRateOf(const std::string& device) {
  constexpr double usual_Hz = 48000;
  const Result<std::vector<SoundDevice>> devices = listSoundDevices();
  if (!devices) return usual_Hz;
  for (const SoundDevice& d : *devices) {
    const bool meant = device.empty() ? d.defaultOutput : d.name.find(device) != std::string::npos;
    if (meant && d.outputChannels > 0) return d.sampleRate_Hz;
  }
  return usual_Hz;
}

/// Description of dropouts in a run, for the user; empty if there were none.
std::string lostIn(const SoundRecording& recorded, const FrequencyResponse& response) {
  if (recorded.dropouts > 0)
    return "the sound system lost " + std::to_string(recorded.dropouts) +
           (recorded.dropouts == 1 ? " block" : " blocks");
  if (response.dropouts_s.empty()) return {};
  char text[80];
  std::snprintf(text, sizeof text, "sound is missing at %.2f s", response.dropouts_s.front());
  return text + (response.dropouts_s.size() > 1
                     ? " and " + std::to_string(response.dropouts_s.size() - 1) + " more places"
                     : std::string());
}

/// A single sweep is unreliable on a busy machine, because a dropout resembles a resonance. Two sweeps
/// without dropouts that agree are accepted.
Result<FrequencyResponse> measureUntilTwoAgree(const SweepArguments& a, const PlayerSettings& player,
                                               const SweepSettings& settings, const Cancelled& cancelled) {
  const std::vector<float> played = sweepSignal(settings);
  std::vector<FrequencyResponse> runs;
  for (std::size_t runSweep = 1; runSweep <= mostRuns; ++runSweep) {
    std::fprintf(stderr, "Run %zu: playing %.0f s from %.0f to %.0f Hz at %.0f samples per second ...\n",
                 runSweep, settings.duration_s, settings.from_Hz, settings.to_Hz, settings.sampleRate_Hz);
    Result<SoundRecording> recorded = playAndRecordSamples(player, a.inputDevice, played, cancelled);
    if (!recorded) return recorded.failure();
    Result<FrequencyResponse> response = analyseSweep(played, recorded->samples, settings);
    if (!response) return response.failure();
    if (const std::string lost = lostIn(*recorded, *response); !lost.empty()) {
      std::fprintf(stderr, "Run %zu does not count: %s\n", runSweep, lost.c_str());
      continue;
    }
    for (const FrequencyResponse& before : runs) {
      if (agree(before, *response)) return response;
    }
    runs.push_back(*std::move(response));
  }
  return Failure{
      FailureCode::notCertain, "sweep", "",
      "no two of " + std::to_string(mostRuns) + " runs are whole and agree; nothing was written",
      "Close other programs, enlarge the sound server's buffer, fix the device so that nothing rattles"};
}

int runSweep(const SweepArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileToExtend(a.outputFile);
  if (!profile) return fail(profile.failure());
  SweepSettings settings = a.sweep;
  settings.sampleRate_Hz = a.player.sampleRate_Hz > 0 ? a.player.sampleRate_Hz : ownRateOf(a.player.device);
  if (settings.to_Hz >= settings.sampleRate_Hz / 2 || settings.from_Hz >= settings.to_Hz) {
    return fail({FailureCode::wrongUsage, "sweep", "", "the range does not fit the sample rate",
                 "Choose 0 < from < to < rate / 2"});
  }
  PlayerSettings player = a.player;
  player.sampleRate_Hz = settings.sampleRate_Hz;
  Result<FrequencyResponse> response = measureUntilTwoAgree(a, player, settings, cancelled);
  if (!response) return fail(response.failure());
  applyResponse(*response, settings, *profile);
  if (a.inputFullScale_m_per_s2 > 0) {
    profile->fullScale_dB = fullScaleLevel_dB(*response, settings, a.inputFullScale_m_per_s2);
    std::fprintf(stderr,
                 "full scale at 250 Hz beside the resonances: %.1f dB above a fingertip's threshold\n",
                 *profile->fullScale_dB);
  }
  if (profile->name.empty()) profile->name = a.player.device;
  if (Result<Done> w = writeDeviceProfile(*profile, a.outputFile); !w) return fail(w.failure());
  if (!a.csvFile.empty()) {
    if (Result<Done> w = writeTextFileAtomically(a.csvFile, responseCsv(*response)); !w)
      return fail(w.failure());
  }
  if (!a.plotFile.empty()) {
    if (Result<Done> w = writeTextFileAtomically(a.plotFile, svgOf({responsePlot(*response, profile->name)}));
        !w)
      return fail(w.failure());
  }
  Json peaks = Json::array();
  for (std::size_t i = 0; i < response->resonances.size(); ++i) {
    const Resonance& r = response->resonances[i];
    Json peak{{"frequency_Hz", r.frequency_Hz}, {"q", r.q}, {"gain_dB", r.gain_dB}};
    if (response->errors.empty()) {
      std::fprintf(stderr, "resonance %.1f Hz, Q %.1f, %.1f dB above the median\n", r.frequency_Hz, r.q,
                   r.gain_dB);
    } else {
      const ResonanceErrors& e = response->errors[i];
      std::fprintf(stderr,
                   "resonance %.2f Hz (+- %.2g), Q %.2f (+- %.2g), %.2f dB (+- %.2g) above the rest\n",
                   r.frequency_Hz, e.frequency_Hz, r.q, e.q, r.gain_dB, e.gain_dB);
      peak["sigma_frequency_Hz"] = e.frequency_Hz, peak["sigma_q"] = e.q, peak["sigma_gain_dB"] = e.gain_dB;
    }
    peaks.push_back(std::move(peak));
  }
  if (response->errors.empty() && !response->resonances.empty())
    std::fprintf(stderr,
                 "the response is no sum of such resonances: each was measured alone, without an error\n");
  if (response->resonances.empty())
    std::fprintf(stderr, "no resonance: the response is flat within %.0f dB\n",
                 settings.resonanceProminence_dB);
  if (a.json)
    print({{"status", "ok"},
           {"profile", a.outputFile},
           {"resonances", peaks},
           {"delay_s", response->delay_s},
           {"full_scale_dB", profile->fullScale_dB ? Json(*profile->fullScale_dB) : Json(nullptr)}});
  return 0;
}

}  // namespace

void addSweepCommand(CLI::App& program, Action& chosen) {
  CLI::App* app =
      program.add_subcommand("sweep", "Measure a device's frequency response and write its profile");
  const auto arguments = std::make_shared<SweepArguments>();
  addSweepOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runSweep(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
