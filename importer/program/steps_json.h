// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results of each step of an import, for developers: the reference against which rules and rewrites of the
// importer are measured.

#include <string>

#include "importer/importer.h"

namespace detent::importer {

/// One JSON object: tokens, axes, polylines and pairing, as far as the import came. The shape may change
/// with the importer.
std::string stepsJson(const ImportAttempt& attempt, const std::string& input);

}  // namespace detent::importer
