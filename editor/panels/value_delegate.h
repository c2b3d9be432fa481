// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Table of numbers with units, and the editor of a cell.

#include <functional>
#include <QStyledItemDelegate>
#include <QTableView>

class QLineEdit;

namespace detent::editor {

/// Keeps a cell open and marked, with the reason beside it, while its text is refused; an unusual value is
/// questioned once and accepted on the second Enter. Its parent is the table. GUI thread.
class ValueDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// Reason why a text is refused; empty if accepted.
  using Refusal = std::function<QString(const QModelIndex&, const QString&)>;
  /// Doubt about an accepted text; empty: none.
  using Doubt = std::function<QString(const QModelIndex&, const QString&)>;
  ValueDelegate(Refusal refusal, Doubt doubt, QObject* parent);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;

 signals:
  /// Enter or Tab was pressed on a refused text, or for the first time on an unusual one.
  void refused(const QModelIndex& index, const QString& why);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static void mark(QLineEdit& editor, const QString& why);
  QString objection(const QString& text, const QModelIndex& index);

  Refusal refusal_;
  Doubt doubt_;
  QPersistentModelIndex questionIndex_;  ///< place of the last question
  QString questionText_;                 ///< its text; empty: none
};

/// Table in which typing changes the current cell or nothing: a cell that cannot be edited never passes the
/// text on to another row. GUI thread.
class ValueTable : public QTableView {
  Q_OBJECT

 public:
  using QTableView::QTableView;
  /// Does nothing: Qt would move to a row that begins with the typed digit, and the next digit would edit it.
  void keyboardSearch(const QString&) override {}

 signals:
  /// The user tried to edit a cell that cannot be edited.
  void editRefused(const QModelIndex& index);

 protected:
  bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
};

}  // namespace detent::editor
