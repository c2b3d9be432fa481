// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Title that a document prints above one of its graphs.

#include <string>

#include "importer/locate_graphs.h"

namespace detent::importer {

/// The line of the document's own text that stands nearest above the plot frame, over its middle part; empty
/// where there is none, where it is as long as a sentence, and on pages whose texts are pixels.
std::string titleAbove(const LocatedGraph& graph);

}  // namespace detent::importer
