// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The library on disk: an SQLite file that stays intact if a writing process dies.

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/library/library_switch.h"
#include "importer/library/ratings.h"
#include "importer/library/switch_spread.h"
#include "model/result.h"

namespace detent::importer {

/// Version of the tables. Raised with every change to them or to the meaning of a key figure: files of other
/// versions are rebuilt.
inline constexpr int libraryVersion = 7;

/// A file that is not in the library, with the reason.
struct RefusedFile {
  std::string file;
  FailureCode code = FailureCode::unreadableInput;
  std::string reason;  ///< a sentence, in English
};

/// State of a file when it was read. Times are of the file clock and comparable with each other only.
struct FileStamp {
  std::int64_t bytes = 0;
  std::int64_t modified_ns = 0;
  std::int64_t looked_ns = 0;
};

/// The result of reading one file: switches, ratings, or a refusal.
struct LibraryFile {
  std::string path;  ///< absolute
  FileStamp stamp;
  std::string sha256, version;
  std::vector<LibrarySwitch> switches;
  std::optional<RefusedFile> refused;
  std::vector<Rating> ratings = {};
};

/// The library's data of a file without its switches.
struct KnownFile {
  FileStamp stamp;
  std::string sha256, version;
  std::optional<RefusedFile> refused;
  bool gone = false;
};

/// Bounds of a figure, both included. A switch without the figure is outside.
struct FigureRange {
  KeyFigure figure = KeyFigure::peakForce;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// A row's place in the file, as long as the store is open to read.
using SwitchId = std::int64_t;

/// Sorts by name; equal names by file and part.
bool byName(const LibrarySwitch& a, const LibrarySwitch& b);

/// One open library. One thread; any number of processes.
class LibraryStore {
 public:
  /// Creates the file if there is none. Empties a file of another version and moves a damaged one aside; see
  /// `rebuilt`. Failure wrongUsage: a folder, a database of another program, or a file that is no database.
  static Result<LibraryStore> openToWrite(const std::string& path);
  /// All queries see the state at the time of opening; a writer waits until the store is closed. Failure
  /// unreadableInput: missing, damaged, of another version.
  static Result<LibraryStore> openToRead(const std::string& path);
  LibraryStore(LibraryStore&&) noexcept;
  LibraryStore& operator=(LibraryStore&&) noexcept;
  ~LibraryStore();

  /// The reason why the file was rebuilt; empty if it was not.
  const Message& rebuilt() const;
  Result<std::map<std::string, KnownFile>> files() const;
  /// Replaces the stored data of these files. Writes all of them or, on a Failure, none.
  Result<Done> put(const std::vector<LibraryFile>& files);
  /// Updates unchanged files whose stamp differs, and marks files that no longer exist. Writes all or, on a
  /// Failure, none.
  Result<Done> restamp(const std::vector<std::pair<std::string, FileStamp>>& same,
                       const std::vector<std::string>& gone);
  /// Switches of present files that satisfy every range, by name.
  Result<std::vector<LibrarySwitch>> switches(const std::vector<FigureRange>& ranges = {}) const;
  /// The switches with these ids, in this order.
  Result<std::vector<LibrarySwitch>> switchesOf(const std::vector<SwitchId>& ids) const;
  /// Ids of the result of `switches`, without reading it.
  Result<std::vector<SwitchId>> idsByName(const std::vector<FigureRange>& ranges) const;
  /// Travel of the switches that satisfy every range (FeltShape::travel_mm), without reading curves; in no
  /// particular order.
  Result<std::vector<std::pair<SwitchId, double>>> travels_mm(const std::vector<FigureRange>& ranges) const;
  /// Passes the shapes of these switches to `take`, in this order, until it returns false.
  Result<Done> shapesOf(const std::vector<SwitchId>& ids,
                        const std::function<bool(SwitchId, const FeltShape&)>& take) const;
  /// Figures of all present files, in no order.
  Result<std::vector<std::pair<SwitchId, KeyFigures>>> figures() const;
  Result<std::vector<std::pair<SwitchId, std::string>>> names() const;
  /// Ratings of the present files, in the order of the sheets.
  Result<std::vector<Rating>> ratings() const;
  /// Records of the present files: those of one switch by one laboratory, by name and credit.
  Result<std::vector<UnitRecord>> records(const std::string& name, const std::string& credit) const;

 private:
  struct Impl;
  explicit LibraryStore(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace detent::importer
