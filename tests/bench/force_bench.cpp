// SPDX-License-Identifier: GPL-3.0-or-later
// detent_force_bench [step|rest|velocity|energy|identify|day ...] [sim|falcon|rig ...]: the tables of
// docs/measurements/bench-force.md, of all devices or those named.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "playback/identification/identify.h"
#include "tests/bench/coverage_count.h"
#include "tests/playback/force/force_run.h"
#include "tests/playback/force/sample_files.h"
#include "tests/playback/identification/pressed_record.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

std::vector<std::string> wanted;  // from the command line; empty: everything

std::vector<ForceDeviceProfile> presets() {
  const std::pair<const char*, ForceDeviceProfile> all[] = {
      {"sim", simulatedDevice()}, {"falcon", falconDevice()}, {"rig", voiceCoilRig()}};
  std::vector<ForceDeviceProfile> named, every;
  for (const auto& [name, profile] : all) {
    every.push_back(profile);
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) named.push_back(profile);
  }
  return named.empty() ? every : named;
}

/// The paper's law: force from the raw reading, velocity by the difference of two, press or release by its
/// sign.
class PaperLaw {
 public:
  PaperLaw(const Button& button, double period_s)
      : graph_(button.states().front().graph), period_s_(period_s) {}
  double step(double x_mm) {
    const double v = (x_mm - before_mm_) / period_s_;
    if (v != 0) pressing_ = v > 0;
    before_mm_ = x_mm;
    return graph_.curve(pressing_ ? Stroke::press : Stroke::release).force_N(x_mm);
  }

 private:
  ForceGraph graph_;
  double period_s_, before_mm_ = 0;
  bool pressing_ = true;
};

