// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/run.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <locale>
#include <sstream>

#include <nlohmann/json.hpp>

#include "model/file/button_file.h"
#include "playback/study/latency_statistics.h"
#include "playback/study/profile_file.h"
#include "playback/study/text_output.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr int histogramBins = 12;
constexpr double weighing_s = 1.0;

const char* nameOf(EventKind kind) {
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

void print(const Json& json) { std::cout << json.dump() << "\n"; }

Result<DeviceProfile> profileOf(const std::string& file) {
  if (file.empty()) return DeviceProfile{};
  return readDeviceProfile(file);
}

/// An existing profile is added to; a broken one is not overwritten.
Result<DeviceProfile> profileToExtend(const std::string& file) {
  if (!std::ifstream(file)) return DeviceProfile{};
  return readDeviceProfile(file);
}

std::string eventsCsv(const std::vector<EngineEvent>& events, double sampleRate_Hz) {
  std::string text = "time_s,event,state,jump,grains,displacement_mm\n";
  for (const EngineEvent& e : events) {
    text += exact(static_cast<double>(e.frame) / sampleRate_Hz) + "," + nameOf(e.kind) + "," +
            std::to_string(e.state) + "," + std::to_string(e.jump) + "," +
            std::to_string(e.kind == EventKind::grain ? e.count : 0) + "," + exact(e.displacement_mm) + "\n";
  }
  return text;
}

int runRender(const Arguments& a, const Button& button, const DeviceProfile& profile,
              const Cancelled& cancelled) {
  Result<PreparedProgram> prepared = prepareProgram(button, profile, a.settings);
  if (!prepared) return fail(prepared.failure());
  for (const std::string& w : prepared->summary.warnings) std::fprintf(stderr, "warning: %s\n", w.c_str());
  prepared->program.gain *= a.gain;
  Result<PressTrace> trace =
      a.standardPress ? Result<PressTrace>(standardPress(prepared->program)) : readPressTrace(a.pressFile);
  if (!trace) return fail(trace.failure());
  RenderSettings settings;
  settings.sampleRate_Hz = a.sampleRate_Hz;
  settings.cancelled = cancelled;
  Result<RenderSummary> summary = renderPressToFile(prepared->program, *trace, settings, a.outputFile);
  if (!summary) return fail(summary.failure());
  if (!a.eventsFile.empty()) {
    if (Result<Done> w = writeWholeFile(a.eventsFile, eventsCsv(summary->events, a.sampleRate_Hz)); !w)
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
  const EngineCounts& n = summary->counts;
  std::fprintf(stderr,
               "%s\n%s: %.3f s, peak %.3f, %llu grains, %llu press jumps, %llu release jumps, %llu "
               "bottom-outs, %.0f x real time\n",
               prepared->summary.line().c_str(), a.outputFile.c_str(), summary->duration_s,
               static_cast<double>(summary->peak), static_cast<unsigned long long>(n.grains),
               static_cast<unsigned long long>(n.pressJumps), static_cast<unsigned long long>(n.releaseJumps),
               static_cast<unsigned long long>(n.bottomOuts), summary->timesRealTime());
  if (a.json) {
    print({{"status", "ok"},
           {"output", a.outputFile},
           {"sample_rate_Hz", a.sampleRate_Hz},
           {"duration_s", summary->duration_s},
           {"peak", summary->peak},
           {"grains", n.grains},
           {"press_jumps", n.pressJumps},
           {"release_jumps", n.releaseJumps},
           {"bottom_outs", n.bottomOuts},
           {"suppressed", n.suppressed},
           {"rejected_readings", rejected},
           {"table_error_N", prepared->summary.tableError_N},
           {"warnings", prepared->summary.warnings},
           {"times_real_time", summary->timesRealTime()}});
  }
  return 0;
}

int runDevices(const Arguments& a) {
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
    if (!a.json) {
      std::printf("%-50s %3d out %3d in %7.0f Hz%s%s\n", d.name.c_str(), d.outputChannels, d.inputChannels,
                  d.sampleRate_Hz, d.defaultOutput ? "  default output" : "",
                  d.defaultInput ? "  default input" : "");
    }
  }
  if (a.json) print({{"status", "ok"}, {"devices", list}});
  if (devices->empty()) {
    return fail({FailureCode::deviceTrouble, "sound devices", "", "none is there",
                 "Connect one, or start a JACK server"});
  }
  return 0;
}

int runSweep(const Arguments& a) {
  Result<DeviceProfile> profile = profileToExtend(a.outputFile);
  if (!profile) return fail(profile.failure());
  SweepSettings settings = a.sweep;
  settings.sampleRate_Hz = a.player.sampleRate_Hz > 0 ? a.player.sampleRate_Hz : 48000;
  if (settings.to_Hz >= settings.sampleRate_Hz / 2 || settings.from_Hz >= settings.to_Hz) {
    return fail({FailureCode::wrongUsage, "sweep", "", "the range does not fit the sample rate",
                 "Choose 0 < from < to < rate / 2"});
  }
  PlayerSettings player = a.player;
  player.sampleRate_Hz = settings.sampleRate_Hz;
  std::fprintf(stderr, "Playing %.0f s from %.0f to %.0f Hz ...\n", settings.duration_s, settings.from_Hz,
               settings.to_Hz);
  const std::vector<float> played = sweepSignal(settings);
  Result<std::vector<float>> recorded = playAndRecordSamples(player, a.inputDevice, played);
  if (!recorded) return fail(recorded.failure());
  Result<FrequencyResponse> response = analyseSweep(played, *recorded, settings);
  if (!response) return fail(response.failure());
  applyResponse(*response, settings, *profile);
  if (profile->name.empty()) profile->name = a.player.device;
  if (Result<Done> w = writeDeviceProfile(*profile, a.outputFile); !w) return fail(w.failure());
  if (!a.csvFile.empty()) {
    if (Result<Done> w = writeWholeFile(a.csvFile, responseCsv(*response)); !w) return fail(w.failure());
  }
  if (!a.plotFile.empty()) {
    if (Result<Done> w = writeWholeFile(a.plotFile, responseSvg(*response, profile->name)); !w)
      return fail(w.failure());
  }
  Json peaks = Json::array();
  for (const Resonance& r : response->resonances) {
    std::fprintf(stderr, "resonance %.1f Hz, Q %.1f, %.1f dB above the median\n", r.frequency_Hz, r.q,
                 r.gain_dB);
    peaks.push_back({{"frequency_Hz", r.frequency_Hz}, {"q", r.q}, {"gain_dB", r.gain_dB}});
  }
  if (response->resonances.empty())
    std::fprintf(stderr, "no resonance: the response is flat within %.0f dB\n",
                 settings.resonanceProminence_dB);
  if (a.json)
    print(
        {{"status", "ok"}, {"profile", a.outputFile}, {"resonances", peaks}, {"delay_s", response->delay_s}});
  return 0;
}

int runLatency(const Arguments& a, const DeviceProfile& profile, const Cancelled& cancelled) {
  LatencySettings settings;
  settings.player = a.player;
  settings.inputDevice = a.inputDevice;
  settings.trials = a.trials;
  settings.placement = a.settings.placement;
  settings.sensorRate_Hz = a.sensorRate_Hz;
  settings.sensorPort = a.sensorPort;
  settings.baud = a.baud;
  settings.calibration = profile.sensor;
  settings.threshold = a.threshold;
  if (!a.sensorPort.empty())
    std::fprintf(stderr, "Tap the sensor %zu times, firmly and briefly.\n", a.trials);
  Result<LatencyResult> result = measureLatency(settings, [&](std::size_t done, std::size_t all) {
    std::fprintf(stderr, "\r%zu of %zu", done, all);
    return !cancelled();
  });
  std::fprintf(stderr, "\r");
  if (!result) return fail(result.failure());
  const LatencyStatistics s = statisticsOf(result->delays_s, result->lost);
  if (s.n == 0) {
    return fail({FailureCode::deviceTrouble, result->device, "", "no vibration came back on the input",
                 "Lead the output to the input, or name the input with --input"});
  }
  std::fprintf(
      stderr,
      "%s: mean %.3f ms (N = %zu, SD = %.3f), median %.3f, 5 %% %.3f, 95 %% %.3f, 99 %% %.3f, lost %zu\n%s",
      result->device.c_str(), 1e3 * s.mean_s, s.n, 1e3 * s.sd_s, 1e3 * s.median_s, 1e3 * s.p5_s,
      1e3 * s.p95_s, 1e3 * s.p99_s, s.lost, histogram(s, histogramBins).c_str());
  if (!a.csvFile.empty()) {
    if (Result<Done> w = writeWholeFile(a.csvFile, latencyCsv(s)); !w) return fail(w.failure());
  }
  if (!a.outputFile.empty()) {
    Result<DeviceProfile> extended = profileToExtend(a.outputFile);
    if (!extended) return fail(extended.failure());
    extended->latency = s.forProfile();
    if (Result<Done> w = writeDeviceProfile(*extended, a.outputFile); !w) return fail(w.failure());
  }
  if (a.json) {
    print({{"status", "ok"},
           {"device", result->device},
           {"n", s.n},
           {"lost", s.lost},
           {"mean_s", s.mean_s},
           {"sd_s", s.sd_s},
           {"median_s", s.median_s},
           {"p5_s", s.p5_s},
           {"p95_s", s.p95_s},
           {"p99_s", s.p99_s},
           {"min_s", s.min_s},
           {"max_s", s.max_s}});
  }
  return 0;
}

/// Weights from the person at the terminal: one mass in grams per line, an empty line or the end of input
/// ends.
Result<std::vector<KnownWeight>> askForWeights(const Arguments& a, const Cancelled& cancelled) {
  std::vector<KnownWeight> weights;
  std::fprintf(stderr, "Lay a weight on the sensor, type its mass in g, Enter. An empty line ends.\n");
  for (std::string line; !cancelled() && std::getline(std::cin, line) && !line.empty();) {
    KnownWeight w;
    std::istringstream text(line);
    text.imbue(std::locale::classic());
    if (!(text >> w.force_N)) {
      std::fprintf(stderr, "no number\n");
      continue;
    }
    w.force_N *= 1e-3 * standardGravity_m_per_s2;
    Result<RawReading> raw = readRawSensor(a.sensorPort, a.baud, weighing_s);
    if (!raw) return raw.failure();
    w.raw = raw->mean;
    std::fprintf(stderr, "%.4f N: %.2f, SD %.2f over %zu readings\n", w.force_N, raw->mean, raw->sd, raw->n);
    weights.push_back(w);
  }
  return weights;
}

int runCalibrate(const Arguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileToExtend(a.outputFile);
  if (!profile) return fail(profile.failure());
  Result<std::vector<KnownWeight>> weights = std::vector<KnownWeight>{};
  if (a.weightsFile.empty()) {
    weights = askForWeights(a, cancelled);
  } else {
    std::ifstream in(a.weightsFile, std::ios::binary);
    if (!in)
      return fail(
          {FailureCode::unreadableInput, a.weightsFile, "", "cannot be read", "Give a CSV of known weights"});
    std::ostringstream text;
    text << in.rdbuf();
    weights = parseWeights(text.str(), a.weightsFile);
  }
  if (!weights) return fail(weights.failure());
  Result<SensorCalibration> calibration = calibrate(*weights, a.calibration);
  if (!calibration) return fail(calibration.failure());
  profile->sensor = *calibration;
  if (Result<Done> w = writeDeviceProfile(*profile, a.outputFile); !w) return fail(w.failure());
  Json coefficients = Json::array(), errors = Json::array();
  for (std::size_t i = 0; i < calibration->coefficientCount; ++i) {
    std::fprintf(stderr, "c%zu = %.6g +- %.2g\n", i, calibration->coefficients[i],
                 calibration->standardErrors[i]);
    coefficients.push_back(calibration->coefficients[i]);
    errors.push_back(calibration->standardErrors[i]);
  }
  std::fprintf(stderr, "residual %.4f N over %.3g to %.3g N, %zu weights\n", calibration->residual_N,
               calibration->lowest_N, calibration->highest_N, calibration->weights);
  if (a.json) {
    print({{"status", "ok"},
           {"profile", a.outputFile},
           {"coefficients", coefficients},
           {"standard_errors", errors},
           {"residual_N", calibration->residual_N},
           {"weights", calibration->weights}});
  }
  return 0;
}

}  // namespace

int fail(const Failure& failure) {
  std::fprintf(stderr, "detent-play: %s\n", failure.sentence().c_str());
  return failure.exitCode();
}

int run(const Arguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileOf(a.profileFile);
  if (!profile) return fail(profile.failure());
  switch (a.command) {
    case Command::devices:
      return runDevices(a);
    case Command::sweep:
      return runSweep(a);
    case Command::latency:
      return runLatency(a, *profile, cancelled);
    case Command::calibrate:
      return runCalibrate(a, cancelled);
    case Command::live:
    case Command::render:
      break;
  }
  std::vector<Button> buttons;
  for (const std::string& file : a.buttons) {
    Result<Button> button = readButtonFile(file);
    if (!button) return fail(button.failure());
    buttons.push_back(*std::move(button));
  }
  if (a.command == Command::render) return runRender(a, buttons.front(), *profile, cancelled);
  return runLive(a, buttons, *profile, cancelled);
}

}  // namespace detent::playback
