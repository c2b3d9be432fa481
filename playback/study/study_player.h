// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The button under a participant's finger.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playback/playback.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

struct StudyPlayerSettings {
  PlayerSettings player;
  bool rehearse = false;   ///< no sound device: everything is followed, nothing is felt
  std::string sensorPort;  ///< empty: press() presses by itself
  unsigned baud = 230400;
  SensorCalibration calibration;
  /// A force-feedback device under the finger, in place of a sensor; sound comes from `player` only where
  /// that names a device, or masks. A simulated one is a rehearsal.
  std::optional<ForceDeviceChoice> force{};
};

/// The reason why a trial cannot be felt at present.
enum class StudyTrouble : std::uint8_t {
  none,
  soundLost,
  sensorUnplugged,
  sensorSilent,
  sensorStuck,
  forceLost,    ///< the force device went away
  forceStopped  ///< it gives no force until somebody arms it: stopForce(), a fault, a place that was lost
};
/// Name in the journal: "sensor silent".
const char* nameOf(StudyTrouble trouble);

/// The device under a participant's finger: plays any button of the study, in any of its modes, exchanged at
/// once; all are prepared before the first trial. One thread.
class StudyPlayer {
 public:
  /// Failure: as LivePlayer::start, attachSensor, ForcePlayer::start and prepareProgram; deviceTrouble: the
  /// sensor sends nothing within 3 s; wrongUsage: a force device for a study of what only a vibration has, or
  /// beside a sensor.
  static Result<std::unique_ptr<StudyPlayer>> start(const Study& study, const StudyPlayerSettings& settings);
  virtual ~StudyPlayer() = default;

  virtual bool sounding() const = 0;  ///< false: a rehearsal
  virtual std::string device() const = 0;
  virtual StudyRoute route() const = 0;
  /// Every stimulus begins as it was made: a self-locking button unlocked, X as well as the choice that is
  /// the same button.
  virtual void beginTrial() = 0;
  /// Puts a button under the finger as the trial's stimulus `slot` (TrialDesk), which keeps its own lock.
  virtual void place(std::size_t slot, std::size_t button, FeedbackMode mode) = 0;
  /// Likewise; without a sensor it is pressed once, as by a hand.
  virtual void press(std::size_t slot, std::size_t button, FeedbackMode mode) = 0;
  /// Movements of the finger since press() or the last call.
  virtual Felt takeFelt() = 0;
  /// Returns true if a sensor or a force device presses; else press() does, for the pressed key.
  virtual bool sensed() const = 0;
  /// Timing, where sensed(): times at which the contact closed since press() or the last call.
  virtual std::vector<ContactClosing> takeClosings() = 0;
  /// Now, on the clock of takeClosings().
  virtual double clock_s() const = 0;
  /// Timing: short tones so many seconds from now (>= 0, rising), each a buffer late at most, then what the
  /// device takes. Nothing sounds in a rehearsal.
  virtual void soundBeats(const std::vector<double>& delays_s) = 0;
  /// Trouble since the last call, or present trouble.
  virtual StudyTrouble troubleSinceAsked() = 0;
  /// Force device: removes the force within 15 ms, until rearm(). Does nothing without one.
  virtual void stopForce() = 0;
  /// A person wants force again.
  virtual void rearm() = 0;
};

}  // namespace detent::playback
