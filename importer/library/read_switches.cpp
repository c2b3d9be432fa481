// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/read_switches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "importer/importer.h"
#include "importer/library/measured_figures.h"
#include "importer/library/switch_name.h"
#include "importer/log/force_log.h"
#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "model/sha256.h"
#include "model/text.h"

namespace detent::importer {
namespace {

bool isButtonFile(const std::filesystem::path& path) {
  return lowered(path.filename().string()).ends_with(".button.json");
}

/// For thousands of logs: a fit of the same samples takes 20 ms instead of 300.
constexpr Quality forFigures = Quality::draft;

/// One state of a button in a file.
struct ReadState {
  ButtonState state;
  std::string name;
  std::optional<Provenance> provenance;
  std::optional<MeasuredFigures> measured = {};
  bool scaleDoubtful = false;
};

bool hasDoubtfulScale(const ImportReport& report) {
  return std::ranges::any_of(report.remarks,
                             [](const Remark& each) { return each.code == RemarkCode::forceScaleDoubtful; });
}

/// Adds the states of a button. `name`: the name in the button's own file or sheet; empty without one.
void addStates(const Button& button, const std::string& name, std::vector<ReadState>& all) {
  for (const ButtonState& state : button.states())
    all.push_back({state, state.name.empty() ? name : name + " (" + state.name + ")", button.provenance()});
}

/// Names of the switches that are separate records of a file; one empty name for a file with a single record.
std::vector<std::string> switchesIn(const std::string& path) {
  std::vector<std::string> names = recordNames(path);
  // Several cycles of one switch have no names.
  if (names.size() < 2 || std::ranges::any_of(names, [](const std::string& each) { return each.empty(); }))
    return {""};
  return names;
}

KeyFigures peakErrorsOf(const ImportReport& report) {
  const KeyFigures figures = keyFiguresOf(report.button.states().front());
  KeyFigures sigmas;
  const auto& travel_mm = figures[KeyFigure::peakTravel];
  const auto& points = report.press.fit.tactilePoints;
  if (!travel_mm || points.empty() || !report.evidence) return sigmas;
  const FittedTactilePoint& peak = *std::ranges::min_element(points, {}, [&](const FittedTactilePoint& each) {
    return std::abs(each.point.displacement_mm - *travel_mm);
  });
  const AxisCalibration& axes = report.evidence->axes.calibration.value;
  sigmas[KeyFigure::peakTravel] = std::hypot(peak.sigma_mm, report.x->residual_px * axes.mmPerPx());
  sigmas[KeyFigure::peakForce] = std::hypot(peak.sigma_N, report.y->residual_px * axes.newtonPerPx());
  return sigmas;
}

std::vector<ReadState> statesOfPage(const std::vector<PageButton>& buttons, const std::string& path) {
  const std::string name = switchNameFrom(path).name;
  std::vector<ReadState> all;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    const std::size_t first = all.size();
    addStates(buttons[i].button, buttons.size() == 1 ? name : name + " graph " + std::to_string(i + 1), all);
    all[first].measured = {keyFiguresOf(all[first].state), buttons[i].sigmas};
  }
  return all;
}

/// Every state of every switch in a file.
Result<std::vector<ReadState>> readStates(const std::string& path, const std::string& releasePath,
                                          Quality quality, bool errors) {
  std::vector<ReadState> all;
  const std::string fileName = switchNameFrom(releasePath.empty() ? path : withoutStrokeWord(path)).name;
  if (isButtonFile(path)) {
    const auto button = readButtonFile(path);
    if (!button) return button.failure();
    addStates(*button, button->name().empty() ? fileName : button->name(), all);
    return all;
  }
  if (isPageFile(path)) {
    const auto buttons = readPageButtons(path, quality);
    if (!buttons) return buttons.failure();
    return statesOfPage(*buttons, path);
  }
  const std::vector<std::string> recorded =
      releasePath.empty() ? switchesIn(path) : std::vector<std::string>{""};
  auto session = ImportSession::open(path);
  if (!session) return session.failure();
  ImportRequest request;
  request.path = path;
  request.quality = quality;
  request.hints.releasePath = releasePath;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (recorded.size() > 1) request.hints.strokes.curve = std::to_string(i + 1);
    const auto report = session->importGraph(request);
    if (!report) return report.failure();
    const std::string& own = recorded[i];
    addStates(report->button,
              recorded.size() == 1 ? fileName : fileName + " " + (own.empty() ? std::to_string(i + 1) : own),
              all);
    if (errors) all.back().measured = measuredFiguresOf(*report);
    all.back().scaleDoubtful = hasDoubtfulScale(*report);
  }
  return all;
}

