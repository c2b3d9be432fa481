// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/arguments.h"

#include <map>

#include <CLI/CLI.hpp>

namespace detent::playback {

namespace {

const std::map<std::string, FeedbackMode> modes{{"full", FeedbackMode::full},
                                                {"click-only", FeedbackMode::clickOnly},
                                                {"slope-only", FeedbackMode::slopeOnly},
                                                {"off", FeedbackMode::off}};
const std::map<std::string, EventPlacement> placements{{"fast", EventPlacement::atOnce},
                                                       {"time-stamped", EventPlacement::timeStamped}};
const std::map<std::string, LowPassPlacement> lowPasses{{"slope", LowPassPlacement::slopeOnly},
                                                        {"all", LowPassPlacement::wholeChain},
                                                        {"off", LowPassPlacement::none}};
const std::map<std::string, JumpFrequencySource> jumpSources{{"paper", JumpFrequencySource::paper},
                                                             {"profile", JumpFrequencySource::profile}};
const std::map<std::string, SensorCircuit> circuits{{"newtons", SensorCircuit::newtons},
                                                    {"linear", SensorCircuit::linear},
                                                    {"divider", SensorCircuit::divider}};

/// One of several words; --help lists them.
template <class Enum>
CLI::Option* choice(CLI::App& app, const std::string& name, Enum& target,
                    const std::map<std::string, Enum>& names, const std::string& help,
                    const std::string& standard) {
  std::string words;
  std::vector<std::string> known;
  for (const auto& [word, value] : names) {
    words += (words.empty() ? "" : "|") + word;
    known.push_back(word);
  }
  const auto take = [&target, &names](const std::string& word) { target = names.at(word); };
  CLI::Validator isKnown = CLI::IsMember(known);
  isKnown.description("");
  return app.add_option_function<std::string>(name, take, help)
      ->check(isKnown)
      ->type_name(words)
      ->default_str(standard);
}

void addFeel(CLI::App& app, Arguments& a) {
  PlaybackSettings& s = a.settings;
  const std::string group = "How it feels (defaults: Kim & Lee 2013)";
  choice(app, "--mode", s.mode, modes, "What is felt", "full")->group(group);
  choice(app, "--placement", s.placement, placements,
         "Events at once, or at their own time plus a constant delay", "time-stamped")
      ->group(group);
  app.add_option("--grains-per-mm", s.grainsPerMm, "Grains per mm of slope, 0..1000")
      ->capture_default_str()
      ->group(group);
  app.add_option("--grain-hz", s.grainFrequency_Hz, "Frequency of a grain in Hz")
      ->capture_default_str()
      ->group(group);
  app.add_option("--grain-s", s.grainDuration_s, "Length of a grain in s")
      ->capture_default_str()
      ->group(group);
  app.add_option("--grain-amplitude", s.grainAmplitude, "Share of full scale, 0..1")
      ->capture_default_str()
      ->group(group);
  choice(app, "--low-pass", s.lowPassPlacement, lowPasses, "What the 150 Hz low-pass acts on", "slope")
      ->group(group);
  app.add_option("--low-pass-order", s.lowPassOrder, "Its order, 1 or 2")
      ->capture_default_str()
      ->group(group);
  app.add_option("--jump-s-per-mm", s.jumpDurationPerTravel_s_per_mm, "Length of a jump's burst in s per mm")
      ->capture_default_str()
      ->group(group);
  app.add_option("--jump-per-mJ", s.jumpAmplitudePerArea_per_mJ, "Amplitude of a jump per mJ of its area")
      ->capture_default_str()
      ->group(group);
  app.add_option("--press-hz", s.pressJumpFrequency_Hz, "Frequency of a press jump in Hz")
      ->capture_default_str()
      ->group(group);
  app.add_option("--release-hz", s.releaseJumpFrequency_Hz, "Frequency of a release jump in Hz")
      ->capture_default_str()
      ->group(group);
  choice(app, "--jump-frequency", s.jumpFrequencySource, jumpSources,
         "Jump frequencies as given, or the profile's nearest resonance", "paper")
      ->group(group);
  app.add_option("--bottom-amplitude", s.bottomOutAmplitude, "Share of full scale, 0..1")
      ->capture_default_str()
      ->group(group);
  app.add_option("--hysteresis-N", s.hysteresis_N,
                 "Force must turn back this far before the stroke turns, in N")
      ->capture_default_str()
      ->group(group);
  app.add_option("--rearm-mm", s.rearmDistance_mm, "Way back before a jump is felt again, in mm")
      ->capture_default_str()
      ->group(group);
  app.add_option("--sensor-period-s", s.sensorPeriod_s,
                 "Time between two sensor readings in s: the delay of time-stamped events")
      ->capture_default_str()
      ->group(group);
  app.add_option("--profile", a.profileFile, "Device profile (docs/device-profile.md)")->group(group);
}

void addDevice(CLI::App& app, Arguments& a) {
  app.add_option("--device", a.player.device,
                 "Sound output: a name from `detent-play devices` or a part of one");
  app.add_option("--device-rate", a.player.sampleRate_Hz, "Samples per second of the device; 0: its own")
      ->capture_default_str();
  app.add_option("--buffer", a.player.bufferFrames,
                 "Samples per callback; 0: the host's choice (least delay)")
      ->capture_default_str();
  app.add_option("--channels", a.player.channels, "Output channels that carry the signal")
      ->capture_default_str();
}

void addSensor(CLI::App& app, Arguments& a) {
  app.add_option("--sensor", a.sensorPort,
                 "Serial force sensor, for example /dev/ttyACM0 (docs/serial-protocol.md)");
  app.add_option("--baud", a.baud, "Its baud rate")->capture_default_str();
}

void addLive(CLI::App& app, Arguments& a) {
  app.add_option("BUTTON", a.buttons, "*.button.json; several for A/B comparison");
  addFeel(app, a);
  addDevice(app, a);
  addSensor(app, a);
  app.add_option("--udp", a.udpPort, "Listen for FUDI signal messages on this UDP port (docs/osc.md)");
  app.add_option("--osc", a.oscPort, "Listen for OSC messages on this UDP port");
  app.add_option("--signals-to", a.signalTarget,
                 "HOST:PORT of a synthesizer (samples/puredata) that gets a message per event");
  app.add_option("--press", a.pressFile,
                 "Play this recorded press (time_s,force_N or time_s,displacement_mm)");
  app.add_option("--finger-N", a.fingerPeak_N,
                 "Force of the keyboard's finger in N; 0: a quarter more than needed")
      ->capture_default_str();
  app.add_option("--gain", a.gain, "Output gain")->capture_default_str()->check(CLI::Range(0.0, 10.0));
  app.add_option("--seconds", a.seconds, "End after so many seconds; 0: on q or Ctrl-C")
      ->capture_default_str();
  app.add_flag("--json", a.json, "One JSON object on stdout at the end");
}

void addRender(CLI::App& app, Arguments& a) {
  app.add_option("BUTTON", a.buttons, "*.button.json")->required()->expected(1);
  auto* press =
      app.add_option("--press", a.pressFile, "Press trace CSV: time_s,force_N or time_s,displacement_mm");
  app.add_flag("--standard-press", a.standardPress, "Instead of a trace: a human-like press of 0.3 s")
      ->excludes(press);
  app.add_option("-o,--output", a.outputFile, "*.wav (32 bit float) or *.flac (24 bit)")->required();
  app.add_option("--events", a.eventsFile, "Also write what was felt, as CSV");
  app.add_option("--rate", a.sampleRate_Hz, "Samples per second, 8000..192000")->capture_default_str();
  addFeel(app, a);
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

void addSweep(CLI::App& app, Arguments& a) {
  addDevice(app, a);
  app.add_option("--input", a.inputDevice, "Accelerometer or microphone; default: the device's own input");
  app.add_option("-o,--output", a.outputFile, "Device profile to write; an existing one keeps its sensor")
      ->required();
  app.add_option("--plot", a.plotFile, "Response as SVG");
  app.add_option("--csv", a.csvFile, "Response as CSV");
  app.add_option("--from-hz", a.sweep.from_Hz, "Lowest frequency in Hz")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--to-hz", a.sweep.to_Hz, "Highest frequency in Hz")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--seconds", a.sweep.duration_s, "Length of the sweep in s")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 120.0));
  app.add_option("--level", a.sweep.level, "Share of full scale")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1.0));
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

