// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/values_panel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolTip>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/panels/values_model.h"

namespace detent::editor {
namespace {

/// Keeps a cell open, marked, with the reason beside it, as long as what is typed there is refused.
class ValueDelegate : public QStyledItemDelegate {
 public:
  ValueDelegate(ValuesModel& model, QObject* parent) : QStyledItemDelegate(parent), model_(model) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                        const QModelIndex& index) const override {
    auto* editor = new QLineEdit(parent);
    editor->setObjectName(QStringLiteral("valueEditor"));
    editor->setFrame(false);
    editor->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QPersistentModelIndex cell(index);
    connect(editor, &QLineEdit::textEdited, editor,
            [this, editor, cell] { mark(*editor, refusal(*editor, cell)); });
    return editor;
  }

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    auto* editor = qobject_cast<QLineEdit*>(object);
    if (!editor || event->type() != QEvent::KeyPress) return QStyledItemDelegate::eventFilter(object, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool ends =
        key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
    const auto* table = qobject_cast<QTableView*>(parent());
    if (!ends || !table) return QStyledItemDelegate::eventFilter(object, event);
    const QString why = refusal(*editor, table->currentIndex());
    if (why.isEmpty()) return QStyledItemDelegate::eventFilter(object, event);
    mark(*editor, why);
    emit model_.refused(table->currentIndex(), why);
    return true;
  }

 private:
  QString refusal(const QLineEdit& editor, const QModelIndex& cell) const {
    return model_.typed(cell, editor.text()).refusal;
  }
  static void mark(QLineEdit& editor, const QString& why) {
    QPalette colors = editor.palette();
    const bool dark = isDark(editor.parentWidget()->palette());
    colors.setColor(QPalette::Text, why.isEmpty() ? editor.parentWidget()->palette().color(QPalette::Text)
                                                  : graphColors(dark).refused);
    editor.setPalette(colors);
    editor.setAccessibleDescription(why);
  }

  ValuesModel& model_;
};

}  // namespace

ValuesPanel::ValuesPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      model_(new ValuesModel(document, settings, this)),
      table_(new QTableView),
      refusal_(new QLabel) {
  setObjectName(QStringLiteral("valuesPanel"));
  table_->setObjectName(QStringLiteral("valuesTable"));
  table_->setAccessibleName(tr("Exact values of the force graph"));
  table_->setModel(model_);
  table_->setItemDelegate(new ValueDelegate(*model_, table_));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // a thousand rows are not measured
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  table_->horizontalHeader()->setHighlightSections(false);
  const int character = fontMetrics().horizontalAdvance(QLatin1Char('0'));
  table_->horizontalHeader()->setMinimumSectionSize(8 * character);
  table_->horizontalHeader()->setSectionResizeMode(ValuesModel::name, QHeaderView::Stretch);
  for (int column = ValuesModel::displacement; column < ValuesModel::columns; ++column)
    table_->setColumnWidth(column, (column < ValuesModel::slopeBefore ? 11 : 15) * character);
  table_->setWordWrap(false);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);  // Tab leaves the table; arrows go through it
  table_->setAlternatingRowColors(true);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  refusal_->setObjectName(QStringLiteral("valuesRefusal"));
  refusal_->setWordWrap(true);
  refusal_->setMargin(6);
  refusal_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(table_, 1);
  layout->addWidget(refusal_);
  setFocusProxy(table_);

  connect(model_, &ValuesModel::refused, this, &ValuesPanel::showRefusal);
  connect(model_, &ValuesModel::accepted, refusal_, &QWidget::hide);
  connect(&document, &ButtonDocument::changed, refusal_, &QWidget::hide);
  connect(model_, &QAbstractItemModel::modelReset, this, &ValuesPanel::spanHeadings);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (const auto mark = model_->markOf(now)) emit markChosen(*mark);
          });
  spanHeadings();
}

void ValuesPanel::spanHeadings() {
  table_->clearSpans();
  for (int row = 0; row < model_->rowCount(); ++row)
    if (!model_->markOf(model_->index(row, 0))) table_->setSpan(row, 0, 1, ValuesModel::columns);
}

void ValuesPanel::showRefusal(const QModelIndex& index, const QString& why) {
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, graphColors(isDark(palette())).refused);
  refusal_->setPalette(colors);
  refusal_->setText(why);
  refusal_->setAccessibleName(why);
  refusal_->show();
  table_->scrollTo(index);
  const QRect cell = table_->visualRect(index);
  QToolTip::showText(table_->viewport()->mapToGlobal(cell.bottomLeft()), why, table_);
}

void ValuesPanel::showMark(std::optional<MarkId> mark) {
  if (!mark) return;
  const auto row = model_->rowOf(*mark);
  // A row that is worked on keeps its cell.
  if (!row || *row == table_->currentIndex().row()) return;
  const QSignalBlocker quiet(this);
  table_->setCurrentIndex(model_->index(*row, ValuesModel::displacement));
  table_->scrollTo(table_->currentIndex());
}

}  // namespace detent::editor
