// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What detent-import does once its command line is understood.

#include <functional>

#include "importer/program/arguments.h"

namespace detent::importer {

/// Runs, prints, and gives the exit code. `cancelled` may be asked from any thread.
int run(const Arguments& arguments, const std::function<bool()>& cancelled);

}  // namespace detent::importer
