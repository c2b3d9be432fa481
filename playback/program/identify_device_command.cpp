// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/identify_device_command.h"

#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "playback/force_feedback.h"
#include "playback/program/json_output.h"
#include "playback/program/live_line.h"
#include "playback/program/number_option.h"
#include "playback/program/real_device_options.h"

namespace detent::playback {

namespace {

struct IdentifyDeviceArguments {
  std::string device, outputFile;
  RealDeviceOptions real;
  double rate_Hz = 0, range_mm = 10;
  bool fast = false, json = false;
};

void addIdentifyDeviceOptions(CLI::App& app, IdentifyDeviceArguments& a) {
  app.add_option("--device", a.device, forceDeviceWords)->required();
  app.add_option("-o,--output", a.outputFile, "*.device to write, for `force --device-profile`");
  app.add_option("--range", a.range_mm, "The handle moves between 0 and this, in mm")
      ->capture_default_str()
      ->check(numberWithin(4.0, 80.0));
  app.add_option("--rate", a.rate_Hz, "Steps per second in Hz, 50..20000; 0: the device's own")
      ->capture_default_str();
  app.add_flag("--fast", a.fast, "Run a simulated device without waiting; the result is the same");
  addRealDeviceOptions(app, a.real, "Largest force in N; default: 1 N");
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

Result<DeviceMeasurementSettings> identifyDeviceSettings(const IdentifyDeviceArguments& a) {
  Result<ForceDeviceChoice> device = forceDeviceFrom(a.device);
  if (!device) return device.failure();
  if (a.fast && device->kind != ForceDeviceKind::simulated) return fastNeedsSimulation();
  DeviceMeasurementSettings settings;
  settings.run.device = *std::move(device);
  const double largest_N = settings.run.device.profile.limits.force_N;
  a.real.applyTo(settings.run.device);
  settings.run.device.profile.limits.force_N = largest_N;
  if (a.real.largest_N) settings.largest_N = *a.real.largest_N;
  if (a.rate_Hz != 0) settings.run.force.rate_Hz = a.rate_Hz;
  settings.run.paced = !a.fast;
  settings.run.stopKeys = settings.run.stopSignals = true;
  settings.range_mm = a.range_mm;
  return settings;
}

Json jsonOf(const IdentifyDeviceArguments& a, const DeviceMeasurement& m) {
  const ForceDeviceMeasurement& d = m.device;
  return {{"status", "ok"},
          {"device", a.device},
          {"device_name", d.name},
          {"mass_kg", d.mass_kg.value},
          {"sigma_mass_kg", d.mass_kg.sigma},
          {"friction_N", d.friction_N.value},
          {"sigma_friction_N", d.friction_N.sigma},
          {"damping_Ns_per_mm", d.damping_Ns_per_mm.value},
          {"sigma_damping_Ns_per_mm", d.damping_Ns_per_mm.sigma},
          {"delay_s", d.delay_s.value},
          {"sigma_delay_s", d.delay_s.sigma},
          {"lag_s", d.lag_s.value},
          {"sigma_lag_s", d.lag_s.sigma},
          {"late_s", d.late_s.value},
          {"sigma_late_s", d.late_s.sigma},
          {"offset_N", m.motion.offset_N.value},
          {"sigma_offset_N", m.motion.offset_N.sigma},
          {"rate_Hz", d.rate_Hz},
          {"round_trip_ms", 1e3 * m.roundTrip_s},
          {"longest_pause_ms", 1e3 * m.longestPause_s},
          {"encoder_step_mm", d.step_mm},
          {"residual_mm", m.motion.residual_mm},
          {"explained", m.motion.explained()},
          {"samples", m.motion.samples}};
}

void printDeviceFigures(const DeviceMeasurement& m) {
  const ForceDeviceMeasurement& d = m.device;
  const auto line = [](const char* name, const ForceDeviceMeasurement::Value& v, double scale,
                       const char* unit) {
    std::fprintf(stderr, "%-9s %9.4g +- %.2g %s\n", name, scale * v.value, scale * v.sigma, unit);
  };
  line("mass", d.mass_kg, 1e3, "g");
  line("friction", d.friction_N, 1, "N");
  line("damping", d.damping_Ns_per_mm, 1, "N s/mm");
  line("delay", d.delay_s, 1e3, "ms");
  line("motor lag", d.lag_s, 1e3, "ms");
  line("together", d.late_s, 1e3, "ms late, at");
  std::fprintf(stderr, "%.0f Hz; %zu samples, %.4f mm left over\n", d.rate_Hz, m.motion.samples,
               m.motion.residual_mm);
  if (!m.motion.explained()) {
    std::fprintf(
        stderr,
        "doubt: the handle does not move as mass, friction and damping do: something else acts on it (a "
        "hand, a spring, a stop, the cable), or the motor gives another force than it is asked for.\n");
  }
}

int runIdentifyDevice(const IdentifyDeviceArguments& a, const Cancelled& cancelled) {
  Result<DeviceMeasurementSettings> settings = identifyDeviceSettings(a);
  if (!settings) return fail(settings.failure());
  std::fprintf(stderr,
               "The handle moves by itself, between 0 and %g mm, with up to %g N: take the finger off.\n",
               settings->range_mm, settings->largest_N);
  LiveLine line;
  Result<DeviceMeasurement> measured = measureForceDevice(*settings, [&](double done) {
    char text[40];
    std::snprintf(text, sizeof text, "%3.0f %%", 100 * done);
    line.show(text);
    return !cancelled();
  });
  line.end();
  if (!measured) return fail(measured.failure());
  if (!a.outputFile.empty()) {
    if (Result<Done> written = writeForceDevice(measured->device, a.outputFile); !written)
      return fail(written.failure());
  }
  printDeviceFigures(*measured);
  if (a.json) print(jsonOf(a, *measured));
  return 0;
}

}  // namespace

void addIdentifyDeviceCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "identify-device",
      "Measure mass, friction, damping, delay and motor lag of a force device. Units: kg, N, N s/mm, s");
  const auto arguments = std::make_shared<IdentifyDeviceArguments>();
  addIdentifyDeviceOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runIdentifyDevice(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
