// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/speed_change.h"

#include <algorithm>

#include "model/speed_family.h"
#include "playback/prepare/damping.h"

namespace detent::playback {

namespace {

// Share of the device's damping that may be used, because it is not known better and the estimate of velocity
// is late.
constexpr double fedOfDamper = 0.5;

}  // namespace

SpeedDamping speedDampingAt(const ButtonState& state, double at_mm) {
  SpeedDamping found;
  const std::vector<double> speeds = speedsOf(state);
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    const auto change = [&](Stroke stroke) {
      return (graphAt(state, i).curve(stroke).force_N(at_mm) -
              graphAt(state, i - 1).curve(stroke).force_N(at_mm)) /
             (speeds[i] - speeds[i - 1]);
    };
    const double pressed = change(Stroke::press),
                 released = state.graph.release() ? -change(Stroke::release) : 0;
    found.least = std::min({found.least, pressed, released});
    found.most = std::max({found.most, pressed, released});
  }
  return found;
}

SpeedDamping renderedSpeedDamping(const ButtonState& state, const ForceDeviceProfile& device,
                                  double rate_Hz) {
  const double largest = largestDamping_Ns_per_mm(device, rate_Hz);
  double most = 0;
  for (const DampingPoint& point : state.damping) most = std::max(most, point.damping_Ns_per_mm);
  return {-(fedOfDamper * device.damping_Ns_per_mm + std::min(leastDamping(state.damping), largest)),
          largest - std::min(most, largest)};
}

}  // namespace detent::playback
