#pragma once
// Whether somebody is watching. POSIX.

namespace detent::importer {

bool stderrIsTerminal();

}  // namespace detent::importer
