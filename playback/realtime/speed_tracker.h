// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke tracker on a button that depends on speed: estimates the speed of a press during the press and
// uses the tables of that speed (docs/develop/decisions/1111).

#include <array>
#include <cstdint>
#include <vector>

#include "playback/realtime/live_program.h"
#include "playback/realtime/stroke_tracker.h"

namespace detent::playback {

/// Marks on the readings by which a press is timed, and the finger's distance between `from` and `to`.
struct PressMarks {
  double touch = 0, from = 0, to = 0;  ///< N or mm, rising
  double way_mm = 0;
};
/// Marks by displacement: from 10 to 90 % of the travel.
PressMarks placeMarks(const StateProgram& state);
/// Marks by force: from 10 % of the strongest force of the press to the strongest of its first half, where
/// the speed is known at the latest. The finger's movement is taken as proportional to its force, with the
/// whole travel at the strongest force. At a jump of the button, the finger does not jump.
PressMarks forceMarks(const StateProgram& state);

/// Predicts the speed of a press from the distance so far, by the marks of LiveProgram::program. Callback
/// thread; no allocation.
class PressPace {
 public:
  void use(const HapticProgram& front);
  /// Called after each reading, in N or mm. Returns false if it gives no new information.
  bool take(double value, bool isForce, std::uint8_t state, double time_s);
  double speed_mm_per_s() const { return speed_; }
  /// Returns true while a press is under way whose beginning was seen.
  bool begun() const { return begun_; }
  /// The next reading does not continue the previous one.
  void interrupt() { heard_ = begun_ = timed_ = false; }

 private:
  struct StateMarks {
    PressMarks mm, N;
  };

  std::array<StateMarks, maxStates> marks_{};
  double speed_ = 0;
  double before_ = 0, before_s_ = 0;     // the previous reading
  double touched_s_ = 0, passed_s_ = 0;  // times at which the press passed the marks `touch` and `from`
  bool heard_ = false, begun_ = false, timed_ = false;
};

/// A StrokeTracker for a button with or without graphs at several speeds. Each press has one speed: until its
/// first jump, at most until half the travel, it changes to the program of its measured speed; from then on,
/// and on its release, it keeps that program. A press begins with the program of the lowest speed. It changes
/// only with a reading of increasing force or displacement, so nothing moves under a resting finger. Events
/// behind the finger are not repeated, and no jump is lost. Without speeds it is the StrokeTracker. Callback
/// thread; no allocation.
class SpeedTracker {
 public:
  /// Sets the programs; both must outlive their use here. `speeds` as in LiveProgram, nullptr: none. A
  /// present press keeps its speed.
  void use(const HapticProgram* program, const std::vector<SpeedProgram>* speeds = nullptr);

  /// StrokeTracker's update, with the time of the reading.
  const Crossings& updateForce(double force_N, double time_s);
  const Crossings& updateDisplacement(double displacement_mm, double time_s);
  void placeAtForce(double force_N);
  void placeAtDisplacement(double displacement_mm);

  const StrokePosition& position() const { return tracker_.position(); }
  std::uint64_t suppressed() const { return tracker_.suppressed(); }
  /// Program to which the crossings of the last reading belong.
  const HapticProgram* program() const { return playing_; }
  /// Speed of the present or last press; 0: unknown.
  double speed_mm_per_s() const { return pace_.speed_mm_per_s(); }

 private:
  bool family() const { return speeds_ != nullptr && !speeds_->empty(); }
  void goOver(double value);
  void addCrossings(const Crossings& crossings, double value, bool isForce, double time_s);

  StrokeTracker tracker_;
  PressPace pace_;
  const std::vector<SpeedProgram>* speeds_ = nullptr;
  const HapticProgram* playing_ = nullptr;  // the tracker's program
  const HapticProgram* wanted_ = nullptr;   // program to use from the next reading on
  double last_ = 0;                         // reading, N or mm
  bool settled_ = false;
};

}  // namespace detent::playback
