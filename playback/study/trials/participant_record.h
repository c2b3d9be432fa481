// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What one participant's journal says. The journal is a text of JSON lines; every line carries a piece of a
// hash over itself and all before it, so that a line changed, added or taken out by hand is noticed.

#include <optional>
#include <string>
#include <vector>

#include "playback/study/trials/trial_plan.h"

namespace detent::playback {

/// Who answered, and with what under the finger.
enum class SessionKind : std::uint8_t {
  real,       ///< a person, with a sound device
  rehearsal,  ///< a person or nobody, without one: nothing was felt
  simulated   ///< the program
};

/// What reaches the ears. K&L: "Normal" and "Noisy" group.
enum class Listening : std::uint8_t { quiet, masked };

const char* nameOf(SessionKind kind);
const char* nameOf(Listening listening);

/// One stretch of work without a pause.
struct SessionStart {
  SessionKind kind = SessionKind::real;
  Listening listening = Listening::quiet;
  std::string device;      ///< sound device; empty in rehearsal and simulation
  std::string simulation;  ///< "guess", "perfect", "errors=0.1"; else empty
  double utc_s = 0;        ///< wall clock, since 1970
  double noiseLevel = 0;   ///< of the masking noise made here, rms share of full scale; 0: none was made
};

/// One answer. Times are of a steady clock, which never steps.
struct Answer {
  std::size_t trial = 0;             ///< Trial::number
  std::size_t choice = 0;            ///< index into Trial::choices
  std::vector<std::size_t> replays;  ///< of each choice
  std::size_t replaysX = 0;
  double onset_s = 0;       ///< from the start of this stretch to the trial's first sight
  double firstPress_s = 0;  ///< from there to the first press of anything
  double answer_s = 0;      ///< from there to the answer
};

/// An answer with the circumstances it was given in.
struct RecordedAnswer {
  Answer answer;
  SessionKind kind = SessionKind::real;
  Listening listening = Listening::quiet;
  std::size_t interruptions = 0;  ///< how often the trial was begun anew because the device was lost
  double onset_s = 0;             ///< from the start of the participant's first stretch, pauses included
};

/// The state of a participant: the replay of the journal.
struct ParticipantRecord {
  std::string participant;
  std::string program;  ///< that began it
  std::vector<Trial> plan;
  std::vector<SessionStart> sessions;
  std::vector<RecordedAnswer> answers;  ///< answers[i] is of plan[i]
  std::size_t interruptions = 0;        ///< of the trial that comes next
  bool endedEarly = false;
  std::string endReason;
  std::vector<std::string> notes;  ///< what a reader must know: cut lines, clocks that disagree

  bool complete() const { return answers.size() >= plan.size(); }
  /// The trial that comes next; none when complete or ended early (until another session goes on).
  const Trial* next() const;
};

/// What the lines of a journal mean. `unfinished` is what follows the last line end. Failure unreadableInput
/// names file and line: no journal, of another version or study, or edited by hand.
Result<ParticipantRecord> replayJournal(const Study& study, const std::string& participant,
                                        const std::vector<std::string>& lines, const std::string& unfinished,
                                        const std::string& file);

/// All participants of a study by id; journals are read while they are written, too.
Result<std::vector<ParticipantRecord>> readParticipants(const Study& study);

/// The one place that words journal lines. `chain` is the hash so far and is moved on.
std::string headerLine(const Study& study, const std::string& participant, std::string& chain);
std::string sessionLine(const SessionStart& session, std::size_t cutBytes, std::string& chain);
std::string answerLine(const Study& study, const Trial& trial, const Answer& answer, std::string& chain);
std::string interruptionLine(const Trial& trial, const std::string& reason, std::string& chain);
std::string endLine(const std::string& reason, std::string& chain);

/// The hash after those lines.
std::string chainAfter(const std::vector<std::string>& lines);

}  // namespace detent::playback
