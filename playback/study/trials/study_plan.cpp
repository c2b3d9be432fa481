// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/study_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <set>

#include "model/csv_field.h"
#include "model/file/markup.h"
#include "model/file/text_file.h"
#include "model/number_table.h"
#include "model/sha256.h"
#include "model/version.h"
#include "playback/measurement/normal.h"
#include "playback/study/statistics/power.h"
#include "playback/study/trials/study_results.h"
#include "playback/study/trials/trial_plan.h"

namespace detent::playback {

namespace {

namespace fs = std::filesystem;

constexpr double level = 0.05, planPercent = 100;
constexpr std::array<std::size_t, 8> peopleCounts{6, 8, 9, 10, 12, 16, 20, 30};

std::size_t mostChoices(const std::vector<Trial>& trials) {
  std::size_t most = 0;
  for (const Trial& trial : trials) most = std::max(most, trial.choices.size());
  return most;
}

std::string xOf(const Study& study, const Trial& trial) {
  if (!hasRightAnswer(study.design.kind)) return {};
  if (study.design.kind == StudyKind::threshold) return "choice_" + std::to_string(trial.target + 1);
  return answerName(study, trial, trial.target);
}

FigureTable table(const std::string& key, const std::string& title, const std::string& note,
                  std::vector<FigureColumn> columns) {
  return {key, title, note, std::move(columns), {}};
}

// ---- power

/// One person and one pair: exact, by the rule that the report uses.
FigureTable oneTest(const Study& study) {
  constexpr std::array<double, 6> shares{0.6, 0.7, 0.8, 0.9, 0.95, 0.99};
  FigureTable power = table(
      "one_participant", "One participant tells a pair apart, % of times",
      "Exact. Who is right in that share of trials passes the test of the report so often; by guessing at "
      "most 5 %.",
      {{"trials", "trials", 0, "for each pair and mode"}, {"most_errors", "most errors", 0, "that pass"}});
  for (const double share : shares)
    power.columns.push_back({"right_" + std::to_string(std::lround(planPercent * share)),
                             std::to_string(std::lround(planPercent * share)) + " % right", 0, "power, %"});
  std::set<std::size_t> trials{5, 8, 10, 16, 20, 30, study.design.trials};
  for (const std::size_t count : trials) {
    const DiscriminationRule rule = discriminationRule(count);
    std::vector<FigureCell> row{static_cast<double>(count)};
    row.emplace_back(rule.mostErrors ? FigureCell{static_cast<double>(*rule.mostErrors)} : FigureCell{});
    for (const double share : shares)
      row.emplace_back(rule.mostErrors ? planPercent * atMost({*rule.mostErrors, count}, 1 - share) : 0.0);
    power.rows.push_back(std::move(row));
  }
  return power;
}

/// Adds a row per number of people, with a column per difference.
FigureTable byPeople(FigureTable power, const std::vector<DrawDifference>& differences, double atLevel) {
  for (const std::size_t people : peopleCounts) {
    std::vector<FigureCell> row{static_cast<double>(people)};
    for (const DrawDifference& draw : differences)
      row.emplace_back(planPercent * signFlipPower(people, draw, atLevel));
    power.rows.push_back(std::move(row));
  }
  return power;
}

std::string comparedAt(std::size_t comparisons) {
  if (comparisons <= 1) return "p at most 0.05";
  return "p at most 0.05 / " + std::to_string(comparisons) + ", as Holm asks of the first of " +
         std::to_string(comparisons) + " comparisons";
}

constexpr std::array<double, 5> errorDifferences{0.05, 0.1, 0.15, 0.2, 0.3};
constexpr const char* errorAssumptions =
    "the median person errs in 10 % of trials in one, and so much more in the other; the log odds of an "
    "error vary "
    "over people by 0.5 (standard deviation), those of the difference by 0.25.";

DrawDifference errorsOf(std::size_t trials, double difference) {
  const ErrorRates rates{trials, 0.1, difference};
  return [rates](StudyRandom& random) { return drawErrorDifference(rates, random); };
}

std::size_t comparisonsOf(const Study& study) {
  const std::size_t modes = std::max<std::size_t>(study.design.modes.size(), 2);
  return modes * (modes - 1) / 2;
}

void addPower(FigureTable& power, const std::string& description) {
  for (const double difference : errorDifferences) {
    const std::string points = std::to_string(std::lround(planPercent * difference));
    power.columns.push_back({"more_" + points, "+" + points + " points", 0, description});
  }
}

/// Two conditions of the same people: modes, or another factor that the researcher varies.
FigureTable twoConditions(const Study& study) {
  const std::size_t trials = countedTrials(study) / study.design.modes.size();
  FigureTable power = table("two_conditions", "Two conditions with the same people differ, % of times",
                            "By simulation of the report's test, sign flips of whole persons, " +
                                comparedAt(comparisonsOf(study)) + "; " + std::to_string(trials) +
                                " trials in each condition; " + errorAssumptions +
                                " Simulation error: 1 point. Fewer than six people can never find anything.",
                            {{"people", "people", 0, "who are in both"}});
  addPower(power, "power, %");
  std::vector<DrawDifference> draws;
  for (const double difference : errorDifferences) draws.push_back(errorsOf(trials, difference));
  return byPeople(std::move(power), draws, level / static_cast<double>(comparisonsOf(study)));
}

/// The smallest of the given numbers of people that finds a difference in 80 of 100 studies; nothing if even
/// the largest does not.
FigureCell peopleFor(const DrawDifference& draw, double atLevel) {
  constexpr double wanted = 0.8;
  // few, because there are twenty cells and a result of the neighbouring row does no harm
  constexpr std::size_t studies = 1000;
  for (const std::size_t people : peopleCounts)
    if (signFlipPower(people, draw, atLevel, studies) >= wanted) return static_cast<double>(people);
  return {};
}

FigureTable peopleNeeded(const Study& study) {
  const std::size_t cells = countedTrials(study) / study.design.modes.size() / study.design.trials;
  FigureTable needed = table("people_needed", "People needed to find such a difference in 80 of 100 studies",
                             "As above, by trials for each pair (or button) and mode; -: more than " +
                                 std::to_string(peopleCounts.back()) + ".",
                             {{"trials", "trials", 0, "for each pair (or button) and mode"}});
  addPower(needed, "people");
  for (const std::size_t trials : std::set<std::size_t>{5, 10, 20, study.design.trials}) {
    std::vector<FigureCell> row{static_cast<double>(trials)};
    for (const double difference : errorDifferences)
      row.push_back(
          peopleFor(errorsOf(cells * trials, difference), level / static_cast<double>(comparisonsOf(study))));
    needed.rows.push_back(std::move(row));
  }
  return needed;
}

/// Normally distributed differences between people, in hundredths of their standard deviation.
DrawDifference normalAround(double standardDeviations) {
  return [=](StudyRandom& random) {
    constexpr double steps =
        20;  // in twentieths of a standard deviation; finer steps do not change the printed values
    return static_cast<int>(std::lround(steps * (standardDeviations + drawNormal(random))));
  };
}

/// Power for comparing two buttons on a rating scale, or two thresholds.
FigureTable twoMeans(const std::string& title, const std::string& unit, const std::vector<double>& values,
                     const std::function<double(double)>& inDeviations, const std::string& assumed,
                     std::size_t comparisons) {
  FigureTable power = table("two_means", title,
                            "By simulation of the report's test, sign flips of whole persons, " +
                                comparedAt(comparisons) + "; " + assumed + " Simulation error: 1 point.",
                            {{"people", "people", 0, "who answer for both"}});
  std::vector<DrawDifference> draws;
  for (const double value : values) {
    char name[32];
    std::snprintf(name, sizeof name, "%g", value);
    power.columns.push_back({std::string("difference_") + name, name + unit, 0, "power, %"});
    draws.push_back(normalAround(inDeviations(value)));
  }
  return byPeople(std::move(power), draws,
                  level / static_cast<double>(std::max<std::size_t>(comparisons, 1)));
}

FigureTable pairwisePower(const Study& study, std::size_t comparisons) {
  constexpr std::array<double, 5> shares{0.6, 0.7, 0.75, 0.8, 0.9};
  FigureTable power = table(
      "preferred", "One of two buttons is preferred, % of times",
      "By simulation, sign flips of whole persons, " + comparedAt(comparisons) + "; " +
          std::to_string(study.design.trials) +
          " choices of each person, the share of the median person; its log odds vary over people by 0.5. "
          "Simulation error: 1 point.",
      {{"people", "people", 0, "who choose"}});
  std::vector<DrawDifference> draws;
  const std::size_t trials = study.design.trials;
  for (const double share : shares) {
    const std::string words = std::to_string(std::lround(planPercent * share));
    power.columns.push_back({"share_" + words, words + " % of choices", 0, "power, %"});
    draws.emplace_back([=](StudyRandom& random) {
      constexpr double spread = 0.5;
      const double odds = std::log(share / (1 - share)) + spread * drawNormal(random);
      int wins = 0;
      for (std::size_t i = 0; i < trials; ++i) wins += drawShare(random) < 1 / (1 + std::exp(-odds)) ? 1 : 0;
      return 2 * wins - static_cast<int>(trials);
    });
  }
  return byPeople(std::move(power), draws,
                  level / static_cast<double>(std::max<std::size_t>(comparisons, 1)));
}

std::vector<FigureTable> ratingPower(const Study& study) {
  const std::size_t buttons = study.givenButtons(), pairs = buttons * (buttons - 1) / 2;
  switch (study.design.scale) {
    case RatingScale::pairwise:
      return {pairwisePower(study, pairs)};
    case RatingScale::preference:
      return {twoMeans(
          "Two buttons differ in preference, % of times", " points", {0.5, 1, 1.5, 2, 3},
          [](double points) { return points / 1.5; },
          "persons' own differences of their mean ratings vary by 1.5 points (standard deviation).", pairs)};
    case RatingScale::magnitude:
      break;
  }
  return {twoMeans(
      "Two buttons differ in strength, % of times", " times", {1.1, 1.2, 1.35, 1.5, 2},
      [](double ratio) { return std::log(ratio) / std::log(1.35); },
      "persons' own ratios vary by a factor of 1.35 (standard deviation of the logarithm).", pairs)};
}

std::vector<FigureTable> thresholdPower() {
  return {twoMeans(
      "Two thresholds of the same people differ, % of times", " times", {1.15, 1.25, 1.4, 1.6, 2},
      [](double ratio) { return std::log(ratio) / std::log(1.4); },
      "persons' own ratios of two measured thresholds vary by a factor of 1.4 (standard deviation of the "
      "logarithm), of which 60 trials each cause some 1.2.",
      1)};
}

/// Precision of a laboratory's two figures: half the width of their 95 % intervals over people, for numbers
/// of `people` and `trials`.
FigureTable timingPrecision(const Study& study) {
  const StudyDesign& d = study.design;
  // Spread between people, and of one press: typical of practised people (Lee & Oulasvirta, CHI 2016;
  // docs/reference/press-forecast.md).
  constexpr double spread = 0.09, spreadVaries = 0.25, tapsOfRun = 50;
  const bool tapping = d.task == TimingTask::tapping, window = d.task == TimingTask::window;
  const double placeVaries = tapping ? 0.12 : window ? 0.08 : 0.02;
  FigureTable table{"precision",
                    "Half the width of the 95 % intervals over people",
                    std::string("By the normal law: persons' own places vary by ") +
                        (tapping  ? "12 % of the time between presses"
                         : window ? "0.08 of the window"
                                  : "0.02 of the interval") +
                        " (standard deviation), their spreads by a quarter about 0.09 of the interval" +
                        (tapping ? "; a run has some 50 presses." : "."),
                    {{"people", "people", 0, "who press"},
                     {"trials", tapping ? "runs" : "trials", 0, "of each person with a button"},
                     {"place_half_percent",
                      tapping  ? "time between, %"
                      : window ? "aim, % of window"
                               : "behind cue, %",
                      1, "half the interval's width"},
                     {"spread_half_percent", "spread, % of itself", 1, "half the interval's width"}},
                    {}};
  const double window_s =
      std::accumulate(d.windows_s.begin(), d.windows_s.end(), 0.0) / static_cast<double>(d.windows_s.size());
  const double interval_s = std::accumulate(d.intervals_s.begin(), d.intervals_s.end(), 0.0) /
                            static_cast<double>(d.intervals_s.size());
  const double ofOne = window ? spread * interval_s / window_s : spread;
  for (const std::size_t people : peopleCounts) {
    for (const std::size_t trials :
         std::set<std::size_t>{std::max<std::size_t>(d.trials / 2, 1), d.trials, 2 * d.trials}) {
      const double presses = static_cast<double>(trials) * (tapping ? tapsOfRun : 1);
      if (presses < static_cast<double>(leastPresses)) continue;
      const double students = studentQuantile(0.975, people - 1) / std::sqrt(static_cast<double>(people));
      table.rows.push_back({static_cast<double>(people), static_cast<double>(trials),
                            planPercent * students * std::hypot(placeVaries, ofOne / std::sqrt(presses)),
                            planPercent * students * std::hypot(spreadVaries, 1 / std::sqrt(2 * presses))});
    }
  }
  return table;
}

std::vector<FigureTable> timingPower(const Study& study) {
  const std::size_t buttons = study.givenButtons();
  std::vector<FigureTable> tables{timingPrecision(study)};
  if (buttons < 2) return tables;
  tables.push_back(twoMeans(
      "The spreads with two buttons differ, % of times", " times", {1.1, 1.2, 1.3, 1.5, 2},
      [](double ratio) { return std::log(ratio) / std::log(1.25); },
      "persons' own ratios of two spreads vary by a factor of 1.25 (standard deviation of the logarithm), of "
      "which 60 "
      "presses each cause some 1.14.",
      buttons * (buttons - 1)));
  return tables;
}

// ---- the page

std::string section(const std::string& title, const std::string& markup) {
  return "<section><h2>" + title + "</h2>\n" + markup + "</section>\n";
}

std::string paragraph(const std::string& words) { return "<p>" + escapedForMarkup(words) + "</p>\n"; }
std::string blank(const std::string& words) {
  return "<p class=\"blank\">" + escapedForMarkup(words) + ": " + std::string(60, '.') + "</p>\n";
}
std::string list(const std::vector<std::string>& items) {
  std::string text = "<ul>\n";
  for (const std::string& item : items) text += "<li>" + escapedForMarkup(item) + "</li>\n";
  return text + "</ul>\n";
}

std::string modesOf(const Study& study) {
  std::string words;
  for (const FeedbackMode mode : study.design.modes)
    words += (words.empty() ? "" : ", ") + std::string(nameOf(mode));
  return words;
}

std::string listed(const std::vector<double>& values) {
  std::string words;
  for (const double value : values) words += (words.empty() ? "" : ", ") + shortestText(value);
  return words;
}

std::string timingTaskOf(const StudyDesign& d) {
  switch (d.task) {
    case TimingTask::cue:
      return "Timing, press with a cue: four beats an interval apart, the last is the cue; intervals of " +
             listed(d.intervals_s) + " s.";
    case TimingTask::window:
      return "Timing, hit a moving target in its window: it sets out an interval before; intervals of " +
             listed(d.intervals_s) + " s, windows of " + listed(d.windows_s) + " s.";
    case TimingTask::tapping:
      break;
  }
  return "Timing, press as fast as can be kept up: runs of " + shortestText(d.run_s) +
         " s from the first press on.";
}

std::string taskOf(const Study& study) {
  const StudyDesign& d = study.design;
  switch (d.kind) {
    case StudyKind::abx:
      return "ABX: two buttons α and β and X, which is one of them; the participant feels each as often as "
             "wanted and says which one X is.";
    case StudyKind::sameDifferent:
      return "Same or different: two stimuli, in half of the trials one button twice; the participant feels "
             "each as often as wanted and says whether they are the same.";
    case StudyKind::matching:
      return std::string("Matching: X is one of all buttons") +
             (d.targets == TargetKind::physicalButton ? ", the real switch handed over by number" : "") +
             "; the participant says which.";
    case StudyKind::threshold:
      return std::string("Threshold of \"") + nameOf(d.quantity) +
             "\": two buttons, one of which has more of it; the participant says which. The differences "
             "follow "
             "the answers (QUEST+).";
    case StudyKind::timing:
      return timingTaskOf(d);
    case StudyKind::rating:
      break;
  }
  return std::string("Rating, \"") + nameOf(d.scale) + "\".";
}

std::vector<std::string> hypotheses(const Study& study) {
  const StudyDesign& d = study.design;
  std::vector<std::string> all;
  if (asksForX(d.kind) || d.kind == StudyKind::sameDifferent)
    all.push_back("For each pair, participants tell the buttons apart: fewer errors than by guessing.");
  if (d.kind == StudyKind::threshold)
    all.push_back("The threshold of each button lies below ... %, or differs between ... and ...");
  if (d.kind == StudyKind::rating) all.push_back("Buttons differ in what is rated, pair by pair.");
  if (d.kind == StudyKind::timing)
    all.push_back("Buttons differ in where (or how fast) and how exactly they are pressed, pair by pair.");
  if (d.modes.size() > 1)
    all.push_back("The error rate (or rating, or timing) differs between the modes " + modesOf(study) +
                  ", two-sided.");
  return all;
}

std::vector<std::string> analysis(const Study& study) {
  const StudyDesign& d = study.design;
  std::vector<std::string> all;
  if (d.kind == StudyKind::threshold) {
    all.push_back(
        "Per participant and button: median and 95 % credible interval of the difference told in 75 of "
        "100, by QUEST+'s belief; prior and ranges as in Detent's docs/guide/studies.md.");
    all.push_back("Over participants: geometric mean with Student's 95 % interval of the logarithm.");
    return all;
  }
  if (d.kind == StudyKind::sameDifferent) {
    all.push_back(
        "Per pair: hits (\"different\" to two buttons) and false alarms (to one twice), exact p of so many "
        "hits "
        "if nobody tells them apart, whatever each person's bias; Holm over the pairs. d' by differencing "
        "with "
        "its likelihood interval, and by independent observations.");
    return all;
  }
  if (d.kind == StudyKind::timing) {
    all.push_back(
        "Per participant and button: place and spread of the presses, a drift over the trials and a share of "
        "presses "
        "that belong to nothing fitted and kept out; from 10 presses on.");
    all.push_back(
        "Over participants: mean place, geometric mean of the spreads, with Student's 95 % intervals.");
    all.push_back("Then each two buttons, signs of whole persons flipped, Holm over pairs and both figures.");
    return all;
  }
  if (d.kind == StudyKind::rating) {
    all.push_back(
        d.scale == RatingScale::pairwise
            ? "Bradley–Terry scores with sandwich intervals over persons; then each two buttons, signs of "
              "whole persons flipped, Holm over the pairs."
            : "Mean over participants with Student's 95 % interval (magnitudes: of logarithms, each "
              "person's moved to the mean of all); then each two buttons, signs of whole persons flipped, "
              "Holm over the pairs.");
    if (d.scale == RatingScale::preference)
      all.push_back(
          "Secondary: the same by order alone, how often a person's rating of the first is higher.");
    return all;
  }
  const DiscriminationRule rule = discriminationRule(d.trials);
  if (d.kind == StudyKind::abx && rule.mostErrors) {
    char words[160];
    std::snprintf(words, sizeof words,
                  "A participant tells a pair apart with at most %zu errors in %zu trials (exact p = %.4f by "
                  "guessing); Holm over the participant's pairs and modes.",
                  *rule.mostErrors, d.trials, rule.p);
    all.emplace_back(words);
  }
  all.push_back(
      "Error rates by pair and condition with Wilson and Clopper–Pearson intervals; over participants a BCa "
      "bootstrap of whole persons with tails by Student's t (Hesterberg 2015), from six people on.");
  all.push_back(
      "Conditions with the same people: signs of whole persons flipped, exactly up to 20 people, two-sided; "
      "Holm over conditions, and over pairs and conditions. alpha = 0.05.");
  if (d.kind == StudyKind::abx) all.push_back("d' of all participants by differencing.");
  if (d.kind == StudyKind::matching)
    all.push_back(
        "Each button: share found against guessing among all, exact p, Holm over the buttons. Each pair: "
        "share "
        "taken for each other among the answers that name one of both, against one half, exact p, Holm over "
        "the pairs.");
  return all;
}

std::string stimuliTable(const Study& study) {
  FigureTable stimuli =
      table("stimuli", "Stimuli",
            "SHA-256 of the button files; each mode's sound has one of its own in study.json.",
            {{"label", "button", 0, ""}, {"name", "name", 0, ""}, {"sha256", "SHA-256", 0, ""}});
  for (std::size_t i = 0; i < study.givenButtons(); ++i)
    stimuli.rows.push_back({study.buttons[i].label, study.buttons[i].button.name(), study.buttons[i].sha256});
  return tableMarkup(stimuli);
}

std::string designSection(const Study& study, const Preregistration& plan) {
  const StudyDesign& d = study.design;
  const std::size_t questions = countedTrials(study);
  return section(
      "Design",
      paragraph(taskOf(study)) +
          list({std::string("Feel: ") + feels.word(d.feel) + " (study.json).",
                "Within participants; modes: " + modesOf(study) +
                    (d.modes.size() > 1
                         ? ", in blocks, their order counterbalanced over participants, a rest between."
                         : "."),
                std::to_string(questions) + " questions for each participant that count (" +
                    std::to_string(d.trials) + " for each " + (asksForPairs(d) ? "pair" : "button") +
                    " and mode), after " + std::to_string(d.practice) +
                    " of practice; a rest after every 50.",
                d.pairsEach > 0
                    ? std::to_string(d.pairsEach) + " pairs for each participant, shared out evenly."
                    : std::string("Every participant gets all of them."),
                std::to_string(plan.people) +
                    " participants are planned; no results are looked at before they are done."}) +
          blank("Listening condition (quiet; masked by rain), the same for all of a participant's trials") +
          blank("Who takes part, how they are found and paid, ethics approval"));
}

std::string randomisationSection(const Study& study, const Preregistration& plan) {
  std::vector<std::string> items{
      std::string("Generator: ") + generatorName + "; seed " + std::to_string(study.design.seed) +
          "; a participant's list is a function of seed, id and place alone.",
      "study.json: SHA-256 " + study.sha256 + ", made by Detent " + study.program + "."};
  if (!plan.listsSha256.empty())
    items.push_back("Lists of all planned participants, made before the first came: SHA-256 " +
                    plan.listsSha256 +
                    " over the files in order of the ids. The study keeps to them, whoever comes first.");
  else
    items.push_back("Lists are not fixed by id: places follow from who comes first.");
  if (!study.profileSha256.empty()) items.push_back("Device profile: SHA-256 " + study.profileSha256 + ".");
  return section("Randomisation and stimuli", list(items)) + stimuliTable(study);
}

std::string foretoldSection(const Study& study, const std::vector<ForetoldPair>& foretold) {
  if (foretold.empty()) return {};
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < study.givenButtons(); ++i) labels.push_back(study.buttons[i].label);
  FigureTable forecastTable = table(
      "foretold", "Foretold",
      "By Detent's model of what is felt; how far it can be believed: docs/reference/predicted-confusion.md.",
      {{"pair", "pair", 0, ""},
       {"mode", "mode", 0, ""},
       {"verdict", "foretold", 0, ""},
       {"reason", "what differs", 0, ""}});
  for (const ForetoldPair& pair : foretold)
    forecastTable.rows.push_back({pairName(labels, pair.first, pair.second), std::string(nameOf(pair.mode)),
                                  pair.verdict, pair.reason});
  return tableMarkup(forecastTable);
}

}  // namespace

