// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Old button files are brought to the present version step by step, on the JSON, before anything is read from
// it.

#include <functional>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/result.h"

namespace detent {

/// Turns a document of one version into one of the next; `version` itself is set by migrated().
using Migration = std::function<void(nlohmann::json&)>;

/// Entry i turns version i + 1 into version i + 2. One entry is added whenever buttonFileVersion grows, none
/// ever goes.
const std::vector<Migration>& buttonMigrations();

/// Brings a document to version steps.size() + 1. Refuses versions above it and below 1. `subject` as in
/// buttonFromJson.
Result<nlohmann::json> migrated(nlohmann::json document, const std::vector<Migration>& steps,
                                const std::string& subject);

}  // namespace detent
