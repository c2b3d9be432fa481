// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/selection_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTransposeProxyModel>
#include <QVBoxLayout>
#include <utility>

#include "editor/document/trouble_label.h"
#include "editor/panels/value_delegate.h"
#include "editor/panels/values_model.h"

namespace detent::editor {

/// The row of one mark, as a column.
class SelectedRow : public QTransposeProxyModel {
 public:
  SelectedRow(ValuesModel& model, QObject* parent) : QTransposeProxyModel(parent) {
    only_.setSourceModel(&model);
    setSourceModel(&only_);
  }

  void setMark(std::optional<MarkId> mark) {
    only_.mark = mark;
    only_.filterAgain();
  }
  QModelIndex toValues(const QModelIndex& index) const { return only_.mapToSource(mapToSource(index)); }
  QModelIndex cell(int column) const { return index(column, 0); }

  // The unit is shown in the cell.
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    const QVariant head = QTransposeProxyModel::headerData(section, orientation, role);
    return role == Qt::DisplayRole ? head.toString().section('\n', 0, -2).replace('\n', ' ') : head;
  }

 private:
  struct OnlyMark : QSortFilterProxyModel {
    std::optional<MarkId> mark;
    void filterAgain() { invalidateFilter(); }
    bool filterAcceptsRow(int row, const QModelIndex&) const override {
      const auto* values = static_cast<const ValuesModel*>(sourceModel());
      const auto here = values->markOf(values->index(row, 0));
      return mark && here && *here == *mark;
    }
  };

  OnlyMark only_;
};

SelectionPanel::SelectionPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      model_(new ValuesModel(document, settings, this)),
      row_(new SelectedRow(*model_, this)),
      title_(described(new QLabel, "selectionTitle")),
      trouble_(new TroubleLabel("selectionTrouble")),
      table_(described(new ValueTable, "selectionTable", {}, tr("Values of the selected point"))) {
  setObjectName(QStringLiteral("selectionPanel"));
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setMargin(6);
  table_->setModel(row_);
  auto* delegate = new ValueDelegate(
      [this](const QModelIndex& cell, const QString& text) {
        return model_->typed(row_->toValues(cell), text).refusal;
      },
      [this](const QModelIndex& cell, const QString& text) {
        return model_->doubt(row_->toValues(cell), text);
      },
      table_);
  delegate->alignDecimals(0, QStringLiteral(".000 cN/mm"));
  table_->setItemDelegate(delegate);
  table_->setUpForNumbers();
  table_->horizontalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->setHighlightSections(false);
  setFocusProxy(table_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  // Reserves space for the numbers of any point, so that the figures below do not move with the selection.
  constexpr int mostLines = 4;
  auto* room = new QWidget;
  room->setFixedHeight(2 * table_->frameWidth() + mostLines * table_->verticalHeader()->defaultSectionSize());
  auto* numbers = new QVBoxLayout(room);
  numbers->setContentsMargins(0, 0, 0, 0);
  numbers->addWidget(table_);
  numbers->addStretch(1);
  for (QWidget* part : {static_cast<QWidget*>(title_), room, static_cast<QWidget*>(trouble_)})
    layout->addWidget(part);
  connect(delegate, &QAbstractItemDelegate::closeEditor, this,
          [this](QWidget*, QAbstractItemDelegate::EndEditHint hint) {
            const bool goesOn = hint == QAbstractItemDelegate::EditNextItem ||
                                hint == QAbstractItemDelegate::EditPreviousItem;
            if (!goesOn && std::exchange(editing_, false) && table_->hasFocus()) emit edited();
          });
  connect(delegate, &ValueDelegate::refused, this,
          [this](const QModelIndex&, const QString& why) { trouble_->say(why); });
  connect(model_, &ValuesModel::refused, this,
          [this](const QModelIndex&, const QString& why) { trouble_->say(why); });
  connect(&document, &ButtonDocument::changed, this, [this] { trouble_->say({}); });
  connect(model_, &QAbstractItemModel::modelReset, this, [this] { showMark(mark_); });
  connect(model_, &QAbstractItemModel::dataChanged, this, &SelectionPanel::layOut);
  showMark({});
}

// A slope handle shows the numbers of its knot.
void SelectionPanel::showMark(std::optional<MarkId> mark) {
  if (mark && (mark->kind == MarkKind::slopeBefore || mark->kind == MarkKind::slopeAfter))
    mark->kind = MarkKind::knot;
  mark_ = mark;
  row_->setMark(mark);
  trouble_->say({});
  layOut();
}

bool SelectionPanel::edit(FirstValue first) {
  if (row_->columnCount() == 0) return false;
  QModelIndex cell = row_->cell(first == FirstValue::force ? ValuesModel::force : ValuesModel::displacement);
  if (!(cell.flags() & Qt::ItemIsEditable)) cell = row_->cell(ValuesModel::displacement);
  editing_ = true;
  table_->setFocus(Qt::OtherFocusReason);
  table_->setCurrentIndex(cell);
  static_cast<QAbstractItemView*>(table_)->edit(cell);
  return true;
}

// Lines without a number, such as the slope of an operating point, are not shown.
void SelectionPanel::layOut() {
  const bool found = row_->columnCount() > 0;
  const QString name = found ? row_->cell(ValuesModel::name).data().toString() : QString();
  const auto stroke = mark_ && mark_->stroke == Stroke::release ? tr("release") : tr("press");
  title_->setText(found ? tr("%1, %2").arg(name, stroke) : tr("Select a point in the graph."));
  int height_px = 2 * table_->frameWidth();
  for (int row = 0; row < ValuesModel::columns; ++row) {
    const bool shown = found && row != ValuesModel::name && !row_->cell(row).data().toString().isEmpty();
    table_->setRowHidden(row, !shown);
    if (shown) height_px += table_->rowHeight(row);
  }
  table_->setVisible(found);
  table_->setFixedHeight(height_px);
}

}  // namespace detent::editor
