// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/run.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <new>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "importer/all_graphs.h"
#include "importer/overlay/encode_png.h"
#include "importer/overlay/overlay.h"
#include "importer/program/batch_report.h"
#include "importer/program/family.h"
#include "importer/program/forced_end.h"
#include "importer/program/progress_json.h"
#include "importer/program/progress_line.h"
#include "importer/program/report_json.h"
#include "importer/program/staged_outputs.h"
#include "importer/program/steps_json.h"
#include "model/file/button_file.h"
#include "model/file/curve_csv.h"
#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/program/command_line.h"

namespace detent::importer {
namespace {

namespace fs = std::filesystem;

constexpr int interruptedExitCode = static_cast<int>(FailureCode::cancelled);

/// Output files of one import; an empty path is not written.
struct OutputPaths {
  std::string button, csv, trace, overlay, steps;
};

/// "plot.button.json" -> "plot-p2-g1.button.json": one name per graph.
std::string withGraphNumber(const std::string& path, int page, int graph) {
  if (path.empty()) return path;
  const fs::path whole(path);
  const std::string name = whole.filename().string();
  const std::size_t dot = name.find('.', 1);
  const std::string tag = "-p" + std::to_string(page) + "-g" + std::to_string(graph);
  const std::string tagged =
      dot == std::string::npos ? name + tag : name.substr(0, dot) + tag + name.substr(dot);
  return (whole.parent_path() / tagged).string();
}

OutputPaths numbered(const OutputPaths& paths, int page, int graph) {
  return {withGraphNumber(paths.button, page, graph), withGraphNumber(paths.csv, page, graph),
          withGraphNumber(paths.trace, page, graph), withGraphNumber(paths.overlay, page, graph),
          withGraphNumber(paths.steps, page, graph)};
}

Result<std::vector<std::string>> writeOutputs(const ImportReport& report, const OutputPaths& paths) {
  StagedOutputs outputs;
  const auto stage = [&](const std::string& path, const auto& bytes) -> Result<Done> {
    if (path.empty()) return Done{};
    return outputs.stage(path, bytes());
  };
  const ForceGraph& graph = report.button.states().front().graph;
  if (auto done = stage(paths.button, [&] { return jsonFrom(report.button); }); !done) return done.failure();
  if (auto done = stage(paths.csv, [&] { return csvFrom(graph); }); !done) return done.failure();
  if (auto done = stage(paths.trace, [&] { return traceCsv(report.strokes); }); !done) return done.failure();
  const auto overlay = [&] { return pngBytes(drawOverlay(*report.evidence, report.strokes, report.button)); };
  if (report.evidence)
    if (auto done = stage(paths.overlay, overlay); !done) return done.failure();
  if (auto done = outputs.commit(); !done) return done.failure();
  return outputs.paths();
}

/// Writes the overlay of a refused import, which shows what was found and what was left over. Returns a line
/// that says so.
std::string writeRefusal(const GraphEvidence& evidence, const Failure& why, const OutputPaths& paths) {
  if (paths.overlay.empty() || why.code != FailureCode::notCertain) return {};
  StagedOutputs outputs;
  auto done = outputs.stage(paths.overlay, pngBytes(drawOverlay(evidence)));
  if (done) done = outputs.commit();
  return done ? "wrote " + paths.overlay + ", where the import was refused\n"
              : done.failure().sentence() + "\n";
}

/// Writes what each step found, even for a refused import.
Result<Done> writeSteps(const ImportAttempt& attempt, const std::string& input, const std::string& path) {
  return path.empty() ? Done{} : writeTextFileAtomically(path, stepsJson(attempt, input));
}

std::string warningLines(const std::vector<Remark>& remarks) {
  std::string lines;
  for (const Remark& remark : remarks) lines += "warning: " + commandLineWords(remark) + "\n";
  return lines;
}

/// Report of an input: one JSON object per graph.
struct Reported {
  std::vector<std::string> objects = {};  ///< JSON, one for each graph
  std::string text = {};
  bool written = true;                    ///< false: an output could not be written
  std::optional<Question> question = {};  ///< question about the last graph
  bool explains = false;                  ///< include the evidence of readings
};

std::string choiceLines(const std::optional<Question>& question) {
  std::string lines;
  if (!question) return lines;
  for (const Choice& choice : question->choices) lines += "  " + choice.option + "  (" + choice.text + ")\n";
  return lines;
}

/// Asks the question on the terminal. nullopt if the answer is none of its numbers.
std::optional<Choice> answerTo(const Question& question) {
  std::fprintf(stderr, "%s?\n", question.what.c_str());
  for (std::size_t i = 0; i < question.choices.size(); ++i)
    std::fprintf(stderr, "  %zu  %s\n", i + 1, question.choices[i].text.c_str());
  std::size_t number = 0;
  if (!(std::cin >> number) || number < 1 || number > question.choices.size()) return {};
  return question.choices[number - 1];
}

/// Writes the outputs of an attempt, and adds one JSON object to `reported`. Returns the exit code.
int reportAttempt(const ImportAttempt& attempt, const ImportRequest& request, const OutputPaths& paths,
                  Reported& reported) {
  const auto& [report, evidence, question, interpretations] = attempt;
  reported.question = question;
  const auto explained = reported.explains ? interpretations : std::vector<ExplainedInterpretation>{};
  const Result<Done> steps = writeSteps(attempt, request.path, paths.steps);
  Result<std::vector<std::string>> written = std::vector<std::string>{};
  if (!steps) written = steps.failure();
  if (report && steps) written = writeOutputs(*report, paths);
  if (!report || !written) {
    const Failure& failure = report ? written.failure() : report.failure();
    reported.objects.push_back(failureJson(failure, request.path,
                                           evidence ? evidence->switches : std::vector<PlotSwitch>{},
                                           question, explained));
    reported.text += failure.sentence() + "\n" + choiceLines(question) + explanationTable(explained);
    reported.written = reported.written && written;
    if (!report && !written) reported.text += written.failure().sentence() + "\n";
    if (!report && evidence) reported.text += writeRefusal(*evidence, failure, paths);
    return failure.exitCode();
  }
  reported.objects.push_back(reportJson(*report, request.path, *written, explained));
  reported.text += report->brief() + "\n";
  reported.text += warningLines(report->remarks);
  if (!paths.overlay.empty() && !report->evidence)
    reported.text +=
        "warning: " + paths.overlay + " is not written, because a table has no page to draw on\n";
  for (const std::string& path : *written) reported.text += "wrote " + path + "\n";
  reported.text += explanationTable(explained);
  return 0;
}

/// Imports every graph of an input. The exit code is 0 if all succeeded, else that of the first failure.
int importAll(const ImportRequest& request, const OutputPaths& paths, const Progress& progress,
              Reported& reported) {
  int exitCode = 0;
  const auto remarks = attemptAllGraphs(
      request, progress, [&](const ImportAttempt& attempt, const ImportRequest& one, std::size_t graphs) {
        const int code = reportAttempt(attempt, one,
                                       graphs > 1 ? numbered(paths, *one.page, *one.graph) : paths, reported);
        if (exitCode == 0) exitCode = code;
      });
  if (!remarks) {
    reported.objects.push_back(failureJson(remarks.failure(), request.path));
    reported.text += remarks.failure().sentence() + "\n";
    return remarks.failure().exitCode();
  }
  reported.text.insert(0, warningLines(*remarks));
  return exitCode;
}

/// Words of the progress line for a step.
const char* inProgress(ImportStep step) {
  switch (step) {
    case ImportStep::read:
      return "reading the log";
    case ImportStep::locate:
    case ImportStep::view:
    case ImportStep::axes:
    case ImportStep::texts:
    case ImportStep::copies:
      return "finding graphs and reading axes";
    case ImportStep::trace:
      return "tracing curves";
    case ImportStep::strokes:
      return "telling press from release";
    case ImportStep::refine:
      return "refining the axes";
    case ImportStep::fit:
    case ImportStep::callouts:
      return "fitting";
  }
  return "";
}

/// Joined by `separator`.
std::string joined(const std::vector<std::string>& objects, const char* separator) {
  std::string text;
  for (const std::string& object : objects) text += (text.empty() ? "" : separator) + object;
  return text;
}

void print(const Arguments& a, const std::string& json, const std::string& text, int exitCode) {
  if (a.json) std::fputs(json.c_str(), stdout);
  std::fputs(text.c_str(), a.json || exitCode != 0 ? stderr : stdout);
}

int runImport(const Arguments& a, const Progress& progress) {
  ImportRequest request = a.request;
  request.path = a.inputs.front(), request.asks = true;
  if (a.timeLimit_s) request.timeLimit.emplace(*a.timeLimit_s);
  const OutputPaths paths{a.buttonPath, a.csvPath, a.tracePath, a.overlayPath, a.stepsPath};
  Reported reported{.explains = a.explain};
  int exitCode = 0;
  if (a.family) {
    const Result<Family> family = importFamily(a.inputs, request, progress);
    Result<Done> written = Done{};
    if (family && !a.buttonPath.empty()) written = writeButtonFile(a.buttonPath, family->button);
    if (family && written) {
      print(a, familyJson(*family, a.buttonPath) + "\n", familyText(*family, a.buttonPath), 0);
      return 0;
    }
    const Failure& failure = family ? written.failure() : family.failure();
    print(a, failureJson(failure, a.inputs.front()) + "\n", failure.sentence() + "\n", failure.exitCode());
    return failure.exitCode();
  }
  if (a.all) {
    exitCode = importAll(request, paths, progress, reported);
    print(a, "{\"imports\":[" + joined(reported.objects, ",") + "]}\n", reported.text,
          exitCode);  // one object for all graphs
    return exitCode;
  }
  auto session = ImportSession::open(request.path, request.limits);
  if (session) {
    exitCode = reportAttempt(session->attempt(request, progress), request, paths, reported);
    while (a.ask && exitCode == static_cast<int>(FailureCode::notCertain) && reported.question) {
      const std::optional<Choice> answer = answerTo(*reported.question);
      if (!answer || !takeUp(*answer, request.hints)) break;
      reported = {.explains = a.explain};
      exitCode = reportAttempt(session->attempt(request, progress), request, paths, reported);
    }
  } else {
    reported.objects = {failureJson(session.failure(), request.path)};
    reported.text = session.failure().sentence() + "\n";
    exitCode = session.failure().exitCode();
  }
  print(a, joined(reported.objects, "\n") + "\n", reported.text, exitCode);
  return exitCode;
}

std::string listText(const std::vector<ListedPlot>& plots) {
  std::string text;
  for (const auto& [g, switches] : plots) {
    char row[320];
    std::snprintf(
        row, sizeof row,
        "page %d graph %d  box %.1f,%.1f,%.1f,%.1f %s  x %.6g..%.6g %s  y %.6g..%.6g %s  confidence %.2f\n",
        g.page, g.graph, g.frame.x0, g.frame.y0, g.frame.x1, g.frame.y1,
        g.unit == PageUnit::point ? "pt" : "px", g.x.min, g.x.max, g.x.unit.c_str(), g.y.min, g.y.max,
        g.y.unit.c_str(), g.confidence);
    text += row;
    for (std::size_t i = 0; i < switches.size() && switches.size() > 1; ++i) {
      const PlotSwitch& each = switches[i];
      text += "  curve " + std::to_string(i + 1) + (each.name.empty() ? "" : " \"" + each.name + "\"") +
              "  press " + nameOf(each.pressColor) +
              (each.releaseColor ? "  release " + nameOf(*each.releaseColor) : "") + "\n";
    }
  }
  return text;
}

std::string recordsText(const std::vector<ListedRecord>& records) {
  std::string text;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const ListedRecord& each = records[i];
    char row[120];
    std::snprintf(row, sizeof row, "record %zu  travel %.3f mm, highest force %.3f N%s", i + 1,
                  each.travel_mm, each.highest_N, each.release ? ", with its release" : "");
    text += row + (each.name.empty() ? "" : "  \"" + each.name + "\"") + "\n";
  }
  return text;
}

/// The listed graphs with the switches that each shows.
Result<std::vector<ListedPlot>> listedPlots(ImportSession& session, std::vector<ListedGraph> graphs,
                                            const ImportRequest& request, const Progress& progress) {
  std::vector<ListedPlot> plots;
  for (ListedGraph& graph : graphs) {
    auto switches = session.switches(graph, request.quality, request.hints, progress);
    if (!switches && switches.failure().code == FailureCode::cancelled) return switches.failure();
    plots.push_back({std::move(graph), switches ? std::move(*switches) : std::vector<PlotSwitch>{}});
  }
  return plots;
}

/// Why a list is empty: the first plot that measures something else or whose numbers make no scale, else that
/// there is none.
Failure nothingListed(const std::vector<RejectedFrame>& rejected, const std::string& input) {
  for (const RejectedFrame& each : rejected)
    if (each.why.code == FailureCode::notCertain && each.why.reason != nameOf(DoubtCode::ratherADrawing))
      return each.why;
  return {FailureCode::noForceGraph,
          input,
          "",
          "no force graph found",
          {{RemedyKind::giveFrame, "if there is one"}}};
}

int runList(const Arguments& a, const Progress& progress) {
  const ImportRequest& request = a.request;
  const std::string& input = a.inputs.front();
  const auto refused = [&](const Failure& failure) {
    print(a, failureJson(failure, input) + "\n", failure.sentence() + "\n", failure.exitCode());
    return failure.exitCode();
  };
  auto session = ImportSession::open(input, request.limits);
  if (!session) return refused(session.failure());
  if (session->isForceLog()) {
    const auto records = session->records(request.hints, progress);
    if (!records) return refused(records.failure());
    print(a, recordsJson(*records) + "\n", a.json ? "" : recordsText(*records), 0);
    return 0;
  }
  auto listed = session->list(request.page, request.quality, request.hints, progress);
  if (!listed) return refused(listed.failure());
  const auto plots = listedPlots(*session, std::move(listed->graphs), request, progress);
  if (!plots) return refused(plots.failure());

  std::fputs(warningLines(listed->remarks).c_str(), stderr);
  const int exitCode = plots->empty() ? static_cast<int>(FailureCode::noForceGraph) : 0;
  const std::string text =
      plots->empty() ? nothingListed(listed->rejected, input).sentence() + "\n" : listText(*plots);
  print(a, listJson(*plots, listed->remarks) + "\n", a.json && exitCode == 0 ? "" : text, exitCode);
  return exitCode;
}

/// A unique result name for each input: the file's stem, preceded by as many parent folders as necessary.
std::map<std::string, std::string> uniqueStems(const std::vector<std::string>& inputs) {
  std::map<std::string, std::string> stems;
  std::set<std::string> taken;
  std::map<std::string, std::size_t> inputsOf;
  for (const std::string& input : inputs) ++inputsOf[fs::path(input).stem().string()];
  for (const std::string& input : inputs) {
    const fs::path path = fs::absolute(input).lexically_normal();
    std::string stem = path.stem().string();
    if (inputsOf[fs::path(input).stem().string()] > 1)
      stem.insert(0, path.parent_path().filename().string().append("-"));
    std::string unique = stem;
    for (int n = 2; !taken.insert(unique).second; ++n) unique = stem + "-" + std::to_string(n);
    stems[input] = unique;
  }
  return stems;
}

/// Counts the imports of a batch that each confidence bar would accept; the batch's own bar comes first.
class AcceptedByBar {
 public:
  explicit AcceptedByBar(double sure) {
    for (const double bar : {sure, 0.5, 0.8, 0.9, 0.95, 0.99})
      if (bar >= sure) counts_[bar] = 0;
  }

