// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Velocity and acceleration of a recorded displacement, after the fact: a cubic through a window around each sample.

#include <vector>

#include "playback/identification/force_record.h"

namespace detent::playback {

struct RecordMotion {
  std::vector<double> velocity_mm_per_s, acceleration_mm_per_s2;
  std::vector<bool> inside;  ///< false where the window ran out of the record
  double step_mm = 0;        ///< smallest change of displacement in the record
};

/// The window is chosen by speed: as short as spans `lowestQuanta` steps of the recording, so that slow movements are not
/// drowned in its steps and fast ones not smeared. The record has at least 7 samples.
RecordMotion motionOf(const ForceRecord& record, double lowestQuanta);

}  // namespace detent::playback
