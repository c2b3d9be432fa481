// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/arguments.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <string>

#include <CLI/CLI.hpp>

#include "model/program/command_line.h"
#include "model/version.h"

namespace detent::importer {
namespace {

/// Numbers between separators, e.g. "0:4" or "10,20,300,200".
std::optional<std::vector<double>> numbersIn(const std::string& text, char separator) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    double value = 0;
    const auto [after, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    if (after == end) return numbers;
    if (*after != separator) return {};
    at = after + 1;
  }
}

CLI::ValidationError wrong(const char* option, const std::string& text, const char* expected) {
  return CLI::ValidationError(option, "'" + text + "' is not " + expected);
}

void parseAxis(const char* option, const std::string& text, std::optional<double>& min,
               std::optional<double>& max) {
  const auto numbers = numbersIn(text, ':');
  if (!numbers || numbers->size() != 2 || (*numbers)[0] == (*numbers)[1]) {
    throw wrong(option, text, "MIN:MAX, the two different values at the plot frame's edges, e.g. 0:4.5");
  }
  min = (*numbers)[0], max = (*numbers)[1];
}

std::vector<Point> parseCorners(const std::string& text) {
  const auto n = numbersIn(text, ',');
  if (!n || (n->size() != 4 && n->size() != 8)) {
    throw wrong("--frame", text,
                "X0,Y0,X1,Y1 (two opposite corners) or eight numbers (tl,tr,br,bl), in page units");
  }
  std::vector<Point> corners;
  for (std::size_t i = 0; i < n->size(); i += 2) corners.push_back({(*n)[i], (*n)[i + 1]});
  return corners;
}

std::vector<Point> parseLine(const char* option, const std::string& text) {
  const auto n = numbersIn(text, ',');
  if (!n || n->size() < 4 || n->size() % 2 != 0)
    throw wrong(option, text, "X0,Y0,X1,Y1,... two points or more along the curve, in page units");
  std::vector<Point> line;
  for (std::size_t i = 0; i < n->size(); i += 2) line.push_back({(*n)[i], (*n)[i + 1]});
  return line;
}

Box parseBox(const std::string& text) {
  const auto n = numbersIn(text, ',');
  if (!n || n->size() != 4) throw wrong("--mask", text, "X0,Y0,X1,Y1 in page units");
  return {std::min((*n)[0], (*n)[2]), std::min((*n)[1], (*n)[3]), std::max((*n)[0], (*n)[2]),
          std::max((*n)[1], (*n)[3])};
}

Rgb parseColor(const char* option, const std::string& text) {
  const auto color = colorFrom(text);
  if (!color) throw wrong(option, text, "a colour like #2a6099");
  return *color;
}

CLI::Validator within(double low, double high) { return numberWithin<CLI::Validator>(low, high); }

/// Options as typed, before conversion to values.
struct RawOptions {
  std::string frame, xAxis, yAxis, xUnit, yUnit, pressColor, releaseColor, pressLine, releaseLine;
  std::vector<std::string> masks;
  int page = 0, graph = 0;
  double dpi = 0;
};

void addInputs(CLI::App& app, Arguments& a, RawOptions& raw) {
  app.add_option(
         "INPUT", a.inputs,
         "png, jpg, bmp, tiff, webp, gif, pdf, svg, svgz, a force meter's table (csv, tsv, txt, xlsx, "
         "ods, json and others, told by content), or a WebPlotDigitizer project (json, tar)")
      ->required();
  app.add_option("--page", raw.page, "page, from 1 (default: the page of the most certain graph)")
      ->check(within(1, 1000000));
  app.add_option("--graph", raw.graph,
                 "graph on its page in reading order, from 1 (default: the most certain)")
      ->check(within(1, 10000));
  app.add_option("--curve", a.request.hints.strokes.curve,
                 "NAME|N: switch to import if a plot shows several, by its name in the legend or its number; "
                 "--list shows both");
  app.add_option(
         "--record", a.request.hints.strokes.curve,
         "NAME|N|mean: of several records in a table (cycles, specimens, switches) the one to import, or "
         "their mean; --list shows them")
      ->excludes("--curve");
  app.add_flag("--pair", a.pair,
               "two INPUTs are the press and the release of one button, a table each; in a batch those named "
               "alike but for a word such as "
               "downstroke and upstroke");
  app.add_flag("--ask", a.ask,
               "on a terminal: put what is not certain as a question and go on with the answer");
  app.add_flag(
      "--explain", a.explain,
      "print the evidence of the best three readings of a table; with --json as \"interpretations\"");
  app.add_flag("--all", a.all, "import every graph; page and graph number go into the output names");
  app.add_flag(
      "--family", a.family,
      "two to four INPUTs are records of one button, pressed at different speeds, with a column of times: "
      "one button with a graph at each of these speeds; the first stands where no speed is known");
  app.add_flag("--list", a.list,
               "only list the graphs found: page, graph, box, axes, units, confidence, switches");
  addChoice(
      app, "--quality", a.request.quality, qualities,
      "draft, standard or precise (default: standard): drawn plots come out 0.11, 0.08 and 0.06 % of the "
      "span off, for 1, 1.1 and 3.6 times the work; docs/measurements/trade.md",
      "standard");
  app.add_option("--sure", a.request.sure,
                 "confidence below which an import is refused with exit 5; "
                 "docs/measurements/import-confidence.md says what a "
                 "confidence is worth")
      ->check(within(0.0, 1.0))
      ->capture_default_str();
  app.add_flag("--json", a.json, "one JSON object on stdout; text goes to stderr");
  app.add_flag("--json-lines", a.jsonLines,
               "progress as JSON objects, one a line on stdout; the last line is what --json prints");
}

void addOutputs(CLI::App& app, Arguments& a) {
  app.add_option("-o,--output", a.buttonPath, "button file to write (*.button.json)");
  app.add_option("--csv", a.csvPath, "fitted graph to write: stroke,displacement_mm,force_N");
  app.add_option("--trace-csv", a.tracePath, "traced points before the fit, same columns");
  app.add_option(
      "--overlay", a.overlayPath,
      "picture to write (png): findings and unexplained marks drawn over the page; written on exit 5 too");
  app.add_option("--dump-steps", a.stepsPath,
                 "for developers: file to write with the results of each step as JSON (tokens, axes, "
                 "polylines, pair), also of a refused import");
}

void addHints(CLI::App& app, RawOptions& raw, Arguments& a) {
  auto* group = app.add_option_group("By hand",
                                     "Replaces automatic decisions. Page units: pixels of a picture, points "
                                     "(1/72 in) of a document, origin top left");
  group->add_option("--frame", raw.frame,
                    "plot frame: X0,Y0,X1,Y1 or four corners as eight numbers, page units");
  group->add_option("--x-axis", raw.xAxis, "MIN:MAX at the frame's left and right edge, in the x unit");
  group->add_option("--y-axis", raw.yAxis, "MIN:MAX at the frame's bottom and top edge, in the y unit");
  group->add_option("--x-unit", raw.xUnit, "mm, cm, m, um, nm, in or mil (thou)");
  group->add_option("--y-unit", raw.yUnit, "N, uN, mN, cN, dN, kN, MN, gf, kgf (kp), ozf, lbf or dyn");
  group->add_option("--press-color", raw.pressColor, "colour of the press curve, #rrggbb");
  group->add_option("--release-color", raw.releaseColor, "colour of the release curve, #rrggbb");
  group->add_option(
      "--press-line", raw.pressLine,
      "X0,Y0,X1,Y1,... points along the press curve, page units; between them the drawn curve is followed");
  group->add_option("--release-line", raw.releaseLine, "the same along the release curve");
  group
      ->add_flag("--no-release", a.request.hints.strokes.noRelease,
                 "the plot shows no release of this button: the press alone is imported")
      ->excludes("--release-color")
      ->excludes("--release-line");
  group->add_option("--mask", raw.masks, "X0,Y0,X1,Y1 to ignore, page units; may be given several times")
      ->take_all()
      ->allow_extra_args(false);
  group->add_option("--dpi", raw.dpi, "render documents at this resolution (default: by --quality)")
      ->check(within(10.0, 1200.0));
  ColumnHints& columns = a.request.hints.columns;
  group->add_option("--displacement-column", columns.displacement,
                    "NAME|N: column of a table, by title or from 1");
  group->add_option("--force-column", columns.force, "NAME|N");
  group->add_option("--release-displacement-column", columns.releaseDisplacement,
                    "NAME|N: where the release has a column of its own");
  group->add_option("--release-force-column", columns.releaseForce, "NAME|N");
  group->add_option("--stroke-column", columns.stroke, "NAME|N: its cells say press or release");
  group->add_option("--cycle-column", columns.cycle, "NAME|N: its cells number cycles or name specimens");
  group->add_flag("--swap-strokes", a.request.hints.strokes.swap, "exchange press and release");
}

void addBatch(CLI::App& app, Arguments& a) {
  auto* group = app.add_option_group("Batch", "Many inputs, each in its own process");
  group->add_flag("--batch", a.batch,
                  "import every graph of every INPUT into --out-dir; @FILE: inputs that FILE lists, one per "
                  "line; -: inputs listed on standard input");
  group->add_option("--out-dir", a.outDir, "folder for results and report.jsonl (created if missing)");
  group->add_option("--jobs", a.batchOptions.jobs, "processes at once (default: one per core)")
      ->check(within(1, 1024));
  group->add_flag("--resume", a.resume,
                  "skip inputs that report.jsonl already has with the same bytes, options and version");
  group->add_flag("--no-overlays", a.withoutOverlays,
                  "write no *.overlay.png (nine tenths of a batch's output)");
  group->add_option("--memory-limit", a.batchOptions.memoryLimit_MB, "MB of address space per input")
      ->check(within(64.0, 1e6))
      ->capture_default_str();
}

void addLimits(CLI::App& app, Arguments& a) {
  PageLimits& limits = a.request.limits;
  auto* group = app.add_option_group("Limits", "Against hostile input");
  group->add_option("--max-megapixels", limits.maxMegapixels, "of a picture or a render")
      ->check(within(0.01, 10000.0))
      ->capture_default_str();
  group->add_option("--max-pages", limits.maxPages, "of a document")
      ->check(within(1, 1000000))
      ->capture_default_str();
  group->add_option("--max-file-megabytes", limits.maxFileMegabytes, "of the input file")
      ->check(within(0.001, 1e6))
      ->capture_default_str();
  group
      ->add_option("--time-limit", a.timeLimit_s,
                   "seconds per input (default: none; 120 with --batch); then the best result so far is "
                   "taken and marked, or the input is refused")
      ->check(within(0.01, 86400.0));
  group
      ->add_option("--max-page-seconds", limits.maxPageSeconds,
                   "processor time to interpret or to draw one page of a document")
      ->check(within(0.01, 86400.0))
      ->capture_default_str();
  group->add_option("--max-document-megabytes", limits.maxDocumentMegabytes, "memory to read a document")
      ->check(within(17.0, 1e6))
      ->capture_default_str();
}

/// The lines of a list file, without empty ones.
std::vector<std::string> listedInputs(std::istream& list) {
  std::vector<std::string> inputs;
  for (std::string line; std::getline(list, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty()) inputs.push_back(line);
  }
  return inputs;
}

/// The inputs, with each list file replaced by the files it lists.
std::vector<std::string> withListsRead(const std::vector<std::string>& inputs) {
  std::vector<std::string> all;
  for (const std::string& input : inputs) {
    if (input != "-" && !input.starts_with('@')) {
      all.push_back(input);
      continue;
    }
    std::ifstream file;
    if (input != "-") file.open(input.substr(1));
    std::istream& list = input == "-" ? std::cin : file;
    const std::vector<std::string> listed = listedInputs(list);
    if (!list.eof())
      throw CLI::ValidationError(
          "INPUT", "the list " + input.substr(1) + " cannot be read; a file of such a name is ./" + input);
    all.insert(all.end(), listed.begin(), listed.end());
  }
  return all;
}

/// The given options, one per line, without those that do not change a result: output paths, number of
/// processes, and form of the report.
std::string settledBy(const CLI::App& app) {
  static const std::set<std::string> besides{"INPUT",    "--batch", "--out-dir",   "--jobs",
                                             "--resume", "--json",  "--json-lines"};
  std::string lines;
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || besides.count(option->get_name())) continue;
    lines += option->get_name();
    for (const std::string& value : option->results()) lines += " " + value;
    lines += "\n";
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    lines += settledBy(*group);
  return lines;
}

