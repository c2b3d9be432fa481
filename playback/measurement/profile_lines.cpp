// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/profile_lines.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "model/text.h"
#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

/// The error of the first line; empty if there is none.
Message wrongWithFirst(std::string_view line, const ProfileKind& kind) {
  std::vector<double> version;
  if (!line.starts_with(kind.magic) || !numbersOf(line.substr(kind.magic.size()), version) ||
      version.size() != 1) {
    return Message("%1 must start with the line \"%2 %3\"", kind.what, kind.magic, kind.version);
  }
  if (version[0] <= kind.version) return {};
  return Message("a newer Detent wrote this file (version %1)", exact(version[0]));
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
                              const std::function<Message(std::string_view, std::string_view)>& line) {
  std::size_t number = 0;
  bool begun = false;
  const auto bad = [&](Message problem) {
    return Failure{FailureCode::unreadableInput, name, Message("line %1", number), std::move(problem),
                   Message("See docs/reference/device-profile.md")};
  };
  std::istringstream lines(text);
  for (std::string raw; std::getline(lines, raw);) {
    ++number;
    const std::string_view content = trimmed(std::string_view(raw).substr(0, raw.find('#')));
    if (content.empty()) continue;
    if (!begun) {
      if (Message problem = wrongWithFirst(content, kind); !problem.empty()) return bad(std::move(problem));
      begun = true;
      continue;
    }
    const std::size_t equals = content.find('=');
    if (equals == std::string_view::npos) return bad(Message("the line has no \"=\""));
    const std::string_view key = trimmed(content.substr(0, equals));
    Message problem = line(key, trimmed(content.substr(equals + 1)));
    if (!problem.empty()) return bad(Message("%1 %2", key, std::move(problem)));
  }
  if (!begun) return bad(Message("the file is empty"));
  return Done{};
}

}  // namespace detent::playback
