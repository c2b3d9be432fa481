// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A page looked at more than once, at other sizes: what two looks say is believed, where they differ both are
// told (docs/develop/decisions/0812-several-readings.md).

#include <functional>

#include "importer/importer.h"

namespace detent::importer {

/// How many times its size a page is looked at for a second opinion, and for a third where the second alone
/// would decide: a picture larger, or smaller where it is large already; a document finer, and then as
/// `standard` draws it.
struct OtherSizes {
  double second = 2, third = 1.5;
};
OtherSizes otherSizesOf(const Page& page);

/// One look and what came of it, made with ImportRequest::acceptDoubt.
struct PageReading {
  double magnification = 1;
  ImportAttempt attempt;
};

/// Whether another look can make up for what is wrong with this one. What stands on the page (several
/// switches, another quantity, a sign that may part thousands) is not read away by a look that does not see
/// it, and where nothing like a graph was found none is looked for again.
bool anotherMaySettle(const ImportAttempt& attempt);

/// Both read the same button: units and strokes agree within what copies of one graph differ by.
bool sameButton(const ImportReport& a, const ImportReport& b);

/// What looks at one graph come to; any may have failed. A first one that is certain stands; where the second
/// one is certain of another button, both are told: in a doubt that refuses where neither is much surer, else
/// in a remark. In place of an uncertain first one the second is taken where it is certain and `third`, which
/// is asked for only then, is certain of the same button. A photograph that all three looks read alike is
/// worth more. The report keeps all looks (ImportReport::looks).
ImportAttempt settled(PageReading first, PageReading second, const std::function<PageReading()>& third,
                      double sure);

/// The report with one remark more, in its button's provenance, too.
ImportReport withRemark(ImportReport report, Remark remark);

}  // namespace detent::importer
