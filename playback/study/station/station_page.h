// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study as one web page at which participants answer: the trials, the touch rules and the journal of the
// other stations, in a browser and offline.

#include <string>
#include <vector>

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

struct StationSettings {
  std::vector<std::string> participants;   ///< ids; several choose theirs, or open the page with #ID
  Listening listening = Listening::quiet;  ///< masked: by a noise that the experimenter provides
  std::string postTo;                      ///< http(s) address that takes journals; empty: download only
};

/// The page as HTML, complete in itself; it connects to `postTo` alone. Its root element carries
/// data-detent="ready" once it can be used, else "failed". A participant's answers are kept in the browser,
/// each on the disk before the next trial, as the journal that belongs into `participants/ID.jsonl` of the
/// study. Failure wrongUsage: no or too many participants, an id that is invalid, used or similar to another,
/// an address that is none, a timing study, a merged study, one with a device profile, a build without the
/// browsers' engine; unreadableInput: as checkStimuli.
Result<std::string> stationPage(const Study& study, const StationSettings& settings);

/// Returns true if this build contains the engine for browsers.
bool hasStation();

}  // namespace detent::playback