  /// Counts report lines, one object each.
  void count(const std::string& lines) {
    std::istringstream each(lines);
    for (std::string line; std::getline(each, line);) {
      const auto json = nlohmann::json::parse(line, nullptr, false);
      if (!json.is_object() || !json.contains("confidence")) continue;
      for (auto& [bar, accepted] : counts_)
        if (json["confidence"] >= bar) ++accepted;
    }
  }

  std::string text() const {
    std::string words;
    for (const auto& [bar, accepted] : counts_)
      words += (words.empty() ? "accepted: " : ", ") + std::to_string(accepted) + " at --sure " + number(bar);
    return words;
  }
  nlohmann::json json() const {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [bar, accepted] : counts_) object[number(bar)] = accepted;
    return object;
  }

 private:
  static std::string number(double bar) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", bar);
    return text;
  }
  std::map<double, std::size_t> counts_;
};

/// Runs in the child process; an exception that arrives here affects this input only.
int handleInput(const Arguments& a, const std::string& input, const OutputPaths& paths, Reported& reported) {
  // share of the time limit after which results so far can still be reported
  constexpr double beforeTheEnd = 0.9;
  ImportRequest request = a.request;
  request.path = input;
  if (const auto pair = a.releaseOf.find(input); pair != a.releaseOf.end())
    request.hints.releasePath = pair->second;
  request.timeLimit.emplace(a.batchOptions.timeLimit_s, beforeTheEnd);
  try {
    return importAll(request, paths, {}, reported);
  } catch (const std::bad_alloc&) {
    const Failure tooLarge{
        FailureCode::unreadableInput, input, "", "the file needs more memory than the limit",
        "Pass a larger --memory-limit, or a smaller --max-megapixels to refuse such inputs early"};
    reported.objects = {failureJson(tooLarge, input)};
    return tooLarge.exitCode();
  }
}

