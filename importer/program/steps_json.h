// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What each step of an import found, for developers: the oracle that rules and rewrites of the importer are
// measured with.

#include <string>

#include "importer/importer.h"

namespace detent::importer {

/// One JSON object: tokens, axes, polylines and pairing, as far as the import came. The shape may change
/// with the importer.
std::string stepsJson(const ImportAttempt& attempt, const std::string& input);

}  // namespace detent::importer
