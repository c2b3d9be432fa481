// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/store.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <tuple>
#include <utility>

#include "importer/library/database.h"
#include "importer/log/force_log.h"
#include "model/number_table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t applicationId = 0x44744c62;  // "DtLb", stored in the header of the file

const char* const dropped =
    "DROP TABLE IF EXISTS rating; DROP TABLE IF EXISTS curve; DROP TABLE IF EXISTS switch; DROP TABLE IF "
    "EXISTS file;";

const char* const fileTable =
    "CREATE TABLE file (id INTEGER PRIMARY KEY, path BLOB NOT NULL UNIQUE, bytes INTEGER NOT NULL, "
    "modified_ns INTEGER NOT NULL, "
    "looked_ns INTEGER NOT NULL, sha256 TEXT NOT NULL, version TEXT NOT NULL, refused_code INTEGER, "
    "refused_reason TEXT, "
    "gone INTEGER NOT NULL DEFAULT 0);";

/// Columns before the figures; `file` refers to a switch's file.
constexpr int firstFigure = 7, figureCount = static_cast<int>(keyFigureCount);
const std::string switchColumns = "name, unit, run, part, licence, credit, scale_doubtful";
/// Curves are in a separate table: searches for figures do not read curves, and comparisons of curves read
/// nothing else.
const std::string curveColumns = "travel_mm, press, release";

/// ", peak_force_N, ..." for each figure, with given text before and after its name.
std::string figureColumns(const std::string& before = "", const std::string& behind = "") {
  std::string columns;
  for (const KeyFigureName& name : keyFigureNames())
    columns.append(", ").append(before).append(name.key).append(behind);
  return columns;
}

std::string sigmaColumns(const std::string& behind = "") { return figureColumns("sigma_", behind); }

std::string switchTable() {
  return "CREATE TABLE switch (id INTEGER PRIMARY KEY, file INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT "
         "NOT NULL, run TEXT NOT NULL, "
         "part INTEGER NOT NULL, licence TEXT NOT NULL, credit TEXT NOT NULL, scale_doubtful INTEGER NOT "
         "NULL" +
         figureColumns("", " REAL") + sigmaColumns(" REAL") +
         ", UNIQUE (file, part)); CREATE INDEX switch_name ON switch (name);";
}

const char* const curveTable =
    "CREATE TABLE curve (switch INTEGER PRIMARY KEY, travel_mm REAL NOT NULL, press BLOB NOT NULL, release "
    "BLOB NOT NULL); CREATE INDEX curve_travel ON curve (travel_mm);";  // travels can be read without curves

const char* const ratingTable =
    "CREATE TABLE rating (id INTEGER PRIMARY KEY, file INTEGER NOT NULL, name TEXT NOT NULL, maker TEXT NOT "
    "NULL, "
    "licence TEXT NOT NULL, credit TEXT NOT NULL, scores TEXT NOT NULL);";

/// One line per score: name, tab, value. Headings contain neither tab nor line end.
std::string textOf(const std::vector<std::pair<std::string, double>>& scores) {
  std::string text;
  for (const auto& [what, score] : scores)
    text.append(what).append("\t").append(shortestText(score)).append("\n");
  return text;
}

std::vector<std::pair<std::string, double>> scoresIn(std::string_view text) {
  std::vector<std::pair<std::string, double>> scores;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    const std::size_t tab = text.find('\t');
    const auto score = tab < end ? finiteNumberFrom(text.substr(tab + 1, end - tab - 1)) : std::nullopt;
    if (!score) throw DatabaseFault{SQLITE_CORRUPT, "a rating is not whole"};
    scores.emplace_back(text.substr(0, tab), *score);
    text.remove_prefix(end + 1);
  }
  return scores;
}

/// Forces as stored in the file on any processor: 32-bit IEEE numbers, lowest byte first.
std::string packed(const std::vector<float>& forces) {
  std::string bytes;
  bytes.reserve(4 * forces.size());
  for (const float force : forces) {
    const auto bits = std::bit_cast<std::uint32_t>(force);
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xffU);
  }
  return bytes;
}

