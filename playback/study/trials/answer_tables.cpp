// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/answer_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>

#include "playback/measurement/normal.h"
#include "playback/study/statistics/bradley_terry.h"
#include "playback/study/statistics/paired_difference.h"
#include "playback/study/statistics/resampling.h"
#include "playback/study/statistics/same_different.h"
#include "playback/study/trials/study_results.h"

namespace detent::playback {

namespace {

constexpr double answerPercent = 100, confidence = 0.95;

FigureCell cell(const std::optional<double>& value) { return value ? FigureCell(*value) : FigureCell(); }
FigureCell count(std::size_t n) { return static_cast<double>(n); }

/// A mean over participants with Student's interval; none for fewer than fewestForInterval.
struct MeanOverPeople {
  double mean = 0;
  std::optional<Interval> interval;
};

MeanOverPeople meanOver(const std::vector<double>& values) {
  MeanOverPeople result;
  const auto n = static_cast<double>(values.size());
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() < fewestForInterval) return result;
  double squares = 0;
  for (const double v : values) squares += (v - result.mean) * (v - result.mean);
  const double half =
      studentQuantile(0.5 + confidence / 2, values.size() - 1) * std::sqrt(squares / (n - 1) / n);
  result.interval = Interval{result.mean - half, result.mean + half};
  return result;
}

/// A counted answer with its context, by condition.
struct Counted {
  const ParticipantRecord* participant = nullptr;
  std::size_t person = 0;
  std::size_t at = 0;  ///< index of the answer
  const Trial& trial() const { return participant->plan[at]; }
  const Answer& answer() const { return participant->answers[at].answer; }
};
using Conditions = std::map<std::string, std::vector<Counted>>;

Conditions conditionsOf(const Study& study, const std::vector<ParticipantRecord>& participants) {
  Conditions conditions;
  for (std::size_t person = 0; person < participants.size(); ++person) {
    const ParticipantRecord& p = participants[person];
    for (std::size_t i = 0; i < p.answers.size(); ++i)
      if (!p.plan[i].practice)
        conditions[conditionOf(study, p.answers[i], p.plan[i].mode)].push_back({&p, person, i});
  }
  return conditions;
}

// ---- thresholds

struct PersonThreshold {
  std::size_t trials = 0, right = 0;
  ThresholdEstimate estimate;
};

std::size_t referenceOf(const Trial& trial) { return trial.choices[1 - trial.target]; }

/// Thresholds, by reference button and person.
std::map<std::pair<std::size_t, std::size_t>, PersonThreshold> thresholdsIn(
    const Study& study, const std::vector<Counted>& answers) {
  std::map<std::pair<std::size_t, std::size_t>, PersonThreshold> found;
  std::map<std::pair<std::size_t, std::size_t>, const Counted*> any;
  for (const Counted& c : answers) {
    const std::pair key{referenceOf(c.trial()), c.person};
    PersonThreshold& t = found[key];
    ++t.trials;
    if (c.answer().choice == c.trial().target) ++t.right;
    any[key] = &c;
  }
  for (auto& [key, t] : found) {
    const Counted& c = *any.at(key);
    t.estimate = beliefAfter(study, *c.participant, key.first, c.trial().mode, c.participant->answers.size())
                     .estimate(confidence);
  }
  return found;
}

FigureTable personTable(const Study& study) {
  return {
      "thresholds",
      "Threshold of each participant: the increase of " + std::string(nameOf(study.design.quantity)) +
          " told in 75 of 100",
      "95 % credible, equal tails (QUEST+). Open: the interval reaches an end of what was thought possible.",
      {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
       {"participant", "participant", 0, "anonymous id"},
       {"button", "button", 0, "what it was compared with"},
       {"trials", "trials", 0, "questions that count"},
       {"right", "right", 0, "of those, told rightly"},
       {"threshold_percent", "threshold %", 1, "increase told in 75 of 100, lapses aside; median"},
       {"low_percent", "low", 1, "2.5 % are below"},
       {"high_percent", "high", 1, "2.5 % are above"},
       {"open", "open", 0, "yes: the interval reaches an end of what was thought possible"}},
      {}};
}

FigureTable overPeopleTable() {
  return {"thresholds_over_people",
          "Thresholds over participants",
          "Geometric mean, with Student's 95 % interval of its logarithm; none for two people.",
          {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
           {"button", "button", 0, "what it was compared with"},
           {"participants", "people", 0, "participants with any answer"},
           {"threshold_percent", "threshold %", 1, "geometric mean of the participants' medians"},
           {"low_percent", "low", 1, "lower end"},
           {"high_percent", "high", 1, "upper end"}},
          {}};
}

// ---- ratings

/// Mean response of one person to one button or pair: a rating, its logarithm, or 1 if the pair's first was
/// preferred.
using PersonMeans = std::map<std::size_t, std::map<std::size_t, double>>;

PersonMeans meansOf(const std::vector<Counted>& answers,
                    const std::function<std::pair<std::size_t, double>(const Counted&)>& valueOf) {
  std::map<std::size_t, std::map<std::size_t, std::pair<double, double>>> sums;
  for (const Counted& c : answers) {
    const auto [thing, value] = valueOf(c);
    auto& [sum, n] = sums[thing][c.person];
    sum += value;
    ++n;
  }
  PersonMeans means;
  for (const auto& [thing, people] : sums)
    for (const auto& [person, sum] : people) means[thing][person] = sum.first / sum.second;
  return means;
}

/// Ratings on one common scale: everybody uses their own numbers, so a person's deviations (in logarithms)
/// are added to the mean of all (Stevens; Lane, Catania & Stevens, JASA 1961). Persons who did not rate every
/// button are left out.
PersonMeans onOneScale(const PersonMeans& logs, std::size_t things) {
  std::map<std::size_t, std::pair<double, std::size_t>> byPerson;
  for (const auto& [thing, people] : logs)
    for (const auto& [person, value] : people) {
      byPerson[person].first += value;
      ++byPerson[person].second;
    }
  double all = 0, persons = 0;
  for (const auto& [person, sum] : byPerson)
    if (sum.second == things) {
      all += sum.first / static_cast<double>(things);
      ++persons;
    }
  PersonMeans scaled;
  for (const auto& [thing, people] : logs)
    for (const auto& [person, value] : people) {
      const auto& [sum, n] = byPerson[person];
      if (n == things) scaled[thing][person] = value - sum / static_cast<double>(things) + all / persons;
    }
  return scaled;
}

std::vector<double> valuesOf(const std::map<std::size_t, double>& people) {
  std::vector<double> values;
  for (const auto& [person, value] : people) values.push_back(value);
  return values;
}

FigureTable scoreTable(const Study& study) {
  const bool pairwise = study.design.scale == RatingScale::pairwise;
  const bool magnitude = study.design.scale == RatingScale::magnitude;
  FigureTable table{
      "ratings",
      magnitude  ? "Magnitude of each button"
      : pairwise ? "Preference of each button (Bradley-Terry)"
                 : "Preference of each button, 1 to 7",
      magnitude ? "Geometric mean over participants, each on the scale of all; Student's 95 % interval of "
                  "the logarithm."
      : pairwise
          ? "Log odds against the mean of all: a difference of 1 is preferred in 73 of 100. 95 %, "
            "persons independent; "
            "below six people trials are taken as independent, which is too narrow; none for two people."
          : "Mean over participants with Student's 95 % interval, cut off at the ends of the scale; none for "
            "two people.",
      {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
       {"button", "button", 0, "what was rated"},
       {"participants", "people", 0, "participants that count"},
       {"value",
        pairwise    ? "score"
        : magnitude ? "magnitude"
                    : "mean",
        2, "see the table's note"},
       {"low", "low", 2, "lower end, 95 %"},
       {"high", "high", 2, "upper end, 95 %"}},
      {}};
  return table;
}

FigureTable differenceTable(const Study& study) {
  const bool pairwise = study.design.scale == RatingScale::pairwise;
  const bool magnitude = study.design.scale == RatingScale::magnitude;
  return {"rating_differences",
          "Every two buttons against each other",
          "Two-sided p by flipping the signs of whole persons, exact up to 20 people; Holm over the pairs of "
          "a condition. "
          "Interval: what this test does not refuse, from six people on.",
          {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
           {"first", "first", 0, "button"},
           {"second", "second", 0, "button"},
           {"participants", "people", 0, "participants who rated both"},
           {"difference",
            pairwise    ? "first preferred, %"
            : magnitude ? "ratio"
                        : "difference",
            pairwise ? 1 : 2,
            pairwise    ? "share of choices for the first, mean over persons"
            : magnitude ? "first over second, geometric mean over persons"
                        : "first minus second, mean over persons"},
           {"low", "low", pairwise ? 1 : 2, "lower end, 95 %"},
           {"high", "high", pairwise ? 1 : 2, "upper end, 95 %"},
           {"p", "p", 4, "two-sided"},
           {"p_holm", "p, Holm", 4, "for all pairs of the condition together"}},
          {}};
}

/// Converts a mean of logarithms, shares or ratings back to the scale of the answers.
double toAnswerScale(RatingScale scale, double value) {
  switch (scale) {
    case RatingScale::preference:
      break;
    case RatingScale::magnitude:
      return std::exp(value);
    case RatingScale::pairwise:
      return answerPercent * (value + 0.5);
  }
  return value;
}

void addDifferences(const Study& study, const std::string& condition,
                    const std::vector<std::vector<double>>& differences, RatingScale scale,
                    FigureTable& table) {
  const auto pairs = pairsOf(study.buttons.size());
  std::vector<double> p;
  const std::size_t before = table.rows.size();
  for (std::size_t at = 0; at < pairs.size(); ++at) {
    if (differences[at].empty()) continue;
    const PairedDifference d = pairedDifference(differences[at], confidence);
    p.push_back(d.p);
    table.rows.push_back(
        {condition, study.buttons[pairs[at].first].label, study.buttons[pairs[at].second].label,
         count(differences[at].size()), toAnswerScale(scale, d.mean),
         cell(d.interval ? std::optional(toAnswerScale(scale, d.interval->low)) : std::nullopt),
         cell(d.interval ? std::optional(toAnswerScale(scale, d.interval->high)) : std::nullopt), d.p,
         FigureCell()});
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) table.rows[before + i].back() = adjusted[i];
}

std::size_t pairAt(std::size_t first, std::size_t second) { return second * (second - 1) / 2 + first; }

void addPairwise(const Study& study, const std::string& condition, const std::vector<Counted>& answers,
                 FigureTable& scores, FigureTable& differences) {
  std::vector<Preference> preferences;
  std::map<std::size_t, std::size_t> persons;  // person numbers without gaps
  for (const Counted& c : answers) persons.emplace(c.person, persons.size());
  for (const Counted& c : answers)
    preferences.push_back({persons.at(c.person), c.trial().choices[c.answer().choice],
                           c.trial().choices[1 - c.answer().choice]});
  const PreferenceScores found = bradleyTerry(preferences, study.buttons.size(), confidence);
  const bool known = persons.size() >= fewestForInterval;
  for (std::size_t i = 0; i < found.scores.size(); ++i)
    scores.rows.push_back({condition, study.buttons[i].label, count(persons.size()), found.scores[i],
                           known ? FigureCell(found.intervals[i].low) : FigureCell(),
                           known ? FigureCell(found.intervals[i].high) : FigureCell()});
  const PersonMeans shares = meansOf(answers, [](const Counted& c) {
    const auto [first, second] = std::minmax(c.trial().choices[0], c.trial().choices[1]);
    return std::pair{pairAt(first, second), c.trial().choices[c.answer().choice] == first ? 0.5 : -0.5};
  });
  std::vector<std::vector<double>> byPair(pairsOf(study.buttons.size()).size());
  for (const auto& [pair, people] : shares) byPair[pair] = valuesOf(people);
  addDifferences(study, condition, byPair, RatingScale::pairwise, differences);
}

/// Compares ratings by their order only, without assuming that 3 to 4 is the same distance as 6 to 7.
FigureTable orderTable() {
  return {"rating_order",
          "Every two buttons against each other, by order alone",
          "In how many of a person's ratings the first is higher, equal ones half: 50 where neither is. "
          "Two-sided p by flipping the signs of whole persons, exact up to 20 people; Holm over the pairs of "
          "a condition. Interval: what this test does not refuse, from six people on.",
          {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
           {"first", "first", 0, "button"},
           {"second", "second", 0, "button"},
           {"participants", "people", 0, "participants who rated both"},
           {"higher_percent", "first higher, %", 1, "share of rating pairs, mean over persons"},
           {"low_percent", "low", 1, "lower end, 95 %"},
           {"high_percent", "high", 1, "upper end, 95 %"},
           {"p", "p", 4, "two-sided"},
           {"p_holm", "p, Holm", 4, "for all pairs of the condition together"}},
          {}};
}

/// Share of rating pairs, one of each button, in which the first is higher, minus one half.
double higherShare(const std::vector<double>& first, const std::vector<double>& second) {
  double sum = 0;
  for (const double a : first)
    for (const double b : second) sum += a > b ? 1 : a == b ? 0.5 : 0;
  return sum / static_cast<double>(first.size() * second.size()) - 0.5;
}

void addOrder(const Study& study, const std::string& condition, const std::vector<Counted>& answers,
              FigureTable& order) {
  std::map<std::size_t, std::map<std::size_t, std::vector<double>>> ratings;  // by button, then by person
  for (const Counted& c : answers)
    ratings[c.trial().choices[0]][c.person].push_back(c.answer().rating.value_or(0));
  std::vector<std::vector<double>> byPair;
  for (const auto& [first, second] : pairsOf(study.buttons.size())) {
    std::vector<double>& values = byPair.emplace_back();
    for (const auto& [person, given] : ratings[first])
      if (const auto other = ratings[second].find(person); other != ratings[second].end())
        values.push_back(higherShare(given, other->second));
  }
  addDifferences(study, condition, byPair, RatingScale::pairwise, order);
}

void addScale(const Study& study, const std::string& condition, const std::vector<Counted>& answers,
              FigureTable& scores, FigureTable& differences) {
  const bool magnitude = study.design.scale == RatingScale::magnitude;
  PersonMeans means = meansOf(answers, [&](const Counted& c) {
    const double rating = c.answer().rating.value_or(1);
    return std::pair{c.trial().choices[0], magnitude ? std::log(rating) : rating};
  });
  if (magnitude) means = onOneScale(means, study.buttons.size());
  for (const auto& [button, people] : means) {
    const MeanOverPeople m = meanOver(valuesOf(people));
    const auto end = [&](double Interval::*side) {
      if (!m.interval) return FigureCell();
      const double at = toAnswerScale(study.design.scale, (*m.interval).*side);
      return FigureCell(magnitude ? at : std::clamp(at, worstPreference, bestPreference));
    };
    scores.rows.push_back({condition, study.buttons[button].label, count(people.size()),
                           toAnswerScale(study.design.scale, m.mean), end(&Interval::low),
                           end(&Interval::high)});
  }
  std::vector<std::vector<double>> byPair;
  for (const auto& [first, second] : pairsOf(study.buttons.size())) {
    std::vector<double>& values = byPair.emplace_back();
    for (const auto& [person, value] : means[first])
      if (const auto other = means[second].find(person); other != means[second].end())
        values.push_back(value - other->second);
  }
  addDifferences(study, condition, byPair, study.design.scale, differences);
}

// ---- matching

FigureTable matchTable() {
  return {
      "matches",
      "Matches of each button",
      "Wilson's 95 % take trials as independent, resampled 95 % persons (from six on). p: guessing gets as "
      "many right, exact; Holm over the buttons of a condition.",
      {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
       {"button", "X", 0, "button that was to be found"},
       {"trials", "trials", 0, "questions that count"},
       {"right", "right", 0, "of those, answered rightly"},
       {"right_percent", "right %", 1, "share"},
       {"low_percent", "low", 1, "lower end, Wilson"},
       {"high_percent", "high", 1, "upper end, Wilson"},
       {"resampled_low_percent", "people low", 1, "lower end, participants resampled"},
       {"resampled_high_percent", "high", 1, "upper end, participants resampled"},
       {"chance_percent", "chance %", 1, "share that guessing gets right"},
       {"p", "p", 4, "that guessing gets as many right"},
       {"p_holm", "p, Holm", 4, "for all buttons of the condition together"}},
      {}};
}

FigureTable confusedTable() {
  return {"taken_for_each_other",
          "Pairs taken for each other",
          "Of the questions about either button that were answered with one of both, those answered with the "
          "other: half of them if both feel the same, whatever the other buttons feel like. Intervals as "
          "above. p: of so few if both feel the same, exact; Holm over the pairs of a condition.",
          {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
           {"first", "first", 0, "button"},
           {"second", "second", 0, "button"},
           {"trials", "trials", 0, "questions about either that were answered with one of both"},
           {"confused", "taken", 0, "of those, answered with the other"},
           {"confused_percent", "taken %", 1, "share"},
           {"low_percent", "low", 1, "lower end, Wilson"},
           {"high_percent", "high", 1, "upper end, Wilson"},
           {"resampled_low_percent", "people low", 1, "lower end, participants resampled"},
           {"resampled_high_percent", "high", 1, "upper end, participants resampled"},
           {"chance_percent", "chance %", 1, "share where both feel the same"},
           {"p", "p", 4, "of so few where both feel the same"},
           {"p_holm", "p, Holm", 4, "for all pairs of the condition together"}},
          {}};
}

/// Counts of each person, by X and answer.
using MatchCounts = std::map<std::size_t, std::vector<std::vector<std::size_t>>>;

MatchCounts matchesIn(const std::vector<Counted>& answers, std::size_t buttons) {
  MatchCounts counts;
  for (const Counted& c : answers) {
    auto& own = counts[c.person];
    own.resize(buttons, std::vector<std::size_t>(buttons, 0));
    ++own[c.trial().choices[c.trial().target]][c.trial().choices[c.answer().choice]];
  }
  return counts;
}

/// Appends to a row the mean share over persons, with its two intervals.
std::vector<FigureCell> shareCells(std::vector<FigureCell> row, const std::vector<Count>& persons) {
  const Count all = sumOf(persons);
  const Interval independent = wilson(all, confidence);
  const std::optional<Interval> resampled = participantBootstrap(persons);
  const auto end = [&](double Interval::*side) {
    return cell(resampled ? std::optional(answerPercent * (*resampled).*side) : std::nullopt);
  };
  for (FigureCell& each : std::vector<FigureCell>{
           count(all.trials), count(all.errors), answerPercent * rateOf(all), answerPercent * independent.low,
           answerPercent * independent.high, end(&Interval::low), end(&Interval::high)})
    row.push_back(std::move(each));
  return row;
}

/// Appends chance, p and Holm's p to the rows from `before` on.
void addChance(FigureTable& table, std::size_t before, double chance, const std::vector<double>& p) {
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (const double value : {answerPercent * chance, p[i], adjusted[i]})
      table.rows[before + i].emplace_back(value);
}

void addMatches(const Study& study, const std::string& condition, const std::vector<Counted>& answers,
                FigureTable& matches, FigureTable& confused) {
  const std::size_t buttons = study.buttons.size();
  const double chance = 1 / static_cast<double>(buttons);
  constexpr double evenChance = 0.5;
  const MatchCounts counts = matchesIn(answers, buttons);
  const auto persons = [&](const auto& of) {
    std::vector<Count> each;
    for (const auto& [person, own] : counts)
      if (const Count one = of(own); one.trials > 0) each.push_back(one);
    return each;
  };
  const auto trialsOf = [](const std::vector<std::size_t>& row) {
    return std::accumulate(row.begin(), row.end(), std::size_t{0});
  };
  std::vector<double> p;
  std::size_t before = matches.rows.size();
  for (std::size_t x = 0; x < buttons; ++x) {
    const std::vector<Count> right = persons([&](const auto& own) {
      return Count{own[x][x], trialsOf(own[x])};
    });
    if (right.empty()) continue;
    const Count all = sumOf(right);
    p.push_back(atMost({all.trials - all.errors, all.trials}, 1 - chance));
    matches.rows.push_back(shareCells({condition, study.buttons[x].label}, right));
  }
  addChance(matches, before, chance, p);
  p.clear();
  before = confused.rows.size();
  for (const auto& [first, second] : pairsOf(buttons)) {
    const std::size_t a = first, b = second;
    const std::vector<Count> taken = persons([&](const auto& own) {
      return Count{own[a][b] + own[b][a], own[a][a] + own[a][b] + own[b][a] + own[b][b]};
    });
    if (taken.empty()) continue;
    p.push_back(atMost(sumOf(taken), evenChance));
    confused.rows.push_back(shareCells({condition, study.buttons[a].label, study.buttons[b].label}, taken));
  }
  addChance(confused, before, evenChance, p);
}

// ---- same/different

FigureTable emptySameDifferentTable() {
  return {
      "same_different",
      "Pairs told apart: same or different",
      "d' by differencing (mixed pairs), its 95 % by likelihood, and by independent observations (one known "
      "pair); a share of 0 or 100 % counts half an answer less or more (*). p: so many hits where nobody "
      "tells the two apart, whatever each person's bias, exact; Holm over the pairs of a condition.",
      {{"condition", "condition", 0, "what reached the ears, mode, and whether a person answered"},
       {"first", "first", 0, "button"},
       {"second", "second", 0, "button"},
       {"different", "different", 0, "trials with both"},
       {"hits_percent", "hits %", 1, "of those, called different"},
       {"same", "same", 0, "trials with one of them twice"},
       {"false_alarms_percent", "false %", 1, "of those, called different"},
       {"d_prime_differencing", "d' differ.", 2, "mixed pairs"},
       {"d_prime_low", "low", 2, "lower end, 95 %"},
       {"d_prime_high", "high", 2, "upper end, 95 %"},
       {"d_prime_independent", "d' indep.", 2, "one pair that is known"},
       {"moved", "*", 0, "*: a share of 0 or 100 % was moved by half an answer"},
       {"p", "p", 4, "that people who do not tell them apart have as many hits"},
       {"p_holm", "p, Holm", 4, "for all pairs of the condition together"}},
      {}};
}

void addSameDifferent(const Study& study, const std::string& condition, const std::vector<Counted>& answers,
                      FigureTable& table) {
  std::map<std::size_t, std::map<std::size_t, SameDifferentCount>> byPair;
  for (const Counted& c : answers) {
    const auto [first, second] = std::minmax(c.trial().choices[0], c.trial().choices[1]);
    SameDifferentCount& own = byPair[pairAt(first, second)][c.person];
    const bool saidDifferent = c.answer().choice == 1, differ = c.trial().target == 1;
    ++(differ ? own.different : own.same);
    if (saidDifferent) ++(differ ? own.hits : own.falseAlarms);
  }
  std::vector<double> p;
  const std::size_t before = table.rows.size();
  for (const auto& [pair, people] : byPair) {
    std::vector<SameDifferentCount> persons;
    for (const auto& [person, own] : people) persons.push_back(own);
    const SameDifferentCount all = sumOf(persons);
    if (all.different == 0 || all.same == 0) continue;
    const SameDifferentDPrime d = dPrimeOf(all);
    const auto [first, second] = pairsOf(study.buttons.size())[pair];
    p.push_back(guessedP(persons));
    table.rows.push_back({condition, study.buttons[first].label, study.buttons[second].label,
                          count(all.different), answerPercent * rateOf({all.hits, all.different}),
                          count(all.same), answerPercent * rateOf({all.falseAlarms, all.same}),
                          d.differencing, d.low, cell(d.high), d.independent, std::string(d.moved ? "*" : ""),
                          p.back(), FigureCell()});
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) table.rows[before + i].back() = adjusted[i];
}

}  // namespace

