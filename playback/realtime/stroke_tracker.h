// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Force (or displacement) in, crossings out: the reverse function of Kim & Lee's Figure 2b on prepared
// tables, with the memory a jump needs. Finds every grain, jump, bottom-out and contact between two readings,
// in the order travelled.

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/haptic_program.h"

namespace detent::playback {

enum class CrossingKind : std::uint8_t {
  grain,
  pressJump,
  releaseJump,
  bottomOut,
  contactClosed,
  contactOpened
};

/// One thing met on the way between two readings.
struct Crossing {
  CrossingKind kind = CrossingKind::grain;
  std::uint16_t jump = 0;   ///< index into the stroke's jumps
  std::uint8_t state = 0;   ///< state of the button it belongs to
  std::uint32_t count = 1;  ///< grains merged into this one (only if more were crossed than are kept apart)
  double fraction = 1;      ///< when, as a share of the time between the two readings, 0..1, never decreasing
  double displacement_mm = 0;
  double level = 1;  ///< of a grain: its slope's
};

/// All crossings of one reading. Fixed size; owned by the tracker.
struct Crossings {
  static constexpr std::size_t capacity = 1024;
  std::array<Crossing, capacity> items{};
  std::size_t count = 0;
};

/// Position of the finger.
struct StrokePosition {
  double displacement_mm = 0;
  double force_N = 0;  ///< last reading; of displacement inputs the table's force
  bool releasing = false;
  bool contact = false;  ///< between operating point and reset point
  std::uint8_t state = 0;
};

/// Follows readings along the program's tables:
///  - rising force moves along the press stroke to where the curve stays above it; falling force, once it has
///    turned back by the hysteresis, along the release stroke; never backwards within one stroke;
///  - a jump fires once and again only after its re-arm position (chatter is counted, not played);
///  - a grain on the grid g is crossed upwards by x0 < g <= x1, downwards by x1 < g <= x0: none lost, none
///    doubled;
///  - where a state's release does not end at the start of its press, a press that has not actuated returns to
///    that start, and the way between both ends is silent;
///  - a self-locking button changes its state when it is released after an actuation.
/// Readings must be finite (force_conditioner.h sees to it). Callback thread; no allocation.
class StrokeTracker {
 public:
  /// Keeps a reference; `program` must outlive its use here. Silent: starts at rest, all armed.
  void use(const HapticProgram* program);

  /// The same button at another speed, under a finger that presses: what lies behind it has been met, and
  /// where it stands within a jump it stands before it. Silent by itself; the next reading leads on from
  /// here.
  void exchange(const HapticProgram* program);

  /// Follows one force reading; the answer is valid until the next call.
  const Crossings& updateForce(double force_N);
  const Crossings& updateDisplacement(double displacement_mm);

  /// Goes to where this force would have led from rest, without any crossing: after a sensor came back, or a
  /// program was exchanged under a resting finger.
  void placeAtForce(double force_N);
  /// Likewise, to where a press from rest to this displacement would have led.
  void placeAtDisplacement(double displacement_mm);

  const StrokePosition& position() const { return position_; }
  /// Jumps and bottom-outs met while not armed.
  std::uint64_t suppressed() const { return suppressed_; }

 private:
  struct Piece;
  const StateProgram& state() const { return program_->states[position_.state]; }
  const StrokeTable& table() const { return position_.releasing ? state().release : state().press; }

  void toRest();
  void begin();
  void finish();
  void turn(bool releasing, double extreme_N);
  void advanceByForce(double from_N, double to_N);
  void advanceByDisplacement(double to_mm);
  void cross(const Piece& piece);
  void crossGrains(const Piece& piece);
  void boundGrainsUpTo(double farthest_mm);
  void addGrain(std::int64_t index, std::int64_t merged, double level, const Piece& piece);
  void add(CrossingKind kind, std::size_t jump, double at_mm, const Piece& piece);
  void rearm();
  void spreadTies();
  std::int64_t grainCell(double displacement_mm) const;
  double forceAt(double displacement_mm) const;
  double releaseEnd_mm() const;
  double restingPlace_mm() const;

  const HapticProgram* program_ = nullptr;
  StrokePosition position_;
  double extreme_N_ = 0;
  double extreme_mm_ = 0;
  bool bottomOutArmed_ = true;
  bool actuated_ = false;
  std::bitset<maxJumps> pressFired_, releaseFired_;
  std::uint64_t suppressed_ = 0;
  std::int64_t grainStride_ = 1;
  Crossings crossings_;
};

}  // namespace detent::playback
