// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A laboratory's timed presses, from a study or a CSV file: fitted person by person
// (study/statistics/press_timing.h) and put into tables.

#include <string>
#include <vector>

#include "model/result.h"
#include "playback/study/statistics/press_timing.h"
#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// All participants' trials of one task. Plain value, any thread.
struct TimedPeople {
  struct Person {
    std::string participant;
    std::vector<TimedPress> trials;  ///< in the order of the file
  };
  TimingTask task = TimingTask::cue;
  std::vector<Person> people;  ///< by id
};

/// Reads CSV with a header that names participant, interval_s, window_s and press_s (those that the task
/// needs), one row per trial in order; an empty press_s is a trial without a press. Failure unreadableInput
/// names file and line: a column is missing, a value is outside its range, or nobody has enough presses.
Result<TimedPeople> readTimedPresses(const std::string& file, TimingTask task);

/// The laboratory's two figures, then those of each person. Only people with enough presses are fitted; the
/// figures of others stay empty. Failure unreadableInput: nobody could be fitted.
Result<std::vector<FigureTable>> timingTables(const TimedPeople& presses, const std::string& file);

/// One trial of a study's journals, in the form for fitting: one press, none, or (tapping) each tap relative
/// to the one before.
std::vector<TimedPress> timedPresses(const StudyDesign& design, const Trial& trial, const Answer& answer);

/// The same tables for a timing study, by button and condition; then all pairs of buttons compared, with
/// participants as their own control. Works even if nobody has enough presses.
std::vector<FigureTable> timingTables(const Study& study, const std::vector<ParticipantRecord>& participants);

}  // namespace detent::playback
