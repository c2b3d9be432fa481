// SPDX-License-Identifier: GPL-3.0-or-later
// What people agree to, and who does not.

#include "playback/study/trials/consent.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "model/file/text_file.h"
#include "model/sha256.h"
#include "tests/playback/study/trials/study_folder.h"

using namespace detent;
using namespace detent::playback;
namespace fs = std::filesystem;
using detent::test::StudyFolder;

namespace {

std::string fileWith(const StudyFolder& made, const std::string& name, const std::string& text) {
  const fs::path file = made.folder().parent_path() / name;
  std::ofstream(file) << text;
  return file.string();
}

SessionStart agreedStart(const std::string& language, const std::string& sha256) {
  SessionStart start{SessionKind::rehearsal, Listening::quiet, "", "", 1000};
  start.consent = ConsentDecision{language, sha256, 999.5};
  return start;
}

}  // namespace

TEST_CASE("consent: a standard text in English and German, one's own by the ending of its name") {
  const StudyFolder made;
  CHECK(consentIn(made.folder(), "en")->text.find("virtual buttons") != std::string::npos);
  CHECK(consentIn(made.folder(), "de")->text.find("virtuelle Tasten") != std::string::npos);
  CHECK(consentIn(made.folder(), "fr")->text == consentIn(made.folder(), "en")->text);
  const Result<ConsentText> own = readConsent(fileWith(made, "lab.de.txt", "Hiermit willige ich ein.\n"));
  REQUIRE(own);
  CHECK(own->language == "de");
  CHECK(own->sha256 == sha256Hex("Hiermit willige ich ein.\n"));
  CHECK(readConsent(fileWith(made, "lab.txt", "I agree.\n"))->language.empty());
  StudyDesign design;
  design.consents = {*own};
  const StudyFolder german(design);
  CHECK(consentIn(german.folder(), "de")->sha256 == own->sha256);
  const Result<ConsentText> none = consentIn(german.folder(), "en");
  REQUIRE_FALSE(none);
  CHECK(none.failure().sentence().find("consent.en.txt") != std::string::npos);
  design.consents = {*own, *own};
  CHECK_FALSE(writeConsents(made.folder(), design.consents));
}

TEST_CASE("consent: a text that is empty, not UTF-8 or not there is refused by name") {
  const StudyFolder made;
  for (const auto& [name, text] : {std::pair{"empty.txt", " \n"}, std::pair{"latin1.txt", "m\xF6\x67te"}}) {
    const Result<ConsentText> refused = readConsent(fileWith(made, name, text));
    REQUIRE_FALSE(refused);
    CHECK(refused.failure().sentence().find(name) != std::string::npos);
  }
  CHECK_FALSE(readConsent((made.folder() / "nowhere.txt").string()));
}

TEST_CASE("consent: text, decision and time stand in the journal, and resume needs none") {
  const StudyFolder made;
  const std::string sha256 = consentIn(made.folder(), "de")->sha256;
  const SessionStart start = agreedStart("de", sha256);
  CHECK(ParticipantSession::toOpen(*made.study, "P01", start)->plan.empty());
  CHECK(fs::is_empty(made.folder() / "participants"));  // asking writes nothing
  { REQUIRE(ParticipantSession::open(*made.study, "P01", start)); }
  const Result<ParticipantRecord> known = ParticipantSession::toOpen(*made.study, "P01", start);
  REQUIRE(known);
  REQUIRE(known->consent);
  CHECK(known->consent->language == "de");
  CHECK(known->consent->sha256 == sha256);
  CHECK(known->consent->utc_s == 999.5);
  CHECK_FALSE(known->complete());
  CHECK(known->next() != nullptr);
  const Result<ParticipantRecord> alike = ParticipantSession::toOpen(*made.study, "P-1", start);
  REQUIRE_FALSE(alike);
  CHECK(alike.failure().code == FailureCode::wrongUsage);
}

TEST_CASE("consent: who says no is counted and in no journal") {
  const StudyFolder made;
  CHECK(declinedIn(made.folder()) == 0);
  REQUIRE(recordDeclined(made.folder(), {"en", "0123", 5}));
  REQUIRE(recordDeclined(made.folder(), {"de", "4567", 6}));
  CHECK(declinedIn(made.folder()) == 2);
  CHECK(readParticipants(*made.study)->empty());
  const std::string text = *readTextFile((made.folder() / "declined.jsonl").string());
  CHECK(text.find("participant") == std::string::npos);
}
