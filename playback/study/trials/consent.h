// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Consent text of a participant, and their decision. The texts lie in the study's folder:
// consent.LANGUAGE.txt, and consent.txt for every other language. A participant who agrees begins a journal;
// one who declines is counted, and nothing else about them is kept. Any thread.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

struct ConsentText {
  std::string language;  ///< "de"; empty: for every other language
  std::string text;      ///< UTF-8
  std::string sha256;    ///< of the text
};

/// A decision about a text.
struct ConsentDecision {
  std::string language;  ///< the text was shown in
  std::string sha256;    ///< of the text
  double utc_s = 0;      ///< wall-clock time since 1970
};

/// A text from a file; NAME.de.txt is German. Failure unreadableInput: not there, empty, or not UTF-8.
Result<ConsentText> readConsent(const std::string& file);

/// Into a study's folder; none: the standard texts. Failure wrongUsage: two for one language.
Result<Done> writeConsents(const std::filesystem::path& folder, const std::vector<ConsentText>& texts);

/// The text of a study for a language ("en", "de"). Failure unreadableInput: there is none.
Result<ConsentText> consentIn(const std::filesystem::path& folder, const std::string& language);

/// Counts one "no, thank you"; `declined.jsonl` of the study's folder. Failure: as LineJournal.
Result<Done> recordDeclined(const std::filesystem::path& folder, const ConsentDecision& decision);
/// Number of people who declined.
std::size_t declinedIn(const std::filesystem::path& folder);

}  // namespace detent::playback