/// Unpacks forces, reusing the memory of `forces`.
void unpack(std::string_view bytes, std::vector<float>& forces) {
  forces.resize(bytes.size() / sizeof(float));
  if constexpr (std::endian::native == std::endian::little) {
    if (!forces.empty()) std::memcpy(forces.data(), bytes.data(), forces.size() * sizeof(float));
    return;
  }
  for (std::size_t i = 0; i < forces.size(); ++i) {
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 4; ++b)
      bits |= std::uint32_t{static_cast<unsigned char>(bytes[4 * i + b])} << (8 * b);
    forces[i] = std::bit_cast<float>(bits);
  }
}

bool isWhole(const FeltShape& shape) {
  const auto finite = [](const std::vector<float>& forces) {
    return std::ranges::all_of(forces, [](float force) { return std::isfinite(force); });
  };
  return std::isfinite(shape.travel_mm) && shape.travel_mm > 0 &&
         shape.press_N.size() == FeltShape::samples &&
         (shape.release_N.empty() || shape.release_N.size() == FeltShape::samples) && finite(shape.press_N) &&
         finite(shape.release_N);
}

KeyFigures figuresIn(const Statement& row, int first) {
  KeyFigures figures;
  for (std::size_t i = 0; i < keyFigureCount; ++i) figures.values[i] = row.real(first + static_cast<int>(i));
  return figures;
}

/// Reads a row's curveColumns from column `first` on into `shape`, reusing its memory. Throws DatabaseFault
/// if the curve is incomplete.
void readShape(const Statement& row, int first, FeltShape& shape) {
  shape.travel_mm = row.real(first).value_or(0);
  unpack(row.view(first + 1), shape.press_N);
  unpack(row.view(first + 2), shape.release_N);
  if (!isWhole(shape)) throw DatabaseFault{SQLITE_CORRUPT, "the curve of a switch is not whole"};
}

/// Columns that `switchIn` reads, from `switchTables`.
std::string rowColumns() {
  return switchColumns + figureColumns() + sigmaColumns() + ", path, sha256, version, " + curveColumns;
}
const char* const switchTables = " FROM switch JOIN file ON switch.file = file.id";
const char* const withCurves = " JOIN curve ON curve.switch = switch.id";

LibrarySwitch switchIn(const Statement& row) {
  constexpr int ofFile = firstFigure + 2 * figureCount;
  LibrarySwitch each{row.bytes(0),
                     row.bytes(1),
                     row.bytes(2),
                     row.bytes(ofFile),
                     static_cast<int>(row.integer(3)),
                     row.bytes(4),
                     row.bytes(5),
                     row.bytes(ofFile + 1),
                     row.bytes(ofFile + 2),
                     figuresIn(row, firstFigure),
                     figuresIn(row, firstFigure + figureCount),
                     row.integer(6) != 0,
                     {}};
  readShape(row, ofFile + 3, each.shape);
  return each;
}

/// Condition: the file is present and the figures are within the ranges.
std::string whereWithin(const std::vector<FigureRange>& ranges) {
  std::string sql = " WHERE file.gone = 0";
  for (const FigureRange& range : ranges)
    sql += " AND " + std::string(keyFigureNames()[static_cast<std::size_t>(range.figure)].key) +
           " BETWEEN ? AND ?";
  return sql;
}

void bindRanges(Statement& row, const std::vector<FigureRange>& ranges) {
  int parameter = 0;
  for (const FigureRange& range : ranges) {
    row.bind(++parameter, std::optional(range.low));
    row.bind(++parameter, std::optional(range.high));
  }
}

Failure failureOf(const DatabaseFault& fault, const std::string& path) {
  switch (fault.code) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {FailureCode::wrongUsage, path, "", "another program has been writing it for half a minute",
              "Wait until that is done, and try again"};
    case SQLITE_FULL:
    case SQLITE_IOERR:
      return {FailureCode::internalFault, path, "", Message("the disk is full or failed: %1", fault.words),
              "Make room or mend the disk, and index again; what was in the library is as it was"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return {FailureCode::wrongUsage, path, "", Message("the library cannot be opened: %1", fault.words),
              "Pass a --db in a folder that exists and may be written to"};
    default:
      return {FailureCode::unreadableInput, path, "", Message("the library is not complete: %1", fault.words),
              "Run detent-import library index FOLDER... --db on it, which makes it anew"};
  }
}

