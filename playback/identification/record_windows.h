// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Windows over a record that average, differentiate and differentiate twice with one and the same weight
// function. For any quantity q of the record, the rate is exactly the change of the average as the window
// moves, so both sides of F = c + k x + d(way)/dt + m a are smoothed in the same way. (Shinbrot's modulating
// functions, 1957.)

#include <cstddef>
#include <vector>

#include "playback/identification/force_record.h"

namespace detent::playback {

/// Weights of one sample of a window: average = sum of mean q, rate = sum of perS q, curvature = sum of perS2
/// q.
struct SampleShare {
  double mean = 0, perS = 0, perS2 = 0;
};

/// Refers to the record from which it was made. One thread.
class RecordWindows {
 public:
  /// Makes each window just long enough to span `lowestQuanta` displacement steps of the recording, so that
  /// rounding does not hide slow movements and fast ones are not smeared. The record has at least 17 samples.
  RecordWindows(const ForceRecord& record, double lowestQuanta);

  /// Smallest change of displacement in the record (mm).
  double step_mm() const { return step_mm_; }
  /// Returns false if a window would extend beyond the record.
  bool inside(std::size_t at) const { return half_[at] > 0; }
  /// First sample of the window around an inside sample.
  std::size_t first(std::size_t at) const { return at - half_[at]; }
  /// The shares of the window's samples, from `first` on. A constant has rate and curvature 0, a straight
  /// line a rate of 1.
  void shares(std::size_t at, std::vector<SampleShare>& out) const;

 private:
  const ForceRecord& record_;
  double step_mm_ = 0;
  std::vector<std::size_t> half_;
};

/// Stretches in which the handle rests: runs of one reading that it enters and leaves on the same side, or
/// that are at an end of the record.
struct Stays {
  static constexpr std::size_t moving = static_cast<std::size_t>(-1);
  /// number of each sample's rest; samples in movement have `moving`
  std::vector<std::size_t> level;
  std::size_t levels = 0;
};
/// Finds the rests. During a rest, rounding is one unknown number; during movement every sample has a
/// separate rounding error.
Stays staysOf(const std::vector<double>& displacement_mm);

}  // namespace detent::playback
