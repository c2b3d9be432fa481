// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/graph_program.h"

#include <filesystem>

#include "model/file/button_file.h"
#include "model/file/curve_csv.h"
#include "model/file/data_package.h"
#include "model/file/force_steps.h"
#include "model/file/text_file.h"
#include "model/file/traced_project.h"
#include "model/file/travel_steps.h"
#include "model/speed_family.h"
#include "model/text.h"

namespace detent {
namespace {

bool endsWith(const std::string& path, std::string_view suffix) {
  if (path.size() < suffix.size()) return false;
  for (std::size_t i = 0; i < suffix.size(); ++i) {
    const char c = path[path.size() - suffix.size() + i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != suffix[i]) return false;
  }
  return true;
}

Failure usage(Subject subject, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, std::move(subject), "", std::move(problem), std::move(remedies)};
}

std::string stateNames(const Button& button) {
  std::string names;
  for (const ButtonState& state : button.states()) names += (names.empty() ? "" : ", ") + state.name;
  return names;
}

// Returns the state by name; the only one if no name is given.
Result<ButtonState> chosenState(const Button& button, const std::string& name, const std::string& path,
                                const char* option) {
  if (name.empty() && button.states().size() == 1) return button.states().front();
  if (name.empty())
    return Failure{FailureCode::notCertain, path, "",
                   "the button has two states (" + stateNames(button) + "), but one was expected",
                   std::string("Name one with ") + option};
  for (const ButtonState& state : button.states())
    if (state.name == name) return state;
  return usage(path, "the button has no state \"" + name + "\"",
               "Name one of its states: " + stateNames(button));
}

// Rows of a CSV unchanged, or samples of a button's curves.
Result<GraphPolylines> readPolylines(const std::string& path, const std::string& state, const char* option) {
  auto kind = kindOfFile(path);
  if (!kind) return kind.failure();
  if (*kind == GraphFileKind::csv) {
    auto text = readTextFile(path);
    if (!text) return text.failure();
    return polylinesFromCsv(*text, path);
  }
  auto button = readButton(path);
  if (!button) return button.failure();
  auto chosen = chosenState(*button, state, path, option);
  if (!chosen) return chosen.failure();
  return polylinesOf(chosen->graph);
}

std::string stemOf(const std::string& path) {
  std::string stem = std::filesystem::path(path).filename().string();
  return stem.substr(0, stem.find('.', 1));
}

Result<std::string> contentsFor(const ButtonFile& read, const std::string& in, const std::string& out,
                                const ConvertOptions& options) {
  const Button& button = read.button;
  auto kind = kindOfFile(out);
  if (!kind) return kind.failure();
  if (*kind == GraphFileKind::button) return jsonFrom(button, read.cutout, read.annotations);
  if (*kind == GraphFileKind::svg) return svgFrom(button, options.svg);
  auto state = chosenState(button, options.state, in, "--state");
  if (!state) return state.failure();
  if (*kind == GraphFileKind::tracedProject) return tracedProjectFrom(*state, options.svg);
  if (*kind == GraphFileKind::tracedArchive) return tracedArchiveFrom(*state, options.svg);
  if (options.forceStep_N) return forceStepsFrom(state->graph, *options.forceStep_N);
  if (options.travelStep_mm || !options.travels_mm.empty()) {
    auto travels_mm = options.travelStep_mm ? travelsAtEach(*options.travelStep_mm, state->graph)
                                            : travelsWithin(options.travels_mm, state->graph);
    if (travels_mm) return csvAtTravels(*travels_mm, state->graph);
    Failure failure = travels_mm.failure();
    failure.subject = Subject::option(options.travelStep_mm ? "--travel-step" : "--travels");
    return failure;
  }
  return csvFrom(state->graph);
}

Result<ButtonFile> readFile(const std::string& path) {
  auto kind = kindOfFile(path);
  if (!kind) return kind.failure();
  if (*kind == GraphFileKind::svg)
    return usage(path, "this is a picture, which this program only writes",
                 "Use detent-import to read a force graph from it");
  if (*kind == GraphFileKind::tracedProject || *kind == GraphFileKind::tracedArchive)
    return usage(path, "this is a project of WebPlotDigitizer, which this program only writes",
                 "Use detent-import to read the strokes in it");
  if (*kind == GraphFileKind::dataPackage)
    return usage(path, "this is the description of a data package, which this program only writes",
                 "Name the CSV file of its curve instead");
  if (*kind == GraphFileKind::button) return readWholeButtonFile(path);
  auto text = readTextFile(path);
  if (!text) return text.failure();
  auto graph = graphFromCsv(*text, path);
  if (!graph) return graph.failure();
  auto button = Button::fromStates(stemOf(path), {ButtonState{"", *std::move(graph), {}, {}, {}}});
  if (!button) return button.failure();
  return ButtonFile{*std::move(button)};
}

}  // namespace

