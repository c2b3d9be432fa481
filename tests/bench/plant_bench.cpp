// SPDX-License-Identifier: GPL-3.0-or-later
// detent_plant_bench [OUT.svg]: forces that the force engine requests of a motor when something goes wrong,
// on the independent world of tests/playback/plant. Draws force over time for a start deep in a bottom-out, a
// jump, silence and a stop, and prints the table of docs/measurements/bench-force.md; and how still a Falcon
// holds under a finger, by its friction. Deterministic; nothing is timed.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/playback/plant/closed_loop.h"
#include "tests/playback/plant/finger.h"

using namespace detent;
using namespace detent::test;

namespace {

constexpr double max_N = 5, ramp_s = 0.2, gone_s = 0.015;

playback::ForceProgram limitedProgram(const std::string& button) {
  playback::ForceDeviceProfile device = playback::simulatedDevice();
  device.limits.force_N = max_N;
  return preparedFor(sampleButton(button), device);
}

struct Scene {
  std::string title;
  double at_s = 0;                          ///< time of the fault
  std::vector<double> force_N;              ///< one value per period
  std::function<double(double)> allowed_N;  ///< allowed force over the time since the fault
};

/// A hand of 2 N/mm rests on the handle at a depth; faults come at `at_s`.
Scene played(const std::string& title, double depth_mm, double at_s, double end_s, std::vector<Fault> faults,
             bool stop) {
  const playback::ForceProgram program = limitedProgram("B");
  LoopSettings settings;
  settings.handle = handleOf(playback::simulatedDevice());
  settings.start_mm = depth_mm;
  settings.finger.stiffness_N_per_mm = 2;
  ClosedLoop loop(program, settings,
                  holding(depth_mm, std::min(max_N, 0.5 + std::max(0.0, depth_mm - 4) * 2)),
                  std::move(faults));
  Scene scene{title, at_s, {}, {}};
  for (std::int64_t k = 0; static_cast<double>(k) * program.period_s < end_s; ++k) {
    if (stop && static_cast<double>(k) * program.period_s >= at_s) loop.engine().stop();
    scene.force_N.push_back(loop.step().command_N);
  }
  return scene;
}

std::vector<Scene> scenes() {
  const auto afterFault = [](double since_s) { return since_s < gone_s ? max_N : 0; };
  std::vector<Scene> all;
  all.push_back(played("start 30 mm deep", 30, 0, 0.3, {}, false));
  all.back().allowed_N = [](double since_s) { return max_N * std::min(1.0, (since_s + 0.002) / ramp_s); };
  all.push_back(played("the position jumps by 50 mm", 3, 0.4, 0.7, {{FaultKind::jump, 400, 0, 50}}, false));
  all.back().allowed_N = afterFault;
  all.push_back(played("no readings any more", 5, 0.4, 0.7, {{FaultKind::silent, 400, 10000, 0}}, false));
  all.back().allowed_N = afterFault;
  all.push_back(played("stop", 5, 0.4, 0.7, {}, true));
  all.back().allowed_N = afterFault;
  return all;
}

/// Largest excess over the allowed force, from the fault on; 0: never.
double excess_N(const Scene& scene) {
  double most_N = 0;
  for (std::size_t k = 0; k < scene.force_N.size(); ++k) {
    const double since_s = static_cast<double>(k) * 0.001 - scene.at_s;
    if (since_s >= 0) most_N = std::max(most_N, std::abs(scene.force_N[k]) - scene.allowed_N(since_s));
  }
  return most_N;
}

std::string drawn(const std::vector<Scene>& all) {
  constexpr double width = 440, height = 200, left = 46, top = 30;
  std::ostringstream svg;
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"990\" height=\"530\" font-family=\"sans-serif\" "
         "font-size=\"12\">\n"
         "<rect width=\"990\" height=\"530\" fill=\"#ffffff\"/>\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Scene& scene = all[i];
    const double x0 = left + static_cast<double>(i % 2) * (width + 40),
                 y0 = top + static_cast<double>(i / 2) * (height + 60);
    const double from_s = scene.at_s > 0 ? scene.at_s - 0.02 : 0, length_s = scene.at_s > 0 ? 0.1 : 0.3;
    const auto x = [&](double time_s) { return x0 + (time_s - from_s) / length_s * (width - 20); };
    const auto y = [&](double force_N) { return y0 + height - std::max(0.0, force_N) / 6 * height; };
    svg << "<text x=\"" << x0 << "\" y=\"" << y0 - 8 << "\" font-weight=\"bold\">" << scene.title
        << "</text>\n";
    for (int newton = 0; newton <= 6; newton += 2)
      svg << "<line x1=\"" << x0 << "\" x2=\"" << x0 + width - 20 << "\" y1=\"" << y(newton) << "\" y2=\""
          << y(newton) << "\" stroke=\"#dddddd\"/><text x=\"" << x0 - 6 << "\" y=\"" << y(newton) + 4
          << "\" text-anchor=\"end\">" << newton << (newton == 6 ? " N" : "") << "</text>\n";
    for (int tick = 0; tick <= 5; ++tick) {
      const double time_s = from_s + length_s * tick / 5;
      svg << "<text x=\"" << x(time_s) << "\" y=\"" << y0 + height + 16 << "\" text-anchor=\"middle\">"
          << std::lround((time_s - scene.at_s) * 1000) << (tick == 5 ? " ms" : "") << "</text>\n";
    }
    std::ostringstream force, allowed;
    for (std::size_t k = 0; k < scene.force_N.size(); ++k) {
      const double time_s = static_cast<double>(k) * 0.001;
      if (time_s < from_s - 1e-9 || time_s > from_s + length_s + 1e-9) continue;
      force << x(time_s) << "," << y(std::abs(scene.force_N[k])) << " ";
      if (time_s >= scene.at_s) allowed << x(time_s) << "," << y(scene.allowed_N(time_s - scene.at_s)) << " ";
    }
    svg << "<polyline points=\"" << allowed.str()
        << "\" fill=\"none\" stroke=\"#c23b22\" stroke-dasharray=\"5 4\"/>\n"
        << "<polyline points=\"" << force.str()
        << "\" fill=\"none\" stroke=\"#1f4e9c\" stroke-width=\"2\"/>\n";
  }
  svg << "<text x=\"46\" y=\"520\">blue: the force asked of the motor, at most 5 N; red: what is "
         "allowed</text>\n</svg>\n";
  return svg.str();
}