/// The file with the release of a press; empty if there is none.
std::string releaseBeside(const std::string& path) {
  if (withoutStrokeWord(path) == path) return {};
  std::vector<std::string> folder;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(path).parent_path(), error))
    folder.push_back(entry.path().string());
  const auto pairs = pairedFiles(folder);
  const auto pair = pairs.find(path);
  return pair == pairs.end() ? std::string() : pair->second;
}

/// Library rows for the contents of a file.
Result<std::vector<LibrarySwitch>> rowsOf(const std::vector<ReadState>& states, const std::string& path) {
  const SwitchName fromFile = switchNameFrom(withoutStrokeWord(path));
  std::vector<LibrarySwitch> all;
  for (const ReadState& read : states) {
    auto shape = feltShapeOf(read.state.graph);
    if (!shape)
      return Failure{FailureCode::noForceGraph, std::filesystem::path(path).filename().string(),
                     "press stroke", "it ends where it first resists", "Check that it holds a whole press"};
    LibrarySwitch each;
    each.name = read.name;
    each.unit = fromFile.unit;
    each.run = fromFile.run;
    each.source = path;
    each.part = static_cast<int>(all.size()) + 1;
    each.figures = read.measured ? read.measured->figures : keyFiguresOf(read.state);
    if (read.measured) each.sigmas = read.measured->sigmas;
    forgetContactBump(each.figures, each.sigmas, read.state.graph.press().start_mm());
    each.scaleDoubtful = read.scaleDoubtful;
    each.shape = std::move(*shape);
    all.push_back(std::move(each));
  }
  return all;
}

}  // namespace

bool isLibraryFile(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 6> endings{".csv", ".tsv", ".xlsx", ".ods", ".json", ".tar"};
  return std::ranges::find(endings, lowered(path.extension().string())) != endings.end();
}

Result<std::vector<LibrarySwitch>> readSwitches(const std::string& path, bool errors,
                                                const std::string& releasePath) {
  const auto states = readStates(path, releasePath, forFigures, errors);
  if (!states) return states.failure();
  return rowsOf(*states, path);
}

Result<std::string> contentHash(const std::string& path, const std::string& releasePath) {
  auto content = readTextFile(path);
  if (content && !releasePath.empty()) {
    const auto release = readTextFile(releasePath);
    if (!release) return release.failure();
    *content += *release;
  }
  return content ? Result<std::string>(sha256Hex(*content)) : content.failure();
}

bool isPageFile(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 10> endings{".pdf", ".svg", ".png",  ".jpg",  ".jpeg",
                                                     ".bmp", ".tif", ".tiff", ".webp", ".gif"};
  return std::ranges::find(endings, lowered(path.extension().string())) != endings.end();
}

Result<std::vector<PageButton>> readPageButtons(const std::string& path, Quality quality) {
  auto session = ImportSession::open(path);
  if (!session) return session.failure();
  const auto graphs = session->list({}, quality);
  if (!graphs) return graphs.failure();
  std::vector<PageButton> buttons;
  std::optional<Failure> why;
  for (const ListedGraph& graph : graphs->graphs) {
    ImportRequest request;
    request.path = path;
    request.quality = quality;
    request.page = graph.page;
    request.graph = graph.graph;
    const auto report = session->importGraph(request);
    if (report)
      buttons.push_back({report->button, peakErrorsOf(*report)});
    else if (!why)
      why = report.failure();
  }
  if (!buttons.empty()) return buttons;
  if (why) return *why;
  return Failure{FailureCode::noForceGraph, std::filesystem::path(path).filename().string(), "",
                 "no force graph was found in it", "Import it by itself and give what is missing by hand"};
}

Result<std::vector<LibrarySwitch>> switchesOfPage(const std::vector<PageButton>& buttons,
                                                  const std::string& path) {
  return rowsOf(statesOfPage(buttons, path), path);
}

Result<Button> buttonOf(const LibrarySwitch& entry, Quality quality) {
  const std::string release = releaseBeside(entry.source);
  const auto hash = contentHash(entry.source, release);
  const Failure changed{FailureCode::unreadableInput, entry.source, "", "it has changed since it was indexed",
                        "Index its folder again"};
  if (!hash) return hash.failure();
  if (*hash != entry.sha256) return changed;
  auto states = readStates(entry.source, release, quality, false);
  if (!states) return states.failure();
  const auto part = static_cast<std::size_t>(entry.part);
  if (part > states->size()) return changed;
  ReadState& read = (*states)[part - 1];
  read.state.name.clear();
  std::string name = read.name;
  if (!entry.unit.empty()) name += " unit " + entry.unit;
  if (!entry.run.empty()) name += " run " + entry.run;
  return Button::fromStates(name, {std::move(read.state)}, std::move(read.provenance));
}

}  // namespace detent::importer
