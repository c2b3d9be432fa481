// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Readings of a Hall, TMR or inductive sensor under a switch over its travel. Reading order of the folder:
// magnetic_sensor.h, magnetic_key.h, simulate_key.h, write_key_tables.h. Method and limits:
// docs/guide/magnetic-switches.md.

#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

/// One measured point.
struct SensorPair {
  double displacement_mm = 0, reading = 0;  ///< reading in counts of the converter
};

inline constexpr double usualNoise = 2;  ///< standard deviation of a reading at rest, counts

/// Converts displacements to readings and back, linear between the points and beyond them. Immutable; any
/// thread.
class MagneticSensor {
 public:
  /// Failure unreadableInput about `subject`: fewer than two pairs, a value that is not finite, displacements
  /// that do not increase, readings that are not monotone, or noise outside 0..1e6.
  static Result<MagneticSensor> fromPairs(std::vector<SensorPair> pairs, double noise,
                                          const std::string& subject);
  /// Pairs from a CSV with the header `displacement_mm,reading`.
  static Result<MagneticSensor> fromCsv(const std::string& file, double noise);
  /// A magnet of 3 mm diameter and 2 mm length that approaches a 12 bit sensor on its axis, up to 1.2 mm at
  /// the end of `travel_mm` (> 0). A usual size; not measured on a switch.
  static MagneticSensor assumed(double travel_mm, double noise);

  double reading(double displacement_mm) const;
  double displacement_mm(double reading) const;
  const std::vector<SensorPair>& pairs() const { return pairs_; }
  double noise() const { return noise_; }  ///< standard deviation, counts
  bool isAssumed() const { return assumed_; }

 private:
  MagneticSensor(std::vector<SensorPair> pairs, double noise, bool assumed)
      : pairs_(std::move(pairs)), noise_(noise), assumed_(assumed) {}
  std::vector<SensorPair> pairs_;
  double noise_ = 0;
  bool assumed_ = false;
};

}  // namespace detent::playback