// Other programs lengthen some steps. The steps are the same in every pass, so the least time of each step
// over all passes is its own.
void stepTimes() {
  constexpr std::size_t steps = 10000000;
  constexpr int passes = 5;
  std::printf(
      "\nforce step: 1e7 steps of presses, ns; least of %d passes over the same steps\n%-8s %8s %8s %10s %8s "
      "| %14s\n",
      passes, "button", "median", "99.9 %", "99.9999 %", "worst", "worst, 1 pass");
  std::vector<float> least_ns(steps);
  for (const std::string& name : sampleNames()) {
    const PreparedForce prepared = forceOf(sampleButton(name), voiceCoilRig());
    const double travel_mm = prepared.summary.travel_mm;
    float worstOfOne_ns = 0;
    std::fill(least_ns.begin(), least_ns.end(), 1e30F);
    for (int pass = 0; pass < passes; ++pass) {
      ForceEngine engine(prepared.program);
      for (std::size_t i = 0; i < steps; ++i) {
        ForceReading reading;
        reading.position_mm =
            0.5 * travel_mm * (1.05 - std::cos(static_cast<double>(i % 4000) * 2 * std::numbers::pi / 4000));
        const auto begin = std::chrono::steady_clock::now();
        engine.step(reading);
        const auto time_ns = static_cast<float>(
            std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
        least_ns[i] = std::min(least_ns[i], time_ns);
        if (pass == 0) worstOfOne_ns = std::max(worstOfOne_ns, time_ns);
      }
    }
    std::sort(least_ns.begin(), least_ns.end());
    const auto at = [&](double share) {
      return static_cast<double>(least_ns[static_cast<std::size_t>(share * (steps - 1))]);
    };
    std::printf("%-8s %8.0f %8.0f %10.0f %8.0f | %14.0f\n", name.c_str(), at(0.5), at(0.999), at(0.999999),
                at(1), static_cast<double>(worstOfOne_ns));
    std::fflush(stdout);
  }
}

void resting() {
  std::printf(
      "\nresting finger, 6 um tremor, 20 places of the travel, 2 s each after 3 s; worst place\n%-28s %-6s "
      "| %8s %8s %8s | %8s %8s %8s\n",
      "device", "button", "steps pp", "rms mN", "jump mN", "paper pp", "rms mN", "jump mN");
  for (const ForceDeviceProfile& device : presets()) {
    for (const std::string& name : sampleNames()) {
      const Button button = sampleButton(name);
      const PreparedForce prepared = forceOf(button, device);
      double worst[6] = {};
      for (int place = 0; place < 20; ++place) {
        const double at_mm = prepared.summary.travel_mm * place / 20;
        const FingerHold hold{at_mm, button.states().front().graph.press().force_N(at_mm) + device.friction_N,
                              0.4};
        ForceRun run(prepared, device, hold);
        Quiet quiet, paper;
        run.run(3);
        run.run(2, [&](const ForceStep& s) { quiet.add(s.position_mm, s.force_N); });
        SimulatedForceDevice other(simulationOf(device, prepared), SimulatedFinger({}, hold));
        PaperLaw law(button, prepared.program.period_s);
        ForceCommand command;
        for (int i = 0; i < 5000; ++i) {
          const ForceReading reading = other.exchange(command);
          command.force_N = law.step(reading.position_mm);
          if (i >= 3000) paper.add(reading.position_mm, command.force_N);
        }
        const double found[6] = {
            quiet.peakToPeak_mm() / device.step_mm, 1e3 * quiet.rms_N(), 1e3 * quiet.largestJump_N(),
            paper.peakToPeak_mm() / device.step_mm, 1e3 * paper.rms_N(), 1e3 * paper.largestJump_N()};
        for (int i = 0; i < 6; ++i) worst[i] = std::max(worst[i], found[i]);
      }
      std::printf("%-28s %-6s | %8.2f %8.2f %8.2f | %8.1f %8.1f %8.1f\n", device.name.c_str(), name.c_str(),
                  worst[0], worst[1], worst[2], worst[3], worst[4], worst[5]);
    }
  }
}

struct VelocityErrors {
  double moving = 0, resting = 0, delay_s = 0;
};

VelocityErrors velocityErrors(VelocityMethod method, double step_mm, double rate_Hz) {
  const double period_s = 1 / rate_Hz;
  const auto position = [](double t) {
    const double s = std::clamp(t / 0.1, 0.0, 1.0);
    return 4 * s * s * s * (10 + s * (6 * s - 15));
  };
  const auto velocity = [](double t) {
    const double s = std::clamp(t / 0.1, 0.0, 1.0);
    return 4 * 30 * s * s * (1 - s) * (1 - s) / 0.1;
  };
  const auto steps = static_cast<int>(0.1 * rate_Hz), restSteps = static_cast<int>(rate_Hz);
  std::vector<double> byDelay(12, 0.0);
  double resting = 0;
  for (int place = 0; place < 20; ++place) {
    double steady_mm = 0;
    const auto read = [&](double x_mm) {
      const double at_mm = std::round((x_mm + step_mm * place / 20) / step_mm) * step_mm,
                   half_mm = 0.5 * step_mm * (1 + 1e-9);
      return steady_mm = std::max(at_mm - half_mm, std::min(at_mm + half_mm, steady_mm));
    };
    VelocityEstimator estimator(method, period_s, step_mm);
    estimator.restart(read(0));
    for (int k = 1; k <= steps; ++k) {
      const double estimate = estimator.update(read(position(k * period_s)));
      for (std::size_t d = 0; d < byDelay.size(); ++d) {
        const double off = estimate - velocity(k * period_s - static_cast<double>(d) * 0.0005);
        byDelay[d] += off * off;
      }
    }
    for (int k = 0; k < restSteps / 5; ++k) estimator.update(read(4));
    for (int k = 0; k < restSteps; ++k) {
      const double v = estimator.update(read(4 + 0.006 * std::sin(2 * std::numbers::pi * 9 * k * period_s)));
      resting += v * v;
    }
  }
  const auto best = std::min_element(byDelay.begin(), byDelay.end());
  return {std::sqrt(byDelay[0] / (20.0 * steps)), std::sqrt(resting / (20.0 * restSteps)),
          0.0005 * static_cast<double>(best - byDelay.begin())};
}

void velocities() {
  std::printf(
      "\nvelocity: press of 4 mm in 100 ms, then rest with 6 um tremor; rms mm/s moving, at rest, delay "
      "ms\n%8s %8s | %-22s | %-22s | %-22s\n",
      "step um", "rate Hz", "Kalman with bound", "FOAW", "difference (paper)");
  for (const double step_mm : {0.001, 0.01, 0.038}) {
    for (const double rate_Hz : {500.0, 1000.0, 4000.0, 10000.0}) {
      std::printf("%8.0f %8.0f", 1000 * step_mm, rate_Hz);
      for (const VelocityMethod method :
           {VelocityMethod::kalman, VelocityMethod::foaw, VelocityMethod::difference}) {
        const VelocityErrors e = velocityErrors(method, step_mm, rate_Hz);
        std::printf(" | %6.2f %6.2f %6.1f   ", e.moving, e.resting, 1000 * e.delay_s);
      }
      std::printf("\n");
    }
  }
}

/// Results of random presses of one pair of device and sample.
struct EnergyFigures {
  double finger_mJ = 0, motor_mJ = 0, most_mJ = 0, worstShare = 0, fastest_mm_per_s = 0;
  std::uint64_t frozen = 0, absurd = 0, faded = 0;
};

// Runs of four presses, so that the states of a self-locking button alternate. A finger that waits within the
// start's ramp gets energy from that, not from the button. Each pair has its own random numbers: it gives the
// same alone as among all.
EnergyFigures energyOf(const ForceDeviceProfile& device, const std::string& sample, int presses) {
  const std::string pair = device.name + sample;
  std::seed_seq seeds(pair.begin(), pair.end());
  std::mt19937 random(seeds);
  std::uniform_real_distribution<> share(0, 1);
  const PreparedForce prepared = forceOf(sampleButton(sample), device);
  EnergyFigures e;
  for (int press = 0; press < presses; press += 4) {
    const double travel_mm = prepared.summary.travel_mm * (0.3 + 0.75 * share(random)),
                 force_N = 0.3 + 2 * share(random), press_s = 0.04 + 0.3 * share(random),
                 release_s = 0.03 + 0.3 * share(random);
    const FingerPresses plan{travel_mm, force_N, press_s, release_s, 0.25};
    FingerMechanics finger;
    finger.stiffness_N_per_mm = 0.2 + 0.6 * share(random);
    finger.damping_Ns_per_mm = 0.0005 + 0.003 * share(random);
    ForceRun run(prepared, device, plan, finger);
    double taken_mJ = 0;
    run.run(4 * (plan.press_s + plan.release_s + 0.4), [&](const ForceStep& s) {
      taken_mJ = std::max(taken_mJ, s.energy_mJ);
      e.fastest_mm_per_s = std::max(e.fastest_mm_per_s, std::abs(s.velocity_mm_per_s));
    });
    e.finger_mJ = std::min(e.finger_mJ, run.leastFingerWork_mJ());
    e.motor_mJ = std::min(e.motor_mJ, run.engine().lowestBalance_mJ());
    if (taken_mJ > 0) e.worstShare = std::min(e.worstShare, run.engine().lowestBalance_mJ() / taken_mJ);
    e.most_mJ = std::max(e.most_mJ, taken_mJ);
    e.frozen += run.engine().counts().frozen;
    e.absurd += run.engine().counts().absurd;
    e.faded += run.engine().counts().faded + run.engine().counts().tooFast;
  }
  return e;
}

// The finger's net work is what a person would feel. The observer's balance is the motor's, sampled; `share`
// is of the most that the same run of four presses had put in. Nothing is wrong with the device: every frozen
// or absurd reading is a false alarm.
void energies() {
  constexpr int presses = 10000;
  std::printf(
      "\nenergy: %d random presses per device and sample, mJ\n%-28s %-6s %16s %16s %10s %8s %8s %7s %7s "
      "%7s\n",
      presses, "device", "button", "least at finger", "least at motor", "taken", "share %", "m/s", "frozen",
      "absurd", "faded");
  for (const ForceDeviceProfile& device : presets()) {
    for (const std::string& name : sampleNames()) {
      const EnergyFigures e = energyOf(device, name, presses);
      std::printf("%-28s %-6s %16.6f %16.6f %10.2f %8.2f %8.2f %7llu %7llu %7llu\n", device.name.c_str(),
                  name.c_str(), e.finger_mJ, e.motor_mJ, e.most_mJ, 100 * e.worstShare,
                  e.fastest_mm_per_s / 1000, static_cast<unsigned long long>(e.frozen),
                  static_cast<unsigned long long>(e.absurd), static_cast<unsigned long long>(e.faded));
      std::fflush(stdout);
    }
  }
}

void printRow(const char* name, const CoverageCount& k, const CoverageCount& b) {
  std::printf("| %s | %.2f, %.2f | %s | %.2f, %.2f | %s |\n", name, 100 * k.rms(), 100 * k.worst(),
              k.text().c_str(), 100 * b.rms(), 100 * b.worst(), b.text().c_str());
}

void identifyConstants(unsigned runs) {
  for (const double press_s : {0.06, 0.1, 0.2, 0.3, 0.5}) {
    PressedRecord press;
    press.presses_s = {press_s};
    CoverageCount k, b;
    for (unsigned seed = 0; seed < runs; ++seed) {
      const auto found = identify(recordOf(press, seed));
      if (!found) continue;
      k.add(found->k_N_per_mm[0].value, found->k_N_per_mm[0].sigma, 0.3);
      if (!found->b_Ns_per_mm.empty()) b.add(found->b_Ns_per_mm[0].value, found->b_Ns_per_mm[0].sigma, 0.003);
    }
    printRow((std::to_string(std::lround(1000 * press_s)) + " ms, " + std::to_string(b.count()) + " named")
                 .c_str(),
             k, b);
  }
}

void identifyKnots(unsigned runs, const char* name, PressedRecord presses) {
  // Parabolas, which eight knots represent exactly.
  presses.k = [](double x) { return 0.25 + 0.03 * (x - 2) * (x - 2); };
  presses.b = [](double x) { return 0.004 - 0.0005 * (x - 2) * (x - 2); };
  IdentifySettings settings;
  settings.knots = 8;
  std::vector<CoverageCount> k(8), b(8);
  for (unsigned seed = 0; seed < runs; ++seed) {
    const auto found = identify(recordOf(presses, seed), settings);
    if (!found) continue;
    for (std::size_t i = 0; i < 8; ++i) {
      const double at_mm = found->knots_mm[i];
      k[i].add(found->k_N_per_mm[i].value, found->k_N_per_mm[i].sigma, presses.k(at_mm));
      if (!found->b_Ns_per_mm.empty())
        b[i].add(found->b_Ns_per_mm[i].value, found->b_Ns_per_mm[i].sigma, presses.b(at_mm));
    }
  }
  for (std::size_t i = 0; i < 8; ++i) {
    char text[100];
    std::snprintf(text, sizeof text, "%s, knot %zu at %.2f mm, %zu named", name, i + 1,
                  4.0 * static_cast<double>(i) / 7, b[i].count());
    printRow(text, k[i], b[i]);
  }
}

void identifications() {
  constexpr unsigned runs = 1000;
  std::printf(
      "\nidentification, %u records each\n\n| record | k: rms, worst %% | 68.3 %% | 95.0 %% | b: rms, worst "
      "%% | 68.3 %% | 95.0 %% |\n|---|---|---|---|---|---|---|\n",
      runs);
  identifyConstants(runs);
  PressedRecord four;
  four.presses_s = {0.06, 0.1, 0.2, 0.5};
  identifyKnots(runs, "60 to 500 ms", four);
  four.tremor_mm = 0.003;
  identifyKnots(runs, "the same with 6 um of tremor", four);
}

void day() {
  std::printf(
      "\n24 simulated hours of a resting finger at half the travel of B; after the first minute and at the "
      "end\n");
  for (const ForceDeviceProfile& device : presets()) {
    const Button button = sampleButton("B");
    const PreparedForce prepared = forceOf(button, device);
    ForceRun run(prepared, device,
                 FingerHold{2, button.states().front().graph.press().force_N(2) + device.friction_N, 0.4});
    run.run(60);
    const ForceStep begin = run.engine().last();
    run.run(86400 - 60);
    const ForceStep& end = run.engine().last();
    std::printf("%-28s position %+.4f steps, force %+.4f mN, energy %+.6f mJ, %lld steps\n",
                device.name.c_str(), (end.position_mm - begin.position_mm) / device.step_mm,
                1000 * (end.force_N - begin.force_N), end.energy_mJ - begin.energy_mJ,
                static_cast<long long>(end.index));
  }
}

}  // namespace

int main(int argc, char** argv) {
  wanted.assign(argv + 1, argv + argc);
  const auto isWanted = [&](const char* name) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  if (isWanted("step")) stepTimes();
  if (isWanted("rest")) resting();
  if (isWanted("velocity")) velocities();
  if (isWanted("energy")) energies();
  if (isWanted("identify")) identifications();
  if (isWanted("day")) day();
  return 0;
}
