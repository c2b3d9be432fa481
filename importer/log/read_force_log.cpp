// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <span>

#include <nlohmann/json.hpp>

#include "importer/log/force_log.h"
#include "importer/log/form_records.h"
#include "importer/log/interpret_columns.h"
#include "importer/log/recorded_switches.h"
#include "importer/log/split_strokes.h"
#include "model/number_table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr std::size_t kMostText_bytes = std::size_t{256} << 20;
constexpr std::size_t kMostArchive_bytes = std::size_t{32} << 20;
constexpr std::size_t kMostSamples = std::size_t{1} << 20;
// share of the span; readings that differ by less describe the same button
constexpr double kSameButton = 0.01;
constexpr double kStrokesApart = 6;  // evidence that a file is a log if it stores strokes separately

std::string fileNameOf(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// Halves the number of samples; each new one is the mean of two.
void halve(std::vector<CurvePoint>& samples) {
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
    const CurvePoint &a = samples[i], &b = samples[i + 1];
    samples[i / 2] = {0.5 * (a.displacement_mm + b.displacement_mm), 0.5 * (a.force_N + b.force_N)};
  }
  samples.resize(samples.size() / 2);
}

/// JSON as a table: objects with numbers as rows, or lists of numbers as named columns. nullopt if it is
/// neither.
std::optional<Table> tableOfJson(const nlohmann::json& json) {
  Table table;
  const auto unitIn = [&](const std::string& key) -> std::string {
    if (!json.is_object()) return {};
    for (const char* units : {"units", "unit"})
      if (json.contains(units) && json[units].is_object() && json[units].contains(key) &&
          json[units][key].is_string())
        return " (" + json[units][key].get<std::string>() + ")";
    return {};
  };
  const auto cellText = [](const nlohmann::json& cell) {
    return cell.is_number()    ? shortestText(cell.get<double>())
           : cell.is_string()  ? cell.get<std::string>()
           : cell.is_boolean() ? std::string(cell.get<bool>() ? "1" : "0")
                               : std::string();
  };
  const nlohmann::json* records = json.is_array() ? &json : nullptr;
  if (json.is_object())
    for (const auto& [key, value] : json.items())
      if (value.is_array() && value.size() >= 2 && value.front().is_object() &&
          (!records || value.size() > records->size()))
        records = &value;
  if (records && records->size() >= 2 && records->front().is_object()) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : records->front().items()) keys.push_back(key);
    table.beginRow(1);
    for (const std::string& key : keys) table.addOwnCell(key + unitIn(key));
    long line = 1;
    for (const nlohmann::json& record : *records) {
      table.beginRow(++line);
      for (const std::string& key : keys)
        table.addOwnCell(record.is_object() && record.contains(key) ? cellText(record[key]) : "");
    }
    return table;
  }
  if (!json.is_object()) return {};
  std::vector<std::pair<std::string, const nlohmann::json*>> lists;
  std::size_t longest = 0;
  for (const auto& [key, value] : json.items())
    if (value.is_array() && value.size() >= 2 && value.front().is_number())
      lists.emplace_back(key, &value), longest = std::max(longest, value.size());
  if (lists.size() < 2) return {};
  table.beginRow(1);
  for (const auto& [key, list] : lists) table.addOwnCell(key + unitIn(key));
  for (std::size_t i = 0; i < longest; ++i) {
    table.beginRow(static_cast<long>(i) + 2);
    for (const auto& [key, list] : lists) table.addOwnCell(i < list->size() ? cellText((*list)[i]) : "");
  }
  return table;
}

/// A file's records, before one is chosen.
struct FileRecords {
  std::vector<LogRecord> records;
  // Of tables:
  std::optional<Table> table;
  std::optional<DataTable> data;
  std::vector<LogInterpretation> best;
  // Of files that keep strokes apart:
  std::vector<RecordedSwitch> switches;
  struct Units {
    AssumedUnit x, y;
    Evidence evidence;
  };
  BestFew<Units> units{12};  // readings
  AssumedUnit xUnit, yUnit;
};

class LogReader {
 public:
  LogReader(const std::string& path, const LogHints& hints, const Progress& progress)
      : path_(path), hints_(hints), progress_(progress) {}

  LogReading read() {
    auto found = recordsOf(path_, false);
    if (!found) return ended(found.failure());
    reading_.best = explained(*found);
    for (const LogRecord& each : found->records) reading_.records.push_back(listed(each));
    auto record = chosen(*found);
    if (!record) return ended(record.failure());
    if (!hints_.releasePath.empty())
      if (auto fault = addRelease(*record)) return ended(*fault);
    if (auto fault = finish(*found, std::move(*record))) return ended(*fault);
    rate(*found);
    reading_.log = std::move(log_);
    return std::move(reading_);
  }

 private:
  LogReading ended(Failure failure) {
    reading_.log = std::move(failure);
    return std::move(reading_);
  }

  Failure failure(FailureCode code, Message place, Message problem, Remedies remedies) const {
    return {code, fileNameOf(path_), std::move(place), std::move(problem), std::move(remedies)};
  }

  void remark(Message words) { log_.remarks.push_back({RemarkCode::doubted, {std::move(words)}}); }

  static ListedRecord listed(const LogRecord& record) {
    ListedRecord entry{record.name, 0, 0, !record.release.empty()};
    const auto [low, high] = std::ranges::minmax(record.press, {}, &CurvePoint::displacement_mm);
    entry.travel_mm = high.displacement_mm - low.displacement_mm;
    for (const CurvePoint& p : record.press) entry.highest_N = std::max(entry.highest_N, p.force_N);
    return entry;
  }

  static std::vector<ExplainedInterpretation> explained(const FileRecords& found) {
    std::vector<ExplainedInterpretation> best;
    constexpr std::size_t shown = 3;
    for (std::size_t i = 0; i < std::min(shown, found.best.size()); ++i)
      best.push_back({found.best[i].reading(*found.data), found.best[i].evidence});
    return best;
  }

  // -- the file ---------------------------------------------------------------------------------------------

