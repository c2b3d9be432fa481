// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Migration of old button files on the JSON, version by version, before it is read.

#include <functional>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/result.h"

namespace detent {

/// Converts a document to the next version; migrated() sets `version` itself.
using Migration = std::function<void(nlohmann::json&)>;

/// Entry i converts version i + 1 to version i + 2. One entry is added whenever buttonFileVersion grows; none
/// is removed.
const std::vector<Migration>& buttonMigrations();

/// Brings a document to version steps.size() + 1. Refuses versions above it and below 1. `subject`: as in
/// buttonFromJson.
Result<nlohmann::json> migrated(nlohmann::json document, const std::vector<Migration>& steps,
                                const std::string& subject);

}  // namespace detent
