// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one way JSON becomes text.

#include <string>

namespace detent {

/// nlohmann's JSON of either kind as text: one line, or indented by `indent` spaces where that is not negative. What is no UTF-8 (a
/// file's name may be any bytes) becomes U+FFFD, where the library's own dump() would throw.
template <class Json>
std::string jsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace detent
