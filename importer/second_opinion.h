// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads a page more than once, at other sizes. Equal readings are believed; different ones are both reported
// (docs/develop/decisions/0812-several-readings.md).

#include <functional>

#include "importer/importer.h"

namespace detent::importer {

/// Scales of a page for a second reading, and for a third if the second would decide alone. A picture is
/// enlarged, or reduced if it is large already; a document is drawn finer, and then as at `standard`.
struct OtherSizes {
  double second = 2, third = 1.5;
};
OtherSizes otherSizesOf(const Page& page);

/// One reading of a page and its result, made with ImportRequest::acceptDoubt.
struct PageReading {
  double magnification = 1;
  ImportAttempt attempt;
};

/// Returns true if another reading can resolve the doubts of this one. Facts of the page (several switches,
/// another quantity, a sign that may separate thousands) remain even if another reading does not find them.
/// If nothing resembling a graph was found, another reading does not help.
bool anotherMaySettle(const ImportAttempt& attempt);

/// Returns true if both read the same button: units and strokes agree within the difference of copies of one
/// graph.
bool sameButton(const ImportReport& a, const ImportReport& b);

/// Combines readings of one graph; any may have failed. A certain first reading stands. If the second is
/// certain of another button, both are reported: as a doubt that refuses the import if neither is much more
/// certain, else as a remark. An uncertain first reading is replaced by the second if that is certain and
/// `third`, which is called only then, is certain of the same button. A photograph on which all three agree
/// gets a higher confidence.
ImportAttempt settled(PageReading first, PageReading second, const std::function<PageReading()>& third,
                      double sure);

/// The report with one more remark, which is also added to its button's provenance.
ImportReport withRemark(ImportReport report, Remark remark);

}  // namespace detent::importer