/// Returns true for two spellings of one file, whether it exists yet or not.
bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code ignored;
  const auto whole = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  return whole(a) == whole(b) ||
         (std::filesystem::is_regular_file(a, ignored) && std::filesystem::equivalent(a, b, ignored));
}

/// Throws CLI::ValidationError if an output would replace an input or another output.
void refuseOverwriting(const Arguments& a) {
  std::vector<std::pair<std::string, std::string>> taken;  // paths, and what they are called
  for (const std::string& input : a.inputs) taken.emplace_back(input, "INPUT");
  const std::string& release = a.request.hints.releasePath;
  if (!release.empty()) taken.emplace_back(release, "INPUT");
  for (const auto& [option, path] :
       {std::pair("-o", a.buttonPath), std::pair("--csv", a.csvPath), std::pair("--trace-csv", a.tracePath),
        std::pair("--overlay", a.overlayPath), std::pair("--dump-steps", a.stepsPath)}) {
    if (path.empty()) continue;
    for (const auto& [other, name] : taken)
      if (isSameFile(path, other))
        throw CLI::ValidationError(option, "names the file of " + name + "; give it a name of its own");
    taken.emplace_back(path, option);
  }
}

void settle(const RawOptions& raw, Arguments& a) {
  ImportHints& hints = a.request.hints;
  if (raw.page > 0) a.request.page = raw.page;
  if (raw.graph > 0) a.request.graph = raw.graph;
  if (raw.dpi > 0) hints.dpi = raw.dpi;
  if (!raw.frame.empty()) hints.frame = parseCorners(raw.frame);
  if (!raw.xAxis.empty()) parseAxis("--x-axis", raw.xAxis, hints.axes.xMin, hints.axes.xMax);
  if (!raw.yAxis.empty()) parseAxis("--y-axis", raw.yAxis, hints.axes.yMin, hints.axes.yMax);
  if (!raw.xUnit.empty()) {
    hints.axes.xUnit = lengthUnitFrom(raw.xUnit);
    if (!hints.axes.xUnit)
      throw wrong("--x-unit", raw.xUnit, "a unit of length (mm, cm, m, um, nm, in, mil)");
  }
  if (!raw.yUnit.empty()) {
    hints.axes.yUnit = forceUnitFrom(raw.yUnit);
    if (!hints.axes.yUnit)
      throw wrong("--y-unit", raw.yUnit,
                  "a unit of force (N, uN, mN, cN, dN, kN, MN, gf, kgf, ozf, lbf, dyn)");
  }
  if (!raw.pressColor.empty()) hints.trace.pressColor = parseColor("--press-color", raw.pressColor);
  if (!raw.releaseColor.empty()) hints.trace.releaseColor = parseColor("--release-color", raw.releaseColor);
  if (!raw.pressLine.empty()) hints.drawn.press = parseLine("--press-line", raw.pressLine);
  if (!raw.releaseLine.empty()) hints.drawn.release = parseLine("--release-line", raw.releaseLine);
  for (const std::string& mask : raw.masks) hints.trace.masks_px.push_back(parseBox(mask));

  a.json = a.json || a.jsonLines;
  if (a.batch) a.inputs = withListsRead(a.inputs);
  if (a.batch && a.timeLimit_s) a.batchOptions.timeLimit_s = *a.timeLimit_s;
  if (a.batch && a.outDir.empty())
    throw CLI::ValidationError("--batch", "needs --out-dir DIR for its results");
  if (a.family &&
      (a.batch || a.all || a.list || !a.csvPath.empty() || !a.tracePath.empty() || !a.overlayPath.empty()))
    throw CLI::ValidationError(
        "--family", "cannot be combined with --batch, --all, --list, --csv, --trace-csv, --overlay");
  if (a.pair && a.batch) {
    a.releaseOf = pairedFiles(a.inputs);
    for (const auto& [press, release] : a.releaseOf) std::erase(a.inputs, release);
  } else if (a.pair) {
    if (a.inputs.size() != 2 || a.family || a.all)
      throw CLI::ValidationError("--pair", "needs two INPUTs, the press first, and no --family, --all");
    hints.releasePath = a.inputs.back();
    a.inputs.pop_back();
  }
  if (!a.batch && !a.family && a.inputs.size() != 1) {
    throw CLI::ValidationError("INPUT",
                               "one input at a time; pass --batch with --out-dir DIR for several, --family "
                               "for records of one button at several speeds");
  }
  refuseOverwriting(a);
  if (!a.batch && a.withoutOverlays)
    throw CLI::ValidationError("--no-overlays", "is for --batch; without it --overlay asks for one");
  if (a.batch && (a.list || !a.buttonPath.empty() || !a.csvPath.empty() || !a.tracePath.empty() ||
                  !a.overlayPath.empty())) {
    throw CLI::ValidationError(
        "--batch",
        "writes into --out-dir and cannot be combined with --list, -o, --csv, --trace-csv, --overlay");
  }
}

}  // namespace

