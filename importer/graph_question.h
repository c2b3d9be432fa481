// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The question that would settle a refused graph.

#include <optional>

#include "importer/importer.h"

namespace detent::importer {

/// Question whose answer would let a refused import succeed: which of several switches to take, the unit of
/// an axis that names none, or which of two curves is the press. The choices have not been tried yet. Returns
/// nullopt if no single answer is known to settle the failure. `evidence` may be null.
std::optional<Question> questionAbout(const Failure& failure, const GraphEvidence* evidence);

}  // namespace detent::importer
