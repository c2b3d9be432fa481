// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/consent.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/text.h"
#include "playback/study/journal/line_journal.h"

namespace detent::playback {

namespace {

namespace fs = std::filesystem;

constexpr const char* declinedFile = "declined.jsonl";
constexpr const char* englishConsent =
    "You will press virtual buttons and say how they feel. It takes about half an hour; you may pause at any "
    "time, and\n"
    "stop at any time without giving a reason. Only your answers, their times, how you pressed and an "
    "anonymous number\n"
    "are kept.\n";
constexpr const char* germanConsent =
    "Sie werden virtuelle Tasten drücken und sagen, wie sie sich anfühlen. Das dauert etwa eine halbe "
    "Stunde; "
    "Sie\n"
    "können jederzeit eine Pause machen und jederzeit aufhören, ohne einen Grund zu nennen. Festgehalten "
    "werden nur Ihre\n"
    "Antworten, deren Zeiten, wie Sie gedrückt haben, und eine anonyme Nummer.\n";

/// The language in a file name: "de" for NAME.de.txt.
std::string languageOf(const fs::path& file) {
  const std::string inner = file.stem().extension().string();
  const bool code = inner.size() == 3 &&
                    std::all_of(inner.begin() + 1, inner.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return code ? inner.substr(1) : std::string();
}

fs::path fileFor(const fs::path& folder, const std::string& language) {
  return folder / (language.empty() ? std::string("consent.txt") : "consent." + language + ".txt");
}

}  // namespace

Result<ConsentText> readConsent(const std::string& file) {
  Result<std::string> text = readTextFile(file);
  if (!text) return text.failure();
  if (!isUtf8(*text))
    return Failure{FailureCode::unreadableInput, file, "", Message("the file is not encoded as UTF-8"),
                   Message("Save the file as UTF-8 text")};
  if (text->find_first_not_of(" \t\r\n") == std::string::npos)
    return Failure{FailureCode::unreadableInput, file, "", Message("the file is empty"),
                   Message("Write the text that participants are asked to agree to")};
  const std::string hash = sha256Hex(*text);
  return ConsentText{languageOf(file), *std::move(text), hash};
}

Result<Done> writeConsents(const fs::path& folder, const std::vector<ConsentText>& texts) {
  if (texts.empty()) return writeConsents(folder, {{"", englishConsent, ""}, {"de", germanConsent, ""}});
  std::set<std::string> languages;
  for (const ConsentText& text : texts) {
    const fs::path file = fileFor(folder, text.language);
    if (!languages.insert(text.language).second)
      return Failure{FailureCode::wrongUsage, Subject::option("--consent"), "",
                     Message("there are two consent texts for %1", file.filename().string()),
                     Message("Give one text for each language: NAME.en.txt, NAME.de.txt")};
    if (Result<Done> ok = writeTextFileAtomically(file.string(), text.text); !ok) return ok;
  }
  return Done{};
}

Result<ConsentText> consentIn(const fs::path& folder, const std::string& language) {
  std::error_code error;
  const fs::path own = fileFor(folder, language);
  Result<ConsentText> found = readConsent((fs::exists(own, error) ? own : fileFor(folder, "")).string());
  if (found) found->language = language;
  if (found || fs::exists(fileFor(folder, ""), error) || fs::exists(own, error)) return found;
  return Failure{
      FailureCode::unreadableInput, folder.string(), "",
      Message("the folder has no consent text in the language \"%1\"", language),
      Message("Put the file %1 into this folder, or choose another language", own.filename().string())};
}

Result<Done> recordDeclined(const fs::path& folder, const ConsentDecision& decision) {
  Result<LineJournal> journal = LineJournal::open(folder / declinedFile);
  if (!journal) return journal.failure();
  const nlohmann::ordered_json line{{"decision", "declined"},
                                    {"language", decision.language},
                                    {"sha256", decision.sha256},
                                    {"utc_s", decision.utc_s}};
  return journal->append(jsonText(line));
}

std::size_t declinedIn(const fs::path& folder) {
  const fs::path file = folder / declinedFile;
  std::error_code error;
  if (!fs::exists(file, error)) return 0;
  const Result<std::string> text = readTextFile(file.string());
  return text ? splitJournal(*text).lines.size() : 0;
}

}  // namespace detent::playback
