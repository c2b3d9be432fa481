// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/timing_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "model/number_table.h"
#include "playback/study/statistics/paired_difference.h"
#include "playback/study/trials/study_results.h"

namespace detent::playback {

namespace {

constexpr std::size_t mostBytes = 64 << 20;
constexpr double longest_s = 60;  ///< longest interval, window, and time from a cue to the press
constexpr double timingPercent = 100;
constexpr std::array<std::string_view, 3> emptyPressWords{"", "NA",
                                                          "null"};  // the names that R and jsPsych use

/// Columns that a task needs, in the order in which they are read.
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
      return refused(table.place(), "does not name the columns of this task", "Write " + names);
    }
    while (table.next())
      if (std::optional<Failure> failure = take(table, *columns)) return *std::move(failure);
    TimedPeople presses{task_, {}};
    for (auto& [participant, trials] : people_) presses.people.push_back({participant, std::move(trials)});
    if (presses.people.empty())
      return refused("", "the file has a header but no rows", "Give one row for each trial");
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
    const std::string_view press = row.fields()[columns[1]];
    if (std::find(emptyPressWords.begin(), emptyPressWords.end(), press) == emptyPressWords.end()) {
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

/// Names of a task's two figures, and the unit of a share.
struct TaskWords {
  FigureColumn place, spread;
  double placeFactor;
};

TaskWords taskWordsOf(TimingTask task) {
  const FigureColumn spread{"spread_percent", "spread, %", 2,
                            "standard deviation about that, in hundredths of the interval"};
  switch (task) {
    case TimingTask::cue:
      return {{"place_percent", "behind, %", 2, "mean press behind the cue, in hundredths of the interval"},
              spread,
              timingPercent};
    case TimingTask::window:
      return {{"place_percent", "aim, %", 2, "where in the window is aimed at, in hundredths of it"},
              spread,
              timingPercent};
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

FigureCell timingCell(const std::optional<double>& value) {
  return value ? FigureCell(*value) : FigureCell();
}
FigureCell timingCount(std::size_t n) { return static_cast<double>(n); }

/// All trials with one button in one condition; both are empty if a file names neither.
struct TimingCell {
  std::string button, condition;
  TimedPeople presses;
  std::map<std::string, double> within_s;  ///< for each person: median time accuracy of their presses
};

/// One person in one cell.
struct FittedPerson {
  std::string participant;
  std::size_t trials = 0, presses = 0, outside = 0;
  std::optional<PersonTiming> fit;
};

std::vector<FittedPerson> fitted(const TimedPeople& presses) {
  std::vector<FittedPerson> people;
  for (const TimedPeople::Person& person : presses.people) {
    FittedPerson p{person.participant, person.trials.size(), 0, 0, timingOf(presses.task, person.trials)};
    for (const TimedPress& trial : person.trials) {
      if (trial.press_s) ++p.presses;
      if (!trial.press_s || *trial.press_s < 0 || *trial.press_s >= trial.window_s) ++p.outside;
    }
    people.push_back(std::move(p));
  }
  return people;
}

/// Way in which the rows of a table identify their cell: not at all, for a file without button and condition;
/// by the title, if all are of one condition.
struct Naming {
  bool button = false, condition = false;
  std::string title;  ///< appended to the table's own title
};

Naming namingOf(const std::vector<TimingCell>& cells) {
  const bool several = std::any_of(cells.begin(), cells.end(), [&](const TimingCell& c) {
    return c.condition != cells.front().condition;
  });
  return {true, several, several || cells.empty() ? std::string() : " (" + cells.front().condition + ")"};
}

void addCellColumns(FigureTable& table, const Naming& naming) {
  table.title += naming.title;
  if (naming.button) table.columns.push_back({"button", "button", 0, "what was pressed"});
  if (naming.condition)
    table.columns.push_back({"condition", "condition", 0, "listening, mode, who answered"});
}
std::vector<FigureCell> cellRow(const TimingCell& timingCell, const Naming& naming) {
  std::vector<FigureCell> row;
  if (naming.button) row.emplace_back(timingCell.button);
  if (naming.condition) row.emplace_back(timingCell.condition);
  return row;
}
void append(std::vector<FigureCell>& row, std::vector<FigureCell> more) {
  row.insert(row.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

FigureTable laboratoryTable(TimingTask task, const std::vector<TimingCell>& cells,
                            const std::vector<std::vector<FittedPerson>>& fits, const Naming& naming) {
  const auto [place, spread, factor] = taskWordsOf(task);
  FigureTable table{"laboratory", std::string("Timing, task ") + nameOf(task), "", {}, {}};
  addCellColumns(table, naming);
  for (const FigureColumn& column :
       {FigureColumn{"people", "people", 0, "with enough presses"}, place, within(place, true),
        within(place, false), spread, within(spread, true), within(spread, false)})
    table.columns.push_back(column);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::vector<PersonTiming> people;
    for (const FittedPerson& p : fits[i])
      if (p.fit) people.push_back(*p.fit);
    if (people.size() == 1) table.note = "One person has no interval: people differ.";
    std::vector<FigureCell> row = cellRow(cells[i], naming);
    if (people.empty()) {
      append(row, {timingCount(0), {}, {}, {}, {}, {}, {}});
    } else {
      const LaboratoryTiming fit = timingOver(task, people);
      const auto end = [](const std::optional<Interval>& interval, bool low, double times) {
        return timingCell(interval ? std::optional(times * (low ? interval->low : interval->high))
                                   : std::nullopt);
      };
      append(row, {timingCount(people.size()), factor * fit.timing.place, end(fit.place, true, factor),
                   end(fit.place, false, factor), timingPercent * fit.timing.spread,
                   end(fit.spread, true, timingPercent), end(fit.spread, false, timingPercent)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

FigureTable peopleTable(TimingTask task, const std::vector<TimingCell>& cells,
                        const std::vector<std::vector<FittedPerson>>& fits, const Naming& naming) {
  const auto [place, spread, factor] = taskWordsOf(task);
  FigureTable table{"people",
                    "Timing of each participant",
                    "Presses are too few below " + std::to_string(leastPresses) + ".",
                    {{"participant", "participant", 0, "id"}},
                    {}};
  addCellColumns(table, naming);
  const bool file = !naming.button;  // in a study every row has a press
  table.columns.push_back({"trials", "trials", 0, "rows"});
  if (file) table.columns.push_back({"presses", "presses", 0, "of those, with a press"});
  for (const FigureColumn& column :
       {place, spread,
        FigureColumn{"lapses_percent", "lapses, %", 1, "share of the presses that belong to nothing"}})
    table.columns.push_back(column);
  const bool window = !file && task == TimingTask::window;
  if (window)
    table.columns.push_back({"outside_percent", "outside, %", 1, "of the trials, the window was not hit"});
  if (!file)
    table.columns.push_back(
        {"within_ms", "within, ms", 1, "median over trials of how late a press may have been told"});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const FittedPerson& p : fits[i]) {
      std::vector<FigureCell> row{p.participant};
      append(row, cellRow(cells[i], naming));
      row.push_back(timingCount(p.trials));
      if (file) row.push_back(timingCount(p.presses));
      constexpr std::size_t figures = 3;
      if (!p.fit) row.resize(row.size() + figures);
      if (p.fit)
        for (const double figure : {factor * p.fit->timing.place, timingPercent * p.fit->timing.spread,
                                    timingPercent * p.fit->lapses})
          row.emplace_back(figure);
      if (window)
        row.emplace_back(timingPercent * static_cast<double>(p.outside) / static_cast<double>(p.trials));
      if (!file) row.emplace_back(1000 * cells[i].within_s.at(p.participant));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// Difference of two fits of one person. Spreads, and places of tapping, are ratios: given as per cent more.
double differenceOf(TimingTask task, bool ofPlace, const PersonTiming& first, const PersonTiming& second) {
  if (ofPlace && task != TimingTask::tapping)
    return timingPercent * (first.timing.place - second.timing.place);
  return ofPlace ? timingPercent * std::log(first.timing.place / second.timing.place)
                 : timingPercent * std::log(first.timing.spread / second.timing.spread);
}

FigureTable differencesTable(TimingTask task, const std::vector<TimingCell>& cells,
                             const std::vector<std::vector<FittedPerson>>& fits) {
  FigureTable table{
      "differences",
      "Buttons against each other",
      "First minus second: the place in the unit above, the spread (and the time between taps) as a "
      "logarithm, in hundredths. Signs of whole persons flipped, Holm over all rows of a condition.",
      {{"pair", "pair", 0, "two buttons"},
       {"condition", "condition", 0, "listening, mode, who answered"},
       {"figure", "figure", 0, "place or spread"},
       {"people", "people", 0, "fitted with both"},
       {"difference", "difference", 2, "mean over persons"},
       {"low", "from", 2, "95 % interval, lower end"},
       {"high", "to", 2, "upper end"},
       {"p", "p", 4, "two-sided"},
       {"p_holm", "p (Holm)", 4, "adjusted"}},
      {}};
  std::map<std::string, std::vector<std::pair<std::size_t, double>>> byCondition;  // row, p
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t k = i + 1; k < cells.size(); ++k) {
      if (cells[i].condition != cells[k].condition) continue;
      for (const bool ofPlace : {true, false}) {
        std::vector<double> differences;
        for (const FittedPerson& first : fits[i])
          for (const FittedPerson& second : fits[k])
            if (first.participant == second.participant && first.fit && second.fit)
              differences.push_back(differenceOf(task, ofPlace, *first.fit, *second.fit));
        if (differences.empty()) continue;
        const PairedDifference d = pairedDifference(differences);
        byCondition[cells[i].condition].emplace_back(table.rows.size(), d.p);
        table.rows.push_back({pairName({cells[i].button, cells[k].button}, 0, 1), cells[i].condition,
                              std::string(ofPlace ? "place" : "spread"), timingCount(differences.size()),
                              d.mean, timingCell(d.interval ? std::optional(d.interval->low) : std::nullopt),
                              timingCell(d.interval ? std::optional(d.interval->high) : std::nullopt), d.p,
                              FigureCell()});
      }
    }
  }
  for (const auto& [condition, tests] : byCondition) {
    std::vector<double> p;
    for (const auto& [row, value] : tests) p.push_back(value);
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < tests.size(); ++i) table.rows[tests[i].first].back() = adjusted[i];
  }
  return table;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Cells ordered by condition, then button.
std::vector<TimingCell> cellsOf(const Study& study, const std::vector<ParticipantRecord>& participants) {
  struct Person {
    std::vector<TimedPress> trials;
    std::vector<double> within_s;
  };
  std::map<std::pair<std::string, std::size_t>, std::map<std::string, Person>> all;
  for (const ParticipantRecord& p : participants) {
    for (std::size_t i = 0; i < p.answers.size(); ++i) {
      const Trial& trial = p.plan[i];
      if (trial.practice) continue;
      Person& person = all[{conditionOf(study, p.answers[i], trial.mode), trial.choices[0]}][p.participant];
      const std::vector<TimedPress> presses = timedPresses(study.design, trial, p.answers[i].answer);
      person.trials.insert(person.trials.end(), presses.begin(), presses.end());
      person.within_s.push_back(p.answers[i].answer.pressWithin_s);
    }
  }
  std::vector<TimingCell> cells;
  for (auto& [key, people] : all) {
    TimingCell timingCell{study.buttons[key.second].label, key.first, {study.design.task, {}}, {}};
    for (auto& [id, person] : people) {
      timingCell.presses.people.push_back({id, std::move(person.trials)});
      timingCell.within_s[id] = medianOf(std::move(person.within_s));
    }
    cells.push_back(std::move(timingCell));
  }
  return cells;
}

}  // namespace

Result<TimedPeople> readTimedPresses(const std::string& file, TimingTask task) {
  const Result<std::string> text = readTable(file, mostBytes, "Give a CSV of timed presses");
  if (!text) return text.failure();
  return Reader(file, task).read(*text);
}

Result<std::vector<FigureTable>> timingTables(const TimedPeople& presses, const std::string& file) {
  const std::vector<std::vector<FittedPerson>> fits{fitted(presses)};
  if (std::none_of(fits[0].begin(), fits[0].end(), [](const FittedPerson& p) { return p.fit.has_value(); }))
    return Failure{FailureCode::unreadableInput, file, "", "nobody has enough presses that differ",
                   "Give " + std::to_string(leastPresses) + " presses a person at least"};
  const std::vector<TimingCell> cells{{"", "", presses, {}}};
  return std::vector<FigureTable>{laboratoryTable(presses.task, cells, fits, {}),
                                  peopleTable(presses.task, cells, fits, {})};
}

std::vector<TimedPress> timedPresses(const StudyDesign& design, const Trial& trial, const Answer& answer) {
  if (design.task != TimingTask::tapping)
    return {{trial.interval_s, trial.window_s, countedPress(trial, answer.presses_s)}};
  std::vector<TimedPress> presses;
  for (std::size_t i = 1; i < answer.presses_s.size(); ++i)
    presses.push_back({0, 0, answer.presses_s[i] - answer.presses_s[i - 1]});
  return presses;
}

std::vector<FigureTable> timingTables(const Study& study,
                                      const std::vector<ParticipantRecord>& participants) {
  const TimingTask task = study.design.task;
  const std::vector<TimingCell> cells = cellsOf(study, participants);
  std::vector<std::vector<FittedPerson>> fits;
  for (const TimingCell& timingCell : cells) fits.push_back(fitted(timingCell.presses));
  const Naming naming = namingOf(cells);
  std::vector<FigureTable> tables{laboratoryTable(task, cells, fits, naming),
                                  peopleTable(task, cells, fits, naming)};
  FigureTable differences = differencesTable(task, cells, fits);
  if (!differences.rows.empty()) tables.push_back(std::move(differences));
  return tables;
}

}  // namespace detent::playback