void addLatency(CLI::App& app, Arguments& a) {
  addDevice(app, a);
  addSensor(app, a);
  app.add_option("--input", a.inputDevice, "Where the vibration comes back; default: the device's own input");
  app.add_option("--trials", a.trials, "Round trips")->capture_default_str()->check(CLI::Range(1, 100000));
  choice(app, "--placement", a.settings.placement, placements, "As in live play", "time-stamped");
  app.add_option("--sensor-hz", a.sensorRate_Hz, "Rate of the simulated sensor in Hz")->capture_default_str();
  app.add_option("--threshold", a.threshold,
                 "Onset on the input, share of full scale; 0: eight times the noise")
      ->capture_default_str();
  app.add_option("--profile", a.profileFile, "Sensor calibration; also gets the result with --output");
  app.add_option("-o,--output", a.outputFile, "Write the result into this device profile");
  app.add_option("--csv", a.csvFile, "Every delay as CSV");
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

void addCalibrate(CLI::App& app, Arguments& a) {
  addSensor(app, a);
  app.add_option("--weights", a.weightsFile,
                 "Known weights as CSV: mass_g,raw or force_N,raw; else they are asked for");
  choice(app, "--circuit", a.calibration.circuit, circuits, "How the sensor is wired", "divider");
  app.add_option("--full-scale", a.calibration.fullScale_counts, "Largest reading of the converter")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--degree", a.calibration.highestDegree, "Highest degree of the curve")
      ->capture_default_str()
      ->check(CLI::Range(1, 3));
  app.add_option("-o,--output", a.outputFile, "Device profile to write; an existing one keeps its response")
      ->required();
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

}  // namespace

ParsedArguments parseArguments(int argc, char** argv) {
  Arguments a;
  CLI::App app{"Feel a button: a force sensor in, vibration out. Displacement in mm, force in N, time in s."};
  addLive(app, a);
  app.footer(
      "Keys while playing: space presses, Tab changes the button, + and - the gain, m the mode, p the "
      "placement, q ends.\n"
      "Exit codes: 0 done, 1 internal fault, 2 wrong usage, 3 input cannot be read, 6 device trouble.");
  CLI::App* render =
      app.add_subcommand("render", "A press to a sound file, sample for sample what live play gives");
  addRender(*render, a);
  CLI::App* devices = app.add_subcommand("devices", "List sound devices");
  devices->add_flag("--json", a.json, "One JSON object on stdout");
  CLI::App* sweep =
      app.add_subcommand("sweep", "Measure a device's frequency response and write its profile");
  addSweep(*sweep, a);
  CLI::App* latency = app.add_subcommand("latency", "Measure the delay from force to vibration");
  addLatency(*latency, a);
  CLI::App* calibrate = app.add_subcommand("calibrate", "Calibrate a force sensor with known weights");
  addCalibrate(*calibrate, a);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
    if (render->parsed()) {
      a.command = Command::render;
      if (a.pressFile.empty() && !a.standardPress) throw CLI::RequiredError("--press or --standard-press");
    } else if (devices->parsed()) {
      a.command = Command::devices;
    } else if (sweep->parsed()) {
      a.command = Command::sweep;
    } else if (latency->parsed()) {
      a.command = Command::latency;
    } else if (calibrate->parsed()) {
      a.command = Command::calibrate;
      if (a.weightsFile.empty() && a.sensorPort.empty()) throw CLI::RequiredError("--weights or --sensor");
    } else if (a.buttons.empty()) {
      throw CLI::RequiredError("BUTTON");
    }
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return {std::nullopt, code == 0 ? 0 : 2};
  }
  return {a, 0};
}

}  // namespace detent::playback