std::string listCsv(const Study& study, const std::string& participant, std::size_t place) {
  const std::vector<Trial> trials = planTrials(study, participant, place);
  const std::size_t choices = mostChoices(trials);
  std::string text = "participant,trial,practice,rest_before,mode";
  for (std::size_t i = 1; i <= choices; ++i) text += ",choice_" + std::to_string(i);
  const bool timed = study.design.kind == StudyKind::timing;
  text += timed ? ",x,interval_s,window_s\n" : ",x\n";
  for (const Trial& trial : trials) {
    text += participant + "," + std::to_string(trial.number) + "," + (trial.practice ? "1," : "0,") +
            (trial.breakBefore ? "1," : "0,") + nameOf(trial.mode);
    for (const std::size_t button : feltButtons(study.design, trial))
      text += "," + csvField(study.buttons[button].label);
    text += "," + csvField(xOf(study, trial));
    if (timed) text += "," + shortestText(trial.interval_s) + "," + shortestText(trial.window_s);
    text += "\n";
  }
  return text;
}

namespace {

Result<Done> checkNobodyBegan(const Study& study) {
  std::error_code error;
  if (study.sites.empty() && (fs::is_empty(study.folder / "participants", error) || error)) return Done{};
  return Failure{FailureCode::wrongUsage, study.folder.string(), "",
                 Message("the study already has a participant, so it is too late for a plan"),
                 Message("Plan before the first participant begins, or make a new study")};
}

}  // namespace

