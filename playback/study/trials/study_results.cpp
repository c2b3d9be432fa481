// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/study_results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "playback/study/statistics/abx_sensitivity.h"
#include "playback/study/statistics/paired_difference.h"
#include "playback/study/statistics/resampling.h"
#include "playback/study/trials/answer_tables.h"
#include "playback/study/trials/timing_tables.h"

namespace detent::playback {

namespace {

constexpr double secondsPerMinute = 60;

std::string conditionOf(const Study& study, Listening listening, FeedbackMode mode, SessionKind kind) {
  std::string text = nameOf(listening);
  if (study.design.modes.size() > 1) text += std::string("/") + nameOf(mode);
  if (kind != SessionKind::real) text += std::string("/") + nameOf(kind);
  return text;
}

std::string conditionOf(const Study& study, const TrialRow& row) {
  return conditionOf(study, row.listening, row.mode, row.kind);
}

/// Fills in the compared buttons of a trial, and how often each was replayed.
void describe(const Study& study, const Trial& trial, const Answer& answer, TrialRow& row) {
  const StudyKind kind = study.design.kind;
  const std::vector<std::size_t> buttons = feltButtons(study.design, trial);
  const std::vector<std::size_t>& replays = answer.replays;
  row.x = hasRightAnswer(kind) ? answerName(study, trial, trial.target) : std::string();
  row.first = row.second = trial.choices[trial.target];
  row.pair = study.buttons[row.first].label;
  row.replaysA = std::accumulate(replays.begin(), replays.end(), std::size_t{0});
  if (const StudyLevel* level = levelOf(study, row.first)) {
    row.level = level->increase;
    row.pair = study.buttons[level->reference].label;
  }
  row.rating = answer.rating;
  if (kind == StudyKind::matching || trial.choices.size() != 2) return;
  row.a = study.buttons[buttons[0]].label;
  row.b = study.buttons[buttons[1]].label;
  row.replaysA = !replays.empty() ? replays[0] : 0;
  row.replaysB = replays.size() > 1 ? replays[1] : 0;
  if (kind == StudyKind::threshold) return;
  std::tie(row.first, row.second) = std::minmax(trial.choices[0], trial.choices[1]);
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < study.givenButtons(); ++i) labels.push_back(study.buttons[i].label);
  row.pair = pairName(labels, row.first, row.second);
}

TrialRow rowOf(const Study& study, const ParticipantRecord& participant, std::size_t at) {
  const Trial& trial = participant.plan[at];
  const RecordedAnswer& recorded = participant.answers[at];
  TrialRow row;
  row.participant = participant.participant;
  row.trial = trial.number - study.design.practice;
  describe(study, trial, recorded.answer, row);
  row.answered = trial.choices[recorded.answer.choice];
  for (const std::size_t button : feltButtons(study.design, trial))
    row.choices.push_back(study.buttons[button].label);
  if (!recorded.answer.felt.empty()) {
    row.felt = recorded.answer.felt;
    row.felt.push_back(recorded.answer.feltX);
  }
  row.answer = answerName(study, trial, recorded.answer.choice);
  row.correct = hasRightAnswer(study.design.kind) && recorded.answer.choice == trial.target;
  row.replaysX = recorded.answer.replaysX;
  row.onset_s = recorded.onset_s;
  row.firstPress_s = recorded.answer.firstPress_s;
  row.answer_s = recorded.answer.answer_s;
  row.mode = trial.mode;
  row.kind = recorded.kind;
  row.listening = recorded.listening;
  row.interruptions = recorded.interruptions;
  row.condition = conditionOf(study, row) + (row.interruptions > 0 ? "/repeated" : "");
  row.finished = participant.complete();
  row.site = participant.site;
  return row;
}

/// Rows for one answer; for tapping one row per tap after the first.
std::vector<TrialRow> rowsOfAnswer(const Study& study, const ParticipantRecord& participant, std::size_t at) {
  TrialRow row = rowOf(study, participant, at);
  if (study.design.kind != StudyKind::timing) return {std::move(row)};
  const Trial& trial = participant.plan[at];
  const Answer& answer = participant.answers[at].answer;
  const bool tapping = study.design.task == TimingTask::tapping;
  const double onset_s = row.onset_s;
  row.pressWithin_s = answer.pressWithin_s;
  if (!tapping) row.interval_s = trial.interval_s;
  if (study.design.task == TimingTask::window) row.window_s = trial.window_s;
  std::vector<TrialRow> rows;
  for (const TimedPress& press : timedPresses(study.design, trial, answer)) {
    row.press_s = press.press_s;
    rows.push_back(row);
    if (!tapping) break;
    rows.back().onset_s = onset_s + answer.firstPress_s + answer.presses_s[rows.size()];
    rows.back().answer_s = press.press_s.value_or(0);
    row.felt.clear();  // stored for the run, not for each tap
  }
  return rows;
}

void add(Count& count, const TrialRow& row) {
  ++count.trials;
  if (!row.correct) ++count.errors;
}

using Rows = std::vector<const TrialRow*>;

void addTimes(GroupResult& group, const Rows& rows) {
  std::map<std::string, double> seconds;
  for (const TrialRow* row : rows) seconds[row->participant] += row->answer_s;
  double sum = 0, squares = 0;
  for (const auto& [id, s] : seconds) sum += s / secondsPerMinute;
  const auto n = static_cast<double>(seconds.size());
  group.meanTime_min = sum / n;
  for (const auto& [id, s] : seconds)
    squares += (s / secondsPerMinute - group.meanTime_min) * (s / secondsPerMinute - group.meanTime_min);
  group.sdTime_min = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
}

void addParticipants(GroupResult& group, const Rows& rows) {
  std::map<std::string, Count> counts;
  for (const TrialRow* row : rows) {
    add(counts[row->participant], *row);
    add(group.errors, *row);
  }
  for (const auto& [id, count] : counts) {
    group.participants.push_back(id);
    group.perParticipant.push_back(count);
  }
  group.participantCount = counts.size();
  group.wilson = wilson(group.errors);
  group.clopperPearson = clopperPearson(group.errors);
  group.bootstrap = participantBootstrap(group.perParticipant);
}

void addPairs(GroupResult& group, const Study& study, const Rows& rows, const DiscriminationRule& rule) {
  std::map<std::pair<std::size_t, std::size_t>, std::map<std::string, Count>> byPair;
  for (const TrialRow* row : rows) add(byPair[{row->first, row->second}][row->participant], *row);
  for (const auto& [first, second] : pairsOf(study.buttons.size())) {
    const auto at = byPair.find({first, second});
    if (at == byPair.end()) continue;
    Count sum;
    std::vector<AbxTest> tests;
    for (const auto& [id, count] : at->second) {
      sum.errors += count.errors;
      sum.trials += count.trials;
      if (count.trials < study.design.trials) continue;
      const bool passed = rule.mostErrors && count.errors <= *rule.mostErrors;
      tests.push_back({id, count, passed, atMost(count, 0.5), 1});
    }
    PairResult pair = pairResult(first, second, sum);
    if (rule.mostErrors) {  // with so few trials that nobody can pass, there is no test
      pair.failCount = static_cast<std::size_t>(
          std::count_if(tests.begin(), tests.end(), [](const AbxTest& t) { return !t.discriminates; }));
      group.fails.trials += tests.size();
      group.fails.errors += *pair.failCount;
    }
    pair.tests = std::move(tests);
    group.pairs.push_back(std::move(pair));
  }
}

/// Adjusts p by Holm over the pairs and modes of each participant.
void adjustTests(std::vector<GroupResult>& groups) {
  std::map<std::string, std::vector<AbxTest*>> byParticipant;
  for (GroupResult& group : groups)
    for (PairResult& pair : group.pairs)
      for (AbxTest& test : pair.tests) byParticipant[test.participant].push_back(&test);
  for (const auto& [id, tests] : byParticipant) {
    std::vector<double> p;
    for (const AbxTest* test : tests) p.push_back(test->p);
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < tests.size(); ++i) tests[i]->adjusted = adjusted[i];
  }
}

