// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one JSON object that --json prints.

#include <iostream>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"

namespace detent::playback {

using Json = nlohmann::ordered_json;

inline void print(const Json& json) { std::cout << jsonText(json) << "\n"; }

}  // namespace detent::playback
