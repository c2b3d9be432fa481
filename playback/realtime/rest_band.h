// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Removes a hand's tremor and mains hum: a small and fast oscillation of the force around one value counts as
// rest. Follows force_steadier.h, which removes the sensor's own noise.

#include <array>
#include <cstddef>
#include <cstdint>

namespace detent::playback {

/// Readings within about a quarter of a second, in bins of 16 ms; the oldest bin is dropped when a new one
/// begins. O(1), no allocation.
class SwingWindow {
 public:
  static constexpr std::size_t binCount = 16;
  static constexpr double bin_s = 0.016;

  struct Swing {
    double lowest_N = 0, highest_N = 0;
    double way_N = 0;    ///< sum of all steps, up and down
    double drift_N = 0;  ///< mean of the newer half minus that of the older one
    double range_N() const { return highest_N - lowest_N; }
    /// number of half swings; 1: movement in one direction only
    double turns() const { return way_N / range_N(); }
  };

  /// Returns true if `time_s` begins a new bin and all previous ones are full: `swing` then describes them.
  bool add(double time_s, double reading_N, Swing& swing);
  void startAnew() { filled_ = 0; }

 private:
  struct Bin {
    double lowest_N = 0, highest_N = 0, way_N = 0, sum_N = 0;
    std::uint32_t count = 0;
  };

  void open(double reading_N);
  Swing swing() const;

  std::array<Bin, binCount> bins_{};
  std::size_t newest_ = 0, filled_ = 0;
  double binEnds_s_ = 0, last_N_ = 0;
};

/// Holds the force while it only oscillates. Other readings pass unchanged: a movement, however slow, does
/// not come back within a quarter of a second and is not held. The numbers are justified in
/// docs/develop/decisions/0906. Any thread, one owner; no allocation.
class RestBand {
 public:
  /// `most_N`: a larger swing is movement; 0: everything passes.
  void configure(double most_N) { most_N_ = most_N; }

  /// The force for this reading. Readings must be finite, times increasing.
  double next(double time_s, double reading_N);
  /// The next reading is a new start.
  void startAnew();

  /// Range of the swing that is being held; 0: readings pass.
  double swing_N() const { return swing_N_; }

 private:
  enum class Motion : std::uint8_t { up, down, rest };

  void judge(double time_s, const SwingWindow::Swing& swing);
  bool swings(const SwingWindow::Swing& swing) const;
  static bool drifts(const SwingWindow::Swing& swing);
  void restWithin(const SwingWindow::Swing& swing);
  void leave(Motion motion, double reading_N);
  void follow(double reading_N);

  double most_N_ = 0;
  SwingWindow window_;
  Motion motion_ = Motion::up;
  double force_N_ = 0;
  double swing_N_ = 0, swungAt_s_ = 0;
  double lowest_N_ = 0, highest_N_ = 0;  // range of the swing when the finger came to rest
};

}  // namespace detent::playback
