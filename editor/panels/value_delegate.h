// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table cell for a number with a unit.

#include <functional>
#include <QStyledItemDelegate>

class QLineEdit;

namespace detent::editor {

/// Keeps a cell open, marked, with the reason beside it, as long as what is typed there is refused; what is odd is asked
/// about once, and taken when Enter is pressed on it again. Its parent is the table. GUI thread.
class ValueDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// Why a text cannot stand in a cell; empty: it can.
  using Refusal = std::function<QString(const QModelIndex&, const QString&)>;
  /// What is odd about a text that can stand in a cell; empty: nothing.
  using Doubt = std::function<QString(const QModelIndex&, const QString&)>;
  ValueDelegate(Refusal refusal, Doubt doubt, QObject* parent);

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;

 signals:
  /// Enter or Tab was pressed on a refused text, or for the first time on an odd one.
  void refused(const QModelIndex& index, const QString& why);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static void mark(QLineEdit& editor, const QString& why);
  QString objection(const QString& text, const QModelIndex& index);

  Refusal refusal_;
  Doubt doubt_;
  QPersistentModelIndex askedAt_;  ///< where the last question was asked
  QString askedAbout_;             ///< about which text; empty: none
};

}  // namespace detent::editor
