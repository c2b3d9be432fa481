// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables for the clipboard.

#include <QString>

namespace detent::editor {

/// A field of a CSV line (RFC 4180), always quoted.
inline QString csvField(QString text) { return '"' + text.replace('"', QStringLiteral("\"\"")) + '"'; }

}  // namespace detent::editor
