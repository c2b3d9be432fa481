// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The question that would settle a refused graph.

#include <optional>

#include "importer/importer.h"

namespace detent::importer {

/// What a person who sees the page could say where an import was refused: which of several switches, the unit
/// of an axis that names none, which of two curves is the press. The choices are not tried yet. nullopt: no
/// single answer is known to settle it. `evidence` may be null.
std::optional<Question> questionAbout(const Failure& failure, const GraphEvidence* evidence);

}  // namespace detent::importer
