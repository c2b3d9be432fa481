// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A page read more than once, at other sizes: equal readings are believed, different ones are both reported
// (docs/develop/decisions/0812-several-readings.md).

#include <functional>

#include "importer/importer.h"

namespace detent::importer {

/// Scale of a page for a second reading, and for a third if the second alone would decide: a picture larger,
/// or smaller if it is large already; a document finer, and then as `standard` draws it.
struct OtherSizes {
  double second = 2, third = 1.5;
};
OtherSizes otherSizesOf(const Page& page);

/// One reading and its result, made with ImportRequest::acceptDoubt.
struct PageReading {
  double magnification = 1;
  ImportAttempt attempt;
};

/// Returns true if another reading can resolve the doubts of this one. Facts of the page (several switches,
/// another quantity, a sign that may separate thousands) are not overruled by a reading that does not see
/// them, and if nothing like a graph was found there is no other reading.
bool anotherMaySettle(const ImportAttempt& attempt);

/// Returns true if both read the same button: units and strokes agree within the difference of copies of one
/// graph.
bool sameButton(const ImportReport& a, const ImportReport& b);

/// Combines readings of one graph; any may have failed. A first one that is certain stands; if the second one
/// is certain of another button, both are reported: in a doubt that refuses if neither is much more certain,
/// else in a remark. In place of an uncertain first one the second is taken if it is certain and `third`,
/// which is called only then, is certain of the same button. A photograph that all three readings agree on is
/// worth more.
ImportAttempt settled(PageReading first, PageReading second, const std::function<PageReading()>& third,
                      double sure);

/// The report with one remark more, in its button's provenance, too.
ImportReport withRemark(ImportReport report, Remark remark);

}  // namespace detent::importer
