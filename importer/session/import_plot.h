// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Imports a graph of a page: as many readings as the quality asks for, judged together within a time limit.

#include <optional>

#include "importer/session/graph_reader.h"

namespace detent::importer {

ImportAttempt importPlot(GraphReader& reader, const ImportRequest& request, const Progress& progress);

/// The question about a refused graph, with the choices that lead to an accepted import.
std::optional<Question> openQuestion(GraphReader& reader, const ImportAttempt& attempt,
                                     const ImportRequest& request, const Progress& progress);

}  // namespace detent::importer
