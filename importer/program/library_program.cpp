// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/library_program.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "importer/batch/batch.h"
#include "importer/program/forced_end.h"
#include "importer/program/library_json.h"
#include "importer/program/progress_line.h"
#include "importer/program/report_json.h"
#include "model/file/button_file.h"
#include "model/file/json_text.h"
#include "model/file/text_file.h"
#include "model/program/command_line.h"
#include "model/text.h"
#include "model/units.h"

namespace detent::importer {
namespace {

using Json = nlohmann::ordered_json;

/// All values of the command line.
struct LibraryArguments {
  IndexRequest index;
  FindRequest find;
  std::string like, page, wanted;
  std::size_t likePart = 1;
  bool json = false, pages = false;
};

/// Number of internal units of a figure in one unit of this name; empty if the unit does not fit the figure.
std::optional<double> factorOf(std::string_view unit, FigureUnit figure) {
  switch (figure) {
    case FigureUnit::mm:
      if (const auto known = lengthUnitFrom(unit)) return millimetresPer(*known);
      return {};
    case FigureUnit::N:
      if (const auto known = forceUnitFrom(unit)) return newtonsPer(*known);
      return {};
    case FigureUnit::N_per_mm:
      if (!unit.ends_with("/mm")) return {};
      return factorOf(unit.substr(0, unit.size() - 3), FigureUnit::N);
    case FigureUnit::mJ:
      return unit == "mJ"     ? std::optional(1.0)
             : unit == "gfmm" ? std::optional(newtonsPer(ForceUnit::gramForce))
                              : std::nullopt;
    case FigureUnit::share:
      return unit == "%" ? std::optional(0.01) : std::nullopt;
  }
  return {};
}

/// One end of a range: a number, or `open` for an empty text.
std::optional<double> endOf(std::string_view text, double open) {
  return text.empty() ? std::optional(open) : finiteNumberFrom(text);
}

/// Parses "50..60gf", "..0.6N", "3.5..mm"; without a unit in mm, N, N/mm, mJ or shares.
std::optional<FigureRange> rangeFrom(std::string_view text, const KeyFigureName& figure) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return {};
  const std::string_view low = text.substr(0, dots), rest = text.substr(dots + 2);
  const std::size_t number = std::min(rest.find_first_not_of("0123456789.+-"), rest.size());
  const std::string_view unit = rest.substr(number);
  const auto factor = unit.empty() ? std::optional(1.0) : factorOf(unit, figure.unit);
  const FigureRange open;
  const auto least = endOf(low, open.low), most = endOf(rest.substr(0, number), open.high);
  if (!factor || !least || !most || *least > *most) return {};
  return FigureRange{figure.figure, *least * *factor, *most * *factor};
}

const char* exampleOf(FigureUnit unit) {
  switch (unit) {
    case FigureUnit::mm:
      return "LOW..HIGHmm";
    case FigureUnit::N:
      return "LOW..HIGHgf";
    case FigureUnit::N_per_mm:
      return "LOW..HIGHgf/mm";
    case FigureUnit::mJ:
      return "LOW..HIGHmJ";
    case FigureUnit::share:
      return "LOW..HIGH%";
  }
  return "";
}

/// "--peak-force" for "peak_force_N".
std::string optionOf(const KeyFigureName& name) {
  std::string key(name.key);
  for (const std::string_view unit : {"_N_per_mm", "_N", "_mm", "_mJ"})
    if (key.ends_with(unit)) {
      key.erase(key.size() - unit.size());
      break;
    }
  std::ranges::replace(key, '_', '-');
  std::string option = "--" + key;
  if (name.figure == KeyFigure::peakForce) option = "--peak," + option;
  if (name.figure == KeyFigure::totalTravel) option = "--travel," + option;
  return option;
}

void addRanges(CLI::App& app, std::vector<FigureRange>& ranges) {
  auto* group =
      app.add_option_group("Figures",
                           "Required ranges, both ends included; either may be left out; without a unit in "
                           "N, mm, N/mm, mJ or shares. docs/reference/glossary.md defines each");
  for (const KeyFigureName& name : keyFigureNames()) {
    const auto take = [&ranges, &name](const std::string& text) {
      const auto range = rangeFrom(text, name);
      if (!range)
        throw CLI::ValidationError("'" + text + "' is no range. Pass " + std::string(exampleOf(name.unit)) +
                                   ", e.g. 50..60 and the unit");
      ranges.push_back(*range);
    };
    group->add_option_function<std::string>(optionOf(name), take, name.term)->type_name(exampleOf(name.unit));
  }
}

CLI::App* addIndex(CLI::App& app, LibraryArguments& a) {
  CLI::App* index =
      app.add_subcommand("index", "Index folders of measured switches; unchanged files are not read again");
  index
      ->add_option("FOLDER", a.index.folders,
                   "folders (or files) with csv, ods, json and .button.json; hidden ones are skipped")
      ->required();
  index->add_option("--db", a.index.database, "the library's file; created if missing")->required();
  index->add_option(
      "--licence", a.index.licence,
      "licence of these measurements (default: the folder's licence file, else \"none stated\")");
  index->add_option("--credit", a.index.credit,
                    "author of these measurements (default: the clone's owner/name)");
  index->add_flag(
      "--pages", a.pages,
      "read datasheets too: pdf, svg, png, jpg, bmp, tiff, webp, gif, each in its own process; seconds each");
  index->add_option("--jobs", a.index.jobs, "threads (default: one per core)")
      ->check(numberWithin<CLI::Validator>(1, 1024));
  index->add_flag("--json", a.json, "one JSON object on stdout; text goes to stderr");
  return index;
}

/// Options that `find` and `report` share.
CLI::Option* addSearch(CLI::App* find, LibraryArguments& a) {
  find->add_option("--db", a.find.database, "the library's file")->required();
  CLI::Option* const like =
      find->add_option("--like", a.like, "a button or force log: .button.json, csv, ods, json");
  find->add_option("--like-part", a.likePart, "number of the switch or state in it, from 1")
      ->check(numberWithin<CLI::Validator>(1, 1e6))
      ->capture_default_str();
  CLI::Option* const limit = find->add_option("--limit", a.find.limit, "number of switches to show")
                                 ->check(numberWithin<CLI::Validator>(1, 1e6))
                                 ->capture_default_str();
  find->add_flag_callback(
          "--all", [&a] { a.find.limit = std::numeric_limits<std::size_t>::max(); }, "show all that fit")
      ->excludes(limit);
  find->add_option("--name", a.find.name, "part of the switch's name; case does not matter");
  find->add_option("--kind", a.find.kind, "linear, between (a drop of 5 to 8 gf) or tactile")
      ->transform(CLI::CheckedTransformer(std::map<std::string, SwitchKind>{{"linear", SwitchKind::linear},
                                                                            {"between", SwitchKind::between},
                                                                            {"tactile", SwitchKind::tactile}})
                      .description(""))
      ->type_name("linear|between|tactile");
  find->add_flag("--json", a.json, "one JSON object on stdout; text goes to stderr");
  addRanges(*find, a.find.ranges);
  return like;
}

CLI::App* addFind(CLI::App& app, LibraryArguments& a) {
  CLI::App* find = app.add_subcommand(
      "find", "Find switches that feel like a given one or have given figures; nearest first");
  addSearch(find, a);
  find->add_option(
      "-o,--output", a.wanted,
      "*.button.json to write: the nearest switch with the smallest change that gives it the figures");
  return find;
}

CLI::App* addReport(CLI::App& app, LibraryArguments& a) {
  CLI::App* report = app.add_subcommand(
      "report",
      "Write the switches that feel like a given one as one page: plots, figures, credits, licences");
  addSearch(report, a)->required();
  report->add_option("-o,--output", a.page, "page to write (*.html); whole or not at all")->required();
  return report;
}

int refused(const Failure& failure, const std::string& input, bool json) {
  if (json) std::fputs((failureJson(failure, input) + "\n").c_str(), stdout);
  std::fputs((failure.sentence() + "\n").c_str(), stderr);
  return failure.exitCode();
}

Json summaryJson(const IndexSummary& summary) {
  Json refusals = Json::array();
  for (const RefusedFile& each : summary.refusals)
    refusals.push_back({{"file", each.file}, {"status", nameOf(each.code)}, {"reason", each.reason}});
  Json json = {{"imported", summary.imported},   {"refused", summary.refused},
               {"unchanged", summary.unchanged}, {"gone", summary.gone},
               {"switches", summary.switches},   {"ratings", summary.ratings},
               {"refusals", std::move(refusals)}};
  if (!summary.rebuilt.empty()) json["rebuilt"] = english(summary.rebuilt);
  return json;
}

Json sigmasJson(const KeyFigures& sigmas) {
  Json json = Json::object();
  for (const KeyFigureName& name : keyFigureNames())
    if (const auto& sigma = sigmas[name.figure]) json[std::string(name.key)] = *sigma;
  return json;
}

KeyFigures sigmasFrom(const Json& json) {
  KeyFigures sigmas;
  for (const KeyFigureName& name : keyFigureNames())
    if (const auto at = json.find(std::string(name.key)); at != json.end())
      sigmas[name.figure] = at->get<double>();
  return sigmas;
}

/// A child's result for a page: its buttons, or the reason why there are none.
std::string pageLine(const std::string& path) {
  const auto buttons = readPageButtons(path, Quality::standard);
  Json line;
  if (buttons)
    for (const PageButton& each : *buttons)
      line["buttons"].push_back({{"button", jsonFrom(each.button)}, {"sigmas", sigmasJson(each.sigmas)}});
  else
    line = {{"code", static_cast<int>(buttons.failure().code)}, {"reason", buttons.failure().sentence()}};
  return jsonText(line) + "\n";
}

Result<std::vector<LibrarySwitch>> switchesIn(const InputOutcome& outcome) {
  const std::string subject = std::filesystem::path(outcome.input).filename().string();
  const Json line = Json::parse(outcome.reportLines, nullptr, false);
  if (!line.is_object())
    return Failure{FailureCode::unreadableInput, subject, "", Message("the import %1", outcome.death),
                   "Import it by itself"};
  if (!line.contains("buttons")) {
    std::string reason = line.value("reason", std::string());
    if (reason.ends_with('.')) reason.pop_back();  // the full stop is added again later
    return Failure{
        static_cast<FailureCode>(line.value("code", static_cast<int>(FailureCode::unreadableInput))),
        "",
        "",
        Message("%1", reason),
        {}};
  }
  std::vector<PageButton> buttons;
  for (const Json& each : line["buttons"]) {
    auto button = buttonFromJson(each["button"].get<std::string>(), subject);
    if (!button) return button.failure();
    buttons.push_back({*std::move(button), sigmasFrom(each["sigmas"])});
  }
  return switchesOfPage(buttons, outcome.input);
}

PageReader pageReader(int jobs, const std::function<bool()>& cancelled) {
  return [jobs, cancelled](const std::vector<std::string>& paths, const auto& take) {
    BatchOptions options;
    options.jobs = jobs;
    return runIsolated(
        paths, options,
        [](const std::string& path, std::string& lines) {
          lines = pageLine(path);
          return 0;
        },
        [&](const InputOutcome& outcome) { take(outcome.input, switchesIn(outcome)); }, cancelled);
  };
}

int runIndex(const LibraryArguments& a, const std::function<bool()>& cancelled) {
  ProgressLine line;
  IndexRequest request = a.index;
  if (a.pages) request.readPages = pageReader(request.jobs, cancelled);
  const auto summary = indexFolders(
      request, {[&](double fraction, const std::string& file) { line.show(fraction, file); }, cancelled});
  if (!summary) return refused(summary.failure(), a.index.database, a.json);
  std::FILE* const text = a.json ? stderr : stdout;
  if (!summary->rebuilt.empty())
    std::fprintf(stderr, "warning: %s: %s\n", a.index.database.c_str(), english(summary->rebuilt).c_str());
  for (const RefusedFile& each : summary->refusals)
    std::fprintf(stderr, "refused: %s: %s\n", each.file.c_str(), each.reason.c_str());
  std::fprintf(text, "%zu files imported (%zu switches), %zu refused, %zu unchanged, %zu gone\n",
               summary->imported, summary->switches, summary->refused, summary->unchanged, summary->gone);
  if (summary->ratings > 0) std::fprintf(text, "%zu ratings by people\n", summary->ratings);
  if (a.json) std::fprintf(stdout, "%s\n", jsonText(summaryJson(*summary)).c_str());
  return 0;
}

/// A figure in a table column; a dash if it is missing.
std::string cell(const std::optional<double>& value, double unit, const char* format) {
  if (!value) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, *value / unit);
  return text;
}

