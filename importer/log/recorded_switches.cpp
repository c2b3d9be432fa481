// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/recorded_switches.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/text.h"

namespace detent::importer {
namespace {

// -- spreadsheets -------------------------------------------------------------------------------------------

/// A column of numbers with its headings.
struct SheetColumn {
  /// the upper line of a two-line heading, carried to the right over its columns
  std::string title;
  std::string heading;         ///< the line just above the numbers
  std::vector<double> values;  ///< NaN where a cell holds no number
};

/// Returns true for a row of at least three numbers and no more texts than numbers. A row with a word for
/// force is a heading, beside which results of the measurement may stand.
bool isOfNumbers(const Table& sheet, std::size_t row) {
  constexpr int leastNumbers = 3;
  int numbers = 0, texts = 0;
  for (std::size_t c = 0; c < sheet.cells(row); ++c) {
    const std::string_view cell = sheet.cell(row, c);
    if (cell.empty()) continue;
    if (sheet.number(row, c))
      ++numbers;
    else if (lowered(cell).find("force") != std::string::npos)
      return false;
    else
      ++texts;
  }
  return numbers >= leastNumbers && numbers >= texts;
}

std::vector<SheetColumn> headed(const Table& sheet, const std::vector<std::size_t>& above,
                                std::size_t width) {
  std::vector<SheetColumn> columns(width);
  std::string title;
  for (std::size_t i = 0; i < width; ++i) {
    if (above.size() > 1 && !sheet.cell(above[above.size() - 2], i).empty())
      title = std::string(sheet.cell(above[above.size() - 2], i));
    columns[i].title = title;
    if (!above.empty()) columns[i].heading = std::string(sheet.cell(above.back(), i));
  }
  return columns;
}

/// Columns of a sheet; none if no row consists of numbers. Headings are above the first such row.
std::vector<SheetColumn> sheetColumns(const Table& sheet) {
  std::vector<std::size_t> above;
  std::vector<SheetColumn> columns;
  for (std::size_t row = 0; row < sheet.rows(); ++row) {
    const std::size_t width = sheet.cells(row);
    if (columns.empty()) {
      if (!isOfNumbers(sheet, row)) {
        if (width > 0) above.push_back(row);
        continue;
      }
      std::size_t widest = width;
      for (const std::size_t each : above) widest = std::max(widest, sheet.cells(each));
      columns = headed(sheet, above, widest);
    }
    if (width == 0) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto number = sheet.number(row, i);
      columns[i].values.push_back(number ? number->value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return columns;
}

enum class ColumnKind { other, travel, force, contact };

struct NamedColumn {
  ColumnKind kind = ColumnKind::other;
  std::optional<Stroke> stroke;
  std::string name;  // rest of the heading: name of the switch
  LengthUnit unit = LengthUnit::millimetre;
};

bool takeOut(std::string& text, std::string_view words) {
  const std::size_t at = lowered(text).find(words);
  if (at == std::string::npos) return false;
  text.erase(at, words.size());
  return true;
}

/// The title without the words for strokes: "Corrected Upstroke (U4T)" belongs to switch U4T.
std::string nameIn(std::string title) {
  for (const std::string_view words :
       {"corrected", "(downstroke)", "(upstroke)", "downstroke", "upstroke", "raw data"})
    takeOut(title, words);
  std::string_view name = trimmed(title);
  while (!name.empty() && (name.front() == '(' || name.front() == '-')) name = trimmed(name.substr(1));
  while (!name.empty() &&
         (name.back() == '-' || (name.back() == ')' && name.find('(') == std::string_view::npos)))
    name = trimmed(name.substr(0, name.size() - 1));
  return std::string(name);
}

NamedColumn named(const SheetColumn& column) {
  NamedColumn is;
  if (column.heading.empty()) return is;
  const std::string heading = lowered(column.heading), words = lowered(column.title) + " " + heading;
  if (words.find("downstroke") != std::string::npos)
    is.stroke = Stroke::press;
  else if (words.find("upstroke") != std::string::npos)
    is.stroke = Stroke::release;
  if (heading.find("arrow") != std::string::npos || heading.find("points") != std::string::npos) return is;
  if (heading.find("actuated") != std::string::npos)
    is.kind = ColumnKind::contact;
  else if (heading.find("force") != std::string::npos)
    is.kind = ColumnKind::force;
  else if (heading.starts_with("x ") || heading.find(" x ") != std::string::npos)
    is.kind = ColumnKind::travel;
  if (heading.find("micron") != std::string::npos) is.unit = LengthUnit::micrometre;
  is.name = nameIn(column.title);
  return is;
}

/// Columns of travel, force and contact that belong together.
struct StrokeColumns {
  std::size_t travel = 0, force = 0;
  std::optional<std::size_t> contact;
  Stroke stroke = Stroke::press;
};

std::vector<StrokeColumns> strokesIn(const std::vector<NamedColumn>& columns) {
  std::vector<StrokeColumns> strokes;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    if (columns[i].kind != ColumnKind::travel || !columns[i].stroke ||
        columns[i + 1].kind != ColumnKind::force)
      continue;
    StrokeColumns found{i, i + 1, {}, *columns[i].stroke};
    if (i + 2 < columns.size() && columns[i + 2].kind == ColumnKind::contact &&
        columns[i + 2].stroke == columns[i].stroke)
      found.contact = i + 2;
    strokes.push_back(found);
  }
  return strokes;
}

std::vector<CurvePoint> pointsOf(const std::vector<SheetColumn>& sheet, const StrokeColumns& stroke) {
  std::vector<CurvePoint> points;
  for (std::size_t row = 0; row < sheet[stroke.travel].values.size(); ++row) {
    const CurvePoint p{sheet[stroke.travel].values[row], sheet[stroke.force].values[row]};
    if (std::isfinite(p.displacement_mm) && std::isfinite(p.force_N)) points.push_back(p);
  }
  return points;
}

/// Travel at which the contact closes (press) or opens (release), midway between the samples before and
/// after; empty if it does not.
std::optional<double> contactOf(const std::vector<SheetColumn>& sheet, const StrokeColumns& stroke) {
  if (!stroke.contact) return {};
  const double wanted = stroke.stroke == Stroke::press ? 1 : 0;
  const std::vector<double>& states = sheet[*stroke.contact].values;
  // last travel in the other state; a contact that never changes has no such point
  std::optional<double> before;
  for (std::size_t row = 0; row < states.size(); ++row) {
    const double travel = sheet[stroke.travel].values[row];
    if (!std::isfinite(states[row]) || !std::isfinite(travel)) continue;
    if (states[row] != wanted)
      before = travel;
    else if (before)
      return std::midpoint(*before, travel);
  }
  return {};
}

/// Keeps the last run of each name, because a sheet lists the meter's readings first and the edited ones
/// after them. Empty if a run has no name.
std::vector<RecordedSwitch> lastOfEachName(std::vector<RecordedSwitch> runs) {
  std::vector<RecordedSwitch> last;
  for (RecordedSwitch& run : runs) {
    if (run.name.empty()) return {};
    std::erase_if(last, [&](const RecordedSwitch& each) { return each.name == run.name; });
    last.push_back(std::move(run));
  }
  return last;
}

/// Returns the meter's raw runs of a sheet whose stroke columns were left empty: one run, or several with
/// names (of springs, for example).
std::vector<RecordedSwitch> rawRunsOf(const std::vector<SheetColumn>& sheet,
                                      const std::vector<NamedColumn>& columns) {
  std::vector<RecordedSwitch> runs;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    if (columns[i].kind != ColumnKind::travel || columns[i].stroke ||
        columns[i + 1].kind != ColumnKind::force)
      continue;
    RecordedSwitch raw;
    raw.name = columns[i].name;
    raw.run = pointsOf(sheet, {i, i + 1, {}, Stroke::press});
    raw.xUnit = columns[i].unit;
    if (i + 2 < columns.size() && columns[i + 2].kind == ColumnKind::contact) {
      raw.operatingPoint = contactOf(sheet, {i, i + 1, i + 2, Stroke::press});
      if (raw.operatingPoint) raw.resetPoint = contactOf(sheet, {i, i + 1, i + 2, Stroke::release});
    }
    if (raw.run.size() > 1) runs.push_back(std::move(raw));
  }
  return runs.size() > 1 ? lastOfEachName(std::move(runs)) : runs;
}

}  // namespace

std::vector<RecordedSwitch> switchesOfSheet(const Table& table) {
  const std::vector<SheetColumn> sheet = sheetColumns(table);
  std::vector<NamedColumn> columns;
  std::ranges::transform(sheet, std::back_inserter(columns), named);
  std::vector<RecordedSwitch> switches;
  for (const StrokeColumns& stroke : strokesIn(columns)) {
    const NamedColumn& column = columns[stroke.travel];
    if (stroke.stroke == Stroke::press) {
      RecordedSwitch one;
      one.name = column.name, one.xUnit = column.unit;
      one.press = pointsOf(sheet, stroke);
      one.operatingPoint = contactOf(sheet, stroke);
      switches.push_back(std::move(one));
    } else if (!switches.empty() && switches.back().release.empty()) {
      switches.back().release = pointsOf(sheet, stroke);
      switches.back().resetPoint = contactOf(sheet, stroke);
      if (switches.back().name.empty()) switches.back().name = column.name;
    }
  }
  std::erase_if(switches, [](const RecordedSwitch& each) { return each.press.size() < 2; });
  if (switches.empty()) switches = rawRunsOf(sheet, columns);
  return switches;
}

namespace {

// -- JSON ---------------------------------------------------------------------------------------------------

std::vector<double> numbersAt(const nlohmann::json& object, const char* key) {
  std::vector<double> numbers;
  const auto list = object.find(key);
  if (list == object.end() || !list->is_array()) return numbers;
  for (const nlohmann::json& each : *list)
    numbers.push_back(each.is_number() ? each.get<double>() : std::nan(""));
  return numbers;
}

std::optional<double> firstOf(const nlohmann::json& object, const char* key) {
  const std::vector<double> numbers = numbersAt(object, key);
  return !numbers.empty() && std::isfinite(numbers.front()) ? std::optional(numbers.front()) : std::nullopt;
}

std::vector<CurvePoint> paired(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i])) points.push_back({x[i], y[i]});
  return points;
}

}  // namespace

