// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/shared_options.h"

#include <cstdio>
#include <fstream>

#include "model/program/command_line.h"
#include "model/speed_family.h"
#include "playback/measurement/profile_file.h"
#include "playback/program/number_option.h"

namespace detent::playback {

namespace {

constexpr auto lowPasses = named<LowPassPlacement>({{"slope", LowPassPlacement::slopeOnly},
                                                    {"all", LowPassPlacement::wholeChain},
                                                    {"off", LowPassPlacement::none}});
constexpr auto carriers =
    named<GrainCarrier>({{"running", GrainCarrier::running}, {"retriggered", GrainCarrier::retriggered}});
constexpr auto equalizers = named<EqualizerUse>(
    {{"off", EqualizerUse::off}, {"spare-jumps", EqualizerUse::sparingJumps}, {"full", EqualizerUse::full}});
constexpr auto jumpSources = named<JumpFrequencySource>(
    {{"paper", JumpFrequencySource::paper}, {"profile", JumpFrequencySource::profile}});

}  // namespace

CLI::Option* addPlacementOption(CLI::App& app, EventPlacement& placement) {
  return addChoice(app, "--placement", placement, eventPlacements,
                   "fast: events at once; time-stamped: at their own time plus a constant delay",
                   "time-stamped");
}

void addFeelOptions(CLI::App& app, FeelOptions& options) {
  PlaybackSettings& s = options.settings;
  const std::string group = "How it feels (defaults: Kim & Lee 2013)";
  addChoice(app, "--mode", s.mode, feedbackModes, "Parts of the feedback", "full")->group(group);
  addChoice(app, "--feel", s.feel, feels,
            "clear: jumps stand out, dense and steep slopes are stronger; paper: as in the paper",
            feels.word(s.feel))
      ->group(group);
  addPlacementOption(app, s.placement)->group(group);
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
  addChoice(app, "--grain-carrier", s.grainCarrier, carriers,
            "A new grain continues the sine (running) or restarts it (retriggered, for comparison)",
            "running")
      ->group(group);
  app.add_option("--high-pass-hz", s.highPass_Hz, "High-pass of the grains in Hz, 0..100; 0: none")
      ->capture_default_str()
      ->group(group);
  addChoice(app, "--low-pass", s.lowPassPlacement, lowPasses, "Signals that pass the 150 Hz low-pass",
            "slope")
      ->group(group);
  app.add_option("--low-pass-order", s.lowPassOrder, "Order of the low-pass, 1 or 2")
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
  addChoice(app, "--jump-frequency", s.jumpFrequencySource, jumpSources,
            "Jump frequencies as given, or the profile's nearest resonance", "paper")
      ->group(group);
  addChoice(app, "--equalizer", s.equalizer, equalizers,
            "Bands of the profile's equalizer; spare-jumps leaves out those at the frequencies of jumps, "
            "which use the resonance",
            "spare-jumps")
      ->group(group);
  app.add_option("--bottom-amplitude", s.bottomOutAmplitude, "Share of full scale, 0..1")
      ->capture_default_str()
      ->group(group);
  app.add_option("--hysteresis-N", s.hysteresis_N,
                 "Force reversal that turns the stroke, in N; 0: from the sensor's noise")
      ->capture_default_str()
      ->group(group);
  app.add_option("--rearm-N", s.rearm_N,
                 "Force reversal before a jump plays again, in N; 0: 2.5 times the hysteresis")
      ->capture_default_str()
      ->group(group);
  app.add_option("--sensor-period-s", s.sensorPeriod_s,
                 "Time between two sensor readings in s: the delay of time-stamped events")
      ->capture_default_str()
      ->group(group);
  app.add_option("--profile", options.profileFile, "Device profile (docs/reference/device-profile.md)")
      ->group(group);
}

void addDeviceOptions(CLI::App& app, PlayerSettings& options) {
  app.add_option("--device", options.device,
                 "Sound output: a name from `detent-play devices` or a part of one");
  app.add_option("--device-rate", options.sampleRate_Hz, "Samples per second of the device; 0: its own")
      ->capture_default_str()
      ->check(numberWithin(0, 192000));
  app.add_option("--buffer", options.bufferFrames, "Samples per callback; 0: the host's choice (least delay)")
      ->capture_default_str()
      ->check(numberWithin(0, 8192));
  app.add_option("--channels", options.channels, "Output channels that carry the signal")
      ->capture_default_str()
      ->check(numberWithin(1, 64));
}

void addSensorOptions(CLI::App& app, SensorOptions& options) {
  app.add_option("--sensor", options.port,
                 "Serial force sensor, for example /dev/ttyACM0 (docs/reference/serial-protocol.md)");
  app.add_option("--baud", options.baud, "Baud rate of the sensor, 1200 to 4000000")
      ->capture_default_str()
      ->check(numberWithin(1200, 4000000));
}

Result<DeviceProfile> profileOf(const std::string& file) {
  if (file.empty()) return DeviceProfile{};
  return readDeviceProfile(file);
}

Result<DeviceProfile> profileToExtend(const std::string& file) {
  if (!std::ifstream(file)) return DeviceProfile{};
  return readDeviceProfile(file);
}

void tellSpeed(const Button& button, std::optional<double> speed_mm_per_s) {
  const std::vector<double> speeds = speedsOf(button);
  if (speeds.empty()) return;
  if (speed_mm_per_s)
    std::fprintf(stderr, "pressed at %.3g mm/s: the button is that of this speed\n", *speed_mm_per_s);
  else
    std::fprintf(stderr,
                 "no press goes through the travel: the button is that of its lowest speed, %.3g mm/s\n",
                 speeds.front());
}

}  // namespace detent::playback