/// Remarks on a row beside its figures.
std::string remarksOf(const FoundSwitch& each) {
  std::string words;
  if (each.spread.records > 1)
    words += "; " + std::to_string(each.spread.records) + " records of " + std::to_string(each.spread.units) +
             (each.spread.units == 1 ? " unit" : " units");
  if (each.entry.scaleDoubtful) words += "; its forces may lie well off other laboratories'";
  return words;
}

void printTable(const std::vector<FoundSwitch>& found) {
  std::printf("%9s  %7s  %7s  %9s  %-8s  %s\n", "distance", "peak gf", "drop gf", "travel mm", "kind",
              "name; licence; credit; source");
  const double gf = newtonsPer(ForceUnit::gramForce);
  std::size_t group = 0;
  for (const FoundSwitch& each : found) {
    const auto& [entry, distance, spread, ratings] = each;
    const KeyFigures& f = entry.figures;
    if (distance && groupOf(*distance) != group) {
      group = groupOf(*distance);
      std::printf("%s\n",
                  group == 1 ? "nobody can tell:" : ("within " + std::to_string(group) + ":").c_str());
    }
    std::printf("%9s  %7s  %7s  %9s  %-8s  %s%s%s; %s; %s; %s%s\n", cell(distance, 1, "%.2f").c_str(),
                cell(f[KeyFigure::peakForce], gf, "%.1f").c_str(),
                cell(f[KeyFigure::drop], gf, "%.1f").c_str(),
                cell(f[KeyFigure::totalTravel], 1, "%.2f").c_str(), std::string(nameOf(kindOf(f))).c_str(),
                entry.name.c_str(), entry.unit.empty() ? "" : (" unit " + entry.unit).c_str(),
                entry.run.empty() ? "" : (" run " + entry.run).c_str(), entry.licence.c_str(),
                entry.credit.empty() ? "credit unknown" : entry.credit.c_str(), entry.source.c_str(),
                remarksOf(each).c_str());
    for (const Rating& rating : ratings)
      std::printf("%11srated by %s; %s\n", "", ratingWords(rating).c_str(), rating.licence.c_str());
  }
}

