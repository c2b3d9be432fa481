// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/value_delegate.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QTableView>
#include <utility>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"

namespace detent::editor {

ValueDelegate::ValueDelegate(Refusal refusal, Doubt doubt, QObject* parent)
    : QStyledItemDelegate(parent), refusal_(std::move(refusal)), doubt_(std::move(doubt)) {}

QString ValueDelegate::objection(const QString& text, const QModelIndex& index) {
  if (QString why = refusal_(index, text); !why.isEmpty()) return why;
  if (index == questionIndex_ && text == questionText_) return {};
  QString question = doubt_(index, text);
  questionIndex_ = index;
  questionText_ = question.isEmpty() ? QString() : text;
  return question;
}

QWidget* ValueDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                     const QModelIndex& index) const {
  auto* editor = described(new QLineEdit(parent), "valueEditor");
  editor->setFrame(false);
  editor->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  const QPersistentModelIndex cell(index);
  connect(editor, &QLineEdit::textEdited, editor,
          [this, editor, cell] { mark(*editor, refusal_(cell, editor->text())); });
  return editor;
}

bool ValueDelegate::eventFilter(QObject* object, QEvent* event) {
  auto* editor = qobject_cast<QLineEdit*>(object);
  if (!editor || event->type() != QEvent::KeyPress) return QStyledItemDelegate::eventFilter(object, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool ends =
      key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
  const auto* table = qobject_cast<QTableView*>(parent());
  if (!ends || !table) return QStyledItemDelegate::eventFilter(object, event);
  const QString why = objection(editor->text(), table->currentIndex());
  if (why.isEmpty()) return QStyledItemDelegate::eventFilter(object, event);
  mark(*editor, why);
  emit refused(table->currentIndex(), why);
  return true;
}

bool ValueTable::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
  const bool attempted = trigger == DoubleClicked || trigger == EditKeyPressed || trigger == AnyKeyPressed;
  if (attempted && index.isValid() && !(model()->flags(index) & Qt::ItemIsEditable)) {
    emit editRefused(index);
    return false;
  }
  return QTableView::edit(index, trigger, event);
}

void ValueDelegate::mark(QLineEdit& editor, const QString& why) {
  QPalette colors = editor.palette();
  const bool dark = isDark(editor.parentWidget()->palette());
  colors.setColor(QPalette::Text, why.isEmpty() ? editor.parentWidget()->palette().color(QPalette::Text)
                                                : graphColors(dark).refused);
  editor.setPalette(colors);
  editor.setAccessibleDescription(why);
}

}  // namespace detent::editor