Parsed parseArguments(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  CLI::App app{
      "Reads the force graph of a push button from a plot, a datasheet page or a force meter's log.\n"
      "It finds everything without hints. Everything it writes is in mm and N.\n"
      "Exit codes: 0 done, 1 internal fault or disk error, 2 wrong usage, 3 input cannot be read,\n"
      "4 no force graph found, 5 found but not certain enough (the message says what to pass), 130 "
      "interrupted."};
  app.name("detent-import");
  app.formatter(std::make_shared<PlainHelp<CLI::Formatter, CLI::Option>>());
  app.set_version_flag("--version", std::string("detent-import ") + version(), "Print the version and exit");
  Arguments arguments;
  RawOptions raw;
  addInputs(app, arguments, raw);
  addOutputs(app, arguments);
  addHints(app, raw, arguments);
  addBatch(app, arguments);
  addLimits(app, arguments);
  try {
    app.parse(argc, argv);
    settle(raw, arguments);
    arguments.settledBy = settledBy(app);
  } catch (const CLI::ParseError& stop) {
    const bool wanted = stop.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help
    app.exit(stop, out, err);
    return {{}, wanted ? 0 : static_cast<int>(FailureCode::wrongUsage)};
  }
  return {std::move(arguments), 0};
}

}  // namespace detent::importer