/// The reference switch of --like. `errors`: with standard errors of its figures, for reports that show them.
Result<LibrarySwitch> switchLike(const LibraryArguments& a, bool errors) {
  if (!isLibraryFile(a.like))
    return Failure{
        FailureCode::wrongUsage, Subject::option("--like"), "",
        Message("'%1' is neither a button nor a force log", a.like),
        "Import a picture or page first (detent-import INPUT -o OUT.button.json), and pass the button"};
  auto switches = readSwitches(a.like, errors);
  if (!switches) return switches.failure();
  if (a.likePart > switches->size())
    return Failure{FailureCode::wrongUsage, Subject::option("--like-part"), "",
                   Message("there are only %1 switches or states", switches->size()),
                   "Pass one of them, from 1"};
  return std::move((*switches)[a.likePart - 1]);
}

void printNearest(const std::vector<NearMiss>& nearest) {
  if (nearest.empty()) return;
  std::printf("none has all of these; nearest, by how far they miss:\n");
  for (const auto& [entry, miss] : nearest)
    std::printf("%9.2f  %s; %s; %s; %s\n", miss, entry.name.c_str(), entry.licence.c_str(),
                entry.credit.empty() ? "credit unknown" : entry.credit.c_str(), entry.source.c_str());
}

Result<Button> bentFrom(const LibrarySwitch& entry, const std::vector<FigureRange>& ranges) {
  // the figures of the indexed switch, not of the imported button
  auto button = buttonOf(entry, Quality::draft);
  return button ? buttonWithin(*button, ranges) : std::move(button);
}

