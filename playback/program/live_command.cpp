// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_command.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "playback/program/number_option.h"

namespace detent::playback {

namespace {

constexpr const char* thisMachine = "127.0.0.1";

/// Adds an option whose value is a port, or an address and a port; other values are wrong usage.
/// `standardHost` as in parseEndpoint.
void addEndpoint(CLI::App& app, const std::string& name, std::optional<Endpoint>& target,
                 const std::string& standardHost, unsigned lowestPort, const std::string& help) {
  const auto take = [&target, name, standardHost, lowestPort](const std::string& text) {
    const Result<Endpoint> endpoint = parseEndpoint(text, name, standardHost, lowestPort);
    if (!endpoint) throw CLI::ValidationError(endpoint.failure().sentence());
    target = *endpoint;
  };
  app.add_option_function<std::string>(name, take, help)
      ->type_name(standardHost.empty() ? "HOST:PORT" : "[ADDRESS:]PORT");
}

void addLiveOptions(CLI::App& app, LiveArguments& a) {
  app.add_option("BUTTON", a.buttons, "*.button.json; several for A/B comparison");
  addFeelOptions(app, a.feel);
  addDeviceOptions(app, a.player);
  addSensorOptions(app, a.sensor);
  addEndpoint(app, "--udp", a.udp, thisMachine, 0,
              "Listen for FUDI signal messages (docs/reference/osc.md); without an address from this machine "
              "only; port 0: any free port");
  addEndpoint(app, "--osc", a.osc, thisMachine, 0, "Listen for OSC messages, likewise");
  addEndpoint(app, "--signals-to", a.signalTarget, "", 1,
              "Send a message per event to a synthesizer (samples/puredata)");
  app.add_option("--press", a.pressFile,
                 "Play this recorded press (time_s,force_N or time_s,displacement_mm)");
  app.add_option("--finger-N", a.fingerPeak_N,
                 "Force of the keyboard's finger in N; 0: a quarter more than needed")
      ->capture_default_str()
      ->check(numberWithin(0, 1000));
  app.add_option("--gain", a.gain, "Output gain")->capture_default_str()->check(numberWithin(0, 10));
  app.add_option("--seconds", a.seconds, "End after this many seconds; 0: on q or Ctrl-C")
      ->capture_default_str()
      ->check(numberWithin(0, 1e9));
  app.add_flag("--json", a.json, "One JSON object on stdout at the end");
}

int runLive(const LiveArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileOf(a.feel.profileFile);
  if (!profile) return fail(profile.failure());
  std::vector<Button> buttons;
  for (const std::string& file : a.buttons) {
    Result<Button> button = readButtonFile(file);
    if (!button) return fail(button.failure());
    buttons.push_back(*std::move(button));
  }
  return runLive(a, buttons, *profile, cancelled);
}

}  // namespace

void addLiveCommand(CLI::App& program, Action& chosen) {
  const auto arguments = std::make_shared<LiveArguments>();
  addLiveOptions(program, *arguments);
  program.footer(
      "Keys while playing: space presses, Tab changes the button, + and - the gain, m the mode, p the "
      "placement, q ends.\n"
      "Exit codes: 0 done, 1 internal fault or disk error, 2 wrong usage, 3 input cannot be read, 6 device "
      "trouble.");
  program.callback([&program, &chosen, arguments] {
    if (!program.get_subcommands().empty()) return;
    if (arguments->buttons.empty()) throw CLI::RequiredError("BUTTON");
    chosen = [arguments](const Cancelled& cancelled) { return runLive(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
