// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Contents of one participant's journal. The journal consists of JSON lines; every line contains part of a
// hash over itself and all lines before it, so that a manually changed, added or removed line is detected.

#include <optional>
#include <string>
#include <vector>

#include "model/named_values.h"
#include "playback/study/statistics/quest_plus.h"
#include "playback/study/trials/trial_plan.h"

namespace detent::playback {

/// Source of the answers, and the device under the finger.
enum class SessionKind : std::uint8_t {
  real,       ///< a person, with a sound device
  rehearsal,  ///< a person, or nobody, without a sound device: nothing was felt
  simulated   ///< the program
};

/// Sound in the participant's ears. K&L: "Normal" and "Noisy" group.
enum class Listening : std::uint8_t { quiet, masked };

inline constexpr auto sessionKinds = named<SessionKind>({{"real", SessionKind::real},
                                                         {"rehearsal", SessionKind::rehearsal},
                                                         {"simulated", SessionKind::simulated}});
inline constexpr auto listenings =
    named<Listening>({{"quiet", Listening::quiet}, {"masked", Listening::masked}});
inline const char* nameOf(SessionKind kind) { return sessionKinds.word(kind); }
inline const char* nameOf(Listening listening) { return listenings.word(listening); }

/// Timing studies: how a press is detected, and how the cue is presented.
struct TimingRoute {
  std::string press;  ///< source of the presses' times, and what a time means: "key: read from the terminal"
  std::string cue;    ///< display of the cue: "picture", "picture and sound"
  /// Delay from a trial's tone to this computer's output: half a buffer plus the sound system's delay; none:
  /// unknown, or no tone.
  std::optional<double> cueLatency_s{};
};

/// Devices that press and play, by their own names. Stored in the journal's first line and with every
/// session.
struct StudyRoute {
  std::string sensorPort;         ///< empty: keys and large buttons press
  std::string sensorCalibration;  ///< "100 g = 0.98 N ..." in one line; empty without a sensor
  std::string sound;              ///< "DEVICE, 48000 Hz, 256 frames"; empty in rehearsal and simulation
  std::string force{};            ///< "serial:PORT, 1000 Hz, at most 6 N"; empty: no force device
  std::optional<TimingRoute> timing{};
};

/// One period of work without a pause.
struct SessionStart {
  SessionKind kind = SessionKind::real;
  Listening listening = Listening::quiet;
  std::string device;      ///< sound device; empty in rehearsal and simulation
  std::string simulation;  ///< "guess", "perfect", "errors=0.1"; else empty
  double utc_s = 0;        ///< system clock, since 1970
  double noiseLevel = 0;   ///< of the masking noise made by this program, rms share of full scale; 0: none
  StudyRoute route{};
  /// agreement given just before; none: given earlier, or a simulation
  std::optional<ConsentDecision> consent{};
};

/// A participant's movements with one stimulus in one trial, from the sensor (or the key that presses).
struct Felt {
  std::size_t presses = 0;  ///< number of presses that were begun
  std::size_t whole = 0;    ///< presses that reached the bottom, were released, and were played
  double peak_N = 0;        ///< largest force of all presses
  double travel_mm = 0;     ///< deepest of all presses

  void add(const Felt& more);
};

/// One answer. Times are of a steady clock.
struct Answer {
  std::size_t trial = 0;         ///< Trial::number
  std::size_t choice = 0;        ///< index into Trial::choices; 0 where one button is rated
  std::optional<double> rating;  ///< on a scale: 1..7, or a number above 0
  std::vector<double>
      presses_s{};  ///< timing: after the cue, the window's beginning, or the run's first press; increasing
  double pressWithin_s = 0;          ///< timing: largest lateness of the report of a press
  std::vector<std::size_t> replays;  ///< number of replays of each choice
  std::size_t replaysX = 0;
  std::vector<Felt> felt;   ///< movements with each choice
  Felt feltX;               ///< movements with X; empty if X is a real switch
  double onset_s = 0;       ///< from the start of this session to the start of the trial
  double firstPress_s = 0;  ///< from the start of the trial to the first press of any stimulus
  double answer_s = 0;      ///< from the start of the trial to the answer
};

/// An answer with its circumstances.
struct RecordedAnswer {
  Answer answer;
  SessionKind kind = SessionKind::real;
  Listening listening = Listening::quiet;
  std::size_t interruptions = 0;  ///< number of times the trial was repeated because the device was lost
  double onset_s = 0;             ///< since the start of the participant's first session, including pauses
};

/// The state of a participant, from the journal.
struct ParticipantRecord {
  std::string participant;      ///< SITE-ID in a merged study
  std::string site;             ///< of a merged study; else empty
  std::string program;          ///< program that began the record
  std::size_t begunBefore = 0;  ///< participants who began before
  std::size_t place = 0;        ///< see planTrials: as planned (study_plan.h), otherwise begunBefore
  std::optional<ConsentDecision> consent;  ///< latest agreement of the participant
  /// The reason why the journal cannot be used; then there is no plan and no answer.
  std::optional<Failure> damage;
  std::vector<Trial> plan;
  std::vector<SessionStart> sessions;
  std::vector<RecordedAnswer> answers;  ///< answers[i] belongs to plan[i]
  std::size_t interruptions = 0;        ///< interruptions of the next trial so far
  bool endedEarly = false;
  std::string endReason;
  std::vector<std::string> notes;  ///< remarks for a reader: truncated lines, clocks that disagree