void addConfusion(GroupResult& group, std::size_t buttons, const Rows& rows) {
  group.confusion.assign(buttons, std::vector<std::size_t>(buttons, 0));
  for (const TrialRow* row : rows) ++group.confusion[row->first][row->answered];
}

GroupResult groupOf(const Study& study, const DiscriminationRule& rule, const Rows& rows) {
  GroupResult group;
  const TrialRow& any = *rows.front();
  group.condition = conditionOf(study, any);
  group.listening = any.listening;
  group.mode = any.mode;
  group.kind = any.kind;
  addParticipants(group, rows);
  addTimes(group, rows);
  if (study.design.kind == StudyKind::matching) {
    addConfusion(group, study.buttons.size(), rows);
  } else {
    addPairs(group, study, rows, rule);
  }
  return group;
}

/// Counts of each person in a condition, over all trials or those of one pair.
using People = std::map<std::string, Count>;

People peopleOf(const Rows& rows, const std::pair<std::size_t, std::size_t>* pair) {
  People people;
  for (const TrialRow* row : rows)
    if (pair == nullptr || *pair == std::pair(row->first, row->second)) add(people[row->participant], *row);
  return people;
}

std::vector<Count> countsOf(const People& people) {
  std::vector<Count> counts;
  for (const auto& [id, count] : people) counts.push_back(count);
  return counts;
}

