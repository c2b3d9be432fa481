// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Proves, by pushes of some millinewtons, that a positive force moves the handle outwards: motor and encoder
// are not reversed, and the encoder counts. No allocation, lock or clock.

#include <cstdint>

#include "playback/realtime/force_program.h"

namespace detent::playback {

/// Pushes in, out and in again. Each push must reverse the handle's movement; a hand that moves by itself
/// does not do that in step with the pushes.
class DirectionProof {
 public:
  enum class Verdict : std::uint8_t {
    running,
    agrees,    ///< the handle followed all three pushes
    reversed,  ///< the handle moved against all three pushes
    unmoved    ///< the handle followed no push for 3 s: blocked, held, or the encoder does not count
  };

  DirectionProof(const DirectionProofSettings& settings, double period_s)
      : settings_(settings), period_s_(period_s) {}

  /// Starts anew.
  void restart();
  /// Force of the next period (positive: outwards), after one reading.
  double step_N(double position_mm);
  Verdict verdict() const { return verdict_; }

 private:
  void begin(double position_mm, double push);
  void firstPush(double position_mm);
  void turningPush(double position_mm);

  DirectionProofSettings settings_;
  double period_s_;
  Verdict verdict_ = Verdict::running;
  bool begun_ = false;
  std::uint32_t turns_ = 0;        ///< pushes that the handle has answered
  double push_ = 1;                ///< direction of the present push: 1 is inwards
  double moving_ = 0;              ///< direction in which the handle moves
  double answer_ = 0;              ///< 1: the handle follows the push, -1: it moves against it
  double from_mm_ = 0;             ///< position at which the first push began
  double farthest_mm_ = 0;         ///< farthest position in the direction of movement since the push changed
  double time_s_ = 0, all_s_ = 0;  ///< duration of this push, and of all
};

}  // namespace detent::playback
