// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table cell for a number with a unit.

#include <functional>
#include <QStyledItemDelegate>

class QLineEdit;

namespace detent::editor {

/// Keeps a cell open, marked, with the reason beside it, as long as what is typed there is refused. Its parent is the
/// table. GUI thread.
class ValueDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// Why a text cannot stand in a cell; empty: it can.
  using Refusal = std::function<QString(const QModelIndex&, const QString&)>;
  ValueDelegate(Refusal refusal, QObject* parent);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;

 signals:
  /// Enter or Tab was pressed on a refused text.
  void refused(const QModelIndex& index, const QString& why);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static void mark(QLineEdit& editor, const QString& why);
  Refusal refusal_;
};

}  // namespace detent::editor
