// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study in a folder of its own that goes with the test, and simulated participants in it.

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "playback/study/trials/participant_session.h"

namespace detent::test {

using namespace playback;

/// The file of a sample button: "A".
std::string sample(const std::string& name);

class StudyFolder {
 public:
  explicit StudyFolder(StudyDesign design = {}, const std::vector<std::string>& names = {"A", "B", "C"}) {
    static int count = 0;
    root_ = std::filesystem::temp_directory_path() /
            ("detent_trials_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(root_);
    std::vector<std::string> files;
    for (const std::string& name : names) files.push_back(sample(name));
    Result<Study> made = createStudy(root_ / "study", files, "", design);
    if (!made) throw std::runtime_error(made.failure().sentence());
    study = std::make_unique<Study>(*std::move(made));
  }
  ~StudyFolder() { std::filesystem::remove_all(root_); }
  std::filesystem::path folder() const { return root_ / "study"; }
  std::unique_ptr<Study> study;

 private:
  std::filesystem::path root_;
};

inline const playback::SessionStart simulatedStart{SessionKind::simulated, Listening::quiet, "", "perfect",
                                                   1000};

/// Record of the first participant, who has not answered yet.
inline ParticipantRecord beginner(const std::string& id) {
  ParticipantRecord record;
  record.participant = id;
  return record;
}

/// Answers up to `count` trials in the person's or program's place.
inline void answer(const Study& study, const std::string& id, const std::string& how, std::size_t count,
                   const SessionStart& start = simulatedStart) {
  Result<ParticipantSession> session = ParticipantSession::open(study, id, start);
  REQUIRE(session);
  const Result<Simulation> simulation = simulationNamed(how);
  REQUIRE(simulation);
  for (std::size_t i = 0; i < count && session->trial() != nullptr; ++i)
    REQUIRE(session->record(simulatedAnswer(study, id, *session->trial(), *simulation)));
}

}  // namespace detent::test
