// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Evidence against an import in which every single step was certain: the page contradicts itself, or the
// result does not resemble the strokes of one button. docs/develop/decisions/0805-doubts.md lists the wrong
// buttons that each check has found.

#include <vector>

#include "importer/graph_findings.h"

namespace detent::importer {

/// `confidence`: upper limit of the import's confidence with this doubt, 0..1.
struct WeighedDoubt {
  Doubt doubt;
  double confidence = 0;
};

/// The advice on a graph with a second scale of forces, where no choice of curves can help.
Remedies graphWithOneScale();

/// Factor for the confidence of the steps on pages of a class, 0..1. Measured:
/// docs/measurements/import-confidence.md.
double worthOf(PageClass pageClass);

/// Doubts about an import; empty if there are none. Values given by hand are not doubted.
std::vector<WeighedDoubt> doubtsOf(const GraphFindings& findings, const std::vector<SpecCheck>& checks,
                                   const ImportHints& hints);

/// The same for a force meter's log: checks sizes, signs and shape of its strokes. There is no page to
/// compare them with.
std::vector<WeighedDoubt> doubtsOfLog(const StrokePair& strokes, const FittedStrokes& fitted,
                                      const ImportHints& hints);

}  // namespace detent::importer