/// Key for an input whose outputs could not be written. This is no fault of the input, and it ends the batch.
constexpr const char* notWritten = "outputs not written";

/// Answer of a child process: the key of its input on the first line, then the lines of the report.
std::string withKey(const std::string& key, const Reported& reported) {
  return (reported.written ? key : notWritten) + "\n" + joined(reported.objects, "\n") + "\n";
}

/// The answer of a child. One that died without a key gets none, so that the next batch tries its input
/// again.
std::pair<std::string, std::string> keyAndLines(const InputOutcome& outcome) {
  if (outcome.death.empty()) {
    const std::size_t end = outcome.reportLines.find('\n');
    if (end != std::string::npos)
      return {outcome.reportLines.substr(0, end), outcome.reportLines.substr(end + 1)};
  }
  const auto code = static_cast<FailureCode>(outcome.exitCode);
  const Failure died{code, outcome.input, "", outcome.death, "Import it alone to see how far it comes"};
  return {"", failureJson(died, outcome.input) + "\n"};
}

Failure noRoomFor(const std::string& input) {
  return {FailureCode::internalFault,
          input,
          "",
          "its results cannot be written, no permission or no space",
          "Make room, then run it again with --resume",
          "not_written"};
}

std::vector<std::string> toDo(const std::vector<std::string>& inputs, const BatchReport& report) {
  std::vector<std::string> open;
  std::set<std::string> seen;
  for (const std::string& input : inputs)
    if (!report.has(input) && seen.insert(input).second) open.push_back(input);
  return open;
}