std::vector<FigureTable> sameDifferentTables(const Study& study,
                                             const std::vector<ParticipantRecord>& participants) {
  FigureTable table = emptySameDifferentTable();
  for (const auto& [condition, answers] : conditionsOf(study, participants))
    addSameDifferent(study, condition, answers, table);
  return {table};
}

std::vector<FigureTable> matchingTables(const Study& study,
                                        const std::vector<ParticipantRecord>& participants) {
  FigureTable matches = matchTable(), confused = confusedTable();
  for (const auto& [condition, answers] : conditionsOf(study, participants))
    addMatches(study, condition, answers, matches, confused);
  return {matches, confused};
}

std::vector<FigureTable> thresholdTables(const Study& study,
                                         const std::vector<ParticipantRecord>& participants) {
  FigureTable persons = personTable(study), over = overPeopleTable();
  for (const auto& [condition, answers] : conditionsOf(study, participants)) {
    std::map<std::size_t, std::vector<double>> logs;
    for (const auto& [key, t] : thresholdsIn(study, answers)) {
      const auto& [reference, person] = key;
      persons.rows.push_back(
          {condition, participants[person].participant, study.buttons[reference].label, count(t.trials),
           count(t.right), answerPercent * t.estimate.threshold, answerPercent * t.estimate.credible.low,
           answerPercent * t.estimate.credible.high, t.estimate.beyondLevels ? "yes" : "no"});
      logs[reference].push_back(std::log(t.estimate.threshold));
    }
    for (const auto& [reference, values] : logs) {
      const MeanOverPeople m = meanOver(values);
      const auto end = [&](double Interval::*side) {
        return cell(m.interval ? std::optional(answerPercent * std::exp((*m.interval).*side)) : std::nullopt);
      };
      over.rows.push_back({condition, study.buttons[reference].label, count(values.size()),
                           answerPercent * std::exp(m.mean), end(&Interval::low), end(&Interval::high)});
    }
  }
  return {persons, over};
}

std::vector<FigureTable> ratingTables(const Study& study,
                                      const std::vector<ParticipantRecord>& participants) {
  FigureTable scores = scoreTable(study), differences = differenceTable(study), order = orderTable();
  for (const auto& [condition, answers] : conditionsOf(study, participants)) {
    if (study.design.scale == RatingScale::pairwise)
      addPairwise(study, condition, answers, scores, differences);
    else
      addScale(study, condition, answers, scores, differences);
    if (study.design.scale == RatingScale::preference) addOrder(study, condition, answers, order);
  }
  if (study.buttons.size() < 2) return {scores};
  if (study.design.scale == RatingScale::preference) return {scores, differences, order};
  return {scores, differences};
}

}  // namespace detent::playback