Result<GraphFileKind> kindOfFile(const std::string& path) {
  if (lowered(std::filesystem::path(path).filename().string()) == "datapackage.json")
    return GraphFileKind::dataPackage;
  // Readers expect this exact name, and the tables of two packages in one folder would collide.
  if (endsWith(path, ".datapackage.json"))
    return usage(path, "this is not the name of a data package: its description is called datapackage.json",
                 "Give each package a folder of its own: FOLDER/datapackage.json");
  if (endsWith(path, ".wpd.json")) return GraphFileKind::tracedProject;
  if (endsWith(path, ".tar")) return GraphFileKind::tracedArchive;
  if (endsWith(path, ".json")) return GraphFileKind::button;
  if (endsWith(path, ".csv")) return GraphFileKind::csv;
  if (endsWith(path, ".svg")) return GraphFileKind::svg;
  return usage(
      path, "the name does not end in .button.json, .csv or .svg",
      "Give the file one of these endings; convert also writes datapackage.json, .wpd.json and .tar");
}

Result<Button> readButton(const std::string& path) {
  auto file = readFile(path);
  if (!file) return file.failure();
  return std::move(file->button);
}

Result<Report> showGraph(const std::string& path) {
  auto button = readButton(path);
  if (!button) return button.failure();
  return showReport(*button, path);
}

Result<Report> checkGraph(const std::string& path) {
  auto button = readButton(path);
  if (!button) return button.failure();
  return checkReport(*button, validate(*button), path);
}

Result<Report> convertGraph(const std::string& in, const std::string& out, const ConvertOptions& options) {
  const auto kind = kindOfFile(out);
  if (!kind) return kind.failure();
  const char* const sampling = options.forceStep_N           ? "--force-step"
                               : options.travelStep_mm       ? "--travel-step"
                               : !options.travels_mm.empty() ? "--travels"
                                                             : nullptr;
  if (sampling && *kind != GraphFileKind::csv)
    return usage(Subject::option(sampling), "this option is for a .csv alone",
                 "Leave it out, or write a .csv");
  if (!(options.svg.width_px > 200 && options.svg.height_px > 200 && options.svg.width_px <= 20000 &&
        options.svg.height_px <= 20000))
    return usage("plot size", "the size is not between 200 and 20000 px", "Choose a size such as 640 by 460");
  auto file = readFile(in);
  if (!file) return file.failure();
  if (options.speed_mm_per_s) {
    if (speedsOf(file->button).empty())
      return usage(Subject::option("--speed"), "this option is for a button with graphs at several speeds",
                   "Leave it out");
    auto one = atSpeed(file->button, *options.speed_mm_per_s);
    if (!one) return one.failure();
    file->button = *std::move(one);
  }
  if (*kind == GraphFileKind::dataPackage) {
    if (auto written = writeDataPackage(file->button, out); !written) return written.failure();
    return convertReport(file->button, in, out);
  }
  auto contents = contentsFor(*file, in, out, options);
  if (!contents) return contents.failure();
  if (auto written = writeTextFileAtomically(out, *contents); !written) return written.failure();
  return convertReport(file->button, in, out);
}

Result<Report> averageGraphs(const std::vector<std::string>& units, const std::string& out) {
  const auto kind = kindOfFile(out);
  if (!kind) return kind.failure();
  if (*kind != GraphFileKind::button)
    return usage(out, "this is not the name of a button file", "Give the output the ending .button.json");
  std::vector<Button> buttons;
  for (const std::string& unit : units) {
    auto button = readButton(unit);
    if (!button) return button.failure();
    buttons.push_back(std::move(*button));
  }
  auto spread = spreadOf(buttons);
  if (!spread) return spread.failure();
  if (auto written = writeButtonFile(out, spread->mean); !written) return written.failure();
  return averageReport(*spread, units, out);
}

Result<Report> familyOfGraphs(const std::vector<std::string>& paths,
                              const std::vector<double>& speeds_mm_per_s, const std::string& out) {
  const auto kind = kindOfFile(out);
  if (!kind) return kind.failure();
  if (*kind != GraphFileKind::button)
    return usage(out, "this is not the name of a button file", "Give the output the ending .button.json");
  std::vector<Button> buttons;
  for (const std::string& path : paths) {
    auto button = readButton(path);
    if (!button) return button.failure();
    buttons.push_back(std::move(*button));
  }
  auto family = familyOf(buttons, speeds_mm_per_s);
  if (!family) return family.failure();
  if (auto written = writeButtonFile(out, *family); !written) return written.failure();
  return convertReport(*family, paths.front(), out, "family");
}

Result<Report> compareGraphs(const std::string& a, const std::string& b, const CompareOptions& options) {
  auto first = readPolylines(a, options.stateA, "--state-a");
  if (!first) return first.failure();
  auto second = readPolylines(b, options.stateB, "--state-b");
  if (!second) return second.failure();
  auto distance = compare(*first, *second);
  if (!distance) return distance.failure();
  return compareReport(*distance, a, b);
}

}  // namespace detent
