// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/study_output.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "model/csv_field.h"
#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/version.h"
#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  char text[512];
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string tsvField(std::string text) {
  for (char& c : text)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  return text.empty() ? "n/a" : text;
}

/// Seconds with six decimals.
std::string seconds(double s) { return formatted("%.6f", s); }

std::string intervalText(const Interval& i) { return formatted("%.1f-%.1f", 100 * i.low, 100 * i.high); }

/// Pads with blanks on the right (or left) to at least this width.
std::string left(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, widthOf(text)), ' ');
}
std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, widthOf(text)), ' ') + text;
}

std::string table1(const StudyResults& results) {
  std::string text = "Table 1. Summary\n";
  for (const GroupResult& g : results.groups) {
    text += formatted("  %-24s %zu participant%s, avg. time %.1f min (SD %.1f)\n", g.condition.c_str(),
                      g.participantCount, g.participantCount == 1 ? "" : "s", g.meanTime_min, g.sdTime_min);
    text += formatted(
        "    errors %zu / %zu (%.2f %%): Wilson %s, Clopper-Pearson %s,\n    participants resampled %s\n",
        g.errors.errors, g.errors.trials, 100 * rateOf(g.errors), intervalText(g.wilson).c_str(),
        intervalText(g.clopperPearson).c_str(), g.bootstrap ? intervalText(*g.bootstrap).c_str() : "n/a");
    if (g.fails.trials > 0)
      text += formatted("    ABX tests failed %zu / %zu (%.2f %%), Wilson %s\n", g.fails.errors,
                        g.fails.trials, 100 * rateOf(g.fails), intervalText(wilson(g.fails)).c_str());
  }
  return text;
}

const PairResult* pairOf(const GroupResult& group, std::size_t first, std::size_t second) {
  for (const PairResult& pair : group.pairs)
    if (pair.first == first && pair.second == second) return &pair;
  return nullptr;
}

std::string table2(const StudyResults& results, const GroupResult& group) {
  std::string text = "Table 2, " + group.condition +
                     "\n  errors by all participants (* one failed, ** more)\n" + std::string(10, ' ');
  const std::size_t n = results.labels.size();
  const std::vector<std::string> names = shortened(results.labels, 7);
  for (std::size_t i = 0; i + 1 < n; ++i) text += right(names[i], 8);
  text += "\n";
  for (std::size_t second = 1; second < n; ++second) {
    text += "  " + left(names[second], 8);
    for (std::size_t first = 0; first < second; ++first) {
      const PairResult* pair = pairOf(group, first, second);
      text += formatted("%8s",
                        pair == nullptr ? "" : (std::to_string(pair->errors.errors) + markOf(*pair)).c_str());
    }
    text += "\n";
  }
  return text;
}

std::string pairLines(const StudyResults& results, const GroupResult& group) {
  const std::vector<std::string> names = shortened(results.labels, 7);
  std::string text = "  pair                 errors rate %  Wilson 95 % d' differ. (low)  indep. fails\n";
  bool half = false;
  for (const PairResult& pair : group.pairs) {
    const std::string name = left(pairName(names, pair.first, pair.second), 17);
    const Sensitivity& s = pair.sensitivity;
    half |= s.noError;
    text += formatted("  %s %4zu/%-5zu %5.1f  %11s %s%7.2f (%.2f)  %6.2f %5s\n", name.c_str(),
                      pair.errors.errors, pair.errors.trials, 100 * rateOf(pair.errors),
                      intervalText(pair.wilson).c_str(), s.noError ? "~" : " ", s.differencing, s.low,
                      s.independent, pair.failCount ? std::to_string(*pair.failCount).c_str() : "-");
  }
  if (half)
    text += wrapped("~ no error was made: what half an error gives; in brackets what 97.5 % are above", "  ");
  return text;
}

std::string nameOfPair(const std::vector<std::string>& labels, std::size_t pair) {
  const auto [first, second] = pairsOf(labels.size())[pair];
  return pairName(labels, first, second);
}

std::string comparisonLines(const StudyResults& results) {
  std::string text = "Conditions against each other (p two-sided; Holm over all, then over all pairs)\n";
  const std::vector<std::string> names = shortened(results.labels, 7);
  std::string said;
  for (const GroupComparison& c : results.comparisons) {
    const std::string conditions = "  " + c.first + " - " + c.second + "\n";
    if (conditions != said) text += conditions;
    said = conditions;
    text += "  " + left(c.pair ? nameOfPair(names, *c.pair) : "all trials", 17) +
            formatted(" %+6.2f %% errors", 100 * c.difference);
    if (c.interval) text += formatted(" (%+.1f to %+.1f)", 100 * c.interval->low, 100 * c.interval->high);
    text += formatted(", p = %.4f, Holm %.4f\n", c.p, c.adjusted);
    if (!c.pair)
      text += formatted("    %s, %zu participants\n",
                        c.paired ? "the same people in both: signs of persons flipped"
                                 : "other people in each: participants permuted",
                        c.participants);
  }
  return text;
}

