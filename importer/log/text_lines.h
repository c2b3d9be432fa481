// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines of a text file as UTF-8, whatever it was saved as: a constant amount of memory for any length.

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "model/result.h"

namespace detent::importer {

/// Reads UTF-8 (with or without BOM), UTF-16 of either byte order (with BOM, or told by its zero bytes) and,
/// unchanged, one-byte encodings. Lines end with LF, CR LF or CR. One owner, any thread.
class LineReader {
 public:
  /// Failure unreadableInput: missing, a folder, empty, not text.
  static Result<LineReader> open(const std::string& path);

  /// The next line without its end; valid until the next call. False at the end of the file.
  bool next(std::string_view& line);

  long lineNumber() const { return lineNumber_; }  ///< of the line last given, from 1
  double fractionRead() const;                     ///< 0..1
  /// A line longer than `longestLine` or a broken read: the reader stops there.
  bool isBroken() const { return broken_; }

  static constexpr std::size_t longestLine = 1 << 20;  ///< bytes

 private:
  enum class Encoding { bytes, utf16LittleEndian, utf16BigEndian };
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  LineReader() = default;
  bool refill();
  void append(const char* bytes, std::size_t count);

  std::unique_ptr<std::FILE, CloseFile> file_;
  Encoding encoding_ = Encoding::bytes;
  std::string raw_;     ///< read buffer
  std::string text_;    ///< decoded, not yet given
  std::size_t at_ = 0;  ///< start of the next line in text_
  std::string half_;    ///< bytes of an unfinished UTF-16 unit
  char32_t surrogate_ = 0;
  bool skipLineFeed_ = false;
  bool ended_ = false, broken_ = false;
  long lineNumber_ = 0;
  double size_ = 0, read_ = 0;
};

}  // namespace detent::importer