Result<Done> writeUnfinishedRule(const Study& study, Unfinished rule) {
  if (Result<Done> ok = checkNobodyBegan(study); !ok) return ok;
  Result<PlannedPlaces> plan = placesOf(study.folder);
  if (!plan) return plan.failure();
  plan->unfinished = rule;
  return writePlaces(study.folder, *plan, study.sha256, plan->listsSha256);
}

Result<std::string> writeLists(const Study& study, const PlannedPlaces& plan, const fs::path& folder) {
  if (Result<Done> ok = checkNobodyBegan(study); !ok) return ok.failure();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return Failure{FailureCode::unreadableInput, folder.string(), "",
                   Message("the folder cannot be created (%1)", error.message()),
                   Message("Check the folder in which it should be created, and its permissions")};
  std::string all;
  for (std::size_t place = 0; place < plan.participants.size(); ++place) {
    const std::string& id = plan.participants[place];
    const std::string csv = listCsv(study, id, place);
    all += csv;
    if (Result<Done> ok = writeTextFileAtomically((folder / (id + ".csv")).string(), csv); !ok)
      return ok.failure();
  }
  const std::string sha256 = sha256Hex(all);
  if (Result<Done> ok = writePlaces(study.folder, plan, study.sha256, sha256); !ok) return ok.failure();
  return sha256;
}

