// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/timing_tables.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "model/number_table.h"
#include "playback/study/trials/study_design.h"

namespace detent::playback {

namespace {

constexpr std::size_t mostBytes = 64 << 20;
constexpr double longest_s = 60;  ///< of intervals and windows, and how far from its cue a press may lie
constexpr double percent = 100;

/// Columns a task needs, in the order read.
std::vector<std::string_view> columnsOf(TimingTask task) {
  switch (task) {
    case TimingTask::cue:
      return {"participant", "press_s", "interval_s"};
    case TimingTask::window:
      return {"participant", "press_s", "interval_s", "window_s"};
    case TimingTask::tapping:
      break;
  }
  return {"participant", "press_s"};
}

class Reader {
 public:
  Reader(const std::string& file, TimingTask task) : file_(file), task_(task) {}

  Result<TimedPeople> read(const std::string& text) {
    NumberTable table(text);
    std::optional<std::vector<std::size_t>> columns;
    if (table.next()) columns = table.columns(columnsOf(task_));
    if (!columns) {
      std::string names;
      for (const std::string_view name : columnsOf(task_))
        names += (names.empty() ? "" : ",") + std::string(name);
      return refused("line 1", "does not name the columns of this task", "Write " + names);
    }
    while (table.next())
      if (std::optional<Failure> failure = take(table, *columns)) return *std::move(failure);
    TimedPeople presses{task_, {}};
    for (auto& [participant, trials] : people_) presses.people.push_back({participant, std::move(trials)});
    if (presses.people.empty()) return refused("", "has a header but no rows", "Give one row for each trial");
    return presses;
  }

 private:
  Failure refused(const std::string& place, const std::string& problem, const std::string& remedy) const {
    return {FailureCode::unreadableInput, file_, place, problem, remedy};
  }

  std::optional<Failure> take(const NumberTable& row, const std::vector<std::size_t>& columns) {
    const std::size_t last = *std::max_element(columns.begin(), columns.end());
    if (row.fields().size() <= last)
      return refused(row.place(), "has too few fields: " + quotedBegin(row.line()), "Complete or remove it");
    const std::string participant(row.fields()[columns[0]]);
    if (!checkParticipantId(participant))
      return refused(row.place(), "names the participant " + quotedBegin(participant),
                     "Take 1 to 32 of a-z A-Z 0-9 - _, and no name");
    TimedPress trial;
    for (std::size_t i = 2; i < columns.size(); ++i) {
      const std::optional<double> value = row.finite(columns[i]);
      if (!value || *value <= 0 || *value > longest_s)
        return refused(row.place(),
                       std::string(columnsOf(task_)[i]) + " is " + quotedBegin(row.fields()[columns[i]]),
                       "Give seconds above 0, 60 at most");
      (i == 2 ? trial.interval_s : trial.window_s) = *value;
    }
    if (const std::string_view press = row.fields()[columns[1]]; !press.empty()) {
      trial.press_s = row.finite(columns[1]);
      const double least_s = task_ == TimingTask::tapping ? 0 : -longest_s;
      if (!trial.press_s || *trial.press_s <= least_s || *trial.press_s > longest_s)
        return refused(row.place(), "press_s is " + quotedBegin(press),
                       task_ == TimingTask::tapping ? "Give seconds above 0, or nothing where nobody pressed"
                                                    : "Give seconds, or nothing where nobody pressed");
    }
    people_[participant].push_back(trial);
    return {};
  }

  const std::string& file_;
  TimingTask task_;
  std::map<std::string, std::vector<TimedPress>> people_;
};

/// How a task's two figures are called, and what a share is shown as.
struct Words {
  FigureColumn place, spread;
  double placeFactor;
};

Words wordsOf(TimingTask task) {
  const FigureColumn spread{"spread_percent", "spread, %", 2,
                            "standard deviation about that, in hundredths of the interval"};
  switch (task) {
    case TimingTask::cue:
      return {{"place_percent", "behind the cue, %", 2,
               "mean press behind the cue, in hundredths of the interval"},
              spread,
              percent};
    case TimingTask::window:
      return {{"place_percent", "aim, %", 2, "where in the window is aimed at, in hundredths of it"},
              spread,
              percent};
    case TimingTask::tapping:
      break;
  }
  return {{"place_ms", "between presses, ms", 1, "geometric mean of the times between presses"},
          {"spread_percent", "spread, %", 2, "standard deviation about that, in hundredths of it"},
          1000};
}

FigureColumn within(const FigureColumn& of, bool low) {
  const std::string unit = of.key.substr(of.key.rfind('_'));
  return {of.key.substr(0, of.key.rfind('_')) + (low ? "_low" : "_high") + unit, low ? "from" : "to",
          of.decimals, low ? "95 % interval over people, lower end" : "upper end"};
}

FigureCell cell(const std::optional<double>& value) { return value ? FigureCell(*value) : FigureCell(); }

}  // namespace

Result<TimedPeople> readTimedPresses(const std::string& file, TimingTask task) {
  const Result<std::string> text = readTable(file, mostBytes, "Give a CSV of timed presses");
  if (!text) return text.failure();
  return Reader(file, task).read(*text);
}

Result<std::vector<FigureTable>> timingTables(const TimedPeople& presses, const std::string& file) {
  const auto [place, spread, factor] = wordsOf(presses.task);
  FigureTable everybody{"people",
                        "Timing of each participant",
                        "Presses are too few below " + std::to_string(leastPresses) + ".",
                        {{"participant", "participant", 0, "id"},
                         {"trials", "trials", 0, "rows"},
                         {"presses", "presses", 0, "of those, with a press"},
                         place,
                         spread,
                         {"lapses_percent", "lapses, %", 1, "share of the presses that belong to nothing"}},
                        {}};
  std::vector<PersonTiming> people;
  for (const TimedPeople::Person& person : presses.people) {
    const std::optional<PersonTiming> p = timingOf(presses.task, person.trials);
    const auto pressed = std::count_if(person.trials.begin(), person.trials.end(),
                                       [](const TimedPress& t) { return t.press_s.has_value(); });
    everybody.rows.push_back({person.participant, static_cast<double>(person.trials.size()),
                              static_cast<double>(pressed),
                              p ? FigureCell(factor * p->timing.place) : FigureCell(),
                              p ? FigureCell(percent * p->timing.spread) : FigureCell(),
                              p ? FigureCell(percent * p->lapses) : FigureCell()});
    if (p) people.push_back(*p);
  }
  if (people.empty())
    return Failure{FailureCode::unreadableInput, file, "", "nobody has enough presses that differ",
                   "Give " + std::to_string(leastPresses) + " presses a person at least"};
  const LaboratoryTiming fit = timingOver(presses.task, people);
  const auto end = [](const std::optional<Interval>& interval, bool low, double times) {
    return cell(interval ? std::optional(times * (low ? interval->low : interval->high)) : std::nullopt);
  };
  FigureTable laboratory{
      "laboratory",
      std::string("Timing, task ") + nameOf(presses.task),
      people.size() < 2 ? "One person has no interval: people differ." : "",
      {{"people", "people", 0, "with enough presses"},
       place,
       within(place, true),
       within(place, false),
       spread,
       within(spread, true),
       within(spread, false)},
      {{static_cast<double>(people.size()), factor * fit.timing.place, end(fit.place, true, factor),
        end(fit.place, false, factor), percent * fit.timing.spread, end(fit.spread, true, percent),
        end(fit.spread, false, percent)}}};
  return std::vector<FigureTable>{std::move(laboratory), std::move(everybody)};
}

}  // namespace detent::playback