std::string confusionTable(const StudyResults& results, const GroupResult& group) {
  std::string text = "Matches, " + group.condition + " (rows: X, columns: answer)\n" + std::string(10, ' ');
  const std::vector<std::string> names = shortened(results.labels, 7);
  for (const std::string& name : names) text += right(name, 8);
  text += "\n";
  for (std::size_t x = 0; x < group.confusion.size(); ++x) {
    text += "  " + left(names[x], 8);
    for (const std::size_t count : group.confusion[x]) text += formatted("%8zu", count);
    text += "\n";
  }
  return text;
}

Json jsonOf(const Interval& i) { return {i.low, i.high}; }

Json jsonOf(const StudyResults& results, const GroupResult& g) {
  Json pairs = Json::array();
  for (const PairResult& p : g.pairs) {
    Json tests = Json::array();
    for (const AbxTest& t : p.tests)
      tests.push_back({{"participant", t.participant},
                       {"errors", t.errors.errors},
                       {"trials", t.errors.trials},
                       {"discriminates", t.discriminates},
                       {"p", t.p},
                       {"p_holm", t.adjusted}});
    pairs.push_back(
        {{"a", results.labels[p.first]},
         {"b", results.labels[p.second]},
         {"errors", p.errors.errors},
         {"trials", p.errors.trials},
         {"wilson", jsonOf(p.wilson)},
         {"clopper_pearson", jsonOf(p.clopperPearson)},
         {"d_prime_differencing", p.sensitivity.noError ? p.sensitivity.low : p.sensitivity.differencing},
         {"d_prime_independent",
          p.sensitivity.noError ? p.sensitivity.lowIndependent : p.sensitivity.independent},
         {"d_prime_at_least", p.sensitivity.noError},
         {"d_prime_low", p.sensitivity.low},
         {"d_prime_estimate", p.sensitivity.differencing},
         {"fails", p.failCount ? Json(*p.failCount) : Json(nullptr)},
         {"tests", tests}});
  }
  return {{"condition", g.condition},
          {"participants", g.participantCount},
          {"errors", g.errors.errors},
          {"trials", g.errors.trials},
          {"error_rate", rateOf(g.errors)},
          {"wilson", jsonOf(g.wilson)},
          {"clopper_pearson", jsonOf(g.clopperPearson)},
          {"bootstrap", g.bootstrap ? jsonOf(*g.bootstrap) : Json(nullptr)},
          {"mean_time_min", g.meanTime_min},
          {"sd_time_min", g.sdTime_min},
          {"abx_fails", g.fails.errors},
          {"abx_tests", g.fails.trials},
          {"pairs", pairs},
          {"confusion", g.confusion}};
}

/// Additional columns for one kind of study.
struct KindColumn {
  const char* name;
  const char* description;
  std::optional<double> TrialRow::*value;
};

std::vector<KindColumn> kindColumns(StudyKind kind) {
  if (kind == StudyKind::threshold)
    return {{"level", "share by which x has more of the quantity: 0.1 is a tenth", &TrialRow::level}};
  if (kind == StudyKind::rating)
    return {{"rating", "number that was given; nothing where two were compared", &TrialRow::rating}};
  if (kind == StudyKind::timing)
    return {{"interval_s", "how long before it was known when the cue would come; nothing in tapping",
             &TrialRow::interval_s},
            {"window_s", "how long the target stood; nothing but in the window task", &TrialRow::window_s},
            {"press_s",
             "press behind the cue or the window's beginning, negative before it; tapping: behind the press "
             "before",
             &TrialRow::press_s},
            {"press_within_s",
             "how late a press may have been told, estimated, the worst of the trial; a sensor: how far "
             "apart its "
             "readings were",
             &TrialRow::pressWithin_s}};
  return {};
}

/// Columns for a study with sound of presses.
std::string soundFields(const StudyResults& results, const char* between, bool names) {
  const StudySound& sound = results.sound;
  std::string text;
  if (sound.source.empty()) return text;
  for (const std::string& field :
       names ? std::vector<std::string>{"sound", "sound_level_dB", "sound_delay_ms"}
             : std::vector<std::string>{sound.source, exact(sound.level_dB), exact(sound.delay_ms)})
    text += between + field;
  return text;
}

