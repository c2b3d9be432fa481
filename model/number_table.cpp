// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/number_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "model/text.h"

namespace detent {
namespace {

/// Removes and returns the text up to the next separator.
std::string_view nextPart(std::string_view& rest, char separator) {
  const std::size_t at = rest.find(separator);
  const std::string_view part = rest.substr(0, at);
  rest = at == std::string_view::npos ? std::string_view{} : rest.substr(at + 1);
  return part;
}

}  // namespace

NumberTable::NumberTable(std::string_view text) : rest_(text) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool NumberTable::next() {
  do {
    if (rest_.empty()) return false;
    line_ = trimmed(nextPart(rest_, '\n'));
    number_ = ++lines_;
  } while (line_.empty() || line_.front() == '#');
  const bool quotes = line_.find('"') != std::string_view::npos;
  badQuotes_ = quotes && !splitQuoted();
  if (!quotes || badQuotes_) {
    fields_.clear();
    const auto commas = std::count(line_.begin(), line_.end(), ',');
    std::string_view rest = line_;
    for (auto field = 0; field <= commas; ++field) fields_.push_back(trimmed(nextPart(rest, ',')));
  }
  if (!std::exchange(begun_, true)) rowNames_ = fields_.size() > 1 && fields_.front().empty();
  if (rowNames_) fields_.erase(fields_.begin());
  return true;
}

/// Splits a row with quoted fields (RFC 4180), including lines joined by a quoted line break. Returns false,
/// and consumes nothing, if a quotation mark is not closed or text follows a closed one.
bool NumberTable::splitQuoted() {
  fields_.clear();
  unescaped_.clear();
  const char* at = line_.data();
  const char* end = at + line_.size();
  const char* const textEnd = rest_.data() + rest_.size();
  const auto skipBlanks = [&] {
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
  };
  std::string_view rest = rest_;
  std::size_t more = 0;  // lines
  for (;;) {
    skipBlanks();
    if (at == end || *at != '"') {
      const char* const comma = std::find(at, end, ',');
      fields_.push_back(trimmed(std::string_view(at, static_cast<std::size_t>(comma - at))));
      at = comma;
    } else {
      const char* const first = ++at;
      bool doubled = false;
      for (;;) {
        at = std::find(at, textEnd, '"');
        if (at == textEnd) return false;
        if (at + 1 >= textEnd || at[1] != '"') break;
        doubled = true;
        at += 2;
      }
      std::string_view field(first, static_cast<std::size_t>(at - first));
      while (at >= end) {  // the row continues after a quoted line break
        const std::string_view line = nextPart(rest, '\n');
        end = line.data() + line.size();
        ++more;
      }
      ++at;
      if (doubled) {
        std::string& plain = unescaped_.emplace_back();
        for (std::size_t i = 0; i < field.size(); ++i) {
          plain += field[i];
          if (field[i] == '"') ++i;
        }
        field = plain;
      }
      fields_.push_back(field);
      skipBlanks();
      if (at < end && *at != ',') return false;
    }
    if (at == end) break;
    ++at;
  }
  line_ = std::string_view(line_.data(), static_cast<std::size_t>(end - line_.data()));
  rest_ = rest;
  lines_ += more;
  return true;
}

std::string NumberTable::place() const {
  return "line " + std::to_string(std::max<std::size_t>(number_, 1)) +
         (badQuotes_ ? ", whose quotation marks do not match" : "");
}

bool NumberTable::is(std::initializer_list<std::string_view> fields) const {
  return std::equal(fields_.begin(), fields_.end(), fields.begin(), fields.end());
}

std::optional<std::vector<std::size_t>> NumberTable::columns(
    const std::vector<std::string_view>& names) const {
  std::vector<std::size_t> positions;
  for (const std::string_view name : names) {
    const auto at = std::find(fields_.begin(), fields_.end(), name);
    if (at == fields_.end()) return {};
    positions.push_back(static_cast<std::size_t>(at - fields_.begin()));
  }
  return positions;
}

std::optional<double> NumberTable::finite(std::size_t field) const {
  return field < fields_.size() ? finiteNumberFrom(fields_[field]) : std::nullopt;
}

std::optional<double> numberFrom(std::string_view field) {
  field = trimmed(field);
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (field.empty() || end != field.data() + field.size()) return {};
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<double> finiteNumberFrom(std::string_view field) {
  const std::optional<double> value = numberFrom(field);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string shortestText(double value) {
  constexpr double largestWritten = 1e16;
  char text[64];
  const auto form = std::abs(value) < largestWritten ? std::chars_format::fixed : std::chars_format::general;
  return {text, std::to_chars(text, text + sizeof text, value, form).ptr};
}

std::string quotedBegin(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string quoted(1, '"');
  for (const char c : text.substr(0, longest))
    quoted += static_cast<unsigned char>(c) < ' ' || c == 127 ? '?' : c;
  return quoted += '"';
}

Result<std::string> readTable(const std::string& file, std::size_t most_bytes, const Remedies& remedies) {
  const auto refused = [&](const std::string& problem) {
    return Failure{FailureCode::unreadableInput, file, "", problem, remedies};
  };
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return refused("the file cannot be opened (" + error.message() + ")");
  if (size > most_bytes)
    return refused("the file is larger than " + std::to_string(most_bytes >> 20) + " MiB");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || (size > 0 && !(text << in.rdbuf())) || in.bad()) return refused("the file cannot be read");
  return text.str();
}

}  // namespace detent
