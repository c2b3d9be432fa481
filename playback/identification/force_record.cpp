// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/force_record.h"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace detent::playback {

namespace {

constexpr std::uintmax_t largestRecord_bytes = 1ULL << 28;
constexpr std::array<std::string_view, 3> columnNames{"time_s", "displacement_mm", "force_N"};

Failure badRecord(const std::string& name, std::size_t line, std::string problem) {
  return {FailureCode::unreadableInput, name, line == 0 ? "" : "line " + std::to_string(line),
          std::move(problem),
          "A record has the header time_s,displacement_mm,force_N and three numbers per line"};
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    fields.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return fields;
    begin = comma + 1;
  }
}

std::optional<double> finiteNumber(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// Where each of `columnNames` stands in the header.
std::optional<std::array<std::size_t, 3>> columnsOf(const std::vector<std::string_view>& header) {
  std::array<std::size_t, 3> columns{};
  for (std::size_t c = 0; c < columnNames.size(); ++c) {
    std::size_t at = 0;
    while (at < header.size() && header[at] != columnNames[c]) ++at;
    if (at == header.size()) return {};
    columns[c] = at;
  }
  return columns;
}

}  // namespace

Result<ForceRecord> parseForceRecord(const std::string& text, const std::string& name) {
  ForceRecord record;
  std::optional<std::array<std::size_t, 3>> columns;
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = trimmed(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string_view> fields = fieldsOf(line);
    if (!columns) {
      columns = columnsOf(fields);
      if (!columns)
        return badRecord(name, number, "the header is \"" + std::string(line.substr(0, 60)) + "\"");
      continue;
    }
    std::array<double, 3> values{};
    for (std::size_t c = 0; c < values.size(); ++c) {
      const std::optional<double> value =
          (*columns)[c] < fields.size() ? finiteNumber(fields[(*columns)[c]]) : std::nullopt;
      if (!value) return badRecord(name, number, std::string(columnNames[c]) + " is no finite number");
      values[c] = *value;
    }
    if (!record.time_s.empty() && values[0] <= record.time_s.back()) {
      return badRecord(name, number, "the time does not increase");
    }
    record.time_s.push_back(values[0]);
    record.displacement_mm.push_back(values[1]);
    record.force_N.push_back(values[2]);
  }
  if (!columns) return badRecord(name, 0, "is empty");
  return record;
}

Result<ForceRecord> readForceRecord(const std::string& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) return badRecord(file, 0, "cannot be opened (" + error.message() + ")");
  if (size > largestRecord_bytes) return badRecord(file, 0, "is larger than 256 MiB");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || (size > 0 && !(text << in.rdbuf()))) return badRecord(file, 0, "cannot be read");
  return parseForceRecord(text.str(), file);
}

}  // namespace detent::playback
