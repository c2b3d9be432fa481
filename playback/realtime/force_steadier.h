// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A sensor's noise is not a finger's movement. Measures the noise of the readings themselves and gives a
// force that rises while the finger presses harder, falls while it lets go, and stays where it is while the
// finger holds still: in between no reading, however often it is repeated, moves it.

#include <array>
#include <cstddef>

namespace detent::playback {

/// Standard deviation of the white part of a stream of readings, from their fourth differences: what a finger
/// does is smooth at a sensor's rate and leaves them at nothing. A median keeps corners and single glitches
/// out, two running means make it a measure (3 % over 1024 readings). Any thread, one owner; no allocation.
class NoiseEstimate {
 public:
  void add(double reading);
  /// The readings before and after do not belong together (a silence, another trace); what is known stays.
  void startAnew() { historyCount_ = 0; }
  /// 0 until there are enough readings to tell.
  double sd() const;

 private:
  static constexpr std::size_t differenceOrder = 4;
  static constexpr std::size_t medianLength = 63;

  double medianWith(double magnitude);

  std::array<double, differenceOrder> history_{};  // newest first
  std::size_t historyCount_ = 0;
  std::array<double, medianLength> ring_{}, sorted_{};
  std::size_t ringNext_ = 0, ringCount_ = 0;
  double quickMean_ = 0, slowMean_ = 0;  // of the squares
  double count_ = 0;
};

/// Follows a finger through noise. Without noise it passes every reading on, bit for bit. With noise of
/// standard deviation s it keeps, over the last n = 1, 2, 4 .. 64 readings, means that are s / sqrt(n) sure:
/// - pressing, the force is the highest "mean less 2.5 s / sqrt(n)" since the finger turned: fast strokes are
///    followed by the short means, slow ones by the long ones;
///  - it turns when one of the means has fallen 8 s / sqrt(n) below its own highest;
///  - it rests, where it is, when two halves of the last 64 readings agree, and moves again when one of the
///    means leaves the resting mean by 7 standard deviations of their difference.
/// The numbers are claims of docs/develop/decisions/0906. Any thread, one owner; no allocation.
class ForceSteadier {
 public:
  /// `known`: SD of the sensor at rest, 0 where unknown; the larger of it and the measured one counts.
  /// `most`: an SD above is believed to be movement and counts as this.
  void configure(double known, double most) {
    known_ = known;
    most_ = most;
  }

  /// The force for this reading. Readings must be finite and evenly spaced but for jitter, times increasing.
  double next(double time_s, double reading);
  /// Starts anew with the next reading, after a pause. Keeps the estimate of the noise.
  void startAnew();
  /// Evaluates a reading of a recording about to be played, so that its noise is known from the start.
  void learn(double reading) { noise_.add(reading); }

  /// SD that counts now; 0: readings pass.
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
  std::array<double, windows> means_{};     // of the last 2^k readings
  std::array<double, windows> extremes_{};  // highest (or lowest) of each since the finger turned
  std::size_t extremeCount_ = 0;            // how many of them hold readings since then only
  std::size_t age_ = 0;                     // readings since then
  Motion motion_ = Motion::up;
  double force_ = 0, resting_ = 0;
  std::size_t restingCount_ = 0;  // readings behind resting_
  double restingSince_s_ = 0;
};

}  // namespace detent::playback
