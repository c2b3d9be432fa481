// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/values_panel.h"

#include <algorithm>
#include <QEvent>
#include <QHeaderView>
#include <QTableView>
#include <QToolTip>
#include <QVBoxLayout>

#include "editor/document/trouble_label.h"
#include "editor/panels/value_delegate.h"
#include "editor/panels/values_model.h"

namespace detent::editor {
namespace {

constexpr int measuredRows = 200;      // rows of a long table that determine the column widths
constexpr int leastNumber = 6;         // characters of a column of numbers
constexpr int cellTextMargin_px = 12;  // of a cell

}  // namespace

ValuesPanel::ValuesPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      model_(new ValuesModel(document, settings, this)),
      table_(new ValueTable),
      refusal_(new TroubleLabel("valuesRefusal")) {
  setObjectName(QStringLiteral("valuesPanel"));
  table_->setObjectName(QStringLiteral("valuesTable"));
  table_->setAccessibleName(tr("Exact values of the force graph"));
  table_->setModel(model_);
  auto* delegate = new ValueDelegate(
      [this](const QModelIndex& cell, const QString& text) { return model_->typed(cell, text).refusal; },
      [this](const QModelIndex& cell, const QString& text) { return model_->doubt(cell, text); }, table_);
  table_->setItemDelegate(delegate);
  connect(delegate, &ValueDelegate::refused, model_, &ValuesModel::refused);
  table_->verticalHeader()->hide();
  table_->setUpForNumbers();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // a thousand rows are not measured
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(table_, 1);
  layout->addWidget(refusal_);
  setFocusProxy(table_);

  connect(model_, &ValuesModel::refused, this, &ValuesPanel::showRefusal);
  connect(model_, &ValuesModel::accepted, refusal_, &QWidget::hide);
  connect(&document, &ButtonDocument::changed, refusal_, &QWidget::hide);
  table_->viewport()->installEventFilter(this);
  connect(model_, &QAbstractItemModel::modelReset, this, &ValuesPanel::layOut);
  connect(model_, &QAbstractItemModel::headerDataChanged, this, &ValuesPanel::layOut);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (const auto mark = model_->markOf(now)) emit markChosen(*mark);
          });
  layOut();
}

void ValuesPanel::layOut() {
  table_->clearSpans();
  for (int row = 0; row < model_->rowCount(); ++row)
    if (!model_->markOf(model_->index(row, 0))) table_->setSpan(row, 0, 1, ValuesModel::columns);
  for (int column = 0; column < ValuesModel::columns; ++column)
    table_->setColumnWidth(column, widthOf(column));
  giveRoomToNames();
}

// Headings span all columns, so they do not determine a column's width.
int ValuesPanel::widthOf(int column) const {
  const QFontMetrics metrics = table_->fontMetrics();
  int text_px = column == ValuesModel::name ? 0 : leastNumber * metrics.horizontalAdvance(QLatin1Char('0'));
  for (int row = 0; row < std::min(model_->rowCount(), measuredRows); ++row)
    if (const QModelIndex cell = model_->index(row, column); model_->markOf(cell))
      text_px = std::max(text_px, metrics.horizontalAdvance(cell.data().toString()));
  return std::max(text_px + cellTextMargin_px, table_->horizontalHeader()->sectionSizeHint(column));
}

QSize ValuesPanel::sizeHint() const {
  int width_px = 2 * table_->frameWidth() + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  for (int column = 0; column < ValuesModel::columns; ++column) width_px += widthOf(column);
  return {width_px, QWidget::sizeHint().height()};
}

// The remaining width goes to the names; in a narrow panel the numbers scroll.
void ValuesPanel::giveRoomToNames() {
  int others = 0;
  for (int column = ValuesModel::displacement; column < ValuesModel::columns; ++column)
    others += table_->columnWidth(column);
  table_->setColumnWidth(ValuesModel::name,
                         std::max(widthOf(ValuesModel::name), table_->viewport()->width() - others));
}

// The viewport has its size only when the table is shown.
bool ValuesPanel::eventFilter(QObject* object, QEvent* event) {
  if (object == table_->viewport() && event->type() == QEvent::Resize) giveRoomToNames();
  return QWidget::eventFilter(object, event);
}

void ValuesPanel::showRefusal(const QModelIndex& index, const QString& why) {
  refusal_->say(why);
  table_->scrollTo(index);
  const QRect cell = table_->visualRect(index);
  QToolTip::showText(table_->viewport()->mapToGlobal(cell.bottomLeft()), why, table_);
}

void ValuesPanel::showMark(std::optional<MarkId> mark) {
  if (!mark) return;
  const auto row = model_->rowOf(*mark);
  // The row that is being edited stays selected.
  if (!row || *row == table_->currentIndex().row()) return;
  const QSignalBlocker quiet(this);
  table_->setCurrentIndex(model_->index(*row, ValuesModel::displacement));
  table_->scrollTo(table_->currentIndex());
}

}  // namespace detent::editor
