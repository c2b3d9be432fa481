// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/display_units.h"

namespace detent::editor {
namespace {

QString text(std::string_view symbol) {
  return QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size()));
}

}  // namespace

QString DisplayUnits::lengthSymbol() const { return text(symbolOf(length)); }
QString DisplayUnits::forceSymbol() const { return text(symbolOf(force)); }

}  // namespace detent::editor
