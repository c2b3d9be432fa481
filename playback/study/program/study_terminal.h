// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One participant at a terminal: single keys, no labels, nothing to be skipped.

#include <optional>
#include <string>

#include "playback/program/shared_options.h"
#include "playback/study/trials/participant_session.h"

namespace detent::playback {

/// Devices under the finger.
struct StudyDevices {
  PlayerSettings player;
  SensorOptions sensor;
  std::string sensorProfileFile;  ///< calibration; the study's own profile where empty
  bool rehearse = false;          ///< no sound device on purpose
  std::optional<ForceDeviceChoice> force;
};

/// Participant of a session, their language and the sound in their ears.
struct AskedParticipant {
  std::string id;
  std::string language;  ///< they read: "en", "de"; empty: the one they agreed in, else English
  Listening listening = Listening::quiet;
};

/// Asks for consent, then until all is answered, the participant stops, or `cancelled`. Gives what the
/// journal holds then; who does not agree is in no journal. Failure deviceTrouble: no terminal to ask at, or
/// no device where earlier answers had one.
Result<ParticipantRecord> askParticipant(const Study& study, const AskedParticipant& asked,
                                         const StudyDevices& devices, const Cancelled& cancelled);

}  // namespace detent::playback