std::vector<FigureTable> powerTables(const Study& study) {
  switch (study.design.kind) {
    case StudyKind::abx:
      return {oneTest(study), twoConditions(study), peopleNeeded(study)};
    case StudyKind::matching:
      return {twoConditions(study), peopleNeeded(study)};
    case StudyKind::sameDifferent:
      return {};
    case StudyKind::threshold:
      return thresholdPower();
    case StudyKind::timing:
      return timingPower(study);
    case StudyKind::rating:
      break;
  }
  return ratingPower(study);
}

std::string preregistrationPage(const Study& study, const Preregistration& plan) {
  std::string power;
  for (const FigureTable& each : plan.power) power += tableMarkup(each);
  return pageBeginning("Preregistration: " + study.name) +
         "<h1>Preregistration: " + escapedForMarkup(study.name) + "</h1>\n" +
         paragraph(std::string("Written from the plan by Detent ") + version() +
                   " before the first participant; dotted lines are for what only the researcher knows.") +
         section("Hypotheses", list(hypotheses(study)) + blank("Direction and reason, pair by pair")) +
         foretoldSection(study, plan.foretold) + designSection(study, plan) + power +
         blank("Smallest difference of interest, and the power the planned number of people has for it") +
         randomisationSection(study, plan) +
         section("What is kept",
                 list({"Each answer with its time, what was pressed how often, how deep and how hard; "
                       "sensor, calibration and sound route; the consent text's SHA-256 and time.",
                       "An answer counts only where X and what it is compared with were pressed to the "
                       "end and let go while the devices worked; else the trial begins anew and is "
                       "marked repeated."})) +
         section("Analysis", list(analysis(study))) +
         section(
             "Who is left out, and when it ends",
             list({"Nobody is left out for their answers.",
                   plan.unfinished == Unfinished::leftOut
                       ? "Whoever has not answered all trials is left out of the figures that are tested; "
                         "the report shows the figures with them as well."
                       : "Whoever has not answered all trials counts with what they answered; the report "
                         "shows the figures without them as well.",
                   "Rehearsals, simulations and practice never count.",
                   "It ends with " + std::to_string(plan.people) + " complete participants."}) +
                 blank("Other reasons to leave somebody out, fixed now")) +
         "</body></html>\n";
}

}  // namespace detent::playback
