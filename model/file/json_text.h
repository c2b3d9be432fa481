// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Conversion of JSON to text.

#include <string>

namespace detent {

/// Returns the JSON as one line, or indented by `indent` spaces if that is not negative. Invalid UTF-8 (a
/// file name may have any bytes) becomes U+FFFD, where dump() would throw.
template <class Json>
std::string jsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace detent
