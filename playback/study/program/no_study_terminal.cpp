// SPDX-License-Identifier: GPL-3.0-or-later
// Studies in a build without devices.

#include "playback/study/program/study_terminal.h"

namespace detent::playback {

Result<ParticipantRecord> askParticipant(const Study&, const AskedParticipant&, const StudyDevices&,
                                         const Cancelled&) {
  return Failure{FailureCode::deviceTrouble, "study run", "", "this program was built without devices",
                 "Pass --simulate, or build with DETENT_WITH_DEVICE=ON"};
}

}  // namespace detent::playback
