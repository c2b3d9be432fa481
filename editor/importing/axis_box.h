// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One axis of the graph: the values at its ends, its unit, and where they come from.

#include <QComboBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <vector>

#include "editor/importing/origin_mark.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {

/// Fields that correct the axes of the current graph. A text that cannot be read stays as typed, with the
/// reason. GUI thread.
class AxisBox : public QGroupBox {
  Q_OBJECT

 public:
  /// `state` must outlive it.
  AxisBox(ImportState& state, GraphAxis axis, QWidget* parent = nullptr);

  /// Shows the current graph's axis; `ofLog`: it belongs to a force meter's log, of which only
  /// the unit is shown.
  void follow(bool ofLog);
  /// The field that gets the focus.
  QLineEdit* firstField() { return min_; }
  QComboBox* unitField() { return unit_; }
  /// The first field whose text cannot be read, with the reason shown; null if all can be read. Applies
  /// texts that were typed but not confirmed yet.
  QLineEdit* refusedField();

 signals:
  /// The user wants to set the values on the page.
  void ticksRequested();

 private:
  void build();
  QHBoxLayout* rangeRow();
  QWidget* directionRow();
  QHBoxLayout* originRow();
  QHBoxLayout* unitRow();
  void nameFields();
  void takeEnd(bool isMax);
  bool takeWithUnit(QLineEdit& edit, bool isMax);
  /// `otherToo`: the other end was typed as well, and both are one step.
  void setEnd(bool isMax, double value, std::optional<double> other, bool otherToo,
              std::optional<std::size_t> unit);
  void takeUnit(std::size_t index);
  /// Puts the larger of the two given ends where the axis begins (`falls`) or ends.
  void turn(bool falls);
  void showEnds(const AxisCorrection& given, const std::optional<AxisEnds>& found);
  QString noLength() const;
  void showUnit(const Corrections& given, const importer::AxisReading* found);
  QString detailsOf(const AxisCorrection& given, const importer::AxisReading* found) const;
  void followExtension(const importer::GraphEvidence* evidence, const importer::AxisReading* reading);
  QuantityReading typedIn(const QLineEdit& field) const;

  ImportState& state_;
  GraphAxis axis_;
  QLineEdit *min_, *max_;
  QComboBox* unit_;
  OriginMark *range_, *unitOrigin_;
  QLabel* details_;
  QPushButton* extend_;
  QWidget* direction_ = nullptr;
  QToolButton *rises_ = nullptr, *falls_ = nullptr;
  std::optional<GraphId> shownGraph_;
  std::vector<QWidget*> ofPage_;               ///< widgets that a force meter's log does not need
  std::optional<double> minShown_, maxShown_;  ///< values as shown, in the printed unit
};

}  // namespace detent::editor