  Result<std::string> bytesOf(const std::string& path) const {
    const auto unreadable = [&](Message problem, const Message& remedy) {
      return unreadableFile(fileNameOf(path), std::move(problem), remedy);
    };
    std::error_code error;
    if (!std::filesystem::exists(path, error))
      return unreadable(Message("the file does not exist"), Message("Check the path and its permissions"));
    if (std::filesystem::is_directory(path, error))
      return unreadable(Message("this is a folder, not a file"), Message("Give a file"));
    if (!std::filesystem::is_regular_file(path, error))
      return unreadable(Message("this is not an ordinary file"),
                        Message("Save the content to an ordinary file and import that file"));
    std::ifstream file(path, std::ios::binary);
    std::string bytes;
    constexpr std::size_t piece_bytes = std::size_t{1} << 20;
    while (file) {
      const std::size_t size = bytes.size();
      bytes.resize(size + piece_bytes);
      file.read(bytes.data() + size, piece_bytes);
      bytes.resize(size + static_cast<std::size_t>(file.gcount()));
      if (bytes.size() > kMostText_bytes)
        return unreadable(Message("the file is larger than 256 MB"),
                          Message("Export one press with its release, or fewer rows"));
      if (progress_.isCancelled()) return Failure::cancelled(fileNameOf(path));
    }
    if (file.bad() || (bytes.empty() && !file.eof()))
      return unreadable(Message("the file cannot be read"), Message("Check the path and its permissions"));
    if (bytes.empty())
      return unreadable(Message("the file is empty"), Message("Export the measurement again"));
    return bytes;
  }

  Result<FileRecords> recordsOf(const std::string& path, bool eitherStroke) {
    auto bytes = bytesOf(path);
    if (!bytes) return bytes.failure();
    const std::string subject = fileNameOf(path);
    const auto unreadable = [&](Message problem, const Message& remedy) {
      return unreadableFile(subject, std::move(problem), remedy);
    };
    const FileContent content = contentOf(*bytes);
    if (content != FileContent::text && content != FileContent::oldSpreadsheet &&
        bytes->size() > kMostArchive_bytes)
      return unreadable(Message("the file is larger than 32 MB"),
                        Message("Export fewer switches into one file"));
    switch (content) {
      case FileContent::oldSpreadsheet:
        return unreadable(Message("the file is a spreadsheet of Excel 97 to 2003"),
                          Message("Save the spreadsheet as xlsx, ODS or CSV"));
      case FileContent::tar: {
        const auto switches = switchesOfArchive(*bytes, subject);
        if (!switches) return switches.failure();
        return fromSwitches(*switches);
      }
      case FileContent::spreadsheet: {
        auto sheets = tablesOfSpreadsheet(*bytes, subject);
        if (!sheets) return sheets.failure();
        auto found = fromSheets(std::move(*sheets), subject, eitherStroke);
        if (!found && found.failure().code == FailureCode::noForceGraph)
          if (const std::size_t formulas = uncalculatedFormulas(*bytes); formulas > 0)
            return unreadable(
                Message("%1 formulas have no results: no program has calculated them", formulas),
                Message("Open the file in a spreadsheet program and save it there"));
        return found;
      }
      default:
        break;
    }
    const std::string ending = lowered(std::filesystem::path(path).extension().string());
    if (ending == ".ods" || ending == ".xlsx")
      return unreadable(Message("the file is not a spreadsheet, or is damaged"),
                        Message("Save the spreadsheet again"));
    if (ending == ".tar")
      return unreadable(Message("the file is not a TAR archive"),
                        Message("Save the project once more in WebPlotDigitizer"));
    auto text = utf8From(std::move(*bytes));
    if (!text)
      return unreadable(Message("the content is not text"),
                        Message("Export the measurement as CSV, xlsx or ODS"));
    const std::string_view start = trimmed(std::string_view(*text).substr(0, 4096));
    if (ending == ".json" || start.starts_with('{') || start.starts_with("[{")) {
      const nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
      if (keepsStrokesApart(json)) {
        const auto switches = switchesOfJson(json, subject);
        if (!switches) return switches.failure();
        return fromSwitches(*switches);
      }
      if (auto table = json.is_discarded() ? std::nullopt : tableOfJson(json))
        return fromTable(std::move(*table), subject, eitherStroke);
      if (ending == ".json") return switchesOfJson(json, subject).failure();
    }
    auto table = tableOfText(std::move(*text), subject, progress_);
    if (!table) return table.failure();
    return fromTable(std::move(*table), subject, eitherStroke);
  }

  Result<FileRecords> fromSwitches(std::vector<RecordedSwitch> switches) const {
    FileRecords found;
    found.switches = std::move(switches);
    weighUnits(found);
    for (RecordedSwitch& each : found.switches) {
      const double mm = hints_.xUnit ? found.xUnit.size
                        : each.xUnit ? millimetresPer(*each.xUnit)
                                     : found.xUnit.size;
      LogRecord record{each.name, each.press, each.release};
      if (!each.run.empty()) record = fromRun(each);
      if (hints_.swapStrokes) {
        std::swap(record.press, record.release);
        std::ranges::reverse(record.press), std::ranges::reverse(record.release);
      }
      for (auto* stroke : {&record.press, &record.release}) {
        if (!stroke->empty() &&
            (stroke->back().displacement_mm < stroke->front().displacement_mm) == (stroke == &record.press))
          std::ranges::reverse(*stroke);
        for (CurvePoint& p : *stroke) p.displacement_mm *= mm, p.force_N *= found.yUnit.size;
      }
      for (std::optional<double>* contact : {&each.operatingPoint, &each.resetPoint})
        if (*contact) **contact *= mm;
      found.records.push_back(std::move(record));
    }
    for (const LogRecord& each : found.records)
      if (each.press.size() < 2) return strokeless("press stroke", each.press.size());
    return found;
  }

  /// Chooses units: those given by hand, else the file's own, else those that fit a button best.
  void weighUnits(FileRecords& found) const {
    const RecordedSwitch& first = found.switches.front();
    std::vector<AssumedUnit> xUnits = possibleUnits(false), yUnits = possibleUnits(true);
    if (const auto x = hints_.xUnit ? hints_.xUnit : first.xUnit)
      xUnits = {{std::string(symbolOf(*x)), millimetresPer(*x)}};
    if (const auto y = hints_.yUnit ? hints_.yUnit : first.yUnit)
      yUnits = {{std::string(symbolOf(*y)), newtonsPer(*y)}};
    LogRecord all;
    for (const RecordedSwitch& each : found.switches)
      for (const auto* points : {&each.press, &each.release, &each.run})
        all.press.insert(all.press.end(), points->begin(), points->end());
    for (const AssumedUnit& x : xUnits)
      for (const AssumedUnit& y : yUnits) {
        Evidence evidence;
        evidence.addCounted("strokes", "kept apart", kStrokesApart);
        if (!all.press.empty()) evidence.add(unitEvidence(all, x, y));
        found.units.offer({x, y, std::move(evidence)});
      }
    found.xUnit = found.units.kept().front().x, found.yUnit = found.units.kept().front().y;
  }

