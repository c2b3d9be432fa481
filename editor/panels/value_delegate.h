// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Table of numbers with units, and the editor of a cell.

#include <functional>
#include <map>
#include <QStyledItemDelegate>
#include <QTableView>
#include <utility>

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

  /// Role of a cell's unit, which stands behind the number.
  static constexpr int unitRole = Qt::UserRole;
  /// Draws the numbers of a column, with or without their units, decimal signs below each other; `widest` is
  /// the longest text that may stand behind the whole part of a number.
  void alignDecimals(int column, const QString& widest, bool withUnits = true) {
    tails_[column] = {widest, withUnits};
  }
  /// A cell's text before and from the decimal sign on, its unit included if wanted; the second part is empty
  /// for a text that is no number.
  static std::pair<QString, QString> atDecimal(const QModelIndex& cell, bool withUnit);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  /// Fills in the exact number if the cell has space for it, else the text that the cell shows.
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  /// Leaves the value as it is if the text is the one that was filled in, which may have fewer digits.
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
  /// The cell, widened to the left if its text is longer.
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
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
  QString questionText_;                 ///< text of the question; empty: none
  /// Decides where the decimal signs of a column stand. Without one numbers end at the right.
  struct Tail {
    QString widest;
    bool withUnits = true;
  };
  std::map<int, Tail> tails_;
};

/// Table in which typing changes the current cell or nothing: a cell that cannot be edited never passes the
/// text on to another row. GUI thread.
class ValueTable : public QTableView {
  Q_OBJECT

 public:
  using QTableView::QTableView;
  /// Rows as high as a line of text, no grid; Tab leaves the table, arrows move in it.
  void setUpForNumbers();
  /// Does nothing: Qt would move to a row that begins with the typed digit, and the next digit would edit it.
  void keyboardSearch(const QString&) override {}

 signals:
  /// The user tried to edit a cell that cannot be edited.
  void editRefused(const QModelIndex& index);

 protected:
  bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
};

}  // namespace detent::editor
