// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Consent text of a participant, and their decision. The texts are in the study's folder:
// consent.LANGUAGE.txt, and consent.txt for every other language. Agreeing begins a journal; declining is
// counted, and nothing else about the person is stored. Any thread.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

struct ConsentText {
  std::string language;  ///< "de"; empty: for every other language
  std::string text;      ///< UTF-8
  std::string sha256;    ///< hash of the text
};

/// A decision about a text.
struct ConsentDecision {
  std::string language;  ///< the text was shown in
  std::string sha256;    ///< hash of the text
  double utc_s = 0;      ///< system clock, seconds since 1970
};

/// Reads a text from a file; NAME.de.txt is German. Failure unreadableInput: missing, empty, or not UTF-8.
Result<ConsentText> readConsent(const std::string& file);

/// Writes the texts into a study's folder; if there are none, the standard texts. Failure wrongUsage: two
/// texts for one language.
Result<Done> writeConsents(const std::filesystem::path& folder, const std::vector<ConsentText>& texts);

/// The text of a study for a language ("en", "de"). Failure unreadableInput: there is none.
Result<ConsentText> consentIn(const std::filesystem::path& folder, const std::string& language);

/// Counts one refusal in `declined.jsonl` of the study's folder. Failure: as LineJournal.
Result<Done> recordDeclined(const std::filesystem::path& folder, const ConsentDecision& decision);
/// Number of people who declined.
std::size_t declinedIn(const std::filesystem::path& folder);

}  // namespace detent::playback
