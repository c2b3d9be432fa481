// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/unit_ticker.h"

#include <cmath>

#include "editor/quantity/quantity.h"

namespace detent::editor {

void UnitTicker::generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                          QVector<double>& ticks, QVector<double>* subTicks, QVector<QString>* tickLabels) {
  QCPAxisTicker::generate({range.lower / size_, range.upper / size_}, locale, formatChar, precision, ticks,
                          subTicks, tickLabels);
  for (double& tick : ticks) tick *= size_;
  if (subTicks)
    for (double& tick : *subTicks) tick *= size_;
}

// Rounding must not print 1.0000000000000002 or -0.
QString UnitTicker::getTickLabel(double tick, const QLocale&, QChar, int precision) {
  if (std::abs(tick) < 1e-12) tick = 0;
  return numberText(tick, precision);
}

}  // namespace detent::editor
