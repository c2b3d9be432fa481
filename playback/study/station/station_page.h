// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study as one web page on which participants answer: with the trials, the rules for felt presses and the
// journal of the other stations, in a browser and offline.

#include <string>
#include <vector>

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

struct StationSettings {
  /// ids; if there are several, participants choose theirs, or open the page with #ID
  std::vector<std::string> participants;
  Listening listening = Listening::quiet;  ///< masked: the experimenter provides the noise
  std::string postTo;                      ///< http(s) address that receives journals; empty: download only
};

/// The page as HTML without other files; it connects only to `postTo`. Its root element has
/// data-detent="ready" once it can be used, else "failed". A participant's answers are stored in the browser,
/// each on disk before the next trial, as the journal for `participants/ID.jsonl` of the study. Failure
/// wrongUsage: no or too many participants, an id that is invalid, used or similar to another, an invalid
/// address, a timing study, a merged study, one with a device profile, or a build without the browsers'
/// engine; unreadableInput: as checkStimuli.
Result<std::string> stationPage(const Study& study, const StationSettings& settings);

/// Returns true if this build contains the engine for browsers.
bool hasStation();

}  // namespace detent::playback
