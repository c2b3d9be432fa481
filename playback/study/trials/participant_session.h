// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One participant's session: provides the next trial and stores each answer before it counts. The same for a
// terminal, a window and a simulation. One thread.

#include <map>
#include <optional>
#include <vector>

#include "playback/study/journal/line_journal.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

class ParticipantSession {
 public:
  /// Begins or resumes the participant's journal. Failure unreadableInput: see replayJournal and
  /// LineJournal::open; wrongUsage: the id, also one that sounds like another's; a journal would contain both
  /// real and simulated answers; or the participant listened differently before.
  static Result<ParticipantSession> open(const Study& study, const std::string& participant,
                                         const SessionStart& start);

  /// The record that open() would continue, with the same checks, without writing. It has no plan if the
  /// participant has not begun.
  static Result<ParticipantRecord> toOpen(const Study& study, const std::string& participant,
                                          const SessionStart& start);

  const ParticipantRecord& record() const { return record_; }
  /// The trial to be shown; null when all are answered.
  const Trial* trial() const { return record_.next(); }

  /// Stores and syncs an answer. On Failure (full disk; a person's answer to a stimulus that was not felt)
  /// nothing has changed, and the same answer may be given again.
  Result<Done> record(const Answer& answer);
  /// Sound or sensor were lost during the trial: it will be repeated, and this is recorded.
  Result<Done> interrupted(const std::string& reason);
  /// The participant stops, or all trials are answered.
  Result<Done> end(const std::string& reason);

 private:
  ParticipantSession(const Study& study, LineJournal journal, ParticipantRecord record)
      : study_(&study), journal_(std::move(journal)), record_(std::move(record)) {}
  Result<Done> append(const std::string& line, const std::string& chain);

  const Study* study_;
  LineJournal journal_;
  ParticipantRecord record_;
  std::filesystem::path file_;
  std::size_t lines_ = 0;
  std::string chain_;
};

/// Present time of the system clock, seconds since 1970: for SessionStart and ConsentDecision.
double systemClock_s();

/// The participant's listening: as requested, else as in their journal, else quiet.
Listening listeningOf(const Study& study, const std::string& participant,
                      const std::optional<Listening>& requested);

/// Describes the answers of a simulated participant.
struct Simulation {
  double errorRate = 0;  ///< 0 perfect, 0.5 guess (abx)
  bool guess = false;    ///< all choices are equally likely
  double threshold = 0;  ///< threshold studies: notices this increase in 75 of 100 trials; 0: errors as above
  std::string name;      ///< as given
  std::optional<double> dPrime{};       ///< same/different: of an observer who uses differencing
  std::optional<PressTiming> timing{};  ///< timing studies: of the simulated person
  /// Timing studies: the presses of another program's simulated person, by trial, as Answer::presses_s.
  std::map<std::size_t, std::vector<double>> presses_s{};
};

/// "guess", "perfect", "errors=P" with P in [0, 1], "threshold=T" with T in [0.001, 10], "d-prime=D" with
/// D in [0, 10],
/// "timing=PLACE,SPREAD" (PressTiming), or "presses=FILE", CSV `trial,press_s`. Failure wrongUsage;
/// unreadableInput: of the file.
Result<Simulation> simulationNamed(const std::string& name);
/// Failure wrongUsage: it cannot answer the question of the study.
Result<Done> checkSimulation(const Study& study, const Simulation& simulation);

/// The answer of a simulated participant: it depends only on study, participant and trial, so that a crash
/// changes nothing. Its times are invented and marked as simulated.
Answer simulatedAnswer(const Study& study, const std::string& participant, const Trial& trial,
                       const Simulation& simulation);

}  // namespace detent::playback