struct BatchCounts {
  std::size_t handled = 0, failed = 0;
};

void sayBatch(const Arguments& a, const BatchCounts& counts, const BatchReport& report,
              const AcceptedByBar& accepted) {
  std::fprintf(a.json ? stderr : stdout, "%zu inputs handled, %zu failed, %zu already done; report: %s\n",
               counts.handled, counts.failed, report.kept(), report.path().c_str());
  std::fprintf(a.json ? stderr : stdout, "%s\n", accepted.text().c_str());
  if (!a.json) return;
  const nlohmann::json summary{{"handled", counts.handled},
                               {"failed", counts.failed},
                               {"report", report.path()},
                               {"accepted", accepted.json()}};
  std::fprintf(stdout, "%s\n", jsonText(summary).c_str());
}

int refuseBatch(const Failure& failure) {
  std::fprintf(stderr, "%s\n", failure.sentence().c_str());
  return failure.exitCode();
}

int runBatch(const Arguments& a, const std::function<bool()>& cancelled) {
  std::error_code error;
  fs::create_directories(a.outDir, error);
  std::string settledBy = a.settledBy;  // a changed release file repeats all inputs
  for (const auto& [press, release] : a.releaseOf) settledBy += resultKey(release, "") + "\n";
  const auto stems = uniqueStems(a.inputs);
  // An input whose result would get another name is read again, because its old name may now belong to
  // another input.
  const auto keyOf = [&](const std::string& input) {
    return resultKey(input, settledBy + "\n" + stems.at(input));
  };
  auto report = BatchReport::open(a.outDir, a.inputs, keyOf, a.resume);
  if (!report) return refuseBatch(report.failure());
  const std::vector<std::string> inputs = toDo(a.inputs, *report);

  ProgressLine line;
  BatchCounts counts;
  AcceptedByBar accepted(a.request.sure);
  if (const auto before = readTextFile(report->path())) accepted.count(*before);  // kept by --resume
  Result<Done> kept = Done{};
  const auto handle = [&](const std::string& input, std::string& lines) {
    const std::string key = keyOf(input);  // key of the input before it is read
    const std::string base = (fs::path(a.outDir) / stems.at(input)).string();
    Reported reported{.explains = a.explain};
    const int code = handleInput(a, input,
                                 {base + ".button.json", base + ".csv", base + ".trace.csv",
                                  a.withoutOverlays ? "" : base + ".overlay.png", ""},
                                 reported);
    lines = withKey(key, reported);
    return code;
  };
  const auto finished = [&](const InputOutcome& outcome) {
    const auto [key, lines] = keyAndLines(outcome);
    if (kept && key == notWritten) kept = noRoomFor(outcome.input);
    if (kept) kept = report->add(outcome.input, key, lines);
    if (!kept) return;
    accepted.count(lines);
    ++counts.handled;
    if (outcome.exitCode != 0) {
      ++counts.failed;
      std::fprintf(stderr, "exit %d: %s\n", outcome.exitCode, outcome.input.c_str());
    }
    line.show(double(counts.handled) / double(inputs.size()), outcome.input);
    if (a.jsonLines) showInputDone(outcome.input, outcome.exitCode, counts.handled, inputs.size());
  };
  if (inputs.size() > 1) loadTextEngine();  // loaded once here, not in every child
  const auto ran =
      runIsolated(inputs, a.batchOptions, handle, finished, [&] { return !kept || cancelled(); });
  if (!kept) return refuseBatch(kept.failure());
  if (!ran) return refuseBatch(ran.failure());
  if (const auto sorted = report->sortAs(a.inputs); !sorted) return refuseBatch(sorted.failure());
  sayBatch(a, counts, *report, accepted);
  return 0;
}

}  // namespace

int run(const Arguments& arguments, const std::function<bool()>& cancelled) {
  if (arguments.batch) return codeAfterOutput(runBatch(arguments, cancelled));
  int exitCode = 0;
  {
    const ForcedEnd end(cancelled);
    ProgressLine line;
    StepLines lines;
    Progress progress;
    progress.report = [&](double fraction, ImportStep step) {
      line.show(fraction, inProgress(step));
      if (arguments.jsonLines) lines.show(fraction, step);
    };
    progress.cancelled = cancelled;
    exitCode = arguments.list ? runList(arguments, progress) : runImport(arguments, progress);
  }
  return cancelled() ? interruptedExitCode : codeAfterOutput(exitCode);
}

}  // namespace detent::importer
