// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From the movement of a free handle under known forces to what moves: mass, Coulomb friction, damping, and
// how late and how slowly the motor follows, with standard errors. Model and what was tried:
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
  std::vector<bool> good;       ///< the position was read here; else it stands for nothing
  double step_mm = 0.01;        ///< > 0; of the encoder
};

struct MotionIdentification {
  Estimate mass_kg, friction_N, damping_Ns_per_mm;
  Estimate
      delay_s;      ///< from a reading to the beginning of the force it causes, beyond the hold of one period
  Estimate lag_s;   ///< time constant with which the force then follows
  Estimate late_s;  ///< both together, which is what stability asks for: known far better than either
  Estimate offset_N;  ///< steady force on the handle besides the motor's, along growing displacement (weight)
  double residual_mm = 0;                  ///< rms of what the model leaves
  double expected_mm = 0;                  ///< rms of what the encoder's steps alone would leave
  std::size_t stretches = 0, samples = 0;  ///< of movement that entered
  /// Returns true if the handle moves as mass, friction and damping predict. False: something else acts on it
  /// (a hand, a spring, a stop), or its force is not the commanded one.
  bool explained() const;
};

/// Failure unreadableInput: too short, or it hardly moves. Any thread; takes a second for ten seconds at 1
/// kHz.
Result<MotionIdentification> identifyMotion(const MotionRecord& record);

}  // namespace detent::playback
