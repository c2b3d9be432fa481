// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a study found: tidy rows, and figures by group in the layout of K&L's Tables 1 and 2. Any thread.

#include <optional>
#include <string>
#include <vector>

#include "playback/study/statistics/binomial.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// One counted trial.
struct TrialRow {
  std::string participant;
  std::size_t trial = 0;  ///< from 1, practice not counted
  std::string pair;       ///< "A-B" in the study's order; matching: X
  std::string a, b;       ///< abx: labels of alpha and beta; matching: empty
  std::string x, answer;  ///< labels
  bool correct = false;
  std::size_t replaysA = 0, replaysB = 0, replaysX = 0;  ///< matching: replaysA of all choices together
  double onset_s = 0, firstPress_s = 0, answer_s = 0;
  FeedbackMode mode = FeedbackMode::full;
  SessionKind kind = SessionKind::real;
  Listening listening = Listening::quiet;
  std::size_t interruptions = 0;
  /// "quiet", "masked/click-only", "quiet/simulated", "quiet/rehearsal/repeated": listening; mode where the
  /// study has several; what is not a real answer; repeated after the device was lost.
  std::string condition;
};

std::vector<TrialRow> rowsOf(const Study& study, const std::vector<ParticipantRecord>& participants);

/// "At most one error in ten": the most errors that guessing stays under `level` with. Nothing where even no
/// error proves nothing.
struct DiscriminationRule {
  std::optional<std::size_t> mostErrors;
  double p = 1;  ///< exact probability that guessing does as well
};
DiscriminationRule discriminationRule(std::size_t trials, double level = 0.05);

/// How sensitive all participants together were, d' by both strategies.
struct Sensitivity {
  double differencing = 0, independent = 0;
  bool atLeast = false;  ///< no error was made: the values are lower bounds (97.5 %)
};
Sensitivity sensitivityOf(const Count& errors);

/// One participant on one pair.
struct AbxTest {
  std::string participant;
  Count errors;
  bool discriminates = false;
  double p = 1;         ///< exact, of so few errors by guessing
  double adjusted = 1;  ///< Holm over the participant's pairs
};

/// One pair of Table 2.
struct PairResult {
  std::size_t first = 0, second = 0;  ///< buttons of the study
  Count errors;                       ///< of all participants
  Interval wilson, clopperPearson;
  Sensitivity sensitivity;
  std::vector<AbxTest> tests;            ///< complete ones: all trials of the pair answered
  std::optional<std::size_t> failCount;  ///< of the tests, those not passed; none: printed counts do not tell
};
/// K&L's shading of Table 2 as marks: one participant failed *, two or more **.
const char* markOf(const PairResult& pair);
/// A pair's figures from its count; tests and fails are still to be added.
PairResult pairResult(std::size_t first, std::size_t second, const Count& errors);

/// One column of Table 1: everyone who listened, felt and answered in the same way.
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
  std::optional<Interval> bootstrap;                ///< BCa over participants
  double meanTime_min = 0, sdTime_min = 0;          ///< per participant, sum of the answers' times
  std::vector<PairResult> pairs;                    ///< abx
  std::vector<std::vector<std::size_t>> confusion;  ///< matching: [x][answer]
  Count fails;                                      ///< abx tests not passed, of all complete ones
};

struct GroupComparison {
  std::string first, second;  ///< conditions
  double difference = 0;      ///< of the error rates, first minus second
  double p = 1;               ///< participants permuted between the groups
};

struct StudyResults {
  std::string study;
  std::string source;  ///< of printed counts: where they stand
  StudyKind kind = StudyKind::abx;
  std::vector<std::string> labels, names;  ///< of the buttons
  std::vector<TrialRow> rows;
  std::vector<GroupResult> groups;
  std::vector<GroupComparison> comparisons;
  DiscriminationRule rule;
  std::size_t trialsPerTest = 0;
  std::vector<std::string> warnings;  ///< what a reader must know before believing a figure
  bool anySimulated = false, anyRehearsal = false;
};

StudyResults resultsOf(const Study& study, const std::vector<ParticipantRecord>& participants);

}  // namespace detent::playback
