// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/quantity_text.h"

#include <cmath>
#include <QLocale>
#include <QRegularExpression>

namespace detent::editor {
namespace {

double unitOf(Quantity quantity, const DisplayUnits& units) {
  switch (quantity) {
    case Quantity::length:
      return units.toMm(1);
    case Quantity::force:
      return units.toN(1);
    case Quantity::slope:
      return units.toSlope(1);
  }
  return 1;
}

std::optional<double> sizeOf(const QString& unit, Quantity quantity, const DisplayUnits& units) {
  if (unit.isEmpty()) return unitOf(quantity, units);
  const std::string name = unit.toStdString();
  if (quantity == Quantity::length) {
    const auto known = lengthUnitFrom(name);
    return known ? std::optional<double>(millimetresPer(*known)) : std::nullopt;
  }
  if (quantity == Quantity::force) {
    const auto known = forceUnitFrom(name);
    return known ? std::optional<double>(newtonsPer(*known)) : std::nullopt;
  }
  return unit == units.slopeSymbol() ? std::optional<double>(unitOf(quantity, units)) : std::nullopt;
}

}  // namespace

std::optional<double> parseQuantity(const QString& text, Quantity quantity, const DisplayUnits& units) {
  static const QRegularExpression form(
      QStringLiteral(R"(^\s*([-+\x{2212}]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?)\s*(\D*?)\s*$)"));
  const QRegularExpressionMatch match = form.match(text);
  if (!match.hasMatch()) return {};
  QString number = match.captured(1);
  number.replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
  bool ok = false;
  const double value = number.toDouble(&ok);
  const auto size = sizeOf(match.captured(2), quantity, units);
  if (!ok || !size || !std::isfinite(value * *size)) return {};
  return value * *size;
}

QString quantityText(double value, Quantity quantity, const DisplayUnits& units, int digits) {
  double shown = value / unitOf(quantity, units);
  if (shown == 0) shown = 0;  // no -0
  return QLocale().toString(shown, 'g', digits);
}

}  // namespace detent::editor