std::string taskName(const StudyResults& results) {
  std::string task;  // for BIDS: only letters and digits
  for (const char c : results.study)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) task += c;
  return task.empty() ? "study" : task;
}

std::string bidsId(const std::string& participant) {
  std::string id;
  for (const char c : participant)
    if (c != '-' && c != '_') id += c;
  return id;
}

Result<Done> makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return Done{};
  return Failure{FailureCode::unreadableInput, folder.string(), "",
                 Message("the folder cannot be created (%1)", error.message()),
                 Message("Check the folder, its permissions and the free space")};
}

/// 1 or 0; `nothing` for kinds without a right answer.
std::string correctness(StudyKind kind, const TrialRow& row, const char* nothing) {
  return !hasRightAnswer(kind) ? nothing : row.correct ? "1" : "0";
}

std::string eventsOf(const StudyResults& results, const std::string& participant) {
  std::string text =
      "onset\tduration\ttrial_type\ttrial\tpair\talpha\tbeta\tx\tanswer\tcorrect\treplays_alpha\treplays_"
      "beta\t"
      "replays_x\tfirst_press\tcondition";
  const std::vector<KindColumn> more = kindColumns(results.kind);
  for (const KindColumn& column : more) text.append("\t").append(column.name);
  text += "\tfeel" + soundFields(results, "\t", true) + "\n";
  for (const TrialRow& r : results.rows) {
    if (r.participant != participant) continue;
    text += seconds(r.onset_s) + "\t" + seconds(r.answer_s) + "\t" + nameOf(results.kind) + "\t" +
            std::to_string(r.trial) + "\t" + tsvField(r.pair) + "\t" + tsvField(r.a) + "\t" + tsvField(r.b) +
            "\t" + tsvField(r.x) + "\t" + tsvField(r.answer) + "\t" + correctness(results.kind, r, "n/a") +
            "\t" + std::to_string(r.replaysA) + "\t" + std::to_string(r.replaysB) + "\t" +
            std::to_string(r.replaysX) + "\t" + seconds(r.firstPress_s) + "\t" + tsvField(r.condition);
    for (const KindColumn& column : more)
      text += "\t" + (r.*column.value ? exact(*(r.*column.value)) : std::string("n/a"));
    text += "\t" + tsvField(results.feel) + soundFields(results, "\t", false) + "\n";
  }
  return text;
}

}  // namespace

std::string resultsCsv(const StudyResults& results) {
  std::string text =
      "study,participant,trial,pair,a,b,x,answer,correct,replays_a,replays_b,replays_x,answer_s,condition";
  const std::vector<KindColumn> more = kindColumns(results.kind);
  for (const KindColumn& column : more) text.append(",").append(column.name);
  text += ",feel,finished,site" + soundFields(results, ",", true) + "\n";
  for (const TrialRow& r : results.rows) {
    for (const std::string& field :
         {results.study, r.participant, std::to_string(r.trial), r.pair, r.a, r.b, r.x, r.answer})
      text += csvField(field) + ",";
    text += correctness(results.kind, r, "") + "," + std::to_string(r.replaysA) + "," +
            std::to_string(r.replaysB) + "," + std::to_string(r.replaysX) + "," + exact(r.answer_s) + "," +
            csvField(r.condition);
    for (const KindColumn& column : more)
      text += "," + (r.*column.value ? exact(*(r.*column.value)) : std::string());
    text += "," + results.feel + (r.finished ? ",1," : ",0,") + csvField(r.site);
    text += soundFields(results, ",", false) + "\n";
  }
  return text;
}

std::string feltCsv(const StudyResults& results) {
  std::string text = "study,participant,trial,stimulus,button,presses,whole,peak_N,travel_mm,condition\n";
  for (const TrialRow& r : results.rows) {
    for (std::size_t i = 0; i < r.felt.size(); ++i) {
      const bool x = i == r.choices.size();
      const Felt& felt = r.felt[i];
      for (const std::string& field : {results.study, r.participant, std::to_string(r.trial),
                                       x ? std::string("x") : std::to_string(i + 1), x ? r.x : r.choices[i],
                                       std::to_string(felt.presses), std::to_string(felt.whole),
                                       exact(felt.peak_N), exact(felt.travel_mm)})
        text += csvField(field) + ",";
      text += csvField(r.condition) + "\n";
    }
  }
  return text;
}

