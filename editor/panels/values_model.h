// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The exact values of a document's active state as a table.

#include <optional>
#include <QAbstractTableModel>
#include <QTimer>
#include <vector>

#include "editor/canvas/graph_marks.h"
#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {

/// Rows: tactile points, turns, sections (end position and mean slope), knots, operating and reset point;
/// with headings. Values in the user's units; a typed value becomes one undo step, or is refused with a
/// sentence and changes nothing. GUI thread.
class ValuesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { name, displacement, force, slopeBefore, slopeAfter, columns };

  ValuesModel(ButtonDocument& document, ViewSettings& settings, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// The button after an edit of a cell, or the reason of a refusal; both empty if the cell is not editable.
  struct Typed {
    std::optional<Button> button;
    QString refusal;
  };
  Typed typed(const QModelIndex& index, const QString& text) const;
  /// Doubt about an accepted text; empty: none.
  QString doubt(const QModelIndex& index, const QString& text) const;

  /// The mark of a row; nullopt for headings.
  std::optional<MarkId> markOf(const QModelIndex& index) const;
  std::optional<int> rowOf(MarkId mark) const;

 signals:
  /// A typed value was refused; `why` is the reason for the user.
  void refused(const QModelIndex& index, const QString& why);
  void accepted();

 private:
  /// A row of the table; without a mark it is a heading.
  struct Row {
    std::optional<MarkId> mark;
    QString heading;
    friend bool operator==(const Row&, const Row&) = default;
  };
  std::vector<Row> rowsNow() const;
  void follow();
  void followSoon();
  const ButtonState& state() const;
  std::optional<double> valueAt(const MarkId& mark, int column) const;
  Result<Button> edited(const MarkId& mark, int column, double value) const;
  static Quantity quantityOf(int column);
  bool editable(const MarkId& mark, int column) const;

  ButtonDocument& document_;
  ViewSettings& settings_;
  GraphValues values_;
  std::vector<Row> rows_;
  QTimer pause_;
};

}  // namespace detent::editor
