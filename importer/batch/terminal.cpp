// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/batch/terminal.h"

#include <unistd.h>

namespace detent::importer {

bool stderrIsTerminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace detent::importer