/// The first switch of the answer that can be bent into the ranges; if none can, the failure of the first
/// one.
Result<Button> wantedButton(const FoundSwitches& result, const std::vector<FigureRange>& ranges) {
  std::vector<const LibrarySwitch*> entries;
  for (const FoundSwitch& each : result.found) entries.push_back(&each.entry);
  for (const NearMiss& each : result.nearest) entries.push_back(&each.entry);
  std::optional<Failure> why;
  for (const LibrarySwitch* entry : entries) {
    auto button = bentFrom(*entry, ranges);
    if (button) return button;
    if (!why) why = button.failure();
  }
  if (why) return std::move(*why);
  return Failure{FailureCode::notCertain, "library", "", "no switch in it has all figures asked for",
                 "Ask for figures that go together: a linear switch has no peak"};
}

Result<Done> writeWanted(const LibraryArguments& a, const FoundSwitches& result) {
  if (a.find.ranges.empty())
    return Failure{FailureCode::wrongUsage, Subject::option("--output"), "", "no figures are asked for",
                   "Give some, e.g. --peak 50..60gf"};
  if (!lowered(a.wanted).ends_with(".button.json"))
    return Failure{FailureCode::wrongUsage, Subject::option("--output"), "",
                   Message("'%1' is not the name of a button", a.wanted), "Give it the ending .button.json"};
  const auto wanted = wantedButton(result, a.find.ranges);
  if (!wanted) return wanted.failure();
  return writeButtonFile(a.wanted, *wanted);
}