  bool complete() const { return !damage && !plan.empty() && answers.size() >= plan.size(); }
  /// The next trial; none if complete or ended early (until another session begins).
  const Trial* next() const;
};

/// Reads the lines of a journal. `unfinished` is the text after the last line end. Failure unreadableInput
/// names file and line: no journal, of another version or study, or edited by hand.
Result<ParticipantRecord> replayJournal(const Study& study, const std::string& participant,
                                        const std::vector<std::string>& lines, const std::string& unfinished,
                                        const std::string& file);

/// The file of a participant's journal.
std::filesystem::path journalOf(const Study& study, const std::string& participant);

/// Reads one participant; without plan and answers if there is no journal yet. Failure: as replayJournal and
/// checkHead.
Result<ParticipantRecord> readParticipant(const Study& study, const std::string& participant);

/// Reads all participants of a study, sorted by id, even while journals are being written. An unusable
/// journal affects that person only: see ParticipantRecord::damage.
Result<std::vector<ParticipantRecord>> readParticipants(const Study& study);

/// Returns true if an answer was felt: X and both others were fully pressed; in matching at least one other;
/// without an X, all choices.
bool feltEnough(const Study& study, const Answer& answer);

/// Cue, window: the press that counts, if there is one: the first from half an interval before the cue (or
/// the window's beginning) to an interval after it. Earlier presses, such as tapping along with the beats, do
/// not count.
std::optional<double> countedPress(const Trial& trial, const std::vector<double>& presses_s);

/// Returns true if the times of a trial's presses are possible: finite, increasing, and with one that counts;
/// for tapping at least two. In other studies there must be none.
bool pressesFit(const Study& study, const Trial& trial, const Answer& answer);

/// Returns true if a rating lies on the study's scale, or if there is none in a study without a scale.
bool ratingFits(const Study& study, const std::optional<double>& rating);

// ---- what is compared next, where that follows from the answers so far: thresholds (next_level.cpp)

/// The posterior of one button's threshold in one mode after a participant's first `answers` answers;
/// practice does not count.
QuestPlus beliefAfter(const Study& study, const ParticipantRecord& record, std::size_t reference,
                      FeedbackMode mode, std::size_t answers);

/// Sets the most informative level in the next trial. Does nothing if the study does not adapt or all trials
/// are answered.
void placeNextLevel(const Study& study, ParticipantRecord& record);

// ---- lines

/// Text of journal lines, without writing them. `chain` is the hash so far and is updated.
std::string headerLine(const Study& study, const ParticipantRecord& participant, const StudyRoute& route,
                       std::string& chain);
/// The header of a journal stored by a browser, as JSON without route and chain, which the browser adds. It
/// has no head file, and the number of participants before it is unknown.
std::string headerOfBrowser(const Study& study, const ParticipantRecord& participant);
std::string consentLine(const ConsentDecision& decision, std::string& chain);
std::string sessionLine(const SessionStart& session, std::size_t cutBytes, std::string& chain);
std::string answerLine(const Study& study, const Trial& trial, const Answer& answer, std::string& chain);
std::string interruptionLine(const Trial& trial, const std::string& reason, std::string& chain);
std::string endLine(const std::string& reason, std::string& chain);

/// File beside a journal with its state when it was last written, so that a truncated or emptied journal is
/// detected. Written before the first line, which mentions it, and after each line; after a crash between the
/// two it is one line behind.
std::filesystem::path headFileOf(const std::filesystem::path& journal);
Result<Done> writeHead(const std::filesystem::path& journal, std::size_t lines, const std::string& chain);
/// Failure unreadableInput: the journal contains less than before, or its head file is gone. Journals of
/// versions without head files have none.
Result<Done> checkHead(const std::filesystem::path& journal, const std::vector<std::string>& lines);

/// The hash after these lines.
std::string chainAfter(const std::vector<std::string>& lines);

}  // namespace detent::playback
