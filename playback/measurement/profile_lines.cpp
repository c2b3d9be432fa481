// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/profile_lines.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "model/text.h"
#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

/// What is wrong with the first line; empty if nothing.
std::string wrongWithFirst(std::string_view line, const ProfileKind& kind) {
  std::vector<double> version;
  if (!line.starts_with(kind.magic) || !numbersOf(line.substr(kind.magic.size()), version) ||
      version.size() != 1) {
    return kind.what + " starts with \"" + std::string(kind.magic) + " " + std::to_string(kind.version) +
           "\"";
  }
  return version[0] > kind.version ? "written by a newer Detent (version " + exact(version[0]) + ")" : "";
}

}  // namespace

/// All numbers of a value; false if something else stands there.
bool numbersOf(std::string_view text, std::vector<double>& numbers) {
  numbers.clear();
  while (!(text = trimmed(text)).empty()) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
    if (end != text.data() + text.size() && *end != ' ' && *end != '\t') return false;
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return true;
}

Result<Done> readProfileLines(const std::string& text, const std::string& name, const ProfileKind& kind,
                              const std::function<std::string(std::string_view, std::string_view)>& line) {
  std::size_t number = 0;
  bool begun = false;
  const auto bad = [&](std::string problem) {
    return Failure{FailureCode::unreadableInput, name, "line " + std::to_string(number), std::move(problem),
                   "See docs/device-profile.md"};
  };
  std::istringstream lines(text);
  for (std::string raw; std::getline(lines, raw);) {
    ++number;
    const std::string_view content = trimmed(std::string_view(raw).substr(0, raw.find('#')));
    if (content.empty()) continue;
    if (!begun) {
      if (std::string problem = wrongWithFirst(content, kind); !problem.empty())
        return bad(std::move(problem));
      begun = true;
      continue;
    }
    const std::size_t equals = content.find('=');
    if (equals == std::string_view::npos) return bad("no = in the line");
    const std::string_view key = trimmed(content.substr(0, equals));
    const std::string problem = line(key, trimmed(content.substr(equals + 1)));
    if (!problem.empty()) return bad(std::string(key) + " " + problem);
  }
  if (!begun) return bad("the file is empty");
  return Done{};
}

}  // namespace detent::playback