void compare(GroupComparison& c, const People& first, const People& second) {
  std::vector<double> differences;
  for (const auto& [id, count] : first)
    if (const auto other = second.find(id); other != second.end())
      differences.push_back(rateOf(count) - rateOf(other->second));
  c.paired = !differences.empty();
  if (c.paired) {
    const PairedDifference d = pairedDifference(differences);
    c.participants = differences.size();
    c.difference = d.mean;
    c.interval = d.interval;
    c.p = d.p;
    return;
  }
  c.participants = first.size() + second.size();
  const auto rate = [](const People& people) {
    double sum = 0;
    for (const auto& [id, count] : people) sum += rateOf(count);
    return people.empty() ? 0 : sum / static_cast<double>(people.size());
  };
  c.difference = rate(first) - rate(second);
  c.p = groupDifferenceP(countsOf(first), countsOf(second));
}

void adjust(std::vector<GroupComparison>& comparisons) {
  std::vector<double> p;
  for (const GroupComparison& c : comparisons) p.push_back(c.p);
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].adjusted = adjusted[i];
}

/// Comparisons of all pairs of conditions of the same kind of session, over all trials and, for abx, also
/// pair by pair.
std::vector<GroupComparison> comparisonsOf(const Study& study, const std::vector<GroupResult>& groups,
                                           const std::map<std::string, Rows>& rows) {
  std::vector<GroupComparison> whole, byPair;
  const auto pairs = study.design.kind == StudyKind::abx ? pairsOf(study.buttons.size())
                                                         : std::vector<std::pair<std::size_t, std::size_t>>{};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t k = i + 1; k < groups.size(); ++k) {
      if (groups[i].kind != groups[k].kind) continue;
      const Rows &first = rows.at(groups[i].condition), &second = rows.at(groups[k].condition);
      GroupComparison c;
      c.first = groups[i].condition;
      c.second = groups[k].condition;
      compare(c, peopleOf(first, nullptr), peopleOf(second, nullptr));
      whole.push_back(c);
      for (std::size_t at = 0; at < pairs.size(); ++at) {
        const People one = peopleOf(first, &pairs[at]), other = peopleOf(second, &pairs[at]);
        if (one.empty() || other.empty()) continue;
        c.pair = at;
        compare(c, one, other);
        byPair.push_back(c);
      }
    }
  }
  adjust(whole);
  adjust(byPair);
  whole.insert(whole.end(), byPair.begin(), byPair.end());
  return whole;
}

