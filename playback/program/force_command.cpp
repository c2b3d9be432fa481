// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/force_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "model/program/command_line.h"
#include "playback/force_feedback.h"
#include "playback/program/endpoint.h"
#include "playback/program/force_log.h"
#include "playback/program/force_plots.h"
#include "playback/program/force_words.h"
#include "playback/program/json_output.h"
#include "playback/program/live_line.h"
#include "playback/program/number_option.h"
#include "playback/program/real_device_options.h"

namespace detent::playback {

namespace {

constexpr std::size_t mostDrawnSteps = 200000;  // most steps in a plot; the log contains all

struct ForceArguments {
  std::string button, device = "sim", finger = "press";
  SpringPolynomials spring;  ///< in place of a button file
  double rate_Hz = 0;        ///< 0: the device's own
  ForceSettings force;
  double seconds = 0;
  bool fast = false;
  std::string logFile, plotFile, figuresFile;
  RealDeviceOptions real;
  std::string profileFile;
  bool upload = false;
  bool holdToRun = false;
  std::string stopOsc;  ///< PORT or ADDRESS:PORT
  bool json = false;
};

constexpr auto laws = named<ForceLawKind>({{"graph", ForceLawKind::graph}, {"spring", ForceLawKind::spring}});
constexpr auto velocities = named<VelocityMethod>({{"kalman", VelocityMethod::kalman},
                                                   {"foaw", VelocityMethod::foaw},
                                                   {"difference", VelocityMethod::difference}});

void addForceOptions(CLI::App& app, ForceArguments& a) {
  app.add_option("BUTTON", a.button, "*.button.json, or --stiffness in its place");
  const std::string spring = "A spring and damper in place of BUTTON: F = k(x) x + b(x) v";
  app.add_option("--stiffness", a.spring.stiffness_N_per_mm,
                 "k(x) in N/mm: coefficients of x^0, x^1, ... with x in mm, 0.2,0,-0.01")
      ->delimiter(',')
      ->group(spring);
  app.add_option("--damping", a.spring.damping_Ns_per_mm, "b(x) in N s/mm, likewise")
      ->delimiter(',')
      ->group(spring)
      ->needs("--stiffness");
  app.add_option("--travel", a.spring.travel_mm, "In mm")
      ->capture_default_str()
      ->group(spring)
      ->needs("--stiffness");
  app.add_option("--device", a.device, forceDeviceWords)->capture_default_str();
  app.add_option("--finger", a.finger,
                 "Finger of a simulated device: hold (rests in the middle), hold=X (at X mm), press "
                 "(repeatedly), or a press trace CSV (time_s,displacement_mm or time_s,force_N)")
      ->capture_default_str();
  app.add_option("--rate", a.rate_Hz, "Steps per second in Hz, 50..20000; 0: the device's own")
      ->capture_default_str();
  addChoice(app, "--law", a.force.law, laws,
            "Both curves of the graph, or one curve with damping (the paper's spring and damper)", "graph");
  addChoice(app, "--velocity", a.force.velocity, velocities, "Velocity estimator", "kalman");
  app.add_option("--seconds", a.seconds, "End after this many seconds; 0: on Ctrl-C")
      ->capture_default_str()
      ->check(numberWithin(0.0, 1e6));
  app.add_flag("--controller", a.force.passivityController,
               "Damp where the button gives more energy than it took (default: only measure this)");
  app.add_flag("--fast", a.fast, "Run a simulated device without waiting; the result is the same");
  app.add_option("--log", a.logFile,
                 "One row per step: time_s,position_mm,velocity_mm_per_s,force_N,energy_mJ,state");
  app.add_option("--plot", a.plotFile,
                 "SVG of the run: force over displacement beside the button's curves, both over time");
  app.add_option("--figures", a.figuresFile,
                 "SVG of the figures 4, 5 and 6 of Shrestha's paper, from this run");
  app.add_option("--device-profile", a.profileFile,
                 "*.device of `identify-device`: measured values for margin, lead and energy")
      ->group(realDeviceGroup);
  addRealDeviceOptions(app, a.real, "Largest force in N; default: the preset's");
  app.add_flag("--upload", a.upload, "The microcontroller runs the law from a table, at its own rate")
      ->group(realDeviceGroup);
  const std::string safety =
      "Stopping (docs/guide/force-feedback.md): any key, SIGUSR1, Ctrl-C; the key a arms again";
  app.add_flag("--hold-to-run", a.holdToRun,
               "Force only while the space bar is held, or /detent/hold keeps coming")
      ->group(safety);
  app.add_option("--stop-osc", a.stopOsc,
                 "Listen for OSC /detent/stop on PORT of this machine, or on ADDRESS:PORT")
      ->group(safety);
  app.add_flag("--json", a.json, "One JSON object on stdout at the end");
}

/// Energy and extremes of a run, computed from its steps.
struct RunFigures {
  double taken_mJ = 0, given_mJ = 0, strongest_N = 0, fastest_mm_per_s = 0;
  double lowest_mm = 0, highest_mm = 0;
  std::uint64_t rows = 0, stateChanges = 0;

