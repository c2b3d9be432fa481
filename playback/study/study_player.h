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
  bool rehearse = false;   ///< no sound device: everything is tracked, nothing is felt
  std::string sensorPort;  ///< empty: press() makes the presses
  unsigned baud = 230400;
  SensorCalibration calibration;
  /// A force-feedback device in place of a sensor. `player` then makes sound only if it names a device, or
  /// for masking. With a simulated device the session is a rehearsal.
  std::optional<ForceDeviceChoice> force{};
};

/// The reason why a trial cannot be felt at present.
enum class StudyTrouble : std::uint8_t {
  none,
  soundLost,
  sensorUnplugged,
  sensorSilent,
  sensorStuck,
  forceLost,  ///< the force device disappeared
  /// it gives no force until a person arms it: after stopForce(), a fault, or a lost position
  forceStopped
};
/// Name in the journal: "sensor silent".
const char* nameOf(StudyTrouble trouble);

/// The device under a participant's finger: plays any button of the study, in any of its modes, with
/// immediate exchange; all are prepared before the first trial. One thread.
class StudyPlayer {
 public:
  /// Failure: as LivePlayer::start, attachSensor, ForcePlayer::start and prepareProgram; deviceTrouble: the
  /// sensor sends nothing within 3 s; wrongUsage: a force device together with a sensor, or for a study of a
  /// quantity that only a vibration has.
  static Result<std::unique_ptr<StudyPlayer>> start(const Study& study, const StudyPlayerSettings& settings);
  virtual ~StudyPlayer() = default;

  virtual bool sounding() const = 0;  ///< false: a rehearsal
  virtual std::string device() const = 0;
  virtual StudyRoute route() const = 0;
  /// Resets every stimulus to its initial state: a self-locking button is unlocked, X as well as the choice
  /// that is the same button.
  virtual void beginTrial() = 0;
  /// Puts a button under the finger as the trial's stimulus `slot` (TrialController), which keeps its own
  /// lock.
  virtual void place(std::size_t slot, std::size_t button, FeedbackMode mode) = 0;
  /// The same; without a sensor the button is also pressed once, as by a hand.
  virtual void press(std::size_t slot, std::size_t button, FeedbackMode mode) = 0;
  /// Movements of the finger since press() or the last call.
  virtual Felt takeFelt() = 0;
  /// Returns true if a sensor or a force device measures presses; otherwise press() makes them for a pressed
  /// key.
  virtual bool sensed() const = 0;
  /// Timing, where sensed(): times at which the contact closed since press() or the last call.
  virtual std::vector<ContactClosing> takeClosings() = 0;
  /// Now, on the clock of takeClosings().
  virtual double clock_s() const = 0;
  /// Timing: plays short tones at these delays from now (>= 0, increasing), each at most one buffer late,
  /// plus the delay of the device. Silent in a rehearsal.
  virtual void soundBeats(const std::vector<double>& delays_s) = 0;
  /// Trouble since the last call, or present trouble.
  virtual StudyTrouble takeTrouble() = 0;
  /// Force device: removes the force within 15 ms, until rearm(). Does nothing without one.
  virtual void stopForce() = 0;
  /// A person wants force again.
  virtual void rearm() = 0;
};

}  // namespace detent::playback
