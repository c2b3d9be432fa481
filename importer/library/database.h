// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// SQLite's connection and statements as values that close themselves. Faults are thrown here and caught in
// store.cpp.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <sqlite3.h>

namespace detent::importer {

/// Error of SQLite.
struct DatabaseFault {
  int code = SQLITE_ERROR;  ///< primary result code
  std::string words;        ///< SQLite's own
};

/// One connection; waits for others that write. Moves only.
class Database {
 public:
  /// Throws DatabaseFault.
  Database(const std::string& path, bool toWrite);
  Database(Database&& other) noexcept;
  Database& operator=(Database&& other) noexcept;
  ~Database();

  void run(const char* sql);  ///< throws DatabaseFault
  /// The first column of the first row of a question without parameters; 0 where there is none.
  std::int64_t number(const char* sql);
  std::string text(const char* sql);
  sqlite3* handle() const { return handle_; }

 private:
  sqlite3* handle_ = nullptr;
};

/// A prepared statement. Parameters count from 1, columns from 0. Everything throws DatabaseFault.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, const std::optional<double>& value);
  Statement& bindText(int parameter, std::string_view text);
  Statement& bindBytes(int parameter, std::string_view bytes);
  bool step();    ///< goes to the next row; false: there is none
  void finish();  ///< steps to the last row, then accepts new parameters

  std::int64_t integer(int column) const;
  std::optional<double> real(int column) const;
  std::string bytes(int column) const;      ///< of a text or a blob
  std::string_view view(int column) const;  ///< the same, until the next step

 private:
  void check(int code) const;
  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// A transaction: destruction before commit() rolls everything back. It takes SQLite's write lock at once, so
/// that it cannot fail halfway because another process writes.
class Transaction {
 public:
  explicit Transaction(Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace detent::importer