  /// The record of a run that holds both strokes.
  LogRecord fromRun(const RecordedSwitch& each) const {
    DataTable data;
    Table table;
    DataColumn x, f;
    x.unit.kind = ColumnUnit::Kind::displacement, f.unit.kind = ColumnUnit::Kind::force;
    for (const CurvePoint& p : each.run) {
      data.rowOf.push_back(table.rows());
      table.beginRow(static_cast<long>(table.rows()) + 1);
      x.values.push_back(p.displacement_mm), f.values.push_back(p.force_N);
    }
    data.columns = {std::move(x), std::move(f)};
    LogInterpretation made;
    made.groups = {{0, 1, {}, ""}};
    RecordRequest request;
    request.table = &table, request.data = &data, request.eitherStroke = true;
    static_cast<void>(formRecords(request, made));
    LogRecord record = made.records.empty() ? LogRecord{} : made.records.front();
    record.name = each.name;
    return record;
  }

  Result<FileRecords> fromSheets(std::vector<Table> sheets, const std::string& subject, bool eitherStroke) {
    std::vector<FileRecords> read;
    std::optional<Failure> why;
    const std::vector<SheetPair> pairs = hints_.swapStrokes ? std::vector<SheetPair>{} : pairedSheets(sheets);
    std::vector<std::optional<std::size_t>> readOf(sheets.size());  // place in `read`
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      Table& sheet = sheets[i];
      const std::string name = sheet.name;
      const bool isOfPair = std::ranges::any_of(
          pairs, [&](const SheetPair& pair) { return pair.press == i || pair.release == i; });
      const std::vector<RecordedSwitch> switches =
          hasColumnHints() ? std::vector<RecordedSwitch>{} : switchesOfSheet(sheet);
      auto found = switches.empty() ? fromTable(std::move(sheet), subject, eitherStroke || isOfPair)
                                    : fromSwitches(switches);
      if (!found) {
        if (!why || found.failure().code == FailureCode::notCertain) why = found.failure();
        continue;
      }
      for (LogRecord& record : found->records)
        if (sheets.size() > 1) record.name = name + (record.name.empty() ? "" : " " + record.name);
      readOf[i] = read.size();
      read.push_back(std::move(*found));
    }
    joinSheets(pairs, readOf, read);
    if (read.empty())
      return why ? *why
                 : noForceLog(subject, Message("the spreadsheet holds no table of numbers"),
                              Message("Give a sheet with a column of displacement and one of force"));
    // A sheet with titled columns is the log; sheets of other numbers beside it are notes.
    constexpr double sure = 4;  // log-likelihood
    const auto isSure = [&](const FileRecords& each) {
      return each.best.empty() || each.best.front().evidence.total() > sure;
    };
    if (std::ranges::any_of(read, isSure))
      std::erase_if(read, [&](const FileRecords& each) { return !isSure(each); });
    for (std::size_t i = 1; i < read.size(); ++i)
      read.front().records.insert(read.front().records.end(), read[i].records.begin(), read[i].records.end());
    if (read.size() > 1) read.front().switches.clear();
    return std::move(read.front());
  }

  /// Two sheets whose names are the strokes of one button; indices in the workbook.
  struct SheetPair {
    std::size_t press = 0, release = 0;
    std::string name;  ///< both names without the words for strokes
  };

  static std::vector<SheetPair> pairedSheets(const std::vector<Table>& sheets) {
    struct Button {
      std::vector<std::size_t> press, release;
    };
    std::map<std::string, Button> buttons;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      const StrokeName name = strokeNameOf(sheets[i].name);
      if (!name.stroke) continue;
      Button& button = buttons[name.rest];
      (*name.stroke == Stroke::press ? button.press : button.release).push_back(i);
    }
    std::vector<SheetPair> pairs;
    for (const auto& [name, button] : buttons)
      if (button.press.size() == 1 && button.release.size() == 1)
        pairs.push_back({button.press[0], button.release[0], name});
    return pairs;
  }

  /// Joins the sheets that hold one stroke each. A release without its press is left out.
  static void joinSheets(const std::vector<SheetPair>& pairs,
                         const std::vector<std::optional<std::size_t>>& readOf,
                         std::vector<FileRecords>& read) {
    const auto holdsOneStroke = [](const FileRecords& each) {
      return each.switches.empty() && each.records.size() == 1 && each.records.front().release.empty();
    };
    std::vector<bool> isTaken(read.size());
    for (const SheetPair& pair : pairs) {
      if (!readOf[pair.release]) continue;
      FileRecords& second = read[*readOf[pair.release]];
      if (!holdsOneStroke(second)) continue;
      isTaken[*readOf[pair.release]] = true;
      if (!readOf[pair.press]) continue;
      FileRecords& first = read[*readOf[pair.press]];
      if (!holdsOneStroke(first)) continue;
      LogRecord& record = first.records.front();
      record.release = std::move(second.records.front().press);
      std::ranges::reverse(record.release);
      record.name = pair.name;
      shareUnit(first.xUnit, record.press, second.xUnit, record.release, &CurvePoint::displacement_mm);
      shareUnit(first.yUnit, record.press, second.yUnit, record.release, &CurvePoint::force_N);
    }
    std::vector<FileRecords> kept;
    for (std::size_t i = 0; i < read.size(); ++i)
      if (!isTaken[i]) kept.push_back(std::move(read[i]));
    read = std::move(kept);
  }

  /// Replaces a unit that was assumed for one stroke by that of the other stroke.
  static void shareUnit(AssumedUnit& press, std::vector<CurvePoint>& pressPoints, const AssumedUnit& release,
                        std::vector<CurvePoint>& releasePoints, double CurvePoint::*axis) {
    if (release.isAssumed()) {
      for (CurvePoint& p : releasePoints) p.*axis *= press.size / release.size;
    } else if (press.isAssumed()) {
      for (CurvePoint& p : pressPoints) p.*axis *= release.size / press.size;
      press = release;
    }
  }

  bool hasColumnHints() const { return hints_.columns != ColumnHints{}; }

  Failure strokeless(const char* stroke, std::size_t samples) const {
    return failure(FailureCode::noForceGraph, Message(std::string(stroke)),
                   samples == 0 ? Message("there are no samples") : Message("there is only one sample"),
                   Message("A stroke needs at least two samples at different displacements. Check the rows, "
                           "and which rows are press and release"));
  }

  static std::string titlesOf(const DataTable& data) {
    std::string all;
    constexpr std::size_t most = 6;
    for (std::size_t i = 0; i < data.columns.size(); ++i)
      if (i < most) all += (all.empty() ? "" : ", ") + data.columns[i].label();
    return data.columns.size() > most ? all + ", ..." : all;
  }

  Result<FileRecords> fromTable(Table table, const std::string& subject, bool eitherStroke) {
    const auto refuse = [&](FailureCode code, Message problem, const Remedies& remedies) {
      return Failure{code, subject, {}, std::move(problem), remedies};
    };
    FileRecords found;
    found.data = dataIn(table);
    if (!found.data)
      return noForceLog(subject, Message("there are no two columns of numbers"),
                        Message("Give a table with a column of displacement and one of force, for example "
                                "\"displacement_mm,force_N\""));
    found.table = std::move(table);
    takeGivenUnits(*found.data);
    const DataTable& data = *found.data;
    if (data.rows() < 2) return strokeless("press stroke", data.rows());
    ColumnReading read = interpretColumns(*found.table, data, hints_, eitherStroke);
    if (read.badColumn)
      return refuse(FailureCode::wrongUsage, Message("no column is named \"%1\"", *read.badColumn),
                    Message("The columns are %1", titlesOf(data)));
    if (read.best.empty()) return lacking(read.lack, data, subject);
    if (!read.unknownUnit.empty() &&
        !(read.unknownUnitOfForce ? hints_.yUnit.has_value() : hints_.xUnit.has_value()) &&
        usesUnknownUnit(read.best.front(), data)) {
      const bool force = read.unknownUnitOfForce;
      reading_.question = Question{std::string("the unit of ") + (force ? "force" : "displacement"), {}};
      constexpr std::array forceUnits{"N", "gf", "mN", "cN", "kgf", "lbf", "ozf"};
      constexpr std::array lengthUnits{"mm", "um", "in", "mil", "cm"};
      for (const char* unit :
           force ? std::span<const char* const>(forceUnits) : std::span<const char* const>(lengthUnits))
        reading_.question->choices.push_back({unit, std::string(force ? "--y-unit " : "--x-unit ") + unit});
      return refuse(
          FailureCode::notCertain,
          Message("the unit of %1, \"%2\", is not known", force ? "force" : "displacement", read.unknownUnit),
          force ? Remedies(RemedyKind::giveYUnit) : Remedies(RemedyKind::giveXUnit));
    }
    if (saysNothing(read.best.front(), data)) return lacking(TableLack::columns, data, subject);
    if (auto unknown = unknownName(read.best.front(), data))
      return refuse(FailureCode::notCertain, std::move(*unknown),
                    Message("If it is, confirm it with %1", reading_.question->choices.front().option));
    found.best = std::move(read.best);
    found.records = found.best.front().records;
    found.xUnit = found.best.front().xUnit, found.yUnit = found.best.front().yUnit;
    return found;
  }

  /// Returns true if a table has titles, but neither titles nor units indicate its displacement or its force.
  bool saysNothing(const LogInterpretation& made, const DataTable& data) const {
    if (made.groups.size() != 1 || hasColumnHints()) return false;
    return data.columns[made.groups.front().displacement].displacement <= 0 &&
           data.columns[made.groups.front().force].force <= 0 &&
           std::ranges::any_of(data.columns, [](const DataColumn& each) { return !each.title.empty(); });
  }

  /// If a record uses a column whose title does not name that quantity, returns the problem and puts the
  /// question in `reading_`.
  std::optional<Message> unknownName(const LogInterpretation& made, const DataTable& data) {
    if (made.groups.size() != 1) return {};
    const DataColumn &x = data.columns[made.groups.front().displacement],
                     &f = data.columns[made.groups.front().force];
    const bool askX = x.isUnknownName && hints_.columns.displacement.empty(),
               askF = f.isUnknownName && !f.namesRecord && hints_.columns.force.empty();
    if (!askX && !askF) return {};
    const std::string xOption = "--displacement-column " + std::to_string(x.index + 1),
                      fOption = "--force-column " + std::to_string(f.index + 1);
    const auto question = [&](const std::string& text, const std::string& option) {
      reading_.question = Question{"what do the columns measure", {{text, option}}};
    };
    if (askX && askF) {
      question(x.label() + " is the displacement, " + f.label() + " the force", xOption + " " + fOption);
      return Message("it is not known whether column %1 holds displacements and column %2 forces", x.label(),
                     f.label());
    }
    const DataColumn& doubtful = askX ? x : f;
    question(doubtful.label() + (askX ? " is the displacement" : " is the force"), askX ? xOption : fOption);
    return askX ? Message("it is not known whether column %1 holds displacements", doubtful.label())
                : Message("it is not known whether column %1 holds forces", doubtful.label());
  }

  /// Applies units given by hand to columns whose title and unit contradict each other.
  void takeGivenUnits(DataTable& data) {
    const auto take = [&](ColumnQuantity quantity, ColumnUnit::Kind kind, std::string_view symbol,
                          double size) {
      for (DataColumn& each : data.columns) {
        if (each.isText || each.quantity != quantity || each.unit.kind == kind || !each.unit.isKnown())
          continue;
        remark(
            Message("column %1 was read in %2, the unit that you gave", each.label(), std::string(symbol)));
        giveUnit(each, {kind, size, std::string(symbol)});
      }
    };
    if (hints_.xUnit)
      take(ColumnQuantity::displacement, ColumnUnit::Kind::displacement, symbolOf(*hints_.xUnit),
           millimetresPer(*hints_.xUnit));
    if (hints_.yUnit)
      take(ColumnQuantity::force, ColumnUnit::Kind::force, symbolOf(*hints_.yUnit),
           newtonsPer(*hints_.yUnit));
  }

  static bool usesUnknownUnit(const LogInterpretation& made, const DataTable& data) {
    return std::ranges::any_of(made.groups, [&](const ColumnGroup& g) {
      return data.columns[g.force].unit.kind == ColumnUnit::Kind::unknown ||
             data.columns[g.force].unit.kind == ColumnUnit::Kind::other ||
             data.columns[g.displacement].unit.kind == ColumnUnit::Kind::unknown ||
             data.columns[g.displacement].unit.kind == ColumnUnit::Kind::other;
    });
  }

  static Failure lacking(TableLack lack, const DataTable& data, const std::string& subject) {
    const std::string titles = titlesOf(data);
    const Remedies nameThem{
        {RemedyKind::advice, Message("Give the columns titles such as \"Travel (mm)\" and \"Force (N)\"")},
        {RemedyKind::advice,
         Message("If one of them is it: --displacement-column NAME|N, --force-column NAME|N")}};
    switch (lack) {
      case TableLack::displacement:
        return noForceLog(subject, Message("no column holds displacements; the columns are %1", titles),
                          nameThem);
      case TableLack::force:
        return noForceLog(subject, Message("no column holds forces; the columns are %1", titles), nameThem);
      case TableLack::columns:
        return noForceLog(
            subject,
            Message("no column holds displacements, and none holds forces; the columns are %1", titles),
            nameThem);
      case TableLack::movement:
        return noForceLog(
            subject, Message("the displacement changes no more than its noise; the columns are %1", titles),
            Message("Give the log of a press"));
      case TableLack::sortedLoop:
        return noForceLog(
            subject, Message("press and release are mixed, sorted by displacement, and cannot be separated"),
            Message("Export the points in the order of the movement, or each stroke in its own column"));
      default:
        return noForceLog(subject, Message("the file holds a release, but no press"),
                          {{RemedyKind::swapStrokes, "if this is one"},
                           {RemedyKind::advice, Message("If it is a release, record the press too")}});
    }
  }

  // -- one of several records -------------------------------------------------------------------------------

  static std::string namesOf(const std::vector<LogRecord>& records) {
    std::string all;
    constexpr std::size_t most = 12;
    for (std::size_t i = 0; i < records.size(); ++i)
      if (i < most)
        all += (i > 0 ? ", " : "") + std::to_string(i + 1) +
               (records[i].name.empty() ? "" : " \"" + records[i].name + "\"");
    return records.size() > most ? all + ", ..." : all;
  }

  Result<LogRecord> chosen(const FileRecords& found) {
    const std::vector<LogRecord>& records = found.records;
    if (hints_.curve.empty() && records.size() == 1) return records.front();
    const std::string wanted = lowered(hints_.curve);
    const auto isWanted = [&](const LogRecord& each) { return lowered(each.name) == wanted; };
    if (wanted == "mean" && std::ranges::none_of(records, isWanted)) {
      if (records.size() > 1) remark(Message("the mean of %1 recordings was taken", records.size()));
      return records.size() > 1 ? meanOf(records) : records.front();
    }
    if (!wanted.empty() && std::ranges::count_if(records, isWanted) == 1)
      return taken(records,
                   static_cast<std::size_t>(std::ranges::find_if(records, isWanted) - records.begin()));
    for (std::size_t i = 0; i < records.size() && !wanted.empty(); ++i)
      if (wanted == std::to_string(i + 1)) return taken(records, i);
    if (wanted.empty()) {
      // Cycles of one switch count as one record if they differ by less than two buttons would.
      const bool alike = std::ranges::all_of(
          records, [&](const LogRecord& each) { return differenceOf(records.front(), each) < kSameButton; });
      if (alike) {
        log_.remarks.push_back({RemarkCode::severalPresses, {records.size()}});
        return records.front();
      }
    }
    Question question{"which recording should be read", {}};
    for (std::size_t i = 0; i < records.size(); ++i)
      question.choices.push_back({records[i].name.empty() ? std::to_string(i + 1) : records[i].name,
                                  "--record " + std::to_string(i + 1)});
    question.choices.push_back({"their mean", "--record mean"});
    if (wanted.empty()) reading_.question = std::move(question);
    return failure(wanted.empty() ? FailureCode::notCertain : FailureCode::wrongUsage, "",
                   Message("there are %1 recordings: %2", records.size(), namesOf(records)),
                   {{RemedyKind::advice, Message("To read one of them alone, save it as a file of its own")},
                    {RemedyKind::advice,
                     Message("Choose one of them with --record NAME|N, or their mean with --record mean")}});
  }

  Result<LogRecord> taken(const std::vector<LogRecord>& records, std::size_t i) {
    chosenIndex_ = i;
    return records[i];
  }

  /// Adds the release from a second file.
  std::optional<Failure> addRelease(LogRecord& record) {
    auto second = recordsOf(hints_.releasePath, true);
    if (!second) return second.failure();
    if (second->records.size() != 1 || !second->records.front().release.empty() || !record.release.empty())
      return Failure{FailureCode::wrongUsage,
                     fileNameOf(hints_.releasePath),
                     {},
                     Message("a pair consists of two files, one with a press and one with a release"),
                     Message("Give the file of the press first, then that of the release")};
    record.release = std::move(second->records.front().press);
    std::ranges::reverse(record.release);
    return {};
  }

  // -- from a record to strokes -----------------------------------------------------------------------------

  std::optional<Failure> finish(const FileRecords& found, LogRecord record) {
    std::vector<CurvePoint>&press = record.press, &release = record.release;
    log_.xUnit = found.xUnit.symbol, log_.yUnit = found.yUnit.symbol;
    if (found.xUnit.isAssumed())
      log_.remarks.push_back(
          {RemarkCode::displacementUnitAssumed, {log_.xUnit}, {{RemedyKind::giveXUnit, "if it is another"}}});
    if (found.yUnit.isAssumed())
      log_.remarks.push_back(
          {RemarkCode::forceUnitAssumed, {log_.yUnit}, {{RemedyKind::giveYUnit, "if it is another"}}});
    if (press.size() < 2) return strokeless("press stroke", press.size());
    const auto [least, most] = std::ranges::minmax(press, {}, &CurvePoint::displacement_mm);
    if (!(most.displacement_mm > least.displacement_mm))
      return failure(FailureCode::noForceGraph, "press stroke", Message("the displacement never changes"),
                     Message("Check which column holds the displacement"));
    std::size_t together = 1;
    while (std::max(press.size(), release.size()) > kMostSamples) {
      halve(press), halve(release);
      together *= 2;
    }
    if (!found.best.empty()) {
      const LogInterpretation& made = found.best.front();
      if (made.forcesTurned) log_.remarks.push_back({RemarkCode::forcesTurned});
      if (made.displacementTurned) log_.remarks.push_back({RemarkCode::displacementTurned});
      if (made.joined) remark(Message("the press went back a little and continued; both parts were joined"));
      estimateNoise(press, release, lastDigit(found, true), lastDigit(found, false));
      readContacts(found, made);
      tellSpeeds(found, made);
    } else {
      estimateNoise(press, release, std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity());
      if (!found.switches.empty()) {
        const RecordedSwitch& one = found.switches[std::min(chosenIndex_, found.switches.size() - 1)];
        log_.operatingPoint_mm = one.operatingPoint, log_.resetPoint_mm = one.resetPoint;
        if (one.scaleDoubtful) log_.remarks.push_back({RemarkCode::forceScaleDoubtful});
      }
    }
    endBeforeDwell(press, log_.noise_mm, log_.noise_N);
    beginAtContact(press, release);
    log_.strokes.press.points = bridged(press);
    if (release.size() >= 2) log_.strokes.release = StrokePoints{bridged(release), {}, false};
    placeContacts();
    if (together > 1) log_.remarks.push_back({RemarkCode::rowsAveraged, {together}});
    noteRows(found);
    return {};
  }

  static double lastDigit(const FileRecords& found, bool displacement) {
    const ColumnGroup& group = found.best.front().groups.front();
    const DataColumn& column = found.data->columns[displacement ? group.displacement : group.force];
    return std::pow(10.0, -column.decimals) * (displacement ? found.xUnit.size : found.yUnit.size);
  }

  void estimateNoise(const std::vector<CurvePoint>& press, const std::vector<CurvePoint>& release,
                     double digit_mm, double digit_N) {
    double greatest = 0;
    for (const std::vector<CurvePoint>* stroke : {&press, &release}) {
      std::vector<double> x, f;
      for (const CurvePoint& p : *stroke) {
        x.push_back(p.displacement_mm), f.push_back(p.force_N);
        greatest = std::max(greatest, std::abs(p.force_N));
      }
      log_.noise_mm = std::max(log_.noise_mm, noiseOf(x, digit_mm));
      log_.noise_N = std::max(log_.noise_N, noiseOf(f, digit_N));
    }
    // A log without visible noise (computed, or constant) still needs a noise for the fit. A millionth of the
    // span is far below any real one.
    const double travel = std::abs(press.back().displacement_mm - press.front().displacement_mm);
    constexpr double least = std::numeric_limits<double>::min();
    log_.noise_mm = std::max({log_.noise_mm, 1e-6 * travel, least});
    log_.noise_N = std::max({log_.noise_N, 1e-6 * greatest, least});
  }

  /// Measures displacement from contact and force from the unloaded gauge's reading.
  void beginAtContact(std::vector<CurvePoint>& press, std::vector<CurvePoint>& release) {
    const double start_mm = press.front().displacement_mm;
    const double travel_mm = press.back().displacement_mm - start_mm;
    double highest_N = 0;
    for (const CurvePoint& p : press) highest_N = std::max(highest_N, p.force_N);
    double shift_mm = 0;
    if (const auto before = beforeContact(press, log_.noise_N)) {
      if (std::abs(before->force_N) >= log_.noise_N) {
        log_.preload_N = before->force_N;
        for (std::vector<CurvePoint>* stroke : {&press, &release})
          for (CurvePoint& p : *stroke) p.force_N -= before->force_N;
        log_.remarks.push_back({RemarkCode::preloadTakenOff, {{before->force_N, Measure::force_N}}});
      }
      const double air_mm = before->contact_mm - start_mm;
      cutBefore(press, before->contact_mm, true);
      cutBefore(release, before->contact_mm, false);
      shift_mm = before->contact_mm;
      remark(
          Message("the first %1 of the movement, before the contact, was cut off; the contact point is known "
                  "to within %2",
                  millimetres(air_mm), millimetres(before->uncertainty_mm)));
    }
    if (shift_mm == 0) {
      // The stage's position is not travel, so a press that starts without force starts at zero.
      constexpr double farShare = 0.5, nearShare = 0.005,
                       restShare = 0.06;  // shares of the travel; share of the highest force
      const bool atRest = std::abs(press.front().force_N) < restShare * highest_N;
      // lowest of both strokes: if the release ends below the press, displacement counts from there
      double lowest_mm = start_mm;
      for (const CurvePoint& p : release) lowest_mm = std::min(lowest_mm, p.displacement_mm);
      const bool lowestIsStart = lowest_mm > start_mm - farShare * travel_mm;
      if (start_mm < 0 || (lowestIsStart && (start_mm > farShare * travel_mm ||
                                             (start_mm > nearShare * travel_mm && atRest)))) {
        shift_mm = start_mm;
        log_.remarks.push_back({RemarkCode::displacementShifted, {{start_mm, Measure::displacement_mm}}});
      }
    }
    if (shift_mm == 0) return;
    for (std::vector<CurvePoint>* stroke : {&press, &release})
      for (CurvePoint& p : *stroke) p.displacement_mm -= shift_mm;
    for (std::optional<double>* contact_mm : {&log_.operatingPoint_mm, &log_.resetPoint_mm})
      if (*contact_mm) **contact_mm -= shift_mm;
  }

  /// Removes the part before a displacement. A press then begins there with force 0.
  static void cutBefore(std::vector<CurvePoint>& stroke, double place_mm, bool isPress) {
    if (stroke.empty()) return;
    std::vector<CurvePoint> kept;
    for (const CurvePoint& p : stroke)
      if (p.displacement_mm > place_mm) kept.push_back(p);
    if (kept.size() < 2) return;
    if (isPress)
      kept.insert(kept.begin(), {place_mm, 0});
    else if (stroke.back().displacement_mm <= place_mm) {
      const auto below =
          std::ranges::find_if(stroke, [&](const CurvePoint& p) { return p.displacement_mm <= place_mm; });
      kept.push_back({place_mm, below->force_N});
    }
    stroke = std::move(kept);
  }

  /// Reads the operating point and the reset point from a column of contact or voltage that changes during
  /// the press and changes back during the release.
  void readContacts(const FileRecords& found, const LogInterpretation& made) {
    const DataTable& data = *found.data;
    const auto columnOf = [&](Stroke stroke) -> const DataColumn* {
      const DataColumn* any = nullptr;
      for (const DataColumn& each : data.columns) {
        if (each.isText || each.isConstant() || !each.has(ColumnWord::contact)) continue;
        if (each.displacement > 0 || each.force > 0) continue;
        const bool press = each.has(ColumnWord::press), release = each.has(ColumnWord::release);
        if (stroke == Stroke::release ? release : press && !release) return &each;
        if (!release || stroke == Stroke::release) any = any ? any : &each;
      }
      return any;
    };
    const std::size_t sets = made.groups.size();
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const DataColumn* contact = columnOf(stroke);
      if (!contact) continue;
      const ColumnGroup& group =
          made.groups[stroke == Stroke::release && made.groups.front().stroke && sets > 1 ? 1 : 0];
      const std::vector<double>& x = data.columns[group.displacement].values;
      std::vector<std::pair<double, bool>> states;  // in the order travelled
      const double middle = 0.5 * (contact->low + contact->high);
      for (std::size_t row = 0; row < data.rows(); ++row)
        if (!std::isnan(x[row]) && !std::isnan(contact->values[row]))
          states.emplace_back(x[row], contact->values[row] > middle);
      if (states.size() < 2) continue;
      const double sign = made.displacementTurned ? -1 : 1;
      const bool apart = made.groups.front().stroke.has_value();
      if (apart)
        std::ranges::stable_sort(states, [&](const auto& a, const auto& b) {
          return stroke == Stroke::press ? sign * a.first < sign * b.first : sign * a.first > sign * b.first;
        });
      std::optional<double>& place = stroke == Stroke::press ? log_.operatingPoint_mm : log_.resetPoint_mm;
      std::size_t changes = 0;
      for (std::size_t i = 1; i < states.size(); ++i) {
        if (states[i].second == states[i - 1].second) continue;
        ++changes;
        if (!apart && stroke == Stroke::release && changes < 2) continue;
        place = sign * found.xUnit.size * std::midpoint(states[i].first, states[i - 1].first);
        break;
      }
    }
  }

  /// Drops contact points outside the travel of their stroke.
  void placeContacts() {
    const auto keepWithin = [](std::optional<double>& contact_mm, const std::vector<CurvePoint>& stroke) {
      const auto [least, most] = std::ranges::minmax(stroke, {}, &CurvePoint::displacement_mm);
      if (contact_mm && !(*contact_mm >= least.displacement_mm && *contact_mm <= most.displacement_mm))
        contact_mm.reset();
    };
    keepWithin(log_.operatingPoint_mm, log_.strokes.press.points);
    keepWithin(log_.resetPoint_mm,
               log_.strokes.release ? log_.strokes.release->points : log_.strokes.press.points);
  }

  /// Sets the speeds of the first complete press and of the release after it.
  void tellSpeeds(const FileRecords& found, const LogInterpretation& made) {
    const DataTable& data = *found.data;
    const DataColumn* time = nullptr;
    for (const DataColumn& each : data.columns)
      if (!time && !each.isText &&
          (each.quantity == ColumnQuantity::time || each.unit.kind == ColumnUnit::Kind::time))
        time = &each;
    if (!time || !made.fromRun) return;
    const std::vector<double>& x = data.columns[made.groups.front().displacement].values;
    struct TimedPlace {
      double time_s = 0, place_mm = 0;
    };
    std::vector<TimedPlace> run;
    const double seconds = time->unit.kind == ColumnUnit::Kind::time ? time->unit.size : 1;
    const double mm = found.xUnit.size * (made.displacementTurned ? -1 : 1);
    for (std::size_t row = 0; row < data.rows(); ++row)
      if (!std::isnan(x[row]) && !std::isnan(time->values[row]))
        run.push_back({time->values[row] * seconds, x[row] * mm});
    if (run.size() < 8) return;
    const auto [least, most] = std::ranges::minmax(run, {}, &TimedPlace::place_mm);
    const double range_mm = most.place_mm - least.place_mm;
    if (!(range_mm > 0)) return;
    // share of the travel at each end, where a stroke accelerates and brakes
    constexpr double endShare = 0.1;
    const double low_mm = least.place_mm + endShare * range_mm, middle_mm = least.place_mm + 0.5 * range_mm,
                 high_mm = most.place_mm - endShare * range_mm;
    // Time at which a displacement is passed, interpolated between samples, searching from index `at` on.
    const auto passes = [&](double place_mm, bool down, std::size_t& at) -> std::optional<double> {
      for (at = std::max<std::size_t>(at, 1); at < run.size(); ++at) {
        const TimedPlace &a = run[at - 1], &b = run[at];
        if (down ? a.place_mm < place_mm && b.place_mm >= place_mm
                 : a.place_mm > place_mm && b.place_mm <= place_mm)
          return std::lerp(a.time_s, b.time_s, (place_mm - a.place_mm) / (b.place_mm - a.place_mm));
      }
      return {};
    };
    std::size_t at = 1;
    const auto stroke = [&](bool down) -> std::optional<StrokeSpeed> {
      const auto begun_s = passes(down ? low_mm : high_mm, down, at);
      const auto half_s = passes(middle_mm, down, at), ended_s = passes(down ? high_mm : low_mm, down, at);
      if (!begun_s || !half_s || !ended_s || !(*half_s > *begun_s) || !(*ended_s > *half_s)) return {};
      const double first_s = *half_s - *begun_s, second_s = *ended_s - *half_s;
      return StrokeSpeed{(high_mm - low_mm) / (*ended_s - *begun_s),
                         std::max(first_s / second_s, second_s / first_s)};
    };
    log_.pressSpeed = stroke(true);
    if (log_.pressSpeed) log_.releaseSpeed = stroke(false);
  }

  void noteRows(const FileRecords& found) {
    if (found.data) {
      log_.rowsRead = static_cast<long>(found.data->rows()) + found.data->leftOut;
      log_.rowsSkipped = found.data->leftOut;
    }
    if (!log_.strokes.release) log_.remarks.push_back({RemarkCode::noRelease});
    if (log_.rowsSkipped > 0)
      log_.remarks.push_back(
          {RemarkCode::rowsLeftOut,
           {log_.rowsSkipped, log_.rowsRead, found.data->firstLeftOutLine, found.data->firstLeftOutText}});
  }

  // -- confidence -------------------------------------------------------------------------------------------

  /// Sets the confidence by the margins to other readings that give a different button, and to "no log",
  /// which has no evidence. Asks the question that distinguishes the best two.
  void rate(const FileRecords& found) {
    std::vector<double> margins;
    if (found.best.empty()) {
      const auto& units = found.units.kept();
      margins.push_back(units.front().evidence.total());
      for (std::size_t i = 1; i < units.size(); ++i)
        margins.push_back(units.front().evidence.total() - units[i].evidence.total());
    } else {
      const LogInterpretation& best = found.best.front();
      margins.push_back(best.evidence.total());
      for (std::size_t i = 1; i < found.best.size(); ++i) {
        const LogInterpretation& rival = found.best[i];
        if (sameButton(best, rival) || isAnswered(best, rival)) continue;
        if (margins.size() == 1) reading_.question = between(best, rival, *found.data);
        margins.push_back(best.evidence.total() - rival.evidence.total());
      }
    }
    log_.confidence = confidenceOfMargins(margins);
  }

  /// Returns true if a person chose among the records of the best reading, and the rival holds only columns
  /// of such records.
  bool isAnswered(const LogInterpretation& best, const LogInterpretation& rival) const {
    const auto isRecordOfBest = [&](const ColumnGroup& group) {
      return !group.stroke && std::ranges::any_of(best.groups, [&](const ColumnGroup& each) {
        return !each.stroke && each.displacement == group.displacement && each.force == group.force;
      });
    };
    return !hints_.curve.empty() && best.records.size() > 1 && best.xUnit.symbol == rival.xUnit.symbol &&
           best.yUnit.symbol == rival.yUnit.symbol && std::ranges::all_of(rival.groups, isRecordOfBest);
  }

  bool sameButton(const LogInterpretation& a, const LogInterpretation& b) const {
    if (a.records.size() != b.records.size()) return false;
    const std::size_t k = std::min(chosenIndex_, a.records.size() - 1);
    return sameScale(a.records[k], b.records[k]) && differenceOf(a.records[k], b.records[k]) < kSameButton;
  }

  static bool sameScale(const LogRecord& a, const LogRecord& b) {
    const ListedRecord p = listed(a), q = listed(b);
    return std::abs(p.travel_mm - q.travel_mm) < kSameButton * p.travel_mm &&
           std::abs(p.highest_N - q.highest_N) < kSameButton * p.highest_N;
  }

  static std::optional<Question> between(const LogInterpretation& a, const LogInterpretation& b,
                                         const DataTable& data) {
    const ColumnGroup &p = a.groups.front(), &q = b.groups.front();
    const auto option = [&](const char* name, std::size_t c) {
      return name + std::to_string(data.columns[c].index + 1);
    };
    const auto question = [](const char* what, auto choice) {
      return Question{what, {choice(0), choice(1)}};
    };
    const auto columns = [&](const char* what, const char* name, std::size_t first, std::size_t second) {
      return question(what, [&](int k) {
        const std::size_t c = k == 0 ? first : second;
        return Choice{data.columns[c].label(), option(name, c)};
      });
    };
    constexpr const char *toX = "--displacement-column ", *toF = "--force-column ";
    if (p.force != q.force && p.displacement != q.displacement)
      return question("which columns hold displacement and force", [&](int k) {
        const ColumnGroup& g = k == 0 ? p : q;
        return Choice{data.columns[g.displacement].label() + ", " + data.columns[g.force].label(),
                      option(toX, g.displacement) + " " + option(toF, g.force)};
      });
    if (p.force != q.force) return columns("which column holds the force", toF, p.force, q.force);
    if (p.displacement != q.displacement)
      return columns("which column holds the displacement", toX, p.displacement, q.displacement);
    const auto units = [&](const char* what, const std::string& name, AssumedUnit LogInterpretation::*unit) {
      return question(what, [&](int k) {
        const std::string& symbol = ((k == 0 ? a : b).*unit).symbol;
        return Choice{symbol, name + symbol};
      });
    };
    if (a.yUnit.symbol != b.yUnit.symbol)
      return units("what is the unit of force", "--y-unit ", &LogInterpretation::yUnit);
    if (a.xUnit.symbol != b.xUnit.symbol)
      return units("what is the unit of displacement", "--x-unit ", &LogInterpretation::xUnit);
    const LogInterpretation& beside = a.groups.size() > b.groups.size() || a.groups.front().stroke ? a : b;
    if (beside.groups.size() < 2) return {};
    return Question{"does the second column of forces hold the release",
                    {{"it is the release",
                      option(toF, p.force) + " " + option("--release-force-column ", beside.groups[1].force)},
                     {"it is another recording", option(toF, p.force)}}};
  }

  const std::string& path_;
  const LogHints& hints_;
  const Progress& progress_;
  std::size_t chosenIndex_ = 0;
  ForceLog log_;
  LogReading reading_{Failure{}, {}, {}, {}};
};

}  // namespace

