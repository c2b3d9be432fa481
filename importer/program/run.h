// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-import after its command line was parsed.

#include <functional>

#include "importer/program/arguments.h"

namespace detent::importer {

/// Imports, prints, and returns the exit code. `cancelled` may be called from any thread.
int run(const Arguments& arguments, const std::function<bool()>& cancelled);

}  // namespace detent::importer
