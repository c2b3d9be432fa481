// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/study_output.h"

#include <cstdarg>
#include <cstdio>

#include <nlohmann/json.hpp>

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

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string tsvField(std::string text) {
  for (char& c : text)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  return text.empty() ? "n/a" : text;
}

/// Seconds with the microsecond as the last digit.
std::string seconds(double s) { return formatted("%.6f", s); }

std::string intervalText(const Interval& i) { return formatted("%.1f-%.1f", 100 * i.low, 100 * i.high); }

std::string table1(const StudyResults& results) {
  std::string text = "Table 1. Summary\n";
  for (const GroupResult& g : results.groups) {
    text += formatted("  %-24s %zu participant%s, avg. time %.1f min (SD %.1f)\n", g.condition.c_str(),
                      g.participantCount, g.participantCount == 1 ? "" : "s", g.meanTime_min, g.sdTime_min);
    text += formatted("  %-24s errors %zu / %zu (%.2f %%), Wilson %s, Clopper-Pearson %s, participants %s\n",
                      "", g.errors.errors, g.errors.trials, 100 * rateOf(g.errors),
                      intervalText(g.wilson).c_str(), intervalText(g.clopperPearson).c_str(),
                      g.bootstrap ? intervalText(*g.bootstrap).c_str() : "n/a");
    if (g.fails.trials > 0)
      text += formatted("  %-24s ABX tests failed %zu / %zu (%.2f %%), Wilson %s\n", "", g.fails.errors,
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
                     ". Errors by all participants (* one failed, ** more)\n" + std::string(10, ' ');
  const std::size_t n = results.labels.size();
  for (std::size_t i = 0; i + 1 < n; ++i) text += formatted("%8.7s", results.labels[i].c_str());
  text += "\n";
  for (std::size_t second = 1; second < n; ++second) {
    text += formatted("  %-8.8s", results.labels[second].c_str());
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
  std::string text =
      "  pair               errors   rate %   Wilson 95 %   d' differencing   d' independent   fails\n";
  for (const PairResult& pair : group.pairs) {
    const std::string name = results.labels[pair.first] + "-" + results.labels[pair.second];
    const char* bound = pair.sensitivity.atLeast ? ">=" : "  ";
    text += formatted("  %-16.16s %5zu/%-4zu  %5.1f   %11s   %13s%.2f   %12s%.2f   %5s\n", name.c_str(),
                      pair.errors.errors, pair.errors.trials, 100 * rateOf(pair.errors),
                      intervalText(pair.wilson).c_str(), bound, pair.sensitivity.differencing, bound,
                      pair.sensitivity.independent,
                      pair.failCount ? std::to_string(*pair.failCount).c_str() : "-");
  }
  return text;
}

std::string confusionTable(const StudyResults& results, const GroupResult& group) {
  std::string text = "Matches, " + group.condition + " (rows: X, columns: answer)\n" + std::string(10, ' ');
  for (const std::string& label : results.labels) text += formatted("%8.7s", label.c_str());
  text += "\n";
  for (std::size_t x = 0; x < group.confusion.size(); ++x) {
    text += formatted("  %-8.8s", results.labels[x].c_str());
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
    pairs.push_back({{"a", results.labels[p.first]},
                     {"b", results.labels[p.second]},
                     {"errors", p.errors.errors},
                     {"trials", p.errors.trials},
                     {"wilson", jsonOf(p.wilson)},
                     {"clopper_pearson", jsonOf(p.clopperPearson)},
                     {"d_prime_differencing", p.sensitivity.differencing},
                     {"d_prime_independent", p.sensitivity.independent},
                     {"d_prime_at_least", p.sensitivity.atLeast},
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

std::string taskName(const StudyResults& results) {
  std::string task;  // BIDS: letters and digits only
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
                 "cannot be made (" + error.message() + ")",
                 "Check the folder, its rights and the free space"};
}

std::string eventsOf(const StudyResults& results, const std::string& participant) {
  std::string text =
      "onset\tduration\ttrial_type\ttrial\tpair\talpha\tbeta\tx\tanswer\tcorrect\treplays_alpha\treplays_"
      "beta\t"
      "replays_x\tfirst_press\tcondition\n";
  for (const TrialRow& r : results.rows) {
    if (r.participant != participant) continue;
    text += seconds(r.onset_s) + "\t" + seconds(r.answer_s) + "\t" +
            (results.kind == StudyKind::abx ? "abx" : "matching") + "\t" + std::to_string(r.trial) + "\t" +
            tsvField(r.pair) + "\t" + tsvField(r.a) + "\t" + tsvField(r.b) + "\t" + tsvField(r.x) + "\t" +
            tsvField(r.answer) + "\t" + (r.correct ? "1" : "0") + "\t" + std::to_string(r.replaysA) + "\t" +
            std::to_string(r.replaysB) + "\t" + std::to_string(r.replaysX) + "\t" + seconds(r.firstPress_s) +
            "\t" + tsvField(r.condition) + "\n";
  }
  return text;
}

}  // namespace

std::string resultsCsv(const StudyResults& results) {
  std::string text =
      "study,participant,trial,pair,a,b,x,answer,correct,replays_a,replays_b,replays_x,answer_s,condition\n";
  for (const TrialRow& r : results.rows) {
    for (const std::string& field :
         {results.study, r.participant, std::to_string(r.trial), r.pair, r.a, r.b, r.x, r.answer})
      text += csvField(field) + ",";
    text += (r.correct ? "1," : "0,") + std::to_string(r.replaysA) + "," + std::to_string(r.replaysB) + "," +
            std::to_string(r.replaysX) + "," + exact(r.answer_s) + "," + csvField(r.condition) + "\n";
  }
  return text;
}

Result<Done> writeBids(const StudyResults& results, const std::filesystem::path& folder) {
  if (Result<Done> ok = makeFolder(folder); !ok) return ok;
  const std::string task = taskName(results);
  const Json dataset{{"Name", results.study},
                     {"BIDSVersion", "1.8.0"},
                     {"DatasetType", "raw"},
                     {"GeneratedBy", Json::array({{{"Name", "Detent"}, {"Version", version()}}})}};
  const Json columns{{"onset", {{"Description", "when the trial was shown"}, {"Units", "s"}}},
                     {"duration", {{"Description", "from there to the answer"}, {"Units", "s"}}},
                     {"first_press", {{"Description", "from onset to the first press"}, {"Units", "s"}}},
                     {"correct", {{"Description", "1: the answer is X"}}},
                     {"condition", {{"Description", "simulated, rehearsal: no person felt anything"}}}};
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
  std::string list = "participant_id\tstudy_id\n";
  for (const std::string& id : participants) {
    const std::string sub = "sub-" + bidsId(id);
    list.append(sub).append("\t").append(id).append("\n");
    if (Result<Done> ok = makeFolder(folder / sub / "beh"); !ok) return ok;
    const std::string name = std::string(sub).append("_task-").append(task).append("_events.tsv");
    if (Result<Done> ok =
            writeTextFileAtomically((folder / sub / "beh" / name).string(), eventsOf(results, id));
        !ok)
      return ok;
  }
  return writeTextFileAtomically((folder / "participants.tsv").string(), list);
}

std::string resultsText(const StudyResults& results) {
  std::string text = results.study + "\n";
  if (results.anySimulated) text += "SIMULATED: the program answered in place of people.\n";
  if (results.anyRehearsal) text += "REHEARSAL: there was no sound device; nothing was felt.\n";
  if (!results.source.empty()) text += results.source + "\n";
  text += "\n" + table1(results);
  for (const GroupResult& group : results.groups) {
    if (!group.pairs.empty()) text += "\n" + table2(results, group) + "\n" + pairLines(results, group);
    if (!group.confusion.empty()) text += "\n" + confusionTable(results, group);
  }
  for (const GroupComparison& c : results.comparisons)
    text += formatted("\n%s against %s: %+.2f %% errors, p = %.4f (participants permuted)\n", c.first.c_str(),
                      c.second.c_str(), 100 * c.difference, c.p);
  if (results.kind == StudyKind::abx && results.rule.mostErrors)
    text += formatted("\nCan discriminate: at most %zu error%s in %zu (p = %.4f by guessing).\n",
                      *results.rule.mostErrors, *results.rule.mostErrors == 1 ? "" : "s",
                      results.trialsPerTest, results.rule.p);
  if (!results.warnings.empty()) text += "\nTo be known:\n";
  for (const std::string& warning : results.warnings) text += "- " + warning + "\n";
  return text;
}

std::string resultsJson(const StudyResults& results) {
  Json groups = Json::array(), comparisons = Json::array();
  for (const GroupResult& g : results.groups) groups.push_back(jsonOf(results, g));
  for (const GroupComparison& c : results.comparisons)
    comparisons.push_back(
        {{"first", c.first}, {"second", c.second}, {"difference", c.difference}, {"p", c.p}});
  const Json json{{"status", "ok"},
                  {"study", results.study},
                  {"kind", nameOf(results.kind)},
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
                  {"warnings", results.warnings}};
  return jsonText(json);
}

}  // namespace detent::playback