int runFind(const LibraryArguments& a) {
  FindRequest request = a.find;
  if (!a.like.empty()) {
    auto like = switchLike(a, false);
    if (!like) return refused(like.failure(), a.like, a.json);
    request.like = std::move(like->shape);
  }
  const auto result = findSwitches(request);
  if (!result) return refused(result.failure(), request.database, a.json);
  if (!a.wanted.empty())
    if (const auto written = writeWanted(a, *result); !written)
      return refused(written.failure(), a.wanted, a.json);
  if (a.json) {
    std::fprintf(stdout, "%s\n", foundJson(*result).c_str());
    return 0;
  }
  printTable(result->found);
  printNearest(result->nearest);
  std::printf(
      "%zu of %zu. Distances in units of what two laboratories differ by on one switch (%g gf): below 1 "
      "nobody can say that two "
      "differ.\n",
      result->found.size(), result->fitting, labNoise_gf);
  return 0;
}

int runReport(const LibraryArguments& a) {
  const std::string ending = lowered(std::filesystem::path(a.page).extension().string());
  if (ending != ".html" && ending != ".htm")
    return refused({FailureCode::wrongUsage, Subject::option("--output"), "",
                    Message("'%1' is not the name of a page", a.page), "Give it the ending .html"},
                   a.page, a.json);
  auto like = switchLike(a, true);
  if (!like) return refused(like.failure(), a.like, a.json);
  if (like->licence.empty()) like->licence = noLicenceStated;
  FindRequest request = a.find;
  request.like = like->shape;
  const auto result = findSwitches(request);
  if (!result) return refused(result.failure(), request.database, a.json);
  if (auto written = writeTextFileAtomically(a.page, reportPage(*like, result->found, result->fitting));
      !written)
    return refused(written.failure(), a.page, a.json);
  std::fprintf(a.json ? stderr : stdout, "%s: %zu of %zu switches\n", a.page.c_str(), result->found.size(),
               result->fitting);
  if (a.json) {
    const Json json = {{"output", a.page}, {"shown", result->found.size()}, {"fitting", result->fitting}};
    std::fprintf(stdout, "%s\n", jsonText(json).c_str());
  }
  return 0;
}

}  // namespace

int runLibrary(int argc, char** argv, const std::function<bool()>& cancelled) {
  CLI::App app{
      "Keeps thousands of measured switches and finds them by feel. Displacement in mm, force in N in its "
      "JSON.\n"
      "Exit codes: 0 done, 1 internal fault or disk error, 2 wrong usage, 3 input cannot be read, 130 "
      "interrupted."};
  app.name("detent-import library");
  app.formatter(std::make_shared<PlainHelp<CLI::Formatter, CLI::Option>>());
  app.require_subcommand(1);
  LibraryArguments arguments;
  const CLI::App* const index = addIndex(app, arguments);
  addFind(app, arguments);
  const CLI::App* const report = addReport(app, arguments);
  try {
    app.parse(argc - 1, argv + 1);
  } catch (const CLI::ParseError& stop) {
    const bool wanted = stop.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help
    app.exit(stop, std::cout, std::cerr);
    return wanted ? 0 : static_cast<int>(FailureCode::wrongUsage);
  }
  int exitCode = 0;
  {
    // Pages are read in child processes, which must be started while there is a single thread.
    std::optional<ForcedEnd> end;
    if (!arguments.pages) end.emplace(cancelled);
    exitCode = index->parsed()    ? runIndex(arguments, cancelled)
               : report->parsed() ? runReport(arguments)
                                  : runFind(arguments);
  }
  return cancelled() ? static_cast<int>(FailureCode::cancelled) : codeAfterOutput(exitCode);
}

}  // namespace detent::importer
