// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The question that would settle a refused graph.

#include <optional>

#include "importer/importer.h"

namespace detent::importer {

/// Question whose answer would let a refused import succeed: which of several switches to take, the unit of
/// an axis that names none, which of two curves is the press, or which is the release of a given press. Each
/// choice names all that it sets. The choices have not been tried yet. Returns nullopt if no single answer
/// is known to settle the failure. `evidence` may be null.
std::optional<Question> questionAbout(const Failure& failure, const GraphEvidence* evidence,
                                      const ImportHints& hints = {});

}  // namespace detent::importer
