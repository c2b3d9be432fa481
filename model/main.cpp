// SPDX-License-Identifier: GPL-3.0-or-later
// detent-graph: shows, checks, converts and compares force graphs.
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/graph_program.h"
#include "model/program/command_line.h"
#include "model/version.h"

namespace {

using namespace detent;

// Prints text to stdout; with --json JSON to stdout and text to stderr. Failures go to stderr.
int print(const Result<Report>& result, bool asJson) {
  const Report report = result ? *result : failureReport(result.failure());
  std::fputs(report.text.c_str(), result && !asJson ? stdout : stderr);
  if (asJson) std::fputs(report.json.c_str(), stdout);
  return codeAfterOutput(result ? 0 : result.failure().exitCode());
}

struct Arguments {
  std::string a, b;
  std::vector<std::string> units;
  std::vector<double> speeds_mm_per_s;
  std::string forceUnit = "N", lengthUnit = "mm";
  bool json = false, noCallouts = false;
  ConvertOptions convert;
  CompareOptions compare;
};

Result<Report> convert(Arguments& arguments) {
  const auto force = forceUnitFrom(arguments.forceUnit);
  const auto length = lengthUnitFrom(arguments.lengthUnit);
  if (!force || !length)
    return Failure{FailureCode::wrongUsage, Subject::option(force ? "--length-unit" : "--force-unit"), "",
                   "the name is not that of a known unit: \"" +
                       (force ? arguments.lengthUnit : arguments.forceUnit) + "\"",
                   force ? "Use mm, cm, µm, in or mil" : "Use N, mN, cN, gf, kgf, ozf or lbf"};
  arguments.convert.svg.forceUnit = *force;
  arguments.convert.svg.lengthUnit = *length;
  arguments.convert.svg.callouts = !arguments.noCallouts;
  return convertGraph(arguments.a, arguments.b, arguments.convert);
}

void addCommands(CLI::App& app, Arguments& arguments) {
  const auto addJson = [&](CLI::App* command) {
    command->add_flag("--json", arguments.json, "one JSON object on stdout (text goes to stderr)");
  };
  CLI::App* show =
      app.add_subcommand("show", "Print travel (mm), tactile points, sections, work (mJ) and more");
  show->add_option("FILE", arguments.a, ".button.json or .csv")->required();
  addJson(show);
  CLI::App* check = app.add_subcommand("check", "Check a file: exit 0 and warnings if valid, exit 3 if not");
  check->add_option("FILE", arguments.a, ".button.json or .csv")->required();
  addJson(check);

  CLI::App* convertCommand = app.add_subcommand(
      "convert",
      "Convert between .button.json, .csv and .svg by file ending; also to a data package or a project");
  convertCommand->add_option("IN", arguments.a, ".button.json or .csv")->required();
  convertCommand
      ->add_option(
          "OUT", arguments.b,
          ".button.json, .csv, .svg, datapackage.json (with its tables beside it) or\n"
          ".wpd.json or .tar (WebPlotDigitizer, without and with its picture); written whole or not at all")
      ->required();
  convertCommand->add_option("--state", arguments.convert.state,
                             "state of a self-locking button for a CSV or a project (default: the only one)");
  convertCommand->add_option(
      "--speed", arguments.convert.speed_mm_per_s,
      "for a button with graphs at several speeds: write the graph of this speed, mm/s\n"
      "(default: all, or the one in front if the output holds only one)");
  CLI::Option* travelStep = convertCommand->add_option(
      "--travel-step", arguments.convert.travelStep_mm,
      "write the force at each multiple of this travel, mm, to the CSV instead of samples");
  CLI::Option* travels =
      convertCommand
          ->add_option("--travels", arguments.convert.travels_mm,
                       "write the force at these travels, mm, with commas between them: 0.5,1,2")
          ->delimiter(',')
          ->excludes(travelStep);
  convertCommand
      ->add_option("--force-step", arguments.convert.forceStep_N,
                   "write the travel at each multiple of this force, N, to the CSV instead of samples")
      ->excludes(travelStep)
      ->excludes(travels);
  convertCommand
      ->add_option("--force-unit", arguments.forceUnit,
                   "unit of the SVG's and project's force axis: N, mN, cN, gf, kgf, ozf, lbf")
      ->capture_default_str();
  convertCommand
      ->add_option("--length-unit", arguments.lengthUnit,
                   "unit of the displacement axis: mm, cm, µm, in, mil")
      ->capture_default_str();
  convertCommand
      ->add_option("--width", arguments.convert.svg.width_px, "width of the SVG in px, 200 to 20000")
      ->capture_default_str();
  convertCommand
      ->add_option("--height", arguments.convert.svg.height_px,
                   "height of one state's plot in px, 200 to 20000")
      ->capture_default_str();
  convertCommand->add_flag("--no-callouts", arguments.noCallouts,
                           "leave out the labels of tactile points in the SVG");
  addJson(convertCommand);

  CLI::App* average = app.add_subcommand(
      "average", "Average several measured units of a button: mean curve, spread of each figure, outliers");
  average->add_option("UNIT", arguments.units, ".button.json or .csv of units of one button, at least two")
      ->required()
      ->expected(2, 10000);
  average->add_option("-o,--output", arguments.b, ".button.json of the mean; written whole or not at all")
      ->required();
  addJson(average);

  CLI::App* family = app.add_subcommand(
      "family", "Combine two to four graphs of a button, each pressed at another speed, into one button");
  family
      ->add_option("GRAPH", arguments.units,
                   ".button.json or .csv; the first is used where no speed is known")
      ->required()
      ->expected(2, 4);
  family->add_option("--speeds", arguments.speeds_mm_per_s, "speed of each, mm/s, in the same order")
      ->required()
      ->delimiter(',');
  family->add_option("-o,--output", arguments.b, ".button.json; written whole or not at all")->required();
  addJson(family);

  CLI::App* compareCommand =
      app.add_subcommand("compare", "Print the orthogonal distance of two graphs in mm, N and % of A's span");
  compareCommand->add_option("A", arguments.a, ".button.json or .csv")->required();
  compareCommand->add_option("B", arguments.b, ".button.json or .csv")->required();
  compareCommand->add_option("--state-a", arguments.compare.stateA,
                             "state of A, if it is self-locking (default: the only one)");
  compareCommand->add_option("--state-b", arguments.compare.stateB,
                             "state of B, if it is self-locking (default: the only one)");
  addJson(compareCommand);
  app.require_subcommand(1);
}

Result<Report> run(const CLI::App& app, Arguments& arguments) {
  if (app.got_subcommand("show")) return showGraph(arguments.a);
  if (app.got_subcommand("check")) return checkGraph(arguments.a);
  if (app.got_subcommand("convert")) return convert(arguments);
  if (app.got_subcommand("average")) return averageGraphs(arguments.units, arguments.b);
  if (app.got_subcommand("family"))
    return familyOfGraphs(arguments.units, arguments.speeds_mm_per_s, arguments.b);
  return compareGraphs(arguments.a, arguments.b, arguments.compare);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Force graphs of buttons: displacement in mm, force in N.", "detent-graph"};
  app.formatter(std::make_shared<PlainHelp<CLI::Formatter, CLI::Option>>());
  app.footer(
      "Exit codes: 0 done, 1 internal fault or disk error, 2 wrong usage, 3 input cannot be read,\n"
      "4 no force graph in it, 5 not certain (the message says what to pass).");
  app.set_version_flag("--version", std::string("detent-graph ") + version(), "Print the version and exit");
  Arguments arguments;
  addCommands(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(FailureCode::wrongUsage);
  }
  return print(run(app, arguments), arguments.json);
} catch (const std::exception& error) {
  std::fprintf(stderr, "internal fault: %s. Please report it with the input.\n", error.what());
  return static_cast<int>(FailureCode::internalFault);
}