void warn(StudyResults& results, const Study& study, const std::vector<ParticipantRecord>& participants) {
  results.warnings = missingParticipants(participants);
  for (const ParticipantRecord& p : participants) {
    if (p.damage) {
      results.warnings.push_back(p.participant + " is left out: " + p.damage->sentence());
      continue;
    }
    results.warnings.insert(results.warnings.end(), p.notes.begin(), p.notes.end());
    if (!p.complete())
      results.warnings.push_back(p.participant + ": " + std::to_string(p.answers.size()) + " of " +
                                 std::to_string(p.plan.size()) + " trials" +
                                 (p.endedEarly ? ", ended early (" + p.endReason + ")" : ", not finished") +
                                 (results.unfinishedLeftOut ? "; left out of the figures" : ""));
    if (!p.program.empty() && p.program != study.program)
      results.warnings.push_back(p.participant + ": answered with version " + p.program +
                                 ", the study is of " + study.program);
  }
  if (study.design.kind == StudyKind::abx && !results.rule.mostErrors)
    results.warnings.push_back(
        std::to_string(study.design.trials) +
        " trials of a pair are too few for a test: guessing gets them all right in more than 5 % of runs; "
        "five are the fewest");
  const bool nobody = std::none_of(participants.begin(), participants.end(),
                                   [](const ParticipantRecord& p) { return p.complete(); });
  if (nobody && !results.rows.empty())
    results.warnings.emplace_back("nobody has answered all trials yet: everybody counts so far");
  if (results.rows.empty()) results.warnings.push_back("no answer yet: there is nothing to report");
}

std::vector<FigureTable> tablesOf(const Study& study, const std::vector<ParticipantRecord>& participants) {
  switch (study.design.kind) {
    case StudyKind::abx:
    case StudyKind::matching:
      break;
    case StudyKind::sameDifferent:
      return sameDifferentTables(study, participants);
    case StudyKind::threshold:
      return thresholdTables(study, participants);
    case StudyKind::rating:
      return ratingTables(study, participants);
    case StudyKind::timing:
      return timingTables(study, participants);
  }
  return {};
}

/// Figures for a set of participants.
struct Figures {
  std::vector<GroupResult> groups;
  std::vector<GroupComparison> comparisons;
  std::vector<FigureTable> tables;
};

Figures figuresOf(const Study& study, const DiscriminationRule& rule,
                  const std::vector<ParticipantRecord>& participants) {
  Figures figures;
  const std::vector<TrialRow> rows = rowsOf(study, participants);
  if (rows.empty()) return figures;
  if (!asksForX(study.design.kind)) {
    figures.tables = tablesOf(study, participants);
    return figures;
  }
  std::map<std::string, Rows> groups;
  for (const TrialRow& row : rows) groups[conditionOf(study, row)].push_back(&row);
  for (const auto& [condition, all] : groups) figures.groups.push_back(groupOf(study, rule, all));
  adjustTests(figures.groups);
  if (study.design.kind == StudyKind::matching) figures.tables = matchingTables(study, participants);
  figures.comparisons = comparisonsOf(study, figures.groups, groups);
  return figures;
}

}  // namespace

std::string conditionOf(const Study& study, const RecordedAnswer& answer, FeedbackMode mode) {
  return conditionOf(study, answer.listening, mode, answer.kind);
}

std::vector<TrialRow> rowsOf(const Study& study, const std::vector<ParticipantRecord>& participants) {
  std::vector<TrialRow> rows;
  for (const ParticipantRecord& p : participants)
    for (std::size_t i = 0; i < p.answers.size(); ++i)
      if (!p.plan[i].practice)
        for (TrialRow& row : rowsOfAnswer(study, p, i)) rows.push_back(std::move(row));
  return rows;
}

std::string pairName(const std::vector<std::string>& labels, std::size_t first, std::size_t second) {
  for (const char* between : {"-", " | "})
    if (std::none_of(labels.begin(), labels.end(),
                     [&](const std::string& label) { return label.find(between) != std::string::npos; }))
      return labels[first] + between + labels[second];
  return std::to_string(first + 1) + "-" + std::to_string(second + 1);
}

std::vector<std::string> shortened(const std::vector<std::string>& labels, std::size_t width) {
  const auto cut = [](const std::string& text, std::size_t length) {
    // does not divide a character
    while (length > 0 && length < text.size() && (text[length] & 0xc0) == 0x80) --length;
    return text.substr(0, length);
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::string name = cut(labels[i], width);
    const auto alike = [&](const std::string& other) { return cut(other, width) == name; };
    if (std::count_if(labels.begin(), labels.end(), alike) > 1) {
      const std::string number = "~" + std::to_string(i + 1);
      name = cut(labels[i], width - number.size()) + number;
    }
    names.push_back(std::move(name));
  }
  if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) return names;
  for (std::size_t i = 0; i < names.size(); ++i)
    names[i] = "~" + std::to_string(i + 1);  // if this is already a label
  return names;
}

