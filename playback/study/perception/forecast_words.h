// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A forecast in words: the same for the terminal, the report and the window, which translates them.

#include "model/message.h"
#include "playback/study/perception/confusion.h"

namespace detent::playback {

/// The range of errors in words: "2 to 12 errors in 90", "hardly an error in 90".
Message errorsOf(const PredictedPair& pair);
/// The verdict in words: "People tell these apart: 0 to 7 errors in 90" if it is certain enough, else "people
/// probably tell these apart (70 %): ..."
Message verdictOf(const PredictedPair& pair);
/// Verdict and range of errors in a few words, for a line of a list.
Message shortVerdictOf(const PredictedPair& pair);
/// The largest difference in words: "most differs on the press: when the click comes"; "nothing differs".
Message reasonOf(const PredictedPair& pair);

}  // namespace detent::playback
