// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An append-only text file without data loss: each line is on disk before append() returns, a line that a
// crash truncated is removed and reported, and a second process is refused. POSIX.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

/// The lines of a journal, read without changing it or waiting for its writer; each without its line end.
struct JournalText {
  std::vector<std::string> lines;
  std::string unfinished;  ///< text after the last line end: a line that is being written, or was truncated

  /// Returns true for a file of another kind: it has no complete line, and its text does not begin like a
  /// journal (with a JSON object, or zeros after a power failure).
  bool isForeign() const;
};
JournalText splitJournal(const std::string& text);
/// Failure for a file that is not a journal.
Failure notAJournal(const std::filesystem::path& file);

/// An open journal; owned by one thread. Movable, not copyable; destroying it unlocks the file.
class LineJournal {
 public:
  /// Opens or creates `file` and locks it for this process. Failure unreadableInput: it cannot be opened,
  /// another process has locked it, or it is a file of another kind.
  static Result<LineJournal> open(const std::filesystem::path& file);
  ~LineJournal();
  LineJournal(LineJournal&& other) noexcept;
  LineJournal& operator=(LineJournal&& other) noexcept;
  LineJournal(const LineJournal&) = delete;
  LineJournal& operator=(const LineJournal&) = delete;

  /// Contents of the file when it was opened; `unfinished` has been removed from the file.
  const JournalText& opened() const { return opened_; }

  /// Writes one line (which contains no line end) and waits until it is on disk. Failure unreadableInput: the
  /// disk refused; the file is unchanged, and the call may be repeated.
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
