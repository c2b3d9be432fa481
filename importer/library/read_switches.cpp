// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/read_switches.h"

#include <algorithm>
#include <optional>

#include "importer/importer.h"
#include "importer/library/switch_name.h"
#include "importer/log/recorded_switches.h"
#include "model/file/button_file.h"
#include "model/text.h"

namespace detent::importer {
namespace {

bool isButtonFile(const std::filesystem::path& path) {
  return lowered(path.filename().string()).ends_with(".button.json");
}

/// One row per state of a button. `name` is what the button's own file or sheet calls it, if it does.
std::optional<Failure> addStates(const Button& button, const std::string& path, const std::string& name,
                                 std::vector<LibrarySwitch>& all) {
  const SwitchName fromFile = switchNameFrom(path);
  for (const ButtonState& state : button.states()) {
    auto shape = feltShapeOf(state.graph);
    if (!shape)
      return Failure{FailureCode::noForceGraph, std::filesystem::path(path).filename().string(),
                     "press stroke", "it ends where it first resists", "Check that it holds a whole press"};
    LibrarySwitch each;
    each.name = name.empty() ? fromFile.name : name;
    if (!state.name.empty()) each.name += " (" + state.name + ")";
    each.unit = fromFile.unit;
    each.run = fromFile.run;
    each.source = path;
    each.part = static_cast<int>(all.size()) + 1;
    each.figures = keyFiguresOf(state);
    each.shape = std::move(*shape);
    all.push_back(std::move(each));
  }
  return {};
}

/// "" for the only switch of a file, else one word for each, as `StrokeHints::curve` takes it.
Result<std::vector<RecordedSwitch>> switchesIn(const std::string& path) {
  if (!holdsRecordedSwitches(path)) return std::vector<RecordedSwitch>(1);
  return recordedSwitches(path);
}

}  // namespace

bool isLibraryFile(const std::filesystem::path& path) { return isForceLogPath(path.string()); }

Result<std::vector<LibrarySwitch>> readSwitches(const std::string& path) {
  std::vector<LibrarySwitch> all;
  if (isButtonFile(path)) {
    const auto button = readButtonFile(path);
    if (!button) return button.failure();
    if (auto failure = addStates(*button, path, button->name(), all)) return std::move(*failure);
    return all;
  }
  const auto recorded = switchesIn(path);
  if (!recorded) return recorded.failure();
  auto session = ImportSession::open(path);
  if (!session) return session.failure();
  ImportRequest request;
  request.path = path;
  request.quality =
      Quality::draft;  // figures of thousands of logs: a fit of 20 ms instead of 300, of the same samples
  for (std::size_t i = 0; i < recorded->size(); ++i) {
    if (recorded->size() > 1) request.hints.strokes.curve = std::to_string(i + 1);
    const auto report = session->importGraph(request);
    if (!report) return report.failure();
    const std::string& own = (*recorded)[i].name;
    const std::string name =
        recorded->size() == 1 ? ""
                              : switchNameFrom(path).name + " " + (own.empty() ? std::to_string(i + 1) : own);
    if (auto failure = addStates(report->button, path, name, all)) return std::move(*failure);
  }
  return all;
}

}  // namespace detent::importer