double largestStepInFlicker_N(double size_mm) {
  const Scene scene = played("", 3, 0.4, 0.9, {{FaultKind::flicker, 400, 900, size_mm}}, false);
  double most_N = 0;
  for (std::size_t k = 400; k < scene.force_N.size(); ++k)
    most_N = std::max(most_N, std::abs(scene.force_N[k] - scene.force_N[k - 1]));
  return most_N;
}

double largestAfterJumps_N() {
  double most_N = 0;
  for (double jump_mm : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const Scene scene = played("", 3, 0.4, 1.4, {{FaultKind::jump, 400, 0, jump_mm}}, false);
    for (std::size_t k = 415; k < scene.force_N.size(); ++k)
      most_N = std::max(most_N, std::abs(scene.force_N[k]));
  }
  return most_N;
}

double largestOverRamp_N() {
  double most_N = 0;
  for (const char* button : {"A", "B", "D", "push", "latch"}) {
    const playback::ForceProgram program = limitedProgram(button);
    for (double depth_mm = 0; depth_mm <= 50; depth_mm += 1) {
      playback::ForceEngine engine(program);
      for (int k = 0; k < 200; ++k) {
        playback::ForceReading reading;
        reading.position_mm = depth_mm;
        const double allowed_N = max_N * std::min(1.0, (k + 2) * program.period_s / ramp_s);
        most_N = std::max(most_N, std::abs(engine.step(reading).force_N) - allowed_N);
      }
    }
  }
  return most_N;
}

// ---- a Falcon under a finger that holds still

struct Rest {
  int steps = 0;       ///< of the encoder, from the lowest to the highest reading
  double force_N = 0;  ///< rms of the force about its mean
  bool quiet() const { return steps <= 1 && force_N <= 0.005; }
};

/// From the third to the fifth second of holding at a place.
Rest restAt(const playback::ForceDeviceProfile& device, const playback::ForceProgram& program, double at_mm) {
  LoopSettings settings;
  settings.handle = handleOf(device);
  settings.encoderStep_mm = device.step_mm;
  settings.sending.delay_s = device.delay_s;
  ClosedLoop loop(program, settings, holding(at_mm));
  loop.runUntil(3);
  const std::vector<LoopStep> held = loop.runUntil(5);
  double sum = 0, squares = 0;
  for (const LoopStep& step : held) {
    sum += step.command_N;
    squares += step.command_N * step.command_N;
  }
  const auto count = static_cast<double>(held.size());
  const auto [low, high] = std::minmax_element(
      held.begin(), held.end(), [](const LoopStep& a, const LoopStep& b) { return a.read_mm < b.read_mm; });
  return {static_cast<int>(std::lround((high->read_mm - low->read_mm) / device.step_mm)),
          std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)))};
}

void printRest(double friction_N) {
  constexpr int positions = 11;
  playback::ForceDeviceProfile device = playback::falconDevice();
  device.friction_N = friction_N;
  std::printf("| %.0f mN |", 1000 * friction_N);
  for (const char* button : {"A", "B", "C", "E"}) {
    const playback::ForceProgram program = preparedFor(sampleButton(button), device);
    Rest worst;
    int quiet = 0;
    for (int place = 1; place <= positions; ++place) {
      const Rest rest = restAt(device, program, 0.3 * place);
      quiet += rest.quiet() ? 1 : 0;
      worst = {std::max(worst.steps, rest.steps), std::max(worst.force_N, rest.force_N)};
    }
    std::printf(" %d, %.0f; %d of %d |", worst.steps, 1000 * worst.force_N, quiet, positions);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Scene> all = scenes();
  if (argc > 1) std::ofstream(argv[1]) << drawn(all);
  std::printf("| scene, at most %.0f N | most above what is allowed, N |\n|---|---|\n", max_N);
  for (const Scene& scene : all) std::printf("| %s | %.2f |\n", scene.title.c_str(), excess_N(scene));
  std::printf("| start at 0 to 50 mm, five buttons | %.2f |\n", largestOverRamp_N());
  std::printf("| jumps of 1 to 100 mm: force later than 15 ms | %.2f |\n", largestAfterJumps_N());
  std::printf("| flicker of 1.5 mm at 1 kHz: largest step of force | %.2f |\n", largestStepInFlicker_N(1.5));
  std::printf(
      "\n| friction of a Falcon | A: steps, mN rms; quiet places | B | C | E |\n|---|---|---|---|---|\n");
  for (const double friction_N : {0.0, 0.01, 0.02, 0.03, 0.05, 0.1}) printRest(friction_N);
  return 0;
}
