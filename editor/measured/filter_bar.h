// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Filters the measured switches by words, kind, and ranges of figures.

#include <memory>
#include <optional>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/measured/switch_filter.h"

namespace detent::editor {

/// GUI thread.
class FilterBar : public QWidget {
  Q_OBJECT

 public:
  explicit FilterBar(const DisplayUnits& units, QWidget* parent = nullptr);

  /// The filter as typed. Ends that cannot be read are marked, and count as open.
  SwitchFilter filter() const;
  /// Sets the units of numbers that are typed without one.
  void setUnits(const DisplayUnits& units);
  /// Adds a range of a figure with both ends open.
  void addRange();
  bool empty() const;
  void clear();

 signals:
  void changed();

 private:
  struct Range {
    QWidget* row = nullptr;
    QComboBox* figure = nullptr;
    QLineEdit *low = nullptr, *high = nullptr;
  };
  QLineEdit* endOf(const char* name, const QString& hint);
  void remove(QWidget* row);
  std::optional<double> read(QLineEdit& end, KeyFigure figure) const;
  void check();

  DisplayUnits units_;
  QLineEdit* words_ = nullptr;
  QComboBox* kind_ = nullptr;
  QPushButton* add_ = nullptr;
  QVBoxLayout* rows_ = nullptr;
  std::vector<Range> ranges_;
};

}  // namespace detent::editor
