// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Separates a sensor's noise from a finger's movement. Measures the noise of the readings themselves, and
// returns a force that increases while the finger presses harder, decreases while it releases, and stays
// constant while the finger is still, however often noisy readings repeat.

#include <array>
#include <cstddef>

namespace detent::playback {

/// Standard deviation of the white part of a stream of readings, from their fourth differences: movements of
/// a finger are smooth at a sensor's rate and vanish in them. A median excludes corners and single glitches;
/// two running means make it accurate to 3 % over 1024 readings. Any thread, one owner; no allocation.
class NoiseEstimate {
 public:
  void add(double reading);
  /// The next reading does not continue the previous ones (a silence, another trace); the estimate is kept.
  void startAnew() { historyCount_ = 0; }
  /// 0 until there are enough readings.
  double sd() const;

 private:
  static constexpr std::size_t differenceOrder = 4;
  static constexpr std::size_t medianLength = 63;

  double medianWith(double magnitude);

  std::array<double, differenceOrder> history_{};  // newest first
  std::size_t historyCount_ = 0;
  std::array<double, medianLength> ring_{}, sorted_{};
  std::size_t ringNext_ = 0, ringCount_ = 0;
  double quickMean_ = 0, slowMean_ = 0;  // running means of the squares
  double count_ = 0;
};

/// Follows a finger through noise. Without noise it returns every reading unchanged. With noise of standard
/// deviation s it keeps means over the last n = 1, 2, 4 .. 64 readings, whose errors are s / sqrt(n):
/// - while pressing, the force is the highest value of "mean minus 2.5 s / sqrt(n)" since the finger turned,
///   so fast strokes are followed by the short means and slow ones by the long ones;
/// - it turns when one of the means has fallen 8 s / sqrt(n) below its own highest value;
/// - it rests when the two halves of the last 64 readings agree, and moves again when one of the means
///   differs from the resting mean by 7 standard deviations of their difference.
/// The numbers are justified in docs/develop/decisions/0906. Any thread, one owner; no allocation.
class ForceSteadier {
 public:
  /// `known`: SD of the sensor at rest, 0 if unknown; the larger of it and the measured one is used. `most`:
  /// a larger SD is taken as movement and limited to this.
  void configure(double known, double most) {
    known_ = known;
    most_ = most;
  }

  /// The force for this reading. Readings must be finite and evenly spaced except for jitter, with increasing
  /// times.
  double next(double time_s, double reading);
  /// Starts anew with the next reading, after a pause. Keeps the estimate of the noise.
  void startAnew();
  /// Evaluates a reading of a recording that is about to be played, so that its noise is known from the
  /// start.
  void learn(double reading) { noise_.add(reading); }

  /// SD in use; 0: readings are passed on unchanged.
  double noise() const;

 private:
  static constexpr std::size_t windows = 7;  // 1, 2, 4 .. 64 readings
  static constexpr std::size_t longest = std::size_t{1} << (windows - 1);
  enum class Motion { up, down, rest };

  void remember(double reading);
  bool turned(double s) const;
  void turn(Motion motion, std::size_t age);
  void followMotion(double s);
  void restIfStill(double s, double time_s);
  void moveIfLeft(double s, double time_s, double reading);

  NoiseEstimate noise_;
  double known_ = 0, most_ = 0;
  std::array<double, longest> ring_{};
  std::size_t newest_ = 0, count_ = 0;
  std::array<double, windows> means_{};     // mean of the last 2^k readings
  std::array<double, windows> extremes_{};  // highest (or lowest) of each since the finger turned
  std::size_t extremeCount_ = 0;            // number of means that contain only readings since then
  std::size_t age_ = 0;                     // readings since then
  Motion motion_ = Motion::up;
  double force_ = 0, resting_ = 0;
  std::size_t restingCount_ = 0;  // number of readings in resting_
  double restingSince_s_ = 0;
};

}  // namespace detent::playback
