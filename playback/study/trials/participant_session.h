// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One participant at work: asks what comes next, writes each answer down before it counts. The same for a
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
  /// LineJournal::open; wrongUsage: the id, also one that sounds like another's; an answer of a person would
  /// follow a simulated one (or the other way round) in one journal; or the participant listened otherwise
  /// before.
  static Result<ParticipantSession> open(const Study& study, const std::string& participant,
                                         const SessionStart& start);

  /// The record that open() would continue, by the same checks; nothing is written. Without a plan if the
  /// participant has not begun.
  static Result<ParticipantRecord> toOpen(const Study& study, const std::string& participant,
                                          const SessionStart& start);

  const ParticipantRecord& record() const { return record_; }
  /// The trial to be shown; null when all are answered.
  const Trial* trial() const { return record_.next(); }

  /// Written and synced; on Failure (full disk; a person's answer to what was not felt) nothing has changed
  /// and the same answer may be given again.
  Result<Done> record(const Answer& answer);
  /// Sound or sensor were lost during the trial: it is shown anew, and marked.
  Result<Done> interrupted(const std::string& reason);
  /// The participant stops for good, or all is answered.
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

/// Now by the system clock, seconds since 1970: for SessionStart and ConsentDecision.
double wallClock_s();

/// The participant's listening: as requested, else as in their journal, else quiet.
Listening listeningOf(const Study& study, const std::string& participant,
                      const std::optional<Listening>& asked);

/// Answers of the program in a person's place.
struct Simulation {
  double errorRate = 0;  ///< 0 perfect, 0.5 guess (abx)
  bool guess = false;    ///< any choice is as likely as any other
  double threshold =
      0;  ///< threshold studies: a person who notices this increase in 75 of 100 trials; 0: errors as above
  std::string name;                     ///< as given
  std::optional<double> dPrime{};       ///< same/different: of an observer by differencing
  std::optional<PressTiming> timing{};  ///< timing studies: of the person
  /// Timing studies: what another program says a person pressed, by trial, as Answer::presses_s.
  std::map<std::size_t, std::vector<double>> presses_s{};
};

/// "guess", "perfect", "errors=P" with P in [0, 1], "threshold=T" with T in [0.001, 10], "d-prime=D" with
/// D in [0, 10],
/// "timing=PLACE,SPREAD" (PressTiming), or "presses=FILE", CSV `trial,press_s`. Failure wrongUsage;
/// unreadableInput: of the file.
Result<Simulation> simulationNamed(const std::string& name);
/// Failure wrongUsage: it cannot answer what the study asks for.
Result<Done> checkSimulation(const Study& study, const Simulation& simulation);

/// The answer of a simulated participant: a function of study, participant and trial alone, so that a crash
/// changes nothing. Times are made up and marked as simulated.
Answer simulatedAnswer(const Study& study, const std::string& participant, const Trial& trial,
                       const Simulation& simulation);

}  // namespace detent::playback