namespace {

std::string bidsReadme(const StudyResults& results) {
  std::string text = results.study + ": answers of people who felt virtual buttons (" + nameOf(results.kind) +
                     "), written by Detent.\n\nButtons: ";
  for (std::size_t i = 0; i < results.labels.size(); ++i) text += (i > 0 ? ", " : "") + results.labels[i];
  text += ".\nFeel: " + results.feel + ".\n";
  if (results.anySimulated) text += "\nSIMULATED: the program answered in place of people.\n";
  if (results.anyRehearsal) text += "\nREHEARSAL: there was no sound device; nothing was felt.\n";
  for (const std::string& warning : results.warnings) text += "\n" + wrapped(warning, "- ");
  return text +
         "\nTo be added by those who publish it: authors (dataset_description.json), who took part, "
         "ethics.\n";
}

}  // namespace

Result<Done> writeBids(const StudyResults& results, const std::filesystem::path& folder) {
  if (Result<Done> ok = makeFolder(folder); !ok) return ok;
  const std::string task = taskName(results);
  const Json dataset{
      {"Name", results.study},
      {"BIDSVersion", "1.8.0"},
      {"DatasetType", "raw"},
      {"Authors", Json::array({"(first author, to be named)", "(second author, to be named)"})},
      {"GeneratedBy", Json::array({{{"Name", "Detent"}, {"Version", version()}}})}};
  Json columns{{"onset", {{"Description", "when the trial was shown"}, {"Units", "s"}}},
               {"duration", {{"Description", "from there to the answer"}, {"Units", "s"}}},
               {"first_press", {{"Description", "from onset to the first press"}, {"Units", "s"}}},
               {"correct", {{"Description", "1: the answer is X"}}},
               {"condition", {{"Description", "simulated, rehearsal: no person felt anything"}}},
               {"feel", {{"Description", "how slopes, jumps and bottom-out were played: Detent's --feel"}}}};
  for (const auto& [column, words] :
       {std::pair{"trial_type",
                  "kind of question: abx, same-different, matching, threshold, rating or timing"},
        {"trial", "number within the participant, from 1, practice not counted"},
        {"pair", "the two buttons compared; matching: the button X was; else: the button asked about"},
        {"alpha", "button offered first; n/a in matching and scales"},
        {"beta", "button offered second; n/a in matching and scales"},
        {"x",
         "button that X was; threshold: the one that has more; same or different; n/a in rating and timing"},
        {"answer",
         "button that was said to be X, or to have more, or preferred, or rated, or pressed; same or "
         "different"},
        {"replays_alpha", "times alpha was asked for; matching: all choices together"},
        {"replays_beta", "times beta was asked for"},
        {"replays_x", "times X was asked for"}})
    columns[column] = {{"Description", words}};
  if (!results.sound.source.empty())
    for (const auto& [column, words] :
         {std::pair{"sound", "what was heard of each press: a file of the study, or rendered, the vibration"},
          {"sound_level_dB", "added to it"},
          {"sound_delay_ms", "after the click that was felt"}})
      columns[column] = {{"Description", words}};
  for (const KindColumn& column : kindColumns(results.kind))
    columns[column.name] = {{"Description", column.description}};
  const Json people{{"study_id", {{"Description", "the participant's id in the study"}}},
                    {"site", {{"Description", "laboratory, of studies that were merged"}}},
                    {"finished", {{"Description", "1: all trials were answered"}}}};
  if (Result<Done> ok = writeTextFileAtomically((folder / "README").string(), bidsReadme(results)); !ok)
    return ok;
  if (Result<Done> ok =
          writeTextFileAtomically((folder / "participants.json").string(), jsonText(people, 2) + "\n");
      !ok)
    return ok;
  if (Result<Done> ok = writeTextFileAtomically((folder / "dataset_description.json").string(),
                                                jsonText(dataset, 2) + "\n");
      !ok)
    return ok;
  if (Result<Done> ok = writeTextFileAtomically((folder / ("task-" + task + "_events.json")).string(),
                                                jsonText(columns, 2) + "\n");
      !ok)
    return ok;
  std::vector<std::string> participants;
  for (const TrialRow& r : results.rows)
    if (participants.empty() || participants.back() != r.participant) participants.push_back(r.participant);
  std::string list = "participant_id\tstudy_id\tsite\tfinished\n";
  for (const std::string& id : participants) {
    const std::string sub = "sub-" + bidsId(id);
    const TrialRow& any = *std::find_if(results.rows.begin(), results.rows.end(),
                                        [&](const TrialRow& r) { return r.participant == id; });
    list.append(sub).append("\t").append(id).append("\t").append(tsvField(any.site));
    list += any.finished ? "\t1\n" : "\t0\n";
    if (Result<Done> ok = makeFolder(folder / sub / "beh"); !ok) return ok;
    const std::string name = std::string(sub).append("_task-").append(task).append("_events.tsv");
    if (Result<Done> ok =
            writeTextFileAtomically((folder / sub / "beh" / name).string(), eventsOf(results, id));
        !ok)
      return ok;
  }
  return writeTextFileAtomically((folder / "participants.tsv").string(), list);
}

