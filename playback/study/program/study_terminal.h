// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One participant at a terminal: single keys, no labels, nothing to be skipped.

#include <functional>
#include <string>

#include "playback/program/shared_options.h"
#include "playback/study/trials/participant_session.h"

namespace detent::playback {

/// What is under the finger.
struct StudyDevices {
  PlayerSettings player;
  SensorOptions sensor;
  std::string sensorProfileFile;  ///< calibration; the study's own profile where empty
  bool rehearse = false;          ///< no sound device on purpose
};

/// Asks until all is answered, the participant stops, or `cancelled`. Gives what the journal holds then.
/// Failure deviceTrouble: no terminal to ask at, or no device where earlier answers had one.
Result<ParticipantRecord> askParticipant(const Study& study, const std::string& participant,
                                         Listening listening, const StudyDevices& devices,
                                         const std::function<double()>& wallClock_s,
                                         const Cancelled& cancelled);

}  // namespace detent::playback
