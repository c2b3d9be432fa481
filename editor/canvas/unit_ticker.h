// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ticks at round numbers of the user's unit on an axis in mm or N.

#include <qcustomplot.h>

namespace detent::editor {

/// GUI thread.
class UnitTicker : public QCPAxisTicker {
 public:
  /// Size of the shown unit in the axis' own (10 µm: 0.01); > 0.
  void setUnit(double size) { size_ = size; }
  double unit() const { return size_; }

  void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                QVector<double>& ticks, QVector<double>* subTicks, QVector<QString>* tickLabels) override;

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar formatChar, int precision) override;

 private:
  double size_ = 1;
};

}  // namespace detent::editor
