// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/json_place.h"

#include <algorithm>

namespace detent {

Message placeOfByte(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto lineStart = before.rfind('\n');
  const std::size_t column = before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
  return Message("line %1, column %2", std::to_string(lines + 1), std::to_string(column + 1));
}

std::string plainReason(const std::string& what) {
  // "[json.exception.out_of_range.406] number overflow", "[json.exception.parse_error.101] parse error at
  // line 1: syntax error"
  const auto named = what.starts_with('[') ? what.find("] ") : std::string::npos;
  const auto colon = what.find(": ");
  std::string reason = colon != std::string::npos   ? what.substr(colon + 2)
                       : named != std::string::npos ? what.substr(named + 2)
                                                    : what;
  if (reason.size() > 160) reason = reason.substr(0, 160) + "...";
  for (char& c : reason)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return reason;
}

}  // namespace detent
