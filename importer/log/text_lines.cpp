// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/text_lines.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace detent::importer {
namespace {

constexpr std::size_t chunk = 1 << 18;

Failure unreadable(const std::string& path, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, std::filesystem::path(path).filename().string(), "",
          std::move(problem), std::move(remedies)};
}

void appendUtf8(std::string& text, char32_t c) {
  const auto put = [&](char32_t byte) {
    text.push_back(static_cast<char>(static_cast<unsigned char>(byte)));
  };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xC0 | (c >> 6)), put(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    put(0xE0 | (c >> 12)), put(0x80 | ((c >> 6) & 0x3F)), put(0x80 | (c & 0x3F));
  } else {
    put(0xF0 | (c >> 18)), put(0x80 | ((c >> 12) & 0x3F)), put(0x80 | ((c >> 6) & 0x3F)),
        put(0x80 | (c & 0x3F));
  }
}

}  // namespace

Result<LineReader> LineReader::open(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return unreadable(path, Message("is a folder"), Message("Give a force meter's CSV file"));
  LineReader reader;
  reader.file_.reset(std::fopen(path.c_str(), "rb"));
  if (!reader.file_)
    return unreadable(path, Message("cannot be opened: %1", std::strerror(errno)),
                      Message("Check the path and its rights"));
  const auto size = std::filesystem::file_size(path, error);
  reader.size_ = error ? 0 : static_cast<double>(size);

  reader.raw_.resize(chunk);
  const std::size_t count = std::fread(reader.raw_.data(), 1, chunk, reader.file_.get());
  if (count == 0) return unreadable(path, Message("is empty"), Message("Export the measurement again"));
  reader.read_ = static_cast<double>(count);
  const std::string_view start(reader.raw_.data(), count);
  const std::size_t probe = std::min<std::size_t>(count, 4096);
  std::size_t zerosAtEven = 0, zerosAtOdd = 0;
  for (std::size_t i = 0; i < probe; ++i)
    if (start[i] == 0) ++(i % 2 == 0 ? zerosAtEven : zerosAtOdd);
  std::size_t skip = 0;
  if (start.starts_with("\xEF\xBB\xBF")) {
    skip = 3;
  } else if (start.starts_with("\xFF\xFE") || (zerosAtOdd > probe / 4 && zerosAtEven == 0)) {
    reader.encoding_ = Encoding::utf16LittleEndian;
    skip = start.starts_with("\xFF\xFE") ? 2 : 0;
  } else if (start.starts_with("\xFE\xFF") || (zerosAtEven > probe / 4 && zerosAtOdd == 0)) {
    reader.encoding_ = Encoding::utf16BigEndian;
    skip = start.starts_with("\xFE\xFF") ? 2 : 0;
  } else if (zerosAtEven + zerosAtOdd > 0) {
    return unreadable(path, Message("is not a text file"),
                      Message("Give a force meter's CSV file, or a picture or PDF by its right name"));
  }
  reader.append(reader.raw_.data() + skip, count - skip);
  return reader;
}

double LineReader::fractionRead() const { return size_ > 0 ? std::min(1.0, read_ / size_) : 0; }

void LineReader::append(const char* bytes, std::size_t count) {
  if (encoding_ == Encoding::bytes) {
    text_.append(bytes, count);
    return;
  }
  const auto unitOf = [&](char first, char second) {
    const auto a = static_cast<unsigned char>(first), b = static_cast<unsigned char>(second);
    return static_cast<char32_t>(encoding_ == Encoding::utf16LittleEndian ? a | (b << 8) : b | (a << 8));
  };
  const auto put = [&](char32_t unit) {
    if (unit >= 0xD800 && unit < 0xDC00) {
      surrogate_ = unit;
    } else if (unit >= 0xDC00 && unit < 0xE000) {
      if (surrogate_) appendUtf8(text_, 0x10000 + ((surrogate_ - 0xD800) << 10) + (unit - 0xDC00));
      surrogate_ = 0;
    } else {
      appendUtf8(text_, unit);
    }
  };
  std::size_t i = 0;
  if (!half_.empty() && count > 0) put(unitOf(half_[0], bytes[i++]));
  half_.clear();
  for (; i + 1 < count; i += 2) put(unitOf(bytes[i], bytes[i + 1]));
  if (i < count) half_.assign(1, bytes[i]);
}

bool LineReader::refill() {
  if (ended_) return false;
  text_.erase(0, at_);
  at_ = 0;
  if (text_.size() > longestLine) {
    broken_ = ended_ = true;
    return false;
  }
  raw_.resize(chunk);
  const std::size_t count = std::fread(raw_.data(), 1, chunk, file_.get());
  if (count == 0) {
    ended_ = true;
    broken_ = std::ferror(file_.get()) != 0;
    return false;
  }
  read_ += static_cast<double>(count);
  append(raw_.data(), count);
  return true;
}

bool LineReader::next(std::string_view& line) {
  for (;;) {
    if (skipLineFeed_ && at_ < text_.size()) {
      if (text_[at_] == '\n') ++at_;
      skipLineFeed_ = false;
    }
    const std::size_t end = text_.find_first_of("\r\n", at_);
    if (end != std::string::npos) {
      line = std::string_view(text_).substr(at_, end - at_);
      skipLineFeed_ = text_[end] == '\r';
      at_ = end + 1;
      ++lineNumber_;
      return true;
    }
    if (refill()) continue;
    if (broken_ || at_ >= text_.size()) return false;
    line = std::string_view(text_).substr(at_);
    at_ = text_.size();
    ++lineNumber_;
    return true;
  }
}

}  // namespace detent::importer
