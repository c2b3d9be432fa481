// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Evidence against an import although every step was certain: the page contradicts itself, or the result does
// not resemble one button's strokes. docs/develop/decisions/0805-doubts.md names the wrong buttons that each
// has found.

#include <optional>
#include <vector>

#include "importer/graph_findings.h"

namespace detent::importer {

/// `confidence`: what an import with this doubt is worth at most, 0..1.
struct WeighedDoubt {
  Doubt doubt;
  double confidence = 0;
};

/// The doubt about an axis that measures neither force nor travel; nullopt without one.
std::optional<Doubt> otherQuantityOf(const AxisReading& axis, bool isForce);

/// Factor of the steps' confidence on pages of a class, 0..1: counted,
/// docs/measurements/import-confidence.md.
double worthOf(PageClass pageClass);

/// Empty for an import that nothing speaks against. What was given by hand is not doubted.
std::vector<WeighedDoubt> doubtsOf(const GraphFindings& findings, const std::vector<SpecCheck>& checks,
                                   const ImportHints& hints);

/// The same of a force meter's log, which has no page to hold it against: sizes, signs and shape of its
/// strokes.
std::vector<WeighedDoubt> doubtsOfLog(const StrokePair& strokes, const FittedStrokes& fitted,
                                      const ImportHints& hints);

}  // namespace detent::importer
