// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Prepares a button for the force loop of a device. Only parts that the button has are prepared: no separate
// release if it equals the press curve, no damping table without damping, no second state for a momentary
// button.

#include <cstddef>
#include <optional>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/prepare/force_device_profile.h"
#include "playback/realtime/force_program.h"

namespace detent::playback {

/// graph: both curves, joined by a play operator. spring: the law of Shrestha's paper, one curve k(x) x and
/// b(x) v.
enum class ForceLawKind : std::uint8_t { graph, spring };

struct ForceSettings {
  ForceLawKind law = ForceLawKind::graph;
  VelocityMethod velocity = VelocityMethod::kalman;
  std::optional<double> rate_Hz;     ///< 50..20000; none: the device's own
  bool passivityController = false;  ///< adds damping when the energy balance of the observer falls below 0
};

/// Properties of the button that a device cannot render.
enum class ForceRemarkKind : std::uint8_t {
  bottomOutSoftened,  ///< value: steepest rise, limit: rendered (N/mm)
  fallSoftened,       ///< value: steepest fall, limit: rendered (N/mm)
  forceClipped,       ///< value: strongest force, limit: of the device (N)
  strokesCross,       ///< value: how far the release lies above the press (N); both are rendered equal there
  dampingLimited,     ///< value: strongest damping, limit: rendered (N·s/mm)
  /// value: how far a release lies above the press of another speed (N); both are rendered equal there
  speedsCross,
  /// value: strongest change of force with speed, positive if it damps; limit: rendered (N·s/mm)
  speedLimited,
  wideReturn,  ///< value: play radius; limit: a quarter of the travel (mm), to which the radius is reduced
};
struct ForceRemark {
  ForceRemarkKind kind{};
  std::size_t state = 0;
  double at_mm = 0, value = 0, limit = 0;
};

struct ForceSummary {
  double travel_mm = 0;
  double rest_mm = 0;  ///< position where the first state rests by itself, with no stored energy
  double slopeLimit_N_per_mm = 0;
  double playRadius_mm = 0;  ///< half of the travel from the press to the release curve
  double rowSpacing_mm = 0;  ///< coarsest of the states
  std::vector<ForceRemark> remarks;
};

struct PreparedForce {
  ForceProgram program;
  ForceSummary summary;
};

/// Failure wrongUsage names a value of device or settings outside its range, a travel outside 0.1..100 mm or
/// beyond the device's reach, or graphs at several speeds that together would create energy. Any thread;
/// allocates.
Result<PreparedForce> prepareForce(const Button& button, const ForceDeviceProfile& device,
                                   const ForceSettings& settings = {});

}  // namespace detent::playback
