// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/value_delegate.h"

#include <algorithm>
#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>
#include <QTableView>
#include <utility>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

constexpr char filledIn[] = "filledIn";  // property of a line: its text at first

/// The text may have fewer digits than the value, which typing the same again must not round.
bool isUntouched(const QLineEdit& line) { return line.text() == line.property(filledIn).toString(); }

/// Width of a line without a frame in which the text is seen whole.
int lineWidth_px(const QLineEdit& line, const QString& text) {
  constexpr int margins_px = 6;  // Qt's beside the text, and the cursor
  return line.fontMetrics().horizontalAdvance(text) + margins_px;
}

}  // namespace

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

std::pair<QString, QString> ValueDelegate::atDecimal(const QModelIndex& cell, bool withUnit) {
  static const QRegularExpression number(QStringLiteral("^[-+\u2212]?[0-9]+"));
  const QString text = cell.data().toString();
  const QString unit = withUnit ? u' ' + cell.data(unitRole).toString() : QString();
  const qsizetype whole = number.match(text).capturedLength();
  if (whole == 0) return {text, {}};
  return {text.left(whole), text.mid(whole) + unit};
}

void ValueDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  constexpr int margin_px = 4;
  const auto tail = tails_.find(index.column());
  if (tail == tails_.end() || !index.data(unitRole).isValid())
    return QStyledItemDelegate::paint(painter, option, index);
  const auto [before, after] = atDecimal(index, tail->second.withUnits);
  QStyleOptionViewItem cell = option;
  initStyleOption(&cell, index);
  const QStyle& style = cell.widget ? *cell.widget->style() : *QApplication::style();
  cell.text.clear();
  style.drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
  const QFontMetrics metrics(cell.font);
  const int sign_px =
      std::max(cell.rect.left() + margin_px + metrics.horizontalAdvance(before),
               cell.rect.right() - margin_px - metrics.horizontalAdvance(tail->second.widest));
  const bool chosen = cell.state & QStyle::State_Selected;
  const auto group = cell.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
  painter->save();
  painter->setClipRect(cell.rect);
  painter->setFont(cell.font);
  painter->setPen(cell.palette.color(group, chosen ? QPalette::HighlightedText : QPalette::Text));
  const int base_px = cell.rect.center().y() + (metrics.ascent() - metrics.descent()) / 2 + 1;
  painter->drawText(sign_px - metrics.horizontalAdvance(before), base_px, before);
  painter->drawText(sign_px, base_px, after);
  painter->restore();
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

void ValueDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* line = qobject_cast<QLineEdit*>(editor);
  if (!line) return QStyledItemDelegate::setEditorData(editor, index);
  const QString exact = index.data(Qt::EditRole).toString();
  line->setText(lineWidth_px(*line, exact) <= line->width() ? exact : index.data().toString());
  line->setProperty(filledIn, line->text());
}

void ValueDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  if (const auto* line = qobject_cast<QLineEdit*>(editor); line && isUntouched(*line)) return;
  QStyledItemDelegate::setModelData(editor, model, index);
}

void ValueDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex& index) const {
  QRect place = option.rect;
  if (const auto* line = qobject_cast<QLineEdit*>(editor))
    place.setLeft(std::max(
        0, std::min(place.left(), place.right() + 1 - lineWidth_px(*line, index.data().toString()))));
  editor->setGeometry(place);
}

bool ValueDelegate::eventFilter(QObject* object, QEvent* event) {
  auto* editor = qobject_cast<QLineEdit*>(object);
  if (!editor || event->type() != QEvent::KeyPress) return QStyledItemDelegate::eventFilter(object, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool ends =
      key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
  const auto* table = qobject_cast<QTableView*>(parent());
  if (!ends || !table) return QStyledItemDelegate::eventFilter(object, event);
  if (isUntouched(*editor)) return QStyledItemDelegate::eventFilter(object, event);
  const QString why = objection(editor->text(), table->currentIndex());
  if (why.isEmpty()) return QStyledItemDelegate::eventFilter(object, event);
  mark(*editor, why);
  emit refused(table->currentIndex(), why);
  return true;
}

void ValueTable::setUpForNumbers() {
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  horizontalHeader()->setHighlightSections(false);
  setFrameShape(QFrame::NoFrame);
  setWordWrap(false);
  setShowGrid(false);
  setTabKeyNavigation(false);
  setAlternatingRowColors(true);
  setSelectionMode(SingleSelection);
  setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
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
