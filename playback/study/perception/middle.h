// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The button between two others that people are forecast to distinguish from either equally well.

#include <functional>

#include "playback/study/perception/confusion.h"

namespace detent::playback {

struct PerceptualMiddle {
  double share = 0.5;  ///< share of the way, as between() of model/blend.h takes it
  Button button;
  double dPrimeFrom = 0, dPrimeTo = 0;  ///< forecast between the middle and either button

  /// True if the halves differ by at most 5 %. Forecasts count whole grains, so a pair that differs by one
  /// grain may have no such place.
  bool equal() const;
};

/// The button at a share of the way, 0 to 1, and its difference from either button. Failures: those of
/// between() and feel().
Result<PerceptualMiddle> placeBetween(const Button& from, const Button& to, double share,
                                      const std::function<bool()>& cancelled = {});

/// The middle between two buttons; if the halves are never equal, the place where they differ least. Half the
/// way if the buttons do not differ. Some 40 forecasts. Failures: those of between() and feel().
Result<PerceptualMiddle> perceptualMiddle(const Button& from, const Button& to,
                                          const PerceptionSettings& perception = {},
                                          const ConfusionSettings& confusion = {},
                                          const std::function<bool()>& cancelled = {});

}  // namespace detent::playback
