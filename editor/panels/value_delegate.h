// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table cell for a number with a unit.

#include <functional>
#include <QStyledItemDelegate>

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
  QPersistentModelIndex askedAt_;  ///< place of the last question
  QString askedAbout_;             ///< its text; empty: none
};

}  // namespace detent::editor
