// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The library's answers, as JSON in the shape that scripts rely on.

#include <string>

#include "importer/switch_library.h"

namespace detent::importer {

/// One object, one line: `found`, `nearest`, `fitting`, `lab_noise_N`.
std::string foundJson(const FoundSwitches& result);

}  // namespace detent::importer
