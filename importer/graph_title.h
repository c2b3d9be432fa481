// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Title that a document prints above one of its graphs.

#include <string>

#include "importer/locate_graphs.h"

namespace detent::importer {

/// Line of the document's text nearest above the middle part of the plot frame. Empty if there is none, if it
/// is as long as a sentence, and on pages whose texts are pixels.
std::string titleAbove(const LocatedGraph& graph);

}  // namespace detent::importer
