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

/// One event between two readings.
struct Crossing {
  CrossingKind kind = CrossingKind::grain;
  std::uint16_t jump = 0;  ///< index into the stroke's jumps
  std::uint8_t state = 0;  ///< state of the button in which the event happened
  /// number of grains merged into this one (only if more were crossed than are kept separately)
  std::uint32_t count = 1;
  /// time of the event as a share of the interval between the two readings, 0..1, never decreasing
  double fraction = 1;
  double displacement_mm = 0;
  double level = 1;  ///< for a grain: level of its slope
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
  double force_N = 0;  ///< last reading; for displacement inputs the table's force
  bool releasing = false;
  bool contact = false;  ///< true from the operating point to the reset point
  std::uint8_t state = 0;
};

/// Follows readings along the program's tables:
/// - increasing force moves along the press stroke to where the curve stays above it; decreasing force, once
///   it has turned back by the hysteresis, moves along the release stroke; never backwards within one stroke;
/// - a jump fires once, and again only after its re-arm position (chatter is counted, not played);
/// - a grain at g is crossed in pressing if x0 < g <= x1, in releasing if x1 < g <= x0, so that none is lost
///   or doubled;
/// - if a state's release does not end at the start of its press, a press without actuation returns to that
///   start, and the distance between both is silent;
/// - a self-locking button changes its state when it is released after an actuation.
/// Readings must be finite (force_conditioner.h ensures it). Callback thread; no allocation.
class StrokeTracker {
 public:
  /// Keeps a reference; `program` must outlive its use here. Silent: starts at rest, all armed.
  void use(const HapticProgram* program);

  /// Exchanges the program for the same button at another speed, under a pressing finger: events behind the
  /// finger count as passed, and within a jump the finger is placed before it. No crossings result; the next
  /// reading continues from here.
  void exchange(const HapticProgram* program);

  /// Follows one force reading; the result is valid until the next call.
  const Crossings& updateForce(double force_N);
  const Crossings& updateDisplacement(double displacement_mm);

  /// Moves to where this force would have led from rest, without any crossing: after a sensor came back, or a
  /// program was exchanged under a resting finger.
  void placeAtForce(double force_N);
  /// Moves to where a press from rest to this displacement would have led, without any crossing.
  void placeAtDisplacement(double displacement_mm);

  const StrokePosition& position() const { return position_; }
  /// Number of jumps and bottom-outs passed while not armed.
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
