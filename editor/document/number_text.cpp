// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/number_text.h"

#include <algorithm>
#include <cmath>
#include <QLocale>

namespace detent::editor {
namespace {

// numbers beyond these limits are written with powers of ten
constexpr double largestFixed = 1e9, smallestFixed = 1e-5;
constexpr int mostDecimals = 17;

// C digits with the decimal sign of this locale.
QString localized(QString text) {
  const QString sign = QLocale().decimalPoint();
  if (sign == QLatin1String(",")) text.replace(QLatin1Char('.'), QLatin1Char(','));
  return text;
}

QString withoutTrailingZeros(QString text) {
  if (!text.contains(QLatin1Char('.'))) return text;
  while (text.endsWith(QLatin1Char('0'))) text.chop(1);
  if (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

}  // namespace

QString numberText(double value, int significant) {
  if (value == 0 || !std::isfinite(value)) return value == 0 ? QStringLiteral("0") : QStringLiteral("–");
  const double size = std::abs(value);
  if (size >= largestFixed || size < smallestFixed)
    return localized(QString::number(value, 'g', std::max(significant, 1)));
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  const int decimals = std::clamp(significant - 1 - magnitude, 0, mostDecimals);
  return localized(withoutTrailingZeros(QString::number(value, 'f', decimals)));
}

QString fixedText(double value, int decimals) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  QString text = QString::number(value, 'f', decimals);
  const bool isZero = std::all_of(text.cbegin(), text.cend(), [](QChar c) {
    return c == QLatin1Char('-') || c == QLatin1Char('0') || c == QLatin1Char('.');
  });
  if (isZero && text.startsWith(QLatin1Char('-'))) text.remove(0, 1);
  return localized(text);
}

}  // namespace detent::editor