DiscriminationRule discriminationRule(std::size_t trials, double level) {
  DiscriminationRule rule;
  for (std::size_t errors = 0; errors < trials; ++errors) {
    const double p = atMost({errors, trials}, 0.5);
    if (p >= level) break;
    rule = {errors, p};
  }
  return rule;
}

Sensitivity sensitivityOf(const Count& errors) {
  Sensitivity s;
  s.noError = errors.errors == 0 && errors.trials > 0;
  const double correct = s.noError ? 1 - 0.5 / static_cast<double>(errors.trials) : 1 - rateOf(errors);
  const double least = 1 - clopperPearson(errors).high;
  s.low = dPrimeOf(least, AbxStrategy::differencing);
  s.lowIndependent = dPrimeOf(least, AbxStrategy::independentObservations);
  s.differencing = dPrimeOf(correct, AbxStrategy::differencing);
  s.independent = dPrimeOf(correct, AbxStrategy::independentObservations);
  return s;
}

const char* markOf(const PairResult& pair) {
  const std::size_t fails = pair.failCount.value_or(0);
  return fails == 0 ? "" : fails == 1 ? "*" : "**";
}

PairResult pairResult(std::size_t first, std::size_t second, const Count& errors) {
  return {first, second, errors, wilson(errors), clopperPearson(errors), sensitivityOf(errors), {}, {}};
}

/// Every journal records how many journals existed when it was begun. A missing one is therefore detected,
/// unless it was begun last.
std::vector<std::string> missingParticipants(const std::vector<ParticipantRecord>& participants) {
  struct Site {
    std::size_t people = 0, most = 0;
    const ParticipantRecord* latest = nullptr;
  };
  std::map<std::string, Site> sites;
  for (const ParticipantRecord& p : participants) {
    Site& site = sites[p.site];
    ++site.people;
    if (p.damage || p.begunBefore < site.most) continue;
    site.most = p.begunBefore;
    site.latest = &p;
  }
  std::vector<std::string> missing;
  for (const auto& [name, site] : sites)
    if (site.latest != nullptr && site.most + 1 > site.people)
      missing.push_back(std::to_string(site.most + 1 - site.people) + " who began before " +
                        site.latest->participant +
                        " are no longer in the folder: their journals were taken out");
  return missing;
}

StudyResults resultsOf(const Study& study, const std::vector<ParticipantRecord>& participants) {
  StudyResults results;
  results.study = study.name;
  results.kind = study.design.kind;
  results.feel = feels.word(study.design.feel);
  results.sound = study.design.sound;
  for (std::size_t i = 0; i < study.givenButtons(); ++i) {
    results.labels.push_back(study.buttons[i].label);
    results.names.push_back(study.buttons[i].button.name());
  }
  results.trialsPerTest = study.design.trials;
  if (asksForX(study.design.kind)) results.rule = discriminationRule(study.design.trials);
  results.rows = rowsOf(study, participants);
  for (const TrialRow& row : results.rows) {
    results.anySimulated |= row.kind == SessionKind::simulated;
    results.anyRehearsal |= row.kind == SessionKind::rehearsal;
  }
  std::vector<ParticipantRecord> finished;
  for (const ParticipantRecord& p : participants)
    if (p.complete()) finished.push_back(p);
  const bool differ = !finished.empty() && std::any_of(results.rows.begin(), results.rows.end(),
                                                       [](const TrialRow& row) { return !row.finished; });
  results.unfinishedLeftOut = differ && study.unfinished == Unfinished::leftOut;
  Figures first = figuresOf(study, results.rule, results.unfinishedLeftOut ? finished : participants);
  results.groups = std::move(first.groups);
  results.comparisons = std::move(first.comparisons);
  results.tables = std::move(first.tables);
  if (differ) {
    Figures other = figuresOf(study, results.rule, results.unfinishedLeftOut ? participants : finished);
    results.otherGroups = std::move(other.groups);
    results.otherTables = std::move(other.tables);
  }
  warn(results, study, participants);
  return results;
}

}  // namespace detent::playback
