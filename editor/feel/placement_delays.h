// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The measured delays of the two ways to place events, for showing beside the choice.

#include <QString>

#include "playback/playback.h"

namespace detent::editor {

/// Force crossing on a 425 Hz serial sensor to onset, from docs/measurements/bench-playback.md (a test
/// compares them).
struct PlacementDelay {
  playback::EventPlacement placement;
  int bufferFrames;             ///< at 48 kHz
  double median_ms, spread_ms;  ///< spread: 95th minus 5th percentile
};
inline constexpr PlacementDelay placementDelays[] = {
    {playback::EventPlacement::atOnce, 64, 1.78, 2.71},
    {playback::EventPlacement::timeStamped, 64, 3.75, 0.05},
    {playback::EventPlacement::atOnce, 128, 2.60, 3.59},
    {playback::EventPlacement::timeStamped, 128, 5.09, 0.05},
};

/// "1.8 ms, scattered over 2.7 ms (64 frames at 48 kHz)", for the measured buffer nearest to `bufferFrames`
/// (0: the smallest).
QString measuredDelay(playback::EventPlacement placement, unsigned bufferFrames);

}  // namespace detent::editor
