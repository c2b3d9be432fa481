// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public interface of studies with people: can they tell these buttons apart, and will they?
//
// In:  buttons, a design, answers of participants.
// Out: a journal for each participant, figures with intervals as text, JSON, CSV, BIDS and a page; a forecast without anyone.
// Reading order of the house:
//   study/trials/consent.h             what participants agree to
//   study/trials/study_design.h        which buttons, which task, how often: one folder
//   study/trials/study_plan.h          power, a page to preregister, everybody's list (planned_places.h) before the first person comes
//   study/trials/trial_plan.h          the list of one participant
//   study/trials/participant_record.h  what a journal says (study/journal: lines that are on the disk)
//   study/trials/trial_desk.h          one trial as it is worked on; timing_desk.h one whose presses are timed
//   study/trials/participant_session.h one participant at work
//   study/trials/figure_table.h        a table that every format reads; answer_tables.h makes those of thresholds and ratings,
//                                      timing_tables.h those of timed presses
//   study/trials/study_results.h       rows and figures (study/statistics), study_output.h and study_page.h show them
//   study/perception/*                 what is felt, who is confused with whom, what would help
//   this file                          the button under the participant's finger; the forecast of a study
//
// Threads: ordinary threads only. A library built without DETENT_WITH_STUDIES has none of it.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playback/playback.h"
#include "playback/study/perception/design_help.h"
#include "playback/study/perception/forecast_words.h"
#include "playback/study/trials/consent.h"
#include "playback/study/trials/participant_session.h"
#include "playback/study/trials/study_output.h"
#include "playback/study/trials/study_page.h"
#include "playback/study/trials/timing_desk.h"
#include "playback/study/trials/trial_desk.h"

namespace detent::playback {

struct StudyPlayerSettings {
  PlayerSettings player;
  bool rehearse = false;   ///< no sound device: everything is followed, nothing is felt
  std::string sensorPort;  ///< empty: press() presses by itself
  unsigned baud = 230400;
  SensorCalibration calibration;
};

/// Why a trial cannot be felt just now.
enum class StudyTrouble : std::uint8_t { none, soundLost, sensorUnplugged, sensorSilent, sensorStuck };
/// As the journal keeps it: "sensor silent".
const char* nameOf(StudyTrouble trouble);

/// What a participant has under the finger: any button of the study, in any of its modes, exchanged at once;
/// all are prepared before the first trial. One thread.
class StudyPlayer {
 public:
  /// Failure: as LivePlayer::start, attachSensor and prepareProgram; deviceTrouble: the sensor sends nothing within 3 s.
  static Result<std::unique_ptr<StudyPlayer>> start(const Study& study, const StudyPlayerSettings& settings);
  virtual ~StudyPlayer() = default;

  virtual bool sounding() const = 0;  ///< false: a rehearsal
  virtual std::string device() const = 0;
  virtual StudyRoute route() const = 0;
  /// Every stimulus begins as it was made: a self-locking button unlocked, X as well as the choice that is the same button.
  virtual void beginTrial() = 0;
  /// Puts a button under the finger as the trial's stimulus `slot` (TrialDesk), which keeps its own lock.
  virtual void place(std::size_t slot, std::size_t button, FeedbackMode mode) = 0;
  /// Likewise; without a sensor it is pressed once, as by a hand.
  virtual void press(std::size_t slot, std::size_t button, FeedbackMode mode) = 0;
  /// What the finger has done since press() or since this was last asked.
  virtual Felt takeFelt() = 0;
  /// Whether a sensor presses; else press() does, for the key that was hit.
  virtual bool sensed() const = 0;
  /// Timing, with a sensor: when the contact closed since press() or since this was last asked.
  virtual std::vector<ContactClosing> takeClosings() = 0;
  /// Timing: short tones so many seconds from now (>= 0, rising), each a buffer late at most, then what the device takes. Nothing sounds in a
  /// rehearsal.
  virtual void soundBeats(const std::vector<double>& delays_s) = 0;
  /// What went wrong since this was last asked, or is wrong.
  virtual StudyTrouble troubleSinceAsked() = 0;
};

/// What the forecast says of a study's buttons, on its device, mode by mode by pairsOf(), nothing where nobody says which one X is. Some
/// ten milliseconds a button and mode. Failure: as feel(). Any thread.
Result<std::vector<ForetoldPair>> foretold(const Study& study);

}  // namespace detent::playback