bool isDamage(const DatabaseFault& fault) {
  return fault.code == SQLITE_CORRUPT || fault.code == SQLITE_NOTADB;
}

/// Kind of a file, determined by its first bytes.
enum class FileKind { none, library, otherDatabase, other };

FileKind fileKindOf(const std::string& path) {
  std::array<char, 100> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  if (in.gcount() == 0) return FileKind::none;
  constexpr std::string_view magic("SQLite format 3\0", 16);
  if (std::string_view(head.data(), magic.size()) != magic) return FileKind::other;
  std::int64_t id = 0;
  for (std::size_t i = 68; i < 72; ++i) id = id << 8 | static_cast<unsigned char>(head[i]);
  return id == applicationId ? FileKind::library : FileKind::otherDatabase;
}

/// An unused file name beside the given one.
fs::path asideOf(const std::string& path) {
  fs::path aside = path + ".damaged";
  std::error_code error;
  for (int n = 2; fs::exists(aside, error); ++n) aside = path + ".damaged-" + std::to_string(n);
  return aside;
}

void makeTables(Database& database) {
  database.run(dropped);
  database.run(fileTable);
  database.run(switchTable().c_str());
  database.run(curveTable);
  database.run(ratingTable);
  database.run(("PRAGMA application_id = " + std::to_string(applicationId)).c_str());
  database.run(("PRAGMA user_version = " + std::to_string(libraryVersion)).c_str());
}

/// Opens or creates the tables; returns a message if an existing library was emptied.
Message prepareTables(Database& database) {
  if (database.text("PRAGMA quick_check(1)") != "ok")
    throw DatabaseFault{SQLITE_CORRUPT, "its pages do not fit together"};
  Transaction change(database);
  const std::int64_t version = database.number("PRAGMA user_version");
  if (version == libraryVersion) return {};
  const bool empty = database.number("SELECT count(*) FROM sqlite_master") == 0;
  makeTables(database);
  change.commit();
  if (empty) return {};
  return Message("the library had version %1, this program uses %2: it was built anew from the given folders",
                 version, libraryVersion);
}

Result<Message> movedAside(const std::string& path, const std::string& why) {
  const fs::path aside = asideOf(path);
  std::error_code error;
  fs::rename(path, aside, error);
  if (error)
    return Failure{FailureCode::wrongUsage, path, "",
                   Message("the library is damaged and could not be renamed: %1", error.message()),
                   "Pass another --db"};
  fs::remove(path + "-journal", error);  // the journal of a database that no longer exists
  return Message(
      "the library was damaged (%1) and was built anew from the given folders; the damaged file is kept as "
      "%2",
      why, aside.filename().string());
}

bool isNamedDatabase(const std::string& path) {
  const std::string ending = lowered(fs::path(path).extension().string());
  return ending == ".db" || ending == ".sqlite" || ending == ".sqlite3";
}

std::optional<Failure> notForALibrary(const std::string& path) {
  std::error_code error;
  const char* const advice = "Pass another --db";
  if (fs::is_directory(path, error))
    return Failure{FailureCode::wrongUsage, path, "", "this is a folder, not a file", advice};
  if (isForceLogPath(path))
    return Failure{FailureCode::wrongUsage, path, "", "its name is a measurement's, not a library's", advice};
  const FileKind kind = fileKindOf(path);
  if (kind == FileKind::otherDatabase)
    return Failure{FailureCode::wrongUsage, path, "", "it is a database of another program", advice};
  if (kind == FileKind::other &&
      !isNamedDatabase(path))  // a damaged library is moved aside, but a file of another kind is not
    return Failure{FailureCode::wrongUsage, path, "", "it is no library", advice};
  return {};
}

}  // namespace

struct LibraryStore::Impl {
  std::string path;
  Database database;
  Message rebuilt = {};

  /// Runs `work`; faults of the database become a Failure.
  template <class Work>
  auto guarded(Work work) -> Result<decltype(work())> {
    try {
      return work();
    } catch (const DatabaseFault& fault) {
      return failureOf(fault, path);
    }
  }
  std::int64_t putFile(const LibraryFile& file);
  void putSwitches(const LibraryFile& file, std::int64_t id);
  void putRatings(const LibraryFile& file, std::int64_t id);
};

