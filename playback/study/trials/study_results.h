// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results of a study: tidy rows, and figures by group in the layout of K&L's Tables 1 and 2. Any thread.

#include <optional>
#include <string>
#include <vector>

#include "playback/study/statistics/binomial.h"
#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// One trial that counts.
struct TrialRow {
  std::string participant;
  std::size_t trial = 0;              ///< from 1, practice not counted
  std::string pair;                   ///< "A-B" in the study's order; matching: X; others: the button
  std::size_t first = 0, second = 0;  ///< abx: the pair's buttons; matching: X twice
  std::string a, b;                   ///< labels of the two choices; matching, scales: empty
  std::string x, answer;              ///< labels; threshold: x is the one with more; rating: x is empty
  std::size_t answered = 0;           ///< the chosen button
  bool correct = false;               ///< no meaning in rating
  std::optional<double> level;        ///< threshold: by what share x has more
  std::optional<double> rating;       ///< rating on a scale: the answered number
  /// Timing: as defined in study/statistics/press_timing.h. For tapping each tap is a row.
  std::optional<double> interval_s, window_s, press_s, pressWithin_s;
  std::size_t replaysA = 0, replaysB = 0, replaysX = 0;  ///< matching: replaysA counts all choices together
  std::vector<std::string> choices;                      ///< labels in the order shown
  /// movements with each choice, then with X; empty for journals that did not record them
  std::vector<Felt> felt;
  double onset_s = 0, firstPress_s = 0, answer_s = 0;
  FeedbackMode mode = FeedbackMode::full;
  SessionKind kind = SessionKind::real;
  Listening listening = Listening::quiet;
  std::size_t interruptions = 0;
  /// "quiet", "masked/click-only", "quiet/simulated", "quiet/rehearsal/repeated": listening; the mode if the
  /// study has several; the kind of an answer that is not real; repeated after the device was lost.
  std::string condition;
  bool finished = false;  ///< the participant has answered all trials
  std::string site;       ///< of a merged study; else empty
};

/// The condition of an answer, without "repeated".
std::string conditionOf(const Study& study, const RecordedAnswer& answer, FeedbackMode mode);

std::vector<TrialRow> rowsOf(const Study& study, const std::vector<ParticipantRecord>& participants);

/// "At most one error in ten": the largest number of errors that guessing stays below with a probability of
/// at most `level`. Nothing if even zero errors prove nothing.
struct DiscriminationRule {
  std::optional<std::size_t> mostErrors;
  double p = 1;  ///< exact probability that guessing does as well
};
DiscriminationRule discriminationRule(std::size_t trials, double level = 0.05);

/// Sensitivity of all participants together, d' by both strategies.
struct Sensitivity {
  double differencing = 0, independent = 0;
  double low = 0, lowIndependent = 0;  ///< d' from the lower limit (97.5 %) of the share correct
  /// True if there was no error. `differencing` and `independent` then assume half an error (Macmillan &
  /// Kaplan, Psychological Bulletin 1985).
  bool noError = false;
};
Sensitivity sensitivityOf(const Count& errors);

/// One participant on one pair.
struct AbxTest {
  std::string participant;
  Count errors;
  bool discriminates = false;
  double p = 1;         ///< exact probability of so few errors by guessing
  double adjusted = 1;  ///< Holm over the participant's pairs and modes
};

/// One pair of Table 2.
struct PairResult {
  std::size_t first = 0, second = 0;  ///< buttons of the study
  Count errors;                       ///< of all participants
  Interval wilson, clopperPearson;
  Sensitivity sensitivity;
  std::vector<AbxTest> tests;  ///< tests of pairs of which all trials were answered
  /// number of tests that were not passed; none: unknown for printed counts
  std::optional<std::size_t> failCount;
};
/// K&L's shading of Table 2 as marks: one participant failed *, two or more **.
const char* markOf(const PairResult& pair);
/// A pair's figures from its count; tests and failCount are added later.
PairResult pairResult(std::size_t first, std::size_t second, const Count& errors);

/// One column of Table 1: the participants who listened, felt and answered in the same way.
struct GroupResult {
  std::string condition;  ///< without "repeated"
  Listening listening = Listening::quiet;
  FeedbackMode mode = FeedbackMode::full;
  SessionKind kind = SessionKind::real;
  std::size_t participantCount = 0;
  std::vector<std::string> participants;  ///< none for printed counts
  std::vector<Count> perParticipant;
  Count errors;
  Interval wilson, clopperPearson;
  std::optional<Interval> bootstrap;                ///< BCa over participants, widened (resampling.h)
  double meanTime_min = 0, sdTime_min = 0;          ///< per participant, sum of the answers' times
  std::vector<PairResult> pairs;                    ///< abx
  std::vector<std::vector<std::size_t>> confusion;  ///< matching: [x][answer]
  Count fails;                                      ///< ABX tests that were not passed, of all complete ones
};

/// Comparison of two conditions. If the same people were in both, each is their own control.
struct GroupComparison {
  std::string first, second;        ///< conditions
  std::optional<std::size_t> pair;  ///< index into pairsOf(); none: all trials
  /// true: tested by flipping signs of persons; false: by permuting participants between the groups
  bool paired = false;
  std::size_t participants = 0;  ///< paired: people in both; otherwise in either
  double difference = 0;  ///< difference of the error rates, first minus second; paired: mean over persons
  std::optional<Interval> interval;  ///< paired: 95 % of the mean
  double p = 1;
  double adjusted = 1;  ///< Holm: over all conditions, or over all pairs and conditions
};

struct StudyResults {
  std::string study;
  std::string source;  ///< source of printed counts; empty for a study
  StudyKind kind = StudyKind::abx;
  StudySound sound;                          ///< the sound of presses in the study
  std::string feel;                          ///< "clear", "paper"; empty: unknown for printed counts
  std::vector<std::string> labels, names;    ///< labels and names of the buttons
  std::vector<TrialRow> rows;                ///< of all participants
  std::vector<GroupResult> groups;           ///< abx, matching
  std::vector<GroupComparison> comparisons;  ///< abx, matching
  std::vector<FigureTable> tables;           ///< all but abx
  /// unfinished participants are left out of groups, comparisons and tables
  bool unfinishedLeftOut = false;
  /// The same by the other rule for unfinished participants; empty if there are none.
  std::vector<GroupResult> otherGroups;
  std::vector<FigureTable> otherTables;
  DiscriminationRule rule;
  std::size_t trialsPerTest = 0;
  std::vector<std::string> warnings;  ///< information that a reader needs to judge the figures
  bool anySimulated = false, anyRehearsal = false;
};

/// Name of a pair: "A-B"; "A | B" if a label contains that hyphen, or numbers, so that no two pairs have the
/// same name.
std::string pairName(const std::vector<std::string>& labels, std::size_t first, std::size_t second);

/// Labels shortened to at most `width` bytes (4 or more) that still differ: equal ones get a number,
/// "Long~2".
std::vector<std::string> shortened(const std::vector<std::string>& labels, std::size_t width);

/// Participants of a study whose journals were removed from the folder, as far as later journals show, as
/// sentences.
std::vector<std::string> missingParticipants(const std::vector<ParticipantRecord>& participants);

StudyResults resultsOf(const Study& study, const std::vector<ParticipantRecord>& participants);

}  // namespace detent::playback
