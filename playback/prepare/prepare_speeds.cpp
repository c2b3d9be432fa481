// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/prepare_speeds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/speed_family.h"

namespace detent::playback {

namespace {

constexpr int speedSamples = 256;  // number of displacements along a stroke

/// Largest change of force from one speed to the next, and the strongest force.
struct Change {
  double most_N = 0, strongest_N = 0;
};

void examine(const StrokeCurve& slow, const StrokeCurve& fast, Change& change) {
  for (int i = 0; i <= speedSamples; ++i) {
    const double at_mm = slow.start_mm() + slow.travel_mm() * i / speedSamples;
    const double slow_N = slow.force_N(at_mm),
                 fast_N = fast.force_N(std::clamp(at_mm, fast.start_mm(), fast.end_mm()));
    change.most_N = std::max(change.most_N, std::fabs(fast_N - slow_N));
    change.strongest_N = std::max({change.strongest_N, std::fabs(slow_N), std::fabs(fast_N)});
  }
}

int stepsAfter(const Button& button, std::size_t index) {
  Change change;
  for (const ButtonState& state : button.states())
    for (const Stroke stroke : {Stroke::press, Stroke::release})
      examine(graphAt(state, index).curve(stroke), graphAt(state, index + 1).curve(stroke), change);
  if (!(change.most_N > 0)) return 1;
  const double steps = std::ceil(change.most_N / (finestSpeedStep * change.strongest_N));
  return static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(mostSpeedSteps)));
}

std::vector<double> speedsToPrepare(const Button& button) {
  const std::vector<double> stated = speedsOf(button);
  std::vector<double> speeds;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    speeds.push_back(stated[i]);
    if (i + 1 == stated.size()) break;
    const int steps = stepsAfter(button, i);
    for (int k = 1; k < steps; ++k) speeds.push_back(stated[i] + (stated[i + 1] - stated[i]) * k / steps);
  }
  return speeds;
}

}  // namespace

Result<std::vector<SpeedProgram>> prepareSpeeds(const Button& button, const DeviceProfile& profile,
                                                const PlaybackSettings& settings) {
  std::vector<SpeedProgram> programs;
  const std::vector<double> speeds = speedsToPrepare(button);
  programs.reserve(speeds.size());
  for (const double speed_mm_per_s : speeds) {
    Result<Button> one = atSpeed(button, speed_mm_per_s);
    if (!one) return one.failure();
    Result<PreparedProgram> prepared = prepareProgram(*one, profile, settings);
    if (!prepared) return prepared.failure();
    programs.push_back({speed_mm_per_s, prepared->program});
  }
  return programs;
}

Result<LiveProgram> prepareLive(const PreparedProgram& front, const Button& button,
                                const DeviceProfile& profile, const PlaybackSettings& settings) {
  Result<std::vector<SpeedProgram>> speeds = prepareSpeeds(button, profile, settings);
  if (!speeds) return speeds.failure();
  return LiveProgram(front.program, *std::move(speeds));
}

}  // namespace detent::playback
