// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Help for the designer: the smallest change of one button after which people can distinguish it from
// another.

#include <functional>
#include <optional>
#include <vector>

#include "playback/study/perception/confusion.h"

namespace detent::playback {

/// Properties that may be changed, one at a time.
enum class Lever : std::uint8_t {
  snap,    ///< every jump of the press deeper or shallower (snap ratio)
  travel,  ///< the whole travel
  force    ///< all forces
};

struct Suggestion {
  Lever lever = Lever::snap;
  double factor = 1;  ///< factor on the snap ratio, the travel or the forces, in whole hundredths, as shown
  Button button;      ///< the changed button
  PredictedPair forecast;
};

struct DesignHelpSettings {
  /// largest factor of a lever, and the inverse of the smallest; beyond it the button would be a different
  /// one
  double largestFactor = 4;
  PerceptionSettings perception;
  ConfusionSettings confusion;
};

/// The least change by each lever that makes the forecast PredictedPair::distinguished(), smallest change
/// first. Empty if no lever achieves it, if the two are distinguishable already, or if `cancelled` returned
/// true. About a second. Failure: as feel().
Result<std::vector<Suggestion>> makeDistinguishable(const Button& button, const Button& other,
                                                    const DesignHelpSettings& settings = {},
                                                    const std::function<bool()>& cancelled = {});

}  // namespace detent::playback