bool isForceLogPath(const std::string& path) {
  const std::string ending = lowered(std::filesystem::path(path).extension().string());
  for (const char* known : {".csv", ".ods", ".json", ".tar", ".tsv", ".xlsx"})
    if (ending == known) return true;
  for (const char* other :
       {".pdf", ".svg", ".svgz", ".png", ".jpg", ".jpeg", ".bmp", ".gif", ".tif", ".tiff", ".webp"})
    if (ending == other) return false;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;  // a pipe would wait for its writer
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.empty()) return false;
  if (contentOf(head) != FileContent::text) return true;
  const auto text = utf8From(std::move(head));
  if (!text) return false;
  const std::string_view start = trimmed(*text);
  return !start.starts_with("%PDF") && !start.starts_with("%!PS") &&
         !(start.starts_with('<') && start.find("svg") != std::string_view::npos) &&
         !start.starts_with("<?xml");
}

namespace {

/// A file's path without a word at its end that names a stroke.
struct StrokeFile {
  std::string path;
  std::optional<Stroke> stroke;
};

StrokeFile strokeFileOf(const std::string& given) {
  const std::filesystem::path path(given);
  const std::string stem = path.stem().string();
  const std::size_t at = stem.find_last_of(" ._-");
  if (at == std::string::npos || at == 0) return {given, {}};
  const std::optional<Stroke> stroke = strokeNamedIn(stem.substr(at + 1));
  if (!stroke) return {given, {}};
  const std::string rest = stem.substr(0, stem.find_last_not_of(" ._-", at) + 1);
  return {(path.parent_path() / (rest + path.extension().string())).string(), stroke};
}

}  // namespace

std::string withoutStrokeWord(const std::string& path) { return strokeFileOf(path).path; }

std::map<std::string, std::string> pairedFiles(const std::vector<std::string>& paths) {
  struct Button {
    std::vector<std::string> press, release;
  };
  std::map<std::string, Button> buttons;
  for (const std::string& path : paths)
    if (const StrokeFile file = strokeFileOf(path); file.stroke)
      (*file.stroke == Stroke::press ? buttons[file.path].press : buttons[file.path].release).push_back(path);
  std::map<std::string, std::string> pairs;
  for (const auto& [name, button] : buttons)
    if (button.press.size() == 1 && button.release.size() == 1) pairs[button.press[0]] = button.release[0];
  return pairs;
}

LogReading readLog(const std::string& path, const LogHints& hints, const Progress& progress) {
  return LogReader(path, hints, progress).read();
}

Result<ForceLog> readForceLog(const std::string& path, const LogHints& hints, const Progress& progress) {
  return readLog(path, hints, progress).log;
}

std::vector<std::string> recordNames(const std::string& path) {
  std::vector<std::string> names;
  for (const ListedRecord& each : readLog(path).records) names.push_back(each.name);
  return names;
}

}  // namespace detent::importer