StudyResults otherwise(const StudyResults& results) {
  StudyResults other = results;
  other.groups = results.otherGroups;
  other.tables = results.otherTables;
  return other;
}

std::string otherwiseTitle(const StudyResults& results) {
  return results.unfinishedLeftOut ? "With those who did not finish" : "Without those who did not finish";
}

std::string resultsText(const StudyResults& results) {
  std::string text = results.study + "\n";
  if (results.anySimulated) text += "SIMULATED: the program answered in place of people.\n";
  if (results.anyRehearsal) text += "REHEARSAL: there was no sound device; nothing was felt.\n";
  if (!results.source.empty()) text += wrapped(results.source, "");
  if (!results.feel.empty()) text += "Feel: " + results.feel + "\n";
  if (const StudySound& sound = results.sound; !sound.source.empty())
    text += "Sound of presses: " + sound.source + ", " + exact(sound.level_dB) + " dB, " +
            exact(sound.delay_ms) + " ms after the click\n";
  if (!results.groups.empty()) text += "\n" + table1(results);
  for (const FigureTable& table : results.tables) text += "\n" + tableText(table);
  for (const GroupResult& group : results.groups) {
    if (!group.pairs.empty()) text += "\n" + table2(results, group) + "\n" + pairLines(results, group);
    if (!group.confusion.empty()) text += "\n" + confusionTable(results, group);
  }
  if (!results.comparisons.empty()) text += "\n" + comparisonLines(results);
  if (const StudyResults other = otherwise(results); !other.groups.empty() || !other.tables.empty()) {
    text += "\n" + otherwiseTitle(results) + "\n";
    if (!other.groups.empty()) text += table1(other);
    for (const FigureTable& table : other.tables) text += "\n" + tableText(table);
  }
  if (results.kind == StudyKind::abx && results.rule.mostErrors)
    text += formatted("\nCan discriminate: at most %zu error%s in %zu (p = %.4f by guessing).\n",
                      *results.rule.mostErrors, *results.rule.mostErrors == 1 ? "" : "s",
                      results.trialsPerTest, results.rule.p);
  if (!results.warnings.empty()) text += "\nTo be known:\n";
  for (const std::string& warning : results.warnings) text += wrapped(warning, "- ");
  return text;
}

std::string resultsJson(const StudyResults& results) {
  Json groups = Json::array(), comparisons = Json::array(), tables = Json::array();
  for (const FigureTable& table : results.tables) tables.push_back(Json::parse(tableJson(table)));
  for (const GroupResult& g : results.groups) groups.push_back(jsonOf(results, g));
  Json otherGroups = Json::array(), otherTables = Json::array();
  for (const FigureTable& table : results.otherTables) otherTables.push_back(Json::parse(tableJson(table)));
  for (const GroupResult& g : results.otherGroups) otherGroups.push_back(jsonOf(results, g));
  for (const GroupComparison& c : results.comparisons)
    comparisons.push_back({{"first", c.first},
                           {"second", c.second},
                           {"pair", c.pair ? Json(nameOfPair(results.labels, *c.pair)) : Json(nullptr)},
                           {"paired", c.paired},
                           {"participants", c.participants},
                           {"difference", c.difference},
                           {"interval", c.interval ? jsonOf(*c.interval) : Json(nullptr)},
                           {"p", c.p},
                           {"p_holm", c.adjusted}});
  return jsonText(
      Json{{"status", "ok"},
           {"study", results.study},
           {"kind", nameOf(results.kind)},
           {"feel", results.feel.empty() ? Json(nullptr) : Json(results.feel)},
           {"simulated", results.anySimulated},
           {"rehearsal", results.anyRehearsal},
           {"labels", results.labels},
           {"names", results.names},
           {"trials", results.rows.size()},
           {"rule",
            {{"most_errors", results.rule.mostErrors ? Json(*results.rule.mostErrors) : Json(nullptr)},
             {"trials", results.trialsPerTest},
             {"p", results.rule.p}}},
           {"groups", groups},
           {"comparisons", comparisons},
           {"tables", tables},
           {"unfinished_left_out", results.unfinishedLeftOut},
           {"other_groups", otherGroups},
           {"other_tables", otherTables},
           {"warnings", results.warnings}});
}

}  // namespace detent::playback
