// SPDX-License-Identifier: GPL-3.0-or-later
// For builds without DETENT_WITH_LIBRARY: the command is recognised and refused.
#include <cstdio>

#include "importer/program/library_program.h"
#include "model/result.h"

namespace detent::importer {

int runLibrary(int, char**, const std::function<bool()>&) {
  std::fputs("detent-import: this build has no library. Build with DETENT_WITH_LIBRARY=ON (needs SQLite).\n",
             stderr);
  return static_cast<int>(FailureCode::wrongUsage);
}

}  // namespace detent::importer