bool keepsStrokesApart(const nlohmann::json& json) {
  return isDigitizerProject(json) ||
         (json.is_object() && (json.contains("resources") || json.contains("down_x")));
}

Result<std::vector<RecordedSwitch>> switchesOfJson(const nlohmann::json& json, const std::string& subject) {
  if (isDigitizerProject(json)) return switchesOfProject(json, subject);
  if (json.is_discarded())
    return unreadableFile(subject, Message("the file is not JSON"),
                          Message("Export the file again: it may have been cut off"));
  if (json.is_object() && json.contains("resources"))
    return noForceLog(subject, Message("the file is the description of a data package"),
                      Message("Import the CSV file of its curve, which is in the same folder"));
  if (!json.is_object() || !json.contains("down_x") || !json.contains("down_y"))
    return noForceLog(subject, Message("the file holds no strokes"),
                      Message("A recording has the lists down_x, down_y and up_y"));
  RecordedSwitch one;
  const std::vector<double> x = numbersAt(json, "down_x");
  one.press = paired(x, numbersAt(json, "down_y"));
  // The tester stores the forces of the release from the deepest displacement on, so they are paired with the
  // press's displacements in reverse.
  one.release = paired({x.rbegin(), x.rend()}, numbersAt(json, "up_y"));
  one.operatingPoint = firstOf(json, "pressPoint");
  one.resetPoint = firstOf(json, "releasePoint");
  one.scaleDoubtful = true;
  if (one.press.size() < 2) return noForceLog(subject, Message("the lists of the recording hold no press"));
  return std::vector{std::move(one)};
}

Result<std::vector<RecordedSwitch>> switchesOfArchive(const std::string& bytes, const std::string& subject) {
  const auto project = projectInArchive(bytes, subject);
  if (!project) return project.failure();
  const nlohmann::json json = nlohmann::json::parse(*project, nullptr, false);
  if (isDigitizerProject(json)) return switchesOfProject(json, subject);
  return unreadableFile(subject,
                        json.is_discarded()
                            ? Message("the file wpd.json in the archive is not JSON")
                            : Message("the file wpd.json in the archive is not a WebPlotDigitizer project"),
                        Message("Save the project once more in WebPlotDigitizer"));
}

}  // namespace detent::importer
