// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Texts for a participant at a terminal or a page, in their language. %1, %2 ... are filled in (model/message.h).

#include <string>

#include "playback/study/trials/study_design.h"

namespace detent::playback {

struct ParticipantWords {
  const char *agree, *goodbye;                      ///< consent
  const char *trial, *practice, *rehearsal, *keys;  ///< above a question; %1 of %2
  const char *press, *andX, *realSwitch, *answer;   ///< which keys do what
  const char *spaceBar, *thenEnter;                 ///< of a scale
  const char *magnitude, *preference, *takenBack, *typeMagnitude, *typePreference;
  const char *isX, *better, *force, *click, *deeper, *snaps, *rougher;  ///< of one choice, %1
  const char *pressThem, *pressIt, *notYet;                             ///< answered too early
  const char *rest, *stop, *paused, *last;
  const char *interrupted, *notKept;  ///< %1: why, as the journal says it
  const char *stopForce, *rearm;      ///< of a force device
  const char *rain, *behindTheSignal;
  // timing
  const char *cueTask, *windowTask, *tappingTask, *begin, *hit, *missed, *enough;
  const char *noPress, *held, *notFelt;
  char yes;  ///< besides y
};

/// "de"; English for every other language.
const ParticipantWords& participantWords(const std::string& language);

/// Text for the comparison of one with the other, %1.
const char* comparisonWords(const ParticipantWords& words, const StudyDesign& design);

}  // namespace detent::playback