LibraryStore::LibraryStore(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LibraryStore::LibraryStore(LibraryStore&&) noexcept = default;
LibraryStore& LibraryStore::operator=(LibraryStore&&) noexcept = default;
LibraryStore::~LibraryStore() = default;

const Message& LibraryStore::rebuilt() const { return impl_->rebuilt; }

Result<LibraryStore> LibraryStore::openToWrite(const std::string& path) {
  if (auto refused = notForALibrary(path)) return std::move(*refused);
  Message rebuilt;
  for (const bool again : {false, true}) {
    try {
      auto impl = std::make_unique<Impl>(Impl{path, Database(path, true)});
      const Message emptied = prepareTables(impl->database);
      impl->rebuilt = rebuilt.empty() ? emptied : rebuilt;
      return LibraryStore(std::move(impl));
    } catch (const DatabaseFault& fault) {
      if (again || !isDamage(fault)) return failureOf(fault, path);
      auto aside = movedAside(path, fault.words);
      if (!aside) return aside.failure();
      rebuilt = std::move(*aside);
    }
  }
  return Failure{FailureCode::unreadableInput, path, "", "it cannot be made anew", "Pass another --db"};
}

Result<LibraryStore> LibraryStore::openToRead(const std::string& path) {
  const char* const advice = "Run detent-import library index FOLDER... --db on it first";
  if (fileKindOf(path) == FileKind::none)
    return Failure{FailureCode::unreadableInput, path, "", "there is no library", advice};
  if (auto refused = notForALibrary(path)) return std::move(*refused);
  try {
    auto impl = std::make_unique<Impl>(Impl{path, Database(path, false)});
    const std::int64_t version = impl->database.number("PRAGMA user_version");
    if (version != libraryVersion)
      return Failure{FailureCode::unreadableInput, path, "",
                     Message("the library has version %1, this program uses %2", version, libraryVersion),
                     advice};
    impl->database.run("BEGIN");  // all reads see the state at one moment
    return LibraryStore(std::move(impl));
  } catch (const DatabaseFault& fault) {
    return failureOf(fault, path);
  }
}

Result<std::map<std::string, KnownFile>> LibraryStore::files() const {
  return impl_->guarded([&] {
    std::map<std::string, KnownFile> known;
    Statement row(impl_->database,
                  "SELECT path, bytes, modified_ns, looked_ns, sha256, version, refused_code, "
                  "refused_reason, gone FROM file");
    while (row.step()) {
      KnownFile file{{row.integer(1), row.integer(2), row.integer(3)},
                     row.bytes(4),
                     row.bytes(5),
                     {},
                     row.integer(8) != 0};
      if (row.real(6))
        file.refused = RefusedFile{row.bytes(0), static_cast<FailureCode>(row.integer(6)), row.bytes(7)};
      known.emplace(row.bytes(0), std::move(file));
    }
    return known;
  });
}

std::int64_t LibraryStore::Impl::putFile(const LibraryFile& file) {
  Statement put(database,
                "INSERT INTO file (path, bytes, modified_ns, looked_ns, sha256, version, refused_code, "
                "refused_reason, gone) "
                "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, 0) ON CONFLICT (path) DO UPDATE SET bytes = ?2, "
                "modified_ns = ?3, "
                "looked_ns = ?4, sha256 = ?5, version = ?6, refused_code = ?7, refused_reason = ?8, gone = 0 "
                "RETURNING id");
  put.bindBytes(1, file.path)
      .bind(2, file.stamp.bytes)
      .bind(3, file.stamp.modified_ns)
      .bind(4, file.stamp.looked_ns);
  put.bindText(5, file.sha256).bindText(6, file.version);
  if (file.refused)
    put.bind(7, std::int64_t{static_cast<int>(file.refused->code)}).bindText(8, file.refused->reason);
  const std::int64_t id = put.step() ? put.integer(0) : 0;
  put.finish();
  return id;
}

void LibraryStore::Impl::putSwitches(const LibraryFile& file, std::int64_t id) {
  Statement(database, "DELETE FROM curve WHERE switch IN (SELECT id FROM switch WHERE file = ?1)")
      .bind(1, id)
      .finish();
  Statement(database, "DELETE FROM switch WHERE file = ?1").bind(1, id).finish();
  std::string marks;
  for (int i = 0; i < firstFigure + 2 * figureCount; ++i) marks += ", ?";
  Statement put(database, "INSERT INTO switch (file, " + switchColumns + figureColumns() + sigmaColumns() +
                              ") VALUES (?" + marks + ") RETURNING id");
  Statement putCurve(database, "INSERT INTO curve (switch, " + curveColumns + ") VALUES (?, ?, ?, ?)");
  for (const LibrarySwitch& each : file.switches) {
    put.bind(1, id)
        .bindText(2, each.name)
        .bindText(3, each.unit)
        .bindText(4, each.run)
        .bind(5, std::int64_t{each.part});
    put.bindText(6, each.licence).bindText(7, each.credit).bind(8, std::int64_t{each.scaleDoubtful});
    for (std::size_t i = 0; i < keyFigureCount; ++i) {
      const int figure = firstFigure + 2 + static_cast<int>(i);
      put.bind(figure, each.figures.values[i]).bind(figure + figureCount, each.sigmas.values[i]);
    }
    putCurve.bind(1, put.step() ? put.integer(0) : 0).bind(2, std::optional(each.shape.travel_mm));
    put.finish();
    putCurve.bindBytes(3, packed(each.shape.press_N)).bindBytes(4, packed(each.shape.release_N)).finish();
  }
}

void LibraryStore::Impl::putRatings(const LibraryFile& file, std::int64_t id) {
  Statement(database, "DELETE FROM rating WHERE file = ?1").bind(1, id).finish();
  Statement put(database,
                "INSERT INTO rating (file, name, maker, licence, credit, scores) VALUES (?, ?, ?, ?, ?, ?)");
  for (const Rating& each : file.ratings) {
    put.bind(1, id).bindText(2, each.name).bindText(3, each.maker).bindText(4, each.licence);
    put.bindText(5, each.credit).bindText(6, textOf(each.scores)).finish();
  }
}

Result<Done> LibraryStore::put(const std::vector<LibraryFile>& files) {
  return impl_->guarded([&] {
    Transaction change(impl_->database);
    for (const LibraryFile& file : files) {
      const std::int64_t id = impl_->putFile(file);
      impl_->putSwitches(file, id);
      impl_->putRatings(file, id);
    }
    change.commit();
    return Done{};
  });
}

Result<Done> LibraryStore::restamp(const std::vector<std::pair<std::string, FileStamp>>& same,
                                   const std::vector<std::string>& gone) {
  if (same.empty() && gone.empty()) return Done{};
  return impl_->guarded([&] {
    Transaction change(impl_->database);
    Statement stamp(impl_->database,
                    "UPDATE file SET bytes = ?2, modified_ns = ?3, looked_ns = ?4, gone = 0 WHERE path = ?1");
    for (const auto& [path, at] : same)
      stamp.bindBytes(1, path).bind(2, at.bytes).bind(3, at.modified_ns).bind(4, at.looked_ns).finish();
    Statement mark(impl_->database, "UPDATE file SET gone = 1 WHERE path = ?1");
    for (const std::string& path : gone) mark.bindBytes(1, path).finish();
    change.commit();
    return Done{};
  });
}

Result<std::vector<UnitRecord>> LibraryStore::records(const std::string& name,
                                                      const std::string& credit) const {
  return impl_->guarded([&] {
    Statement row(impl_->database,
                  "SELECT unit" + figureColumns() +
                      " FROM switch JOIN file ON switch.file = file.id WHERE file.gone = 0 AND name = ?1 AND "
                      "credit = ?2");
    row.bindText(1, name).bindText(2, credit);
    std::vector<UnitRecord> records;
    while (row.step()) records.push_back({row.bytes(0), figuresIn(row, 1)});
    return records;
  });
}

Result<std::vector<LibrarySwitch>> LibraryStore::switches(const std::vector<FigureRange>& ranges) const {
  return impl_->guarded([&] {
    Statement row(impl_->database,
                  "SELECT " + rowColumns() + switchTables + withCurves + whereWithin(ranges));
    bindRanges(row, ranges);
    std::vector<LibrarySwitch> found;
    while (row.step()) found.push_back(switchIn(row));
    // Sorted here, because SQLite would write every curve to a temporary file for sorting.
    std::ranges::sort(found, byName);
    return found;
  });
}

Result<std::vector<LibrarySwitch>> LibraryStore::switchesOf(const std::vector<SwitchId>& ids) const {
  return impl_->guarded([&] {
    Statement row(impl_->database,
                  "SELECT " + rowColumns() + switchTables + withCurves + " WHERE switch.id = ?");
    std::vector<LibrarySwitch> found;
    for (const SwitchId id : ids) {
      if (!row.bind(1, id).step()) throw DatabaseFault{SQLITE_CORRUPT, "a switch is not in it any more"};
      found.push_back(switchIn(row));
      row.finish();
    }
    return found;
  });
}

Result<std::vector<SwitchId>> LibraryStore::idsByName(const std::vector<FigureRange>& ranges) const {
  return impl_->guarded([&] {
    Statement row(impl_->database, std::string("SELECT switch.id") + switchTables + whereWithin(ranges) +
                                       " ORDER BY name, path, part");
    bindRanges(row, ranges);
    std::vector<SwitchId> ids;
    while (row.step()) ids.push_back(row.integer(0));
    return ids;
  });
}

Result<std::vector<std::pair<SwitchId, double>>> LibraryStore::travels_mm(
    const std::vector<FigureRange>& ranges) const {
  return impl_->guarded([&] {
    Statement kept(impl_->database, std::string("SELECT switch.id") + switchTables + whereWithin(ranges));
    bindRanges(kept, ranges);
    std::vector<SwitchId> ids;
    while (kept.step()) ids.push_back(kept.integer(0));
    std::ranges::sort(ids);
    Statement row(impl_->database, "SELECT switch, travel_mm FROM curve INDEXED BY curve_travel");
    std::vector<std::pair<SwitchId, double>> travels;
    while (row.step())
      if (std::ranges::binary_search(ids, row.integer(0)))
        travels.emplace_back(row.integer(0), row.real(1).value_or(0));
    return travels;
  });
}

Result<Done> LibraryStore::shapesOf(const std::vector<SwitchId>& ids,
                                    const std::function<bool(SwitchId, const FeltShape&)>& take) const {
  return impl_->guarded([&] {
    Statement row(impl_->database, "SELECT " + curveColumns + " FROM curve WHERE switch = ?");
    FeltShape shape;
    for (const SwitchId id : ids) {
      if (!row.bind(1, id).step()) throw DatabaseFault{SQLITE_CORRUPT, "a switch is not in it any more"};
      readShape(row, 0, shape);
      row.finish();
      if (!take(id, shape)) break;
    }
    return Done{};
  });
}

Result<std::vector<std::pair<SwitchId, std::string>>> LibraryStore::names() const {
  return impl_->guarded([&] {
    Statement row(impl_->database, std::string("SELECT switch.id, name") + switchTables + whereWithin({}));
    std::vector<std::pair<SwitchId, std::string>> all;
    while (row.step()) all.emplace_back(row.integer(0), row.bytes(1));
    return all;
  });
}

Result<std::vector<std::pair<SwitchId, KeyFigures>>> LibraryStore::figures() const {
  return impl_->guarded([&] {
    Statement row(impl_->database, "SELECT switch.id" + figureColumns() + switchTables + whereWithin({}));
    std::vector<std::pair<SwitchId, KeyFigures>> all;
    while (row.step()) all.emplace_back(row.integer(0), figuresIn(row, 1));
    return all;
  });
}

Result<std::vector<Rating>> LibraryStore::ratings() const {
  return impl_->guarded([&] {
    Statement row(
        impl_->database,
        "SELECT name, maker, path, licence, credit, scores FROM rating JOIN file ON rating.file = file.id "
        "WHERE file.gone = 0 ORDER BY rating.id");
    std::vector<Rating> all;
    while (row.step())
      all.push_back(
          {row.bytes(0), row.bytes(1), row.bytes(2), row.bytes(3), row.bytes(4), scoresIn(row.view(5))});
    return all;
  });
}

bool byName(const LibrarySwitch& a, const LibrarySwitch& b) {
  return std::tie(a.name, a.source, a.part) < std::tie(b.name, b.source, b.part);
}

}  // namespace detent::importer