  void add(const ForceStep& step) {
    if (rows > 0) {
      const double work_mJ = step.energy_mJ - before_.energy_mJ;
      (work_mJ > 0 ? taken_mJ : given_mJ) += std::abs(work_mJ);
      stateChanges += step.state != before_.state ? 1 : 0;
    }
    lowest_mm = rows == 0 ? step.position_mm : std::min(lowest_mm, step.position_mm);
    highest_mm = rows == 0 ? step.position_mm : std::max(highest_mm, step.position_mm);
    strongest_N = std::max(strongest_N, std::abs(step.force_N));
    fastest_mm_per_s = std::max(fastest_mm_per_s, std::abs(step.velocity_mm_per_s));
    before_ = step;
    ++rows;
  }

 private:
  ForceStep before_;
};

double percentPunctual(const ForceStatus& s) {
  return s.steps == 0 ? 100 : 100 * static_cast<double>(s.within100us) / static_cast<double>(s.steps);
}

/// Reason why there is no force now, for the live line; empty if there is none.
const char* keptAway(const ForceStatus& s) {
  if (!s.connected) return "  DEVICE LOST, no force";
  if (!s.fault.empty()) return "  NO FORCE: device in error; a arms";
  switch (s.halt) {
    case ForceHalt::stopped:
      return "  STOPPED, no force; a arms";
    case ForceHalt::reversed:
      return "  NO FORCE: reversed polarity";
    case ForceHalt::unmoved:
      return "  NO FORCE: the handle does not move; let go, then a arms";
    case ForceHalt::deadCount:
      return "  NO FORCE: encoder dead; let go, then a arms";
    case ForceHalt::runaway:
      return "  NO FORCE: handle ran away; let go, then a arms";
    case ForceHalt::dropOuts:
      return "  NO FORCE: readings failed repeatedly; a arms";
    case ForceHalt::displaced:
      return "  NO FORCE: place lost; let go, then a arms";
    case ForceHalt::notHeld:
      return "  hold the space bar";
    case ForceHalt::none:
      break;
  }
  if (s.homing) return "  NO FORCE YET: move the handle all the way out and all the way in";
  return s.last.proving ? "  checking the motor's direction: let go" : "";
}

std::string liveText(const ForceStatus& s, const Button& button) {
  char text[200];
  std::snprintf(text, sizeof text, "%8.3f mm %8.1f mm/s %7.3f N %8.3f mJ  %-10s %5.1f %% on time%s",
                s.last.position_mm, s.last.velocity_mm_per_s, s.last.force_N, s.last.energy_mJ,
                stateName(button, s.last.state).c_str(), percentPunctual(s), keptAway(s));
  return text;
}

Json stabilityJson(const StabilityMargin& margin, const Button& button) {
  Json stretches = Json::array();
  for (const UnstableStretch& u : margin.unstable) {
    stretches.push_back({{"state", stateName(button, static_cast<std::uint32_t>(u.state))},
                         {"from_mm", u.from_mm},
                         {"to_mm", u.to_mm},
                         {"falling", u.falling},
                         {"slope_N_per_mm", u.worst.slope_N_per_mm},
                         {"allowed_N_per_mm", u.worst.allowed_N_per_mm},
                         {"bound", codeOf(u.worst.bound)}});
  }
  return {{"stable_as_drawn", margin.stable()},
          {"least_margin_N_per_mm", margin.least.margin_N_per_mm()},
          {"at_mm", margin.least.displacement_mm},
          {"allowed_N_per_mm", margin.least.allowed_N_per_mm},
          {"bound", codeOf(margin.least.bound)},
          {"any_finger_N_per_mm", margin.anyFinger_N_per_mm},
          {"unstable", stretches}};
}

Json jsonOf(const ForceArguments& a, const Button& button, const ForceDeviceProfile& device,
            const ForceLinkPace& pace, const ForceSummary& summary, const ForceStatus& s,
            const RunFigures& runForce, double rate_Hz) {
  Json remarks = Json::array();
  for (const ForceRemark& r : summary.remarks) {
    remarks.push_back({{"code", codeOf(r.kind)},
                       {"state", stateName(button, static_cast<std::uint32_t>(r.state))},
                       {"displacement_mm", r.at_mm},
                       {"value", r.value},
                       {"limit", r.limit},
                       {"text", sentenceOf(r, button)}});
  }
  return {{"status", "ok"},
          {"button", button.name()},
          {"device", a.device},
          {"device_name", device.name},
          {"device_is", device.measured ? "measured" : "assumed"},
          {"encoder_step_mm", device.step_mm},
          {"rate_Hz", rate_Hz},
          {"rows", runForce.rows},
          {"seconds", static_cast<double>(runForce.rows) / rate_Hz},
          {"slope_limit_N_per_mm", summary.slopeLimit_N_per_mm},
          {"play_radius_mm", summary.playRadius_mm},
          {"stability", stabilityJson(stabilityOf(button, device, rate_Hz), button)},
          {"position_mm", {{"lowest", runForce.lowest_mm}, {"highest", runForce.highest_mm}}},
          {"strongest_N", runForce.strongest_N},
          {"fastest_mm_per_s", runForce.fastest_mm_per_s},
          {"state_changes", runForce.stateChanges},
          {"energy_mJ",
           {{"taken", runForce.taken_mJ},
            {"given", runForce.given_mJ},
            {"net", s.last.energy_mJ},
            {"lowest_balance", s.lowestBalance_mJ}}},
          {"deadlines",
           {{"steps", s.steps},
            {"within_100us", s.within100us},
            {"missed", s.missedDeadlines},
            {"worst_us", 1e6 * s.worstLate_s},
            {"mean_us", 1e6 * s.meanLate_s},
            {"realtime_scheduling", s.realtime}}},
          {"safety",
           {{"missing_readings", s.guard.missing},
            {"readings_not_finite", s.guard.notFinite},
            {"absurd_readings", s.guard.absurd},
            {"frozen_readings", s.guard.frozen},
            {"fades", s.guard.faded},
            {"places_lost", s.guard.displaced},
            {"stalls", s.guard.stalled},
            {"encoder_probes", s.guard.probed},
            {"emergency_stops", s.guard.stopped},
            {"halt", codeOf(s.halt)},
            {"fault", s.fault},
            {"too_fast", s.guard.tooFast},
            {"force_limited_steps", s.guard.forceLimited},
            {"slew_limited_steps", s.guard.slewLimited}}},
          {"link",
           {{"round_trip_ms", 1e3 * pace.roundTrip_s},
            {"computer_ms", 1e3 * pace.computer_s},
            {"late_by_computer", s.computerLate},
            {"late_by_device", s.deviceLate},
            {"withdrawn", s.withdrawn},
            {"late", s.lateAnswers},
            {"malformed", s.malformedAnswers},
            {"repeated", s.repeatedAnswers},
            {"reconnects", s.reconnects},
            {"firmware_tries", s.firmwareTries},
            {"homed", !s.homing}}},
          {"dropped_rows", s.droppedRows},
          {"remarks", remarks}};
}

void printForceFigures(const ForceStatus& s, const RunFigures& runForce, const ForceSummary& summary,
                       double rate_Hz) {
  std::fprintf(stderr,
               "%llu steps at %g Hz, %.2f to %.2f mm, up to %.3f N and %.0f mm/s; play radius %.3f mm, "
               "steepest slope %.3g "
               "N/mm\n",
               static_cast<unsigned long long>(runForce.rows), rate_Hz, runForce.lowest_mm,
               runForce.highest_mm, runForce.strongest_N, runForce.fastest_mm_per_s, summary.playRadius_mm,
               summary.slopeLimit_N_per_mm);
  std::fprintf(stderr, "energy: %.3f mJ taken, %.3f mJ given back; lowest balance %.4f mJ\n",
               runForce.taken_mJ, runForce.given_mJ, s.lowestBalance_mJ);
  if (s.steps > 0) {
    std::fprintf(stderr, "deadlines: %.2f %% within 100 us, worst %.0f us, %llu missed%s\n",
                 percentPunctual(s), 1e6 * s.worstLate_s, static_cast<unsigned long long>(s.missedDeadlines),
                 s.realtime ? "" : " (no real-time scheduling: docs/guide/force-feedback.md)");
  }
  const std::uint64_t bad = s.guard.missing + s.guard.notFinite + s.guard.absurd + s.guard.frozen;
  if (bad > 0 || s.guard.tooFast > 0) {
    std::fprintf(
        stderr,
        "safety: %llu readings late, %llu not a number, %llu absurd, %llu frozen, %llu times too fast; the "
        "force was "
        "taken away %llu times\n",
        static_cast<unsigned long long>(s.guard.missing), static_cast<unsigned long long>(s.guard.notFinite),
        static_cast<unsigned long long>(s.guard.absurd), static_cast<unsigned long long>(s.guard.frozen),
        static_cast<unsigned long long>(s.guard.tooFast),
        static_cast<unsigned long long>(s.guard.faded + s.guard.tooFast));
  }
  if (s.deviceLate > 0)
    std::fprintf(stderr, "the device was late: %llu answers dropped in steps that began on time\n",
                 static_cast<unsigned long long>(s.deviceLate));
  if (s.computerLate > 0)
    std::fprintf(stderr, "this computer was late: %llu answers dropped in steps that began late\n",
                 static_cast<unsigned long long>(s.computerLate));
}

// The reason for a missing force at the end is reported, however short the run was.
void printHalt(const ForceStatus& s) {
  if (!s.fault.empty()) std::fprintf(stderr, "no force: the device is in error: %s\n", s.fault.c_str());
  if (!s.clearedFault.empty())
    std::fprintf(stderr, "the device was in error, which was cleared: %s\n", s.clearedFault.c_str());
  if (const std::string kept = sentenceOf(s.halt); !kept.empty())
    std::fprintf(stderr, "no force at the end: %s.\n", kept.c_str());
  if (s.halt == ForceHalt::none && s.guard.faded > 0 && !s.last.good)
    std::fprintf(stderr, "no force at the end: the device %s. Check the cable and its power.\n",
                 s.connected ? "does not answer" : "is lost");
  if (s.halt != ForceHalt::displaced && s.guard.displaced > 0) {
    std::fprintf(stderr,
                 "place lost: the position jumped, or the device was away, %llu times; force comes back only "
                 "after the "
                 "key a\n",
                 static_cast<unsigned long long>(s.guard.displaced));
  }
  if (s.guard.stopped > 0)
    std::fprintf(stderr, "%llu emergency stops\n", static_cast<unsigned long long>(s.guard.stopped));
}

Result<ForcePlayerSettings> forceSettings(const ForceArguments& a) {
  ForcePlayerSettings settings;
  Result<ForceDeviceChoice> device = forceDeviceFrom(a.device);
  if (!device) return device.failure();
  Result<FingerChoice> finger = fingerFrom(a.finger);
  if (!finger) return finger.failure();
  settings.device = *std::move(device);
  settings.finger = *std::move(finger);
  settings.force = a.force;
  if (a.rate_Hz != 0) settings.force.rate_Hz = a.rate_Hz;
  settings.seconds = a.seconds;
  settings.device.uploadTable = a.upload;
  if (!a.profileFile.empty()) {
    Result<ForceDeviceMeasurement> measured = readForceDevice(a.profileFile);
    if (!measured) return measured.failure();
    const double rate_Hz = settings.force.rate_Hz.value_or(settings.device.profile.rate_Hz);
    settings.device.profile = measuredProfile(settings.device.profile, *measured, rate_Hz,
                                              settings.device.kind != ForceDeviceKind::simulated);
  }
  a.real.applyTo(settings.device);  // what is given by hand counts more than the profile
  settings.paced = !a.fast;
  settings.holdToRun = a.holdToRun;
  settings.stopKeys = settings.stopSignals = true;
  if (!a.stopOsc.empty()) {
    Result<Endpoint> endpoint = parseEndpoint(a.stopOsc, "--stop-osc", "127.0.0.1", 0);
    if (!endpoint) return endpoint.failure();
    settings.stopOscPort = endpoint->port;
    settings.stopOscAddress = endpoint->host;
  }
  if (a.fast && settings.device.kind != ForceDeviceKind::simulated) {
    return fastNeedsSimulation();
  }
  if (a.fast && a.seconds == 0) {
    return Failure{FailureCode::wrongUsage, "--fast", "", "needs an end", "Add --seconds S"};
  }
  return settings;
}

Result<Done> writePictures(const ForceArguments& a, const Button& button, const std::vector<ForceStep>& steps,
                           double period_s) {
  if (!a.plotFile.empty()) {
    if (Result<Done> w = writeTextFileAtomically(a.plotFile, runSvg(button, steps, period_s)); !w) return w;
  }
  return a.figuresFile.empty() ? Result<Done>(Done{})
                               : writeTextFileAtomically(a.figuresFile, paperFiguresSvg(button, steps));
}

Result<Button> buttonFor(const ForceArguments& a) {
  const bool given = !a.spring.stiffness_N_per_mm.empty();
  if (given == !a.button.empty()) {
    return Failure{FailureCode::wrongUsage, "BUTTON", "",
                   given ? "is given beside --stiffness" : "is missing",
                   "Give a *.button.json, or --stiffness"};
  }
  return given ? springButton("Spring and damper", a.spring) : readButtonFile(a.button);
}

int runForce(const ForceArguments& a, const Cancelled& cancelled) {
  Result<Button> button = buttonFor(a);
  if (!button) return fail(button.failure());
  const std::string shownAs = a.button.empty() ? button->name() : a.button;
  Result<ForcePlayerSettings> settings = forceSettings(a);
  if (!settings) return fail(settings.failure());
  std::optional<ForceLog> log;
  if (!a.logFile.empty()) {
    Result<ForceLog> opened = ForceLog::open(a.logFile);
    if (!opened) return fail(opened.failure());
    log.emplace(*std::move(opened));
  }
  Result<std::unique_ptr<ForcePlayer>> player = ForcePlayer::start(*button, *settings);
  if (!player) return fail(player.failure());
  const ForceSummary summary = (*player)->summary();
  for (const ForceRemark& r : summary.remarks) {
    std::fprintf(stderr, "note: %s: %s.\n", shownAs.c_str(), sentenceOf(r, *button).c_str());
  }
  const ForceDeviceProfile device = (*player)->device();
  const ForceLinkPace pace = (*player)->pace();
  const double rate_Hz =
      pace.roundTrip_s > 0 ? device.rate_Hz : settings->force.rate_Hz.value_or(device.rate_Hz);
  if (pace.roundTrip_s > 0) {
    std::fprintf(stderr,
                 "link: answers after %.1f ms: %.0f Hz instead of %.0f, the force acts %.1f ms late; slopes "
                 "up to %.2g "
                 "N/mm, %.2g N·s/mm of damping added\n",
                 1e3 * pace.roundTrip_s, rate_Hz, pace.requested_Hz, 1e3 * device.delay_s,
                 device.largestSlope_N_per_mm, pace.addedDamping_Ns_per_mm);
  }
  if (!device.measured) {
    std::fprintf(
        stderr,
        "stability and energy are assumed: %.3g kg, %.3g N of friction, %.3g N·s/mm and %.3g ms are a "
        "preset's; identify-device measures a device (--device-profile).\n",
        device.mass_kg, device.friction_N, device.damping_Ns_per_mm, 1e3 * device.late_s());
  }
  for (const UnstableStretch& u : stabilityOf(*button, device, rate_Hz).unstable) {
    std::fprintf(stderr, "stability: %s: %s.\n", shownAs.c_str(), sentenceOf(u, *button).c_str());
  }
  RunFigures figures;
  std::vector<ForceStep> steps, drawn;
  const bool draws = !a.plotFile.empty() || !a.figuresFile.empty();
  LiveLine line;
  for (bool finished = false; !finished;) {
    finished = (*player)->status().finished;
    if (!finished) std::this_thread::sleep_for(std::chrono::milliseconds(a.fast ? 1 : 50));
    steps.clear();
    (*player)->takeSteps(steps);
    for (const ForceStep& step : steps) {
      figures.add(step);
      if (log) log->write(step, 1 / rate_Hz, *button);
      if (draws && drawn.size() < mostDrawnSteps) drawn.push_back(step);
    }
    line.show(liveText((*player)->status(), *button));
    if (cancelled()) (*player)->stop();
  }
  line.end();
  const ForceStatus status = (*player)->status();
  player->reset();
  if (log) {
    if (Result<Done> written = log->finish(); !written) return fail(written.failure());
  }
  if (Result<Done> pictures = writePictures(a, *button, drawn, 1 / rate_Hz); !pictures)
    return fail(pictures.failure());
  printForceFigures(status, figures, summary, rate_Hz);
  printHalt(status);
  if (a.json) print(jsonOf(a, *button, device, pace, summary, status, figures, rate_Hz));
  return 0;
}

}  // namespace

void addForceCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "force",
      "Render a button as force on a force-feedback device or under a simulated finger. Units: mm, N, s, mJ");
  const auto arguments = std::make_shared<ForceArguments>();
  addForceOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runForce(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
