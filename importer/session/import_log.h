// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Imports a force meter's log.

#include <string>
#include <vector>

#include "importer/importer.h"

namespace detent::importer {

ImportAttempt importLog(const std::string& path, const ImportRequest& request, const Progress& progress);

/// Records of the log, for choosing one.
Result<std::vector<ListedRecord>> recordsOfLog(const std::string& path, const ImportHints& hints,
                                               const Progress& progress);

}  // namespace detent::importer
