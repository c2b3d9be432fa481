// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Identifies a device from the movement of its free handle under known forces: mass, Coulomb friction,
// damping, and the delay and lag of the motor, with standard errors. Model and rejected designs:
// docs/develop/decisions/1110-identifying-devices.md.

#include <cstddef>
#include <vector>

#include "model/result.h"
#include "playback/identification/identify.h"

namespace detent::playback {

/// Record of a loop; all columns have one length. A positive force acts against growing displacement.
struct MotionRecord {
  std::vector<double> time_s;  ///< increasing
  std::vector<double> position_mm;
  std::vector<double> force_N;  ///< commanded at this time, and kept until the next
  std::vector<bool> good;       ///< the position was read at this time; otherwise it has no meaning
  double step_mm = 0.01;        ///< > 0; of the encoder
};

struct MotionIdentification {
  Estimate mass_kg, friction_N, damping_Ns_per_mm;
  /// delay from a reading to the beginning of the force computed from it, beyond the hold of one period
  Estimate delay_s;
  Estimate lag_s;  ///< time constant with which the force follows after the delay
  /// sum of both, on which stability depends: known much more accurately than either
  Estimate late_s;
  /// steady force on the handle besides the motor's, in the direction of growing displacement (weight)
  Estimate offset_N;
  double residual_mm = 0;                  ///< rms deviation from the model
  double expected_mm = 0;                  ///< rms deviation that the encoder's steps alone would cause
  std::size_t stretches = 0, samples = 0;  ///< evaluated stretches of movement, and samples
  /// Returns true if the handle moves as mass, friction and damping predict. False: something else acts on it
  /// (a hand, a spring, a stop), or its force is not the commanded one.
  bool explained() const;
};

/// Failure unreadableInput: the record is too short, or the handle hardly moves. Any thread; takes a second
/// for ten seconds at 1 kHz.
Result<MotionIdentification> identifyMotion(const MotionRecord& record);

}  // namespace detent::playback
