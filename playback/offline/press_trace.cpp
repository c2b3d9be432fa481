// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>

#include "playback/offline/press_files.h"

namespace detent::playback {

namespace {

constexpr std::uintmax_t largestTrace_bytes = 1ULL << 30;

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// A whole field as a number; "nan" and "inf" are numbers here.
bool parseNumber(std::string_view field, double& value) {
  field = trimmed(field);
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error == std::errc::result_out_of_range) {
    value = std::numeric_limits<double>::infinity();
    return end == field.data() + field.size();
  }
  return error == std::errc() && end == field.data() + field.size() && !field.empty();
}

std::string quoted(std::string_view text) {
  std::string result(1, '"');
  result.append(text.substr(0, 60));
  result.push_back('"');
  return result;
}

Failure badLine(const std::string& name, std::size_t line, std::string problem) {
  return {FailureCode::unreadableInput, name, "line " + std::to_string(line), std::move(problem),
          "A press trace has the header time_s,force_N or time_s,displacement_mm and two numbers per line"};
}

}  // namespace

Result<PressTrace> parsePressTrace(const std::string& text, const std::string& name) {
  PressTrace trace;
  bool header = false;
  std::size_t number = 0;
  std::string_view rest = text;
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = trimmed(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos) return badLine(name, number, "no comma in " + quoted(line));
    const std::string_view first = trimmed(line.substr(0, comma)), second = trimmed(line.substr(comma + 1));
    if (!header) {
      if (first != "time_s" || (second != "force_N" && second != "displacement_mm")) {
        return badLine(name, number, "the header is " + quoted(line));
      }
      trace.quantity =
          second == "force_N" ? PressTrace::Quantity::force_N : PressTrace::Quantity::displacement_mm;
      header = true;
      continue;
    }
    PressReading reading;
    if (!parseNumber(first, reading.time_s) || !std::isfinite(reading.time_s)) {
      return badLine(name, number, quoted(first) + " is not a time");
    }
    if (!parseNumber(second, reading.value)) {
      return badLine(name, number, quoted(second) + " is not a number");
    }
    trace.readings.push_back(reading);
  }
  if (!header) return badLine(name, number, "the file is empty");
  if (trace.readings.empty()) return badLine(name, number, "no reading follows the header");
  return trace;
}

Result<PressTrace> readPressTrace(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) {
    return Failure{FailureCode::unreadableInput, file.string(), "",
                   "cannot be opened (" + error.message() + ")", "Give a press trace CSV"};
  }
  if (size > largestTrace_bytes) {
    return Failure{FailureCode::unreadableInput, file.string(), "", "larger than 1 GiB",
                   "Cut the trace into parts"};
  }
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()) || in.bad()) {
    return Failure{FailureCode::unreadableInput, file.string(), "", "cannot be read",
                   "Give a press trace CSV"};
  }
  return parsePressTrace(text.str(), file.string());
}

}  // namespace detent::playback
