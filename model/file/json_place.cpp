// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/json_place.h"

#include <algorithm>

#include "model/text.h"

namespace detent {

Message placeOfByte(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto lineStart = before.rfind('\n');
  const std::size_t column = before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
  return Message("line %1, column %2", std::to_string(lines + 1), std::to_string(column + 1));
}

Message notJson(std::string_view text, std::size_t byte) {
  if (byte > text.size()) return Message("the file is not valid JSON: it ends too early");
  constexpr std::size_t before = 40, after = 20;  // bytes quoted of a long line
  const std::size_t at = byte > 0 ? byte - 1 : 0;
  const std::size_t start = text.substr(0, at).rfind('\n') + 1;  // 0 in the first line
  const std::size_t from = std::max(start, at > before ? at - before : 0);
  std::string part(text.substr(from, std::min(text.find('\n', at), at + after) - from));
  for (char& c : part)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  const std::string_view quoted = trimmed(part);
  return quoted.empty() ? Message("the file is not valid JSON")
                        : Message("the file is not valid JSON: \"%1\" cannot be read", quoted);
}

std::string numberIn(std::string_view what) {
  const std::size_t first = what.find('\''), last = what.rfind('\'');
  return std::string(first < last ? what.substr(first + 1, last - first - 1) : what);
}

}  // namespace detent
