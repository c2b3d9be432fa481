// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A hand's tremor and the hum of the mains are no movement: a force that swings to and fro, little and fast,
// around one place rests. Follows force_steadier.h, which takes the sensor's own noise out.

#include <array>
#include <cstddef>
#include <cstdint>

namespace detent::playback {

/// Readings within about a quarter of a second, in bins of 16 ms; the oldest bin goes as a new one begins.
/// O(1), no allocation.
class SwingWindow {
 public:
  static constexpr std::size_t binCount = 16;
  static constexpr double bin_s = 0.016;

  struct Swing {
    double lowest_N = 0, highest_N = 0;
    double way_N = 0;    ///< sum of all steps, up and down
    double drift_N = 0;  ///< mean of the newer half less that of the older
    double range_N() const { return highest_N - lowest_N; }
    double turns() const { return way_N / range_N(); }  ///< half swings; 1: one way only
  };

  /// Returns true if `time_s` begins a new bin and all before it are full: `swing` then describes those.
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

/// Holds the force while it only swings. What does not swing passes bit for bit: of a movement, however slow,
/// nothing is held, since it does not come back within a quarter of a second. The numbers are claims of
/// docs/develop/decisions/0906. Any thread, one owner; no allocation.
class RestBand {
 public:
  /// `most_N`: a swing over more is movement; 0: everything passes.
  void configure(double most_N) { most_N_ = most_N; }

  /// The force for this reading. Readings must be finite, times increasing.
  double next(double time_s, double reading_N);
  /// The next reading is a new start.
  void startAnew();

  /// Range of the swing that counts now; 0: readings pass.
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
  double lowest_N_ = 0, highest_N_ = 0;  // of the swing at which it came to rest
};

}  // namespace detent::playback
