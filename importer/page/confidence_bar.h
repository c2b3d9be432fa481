// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The confidence that divides believed results from doubtful ones.

namespace detent::importer {

/// Default of ImportRequest::sure: an import with less confidence fails with notCertain (exit code 5) and the
/// options to pass. Labels of an axis with less confidence are not trusted without a given end. Set from the
/// corpus (docs/develop/decisions/0800-import-confidence.md).
inline constexpr double confidenceBar = 0.5;

}  // namespace detent::importer
