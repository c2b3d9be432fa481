// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An append-only text file that loses nothing: each line is on the disk before append() returns, a line that
// was cut off by a crash is removed and reported, and a second process is refused. POSIX.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

/// The lines of a journal without writing to it or waiting for its writer; each without its line end.
struct JournalText {
  std::vector<std::string> lines;
  std::string unfinished;  ///< what follows the last line end: a line being written, or cut off

  /// Returns true for a file of another kind: it has no whole line, and its text begins as no journal does
  /// (JSON objects; zeros after a power cut).
  bool isForeign() const;
};
JournalText splitJournal(const std::string& text);
/// Failure for a file that is not a journal.
Failure notAJournal(const std::filesystem::path& file);

/// An open journal; owned by one thread. Movable, not copyable; destroying it lets others in.
class LineJournal {
 public:
  /// Opens or creates `file` and locks it for this process. Failure unreadableInput: cannot be opened, or
  /// another process holds it, or it is a file of another kind.
  static Result<LineJournal> open(const std::filesystem::path& file);
  ~LineJournal();
  LineJournal(LineJournal&& other) noexcept;
  LineJournal& operator=(LineJournal&& other) noexcept;
  LineJournal(const LineJournal&) = delete;
  LineJournal& operator=(const LineJournal&) = delete;

  /// Contents of the file when it was opened; `unfinished` has been removed from the file.
  const JournalText& opened() const { return opened_; }

  /// Writes one line (without a line end in it) and waits until the disk has it. Failure unreadableInput: the
  /// disk refused; the file is as before, the same call may be made again.
  Result<Done> append(const std::string& line);

 private:
  LineJournal(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  Result<Done> readAndCut();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::int64_t length_bytes_ = 0;
  JournalText opened_;
};

}  // namespace detent::playback
