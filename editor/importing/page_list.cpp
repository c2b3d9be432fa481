// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/page_list.h"

#include <algorithm>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include "editor/importing/page_list_model.h"

namespace detent::editor {
namespace {

/// Picture above, words below; graphs stand a little to the right of their page.
class ThumbnailDelegate : public QStyledItemDelegate {
 public:
  explicit ThumbnailDelegate(const PageListModel& model, QObject* parent)
      : QStyledItemDelegate(parent), model_(model) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const bool isGraph = model_.at(index.row()).graph != 0;
    const int lines = isGraph ? 2 : 1;
    return {width, (isGraph ? graphHeight : pageHeight) + lines * option.fontMetrics.height() + 4 * pad};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const bool isGraph = model_.at(index.row()).graph != 0;
    const bool selected = option.state & QStyle::State_Selected;
    painter->save();
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    const QRect plate = option.rect.adjusted(isGraph ? indent : pad, pad / 2, -pad, -pad / 2);
    if (selected) {
      QColor lit = option.palette.color(QPalette::Highlight);
      lit.setAlpha(option.state & QStyle::State_Active ? 255 : 150);
      painter->setPen(Qt::NoPen);
      painter->setBrush(lit);
      painter->drawRoundedRect(plate, 4, 4);
    }
    const int textHeight = (isGraph ? 2 : 1) * option.fontMetrics.height();
    const QRect room = plate.adjusted(pad, pad, -pad, -textHeight - pad);
    const auto picture = index.data(Qt::DecorationRole).value<QImage>();
    QSize size = picture.size();
    size.scale(room.size(), Qt::KeepAspectRatio);
    QRect target(QPoint(0, 0), size);
    target.moveCenter(room.center());
    painter->drawImage(target, picture);
    painter->setPen(option.palette.color(QPalette::Mid));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(target);
    painter->setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
    const QRect words(plate.left() + pad, room.bottom() + pad / 2, plate.width() - 2 * pad, textHeight);
    drawWords(*painter, words, isGraph ? Qt::AlignLeft : Qt::AlignHCenter,
              index.data(Qt::DisplayRole).toString());
    if (isGraph) drawCheck(*painter, option, index);
    if (option.state & QStyle::State_HasFocus) {
      painter->setPen(QPen(option.palette.color(QPalette::Text), 1, Qt::DotLine));
      painter->drawRect(plate.adjusted(1, 1, -1, -1));
    }
    painter->restore();
  }

  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
    if (event->type() == QEvent::MouseButtonRelease && model_.at(index.row()).graph != 0) {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (checkRect(option).adjusted(-4, -4, 4, 4).contains(mouse->pos())) {
        const bool on = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        return model->setData(index, on ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
      }
    }
    if (event->type() == QEvent::KeyPress)
      return QStyledItemDelegate::editorEvent(event, model, option, index);
    return false;
  }

 private:
  // Each line is shortened where the list is narrow.
  static void drawWords(QPainter& painter, QRect place, Qt::Alignment side, const QString& lines) {
    place.setHeight(painter.fontMetrics().height());
    for (const QString& line : lines.split('\n')) {
      const QString fitting = painter.fontMetrics().elidedText(line, Qt::ElideRight, place.width());
      painter.drawText(place, static_cast<int>(side.toInt()), fitting);
      place.translate(0, place.height());
    }
  }
  static QRect checkRect(const QStyleOptionViewItem& option) {
    return {option.rect.left() + indent + pad + 2, option.rect.top() + pad + 4, 16, 16};
  }
  static void drawCheck(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
    QStyleOptionButton box;
    box.rect = checkRect(option);
    box.palette = option.palette;
    box.state =
        QStyle::State_Enabled |
        (index.data(Qt::CheckStateRole).toInt() == Qt::Checked ? QStyle::State_On : QStyle::State_Off);
    painter.fillRect(box.rect.adjusted(-2, -2, 2, 2), option.palette.color(QPalette::Base));
    const QWidget* widget = option.widget;
    widget->style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, &painter, widget);
  }

  static constexpr int width = 190, pageHeight = 150, graphHeight = 96, pad = 6, indent = 18;
  const PageListModel& model_;
};

}  // namespace

PageList::PageList(ImportState& state, QWidget* parent)
    : QListView(parent), state_(state), model_(new PageListModel(state, this)) {
  setObjectName(QStringLiteral("pageList"));
  setAccessibleName(tr("Pages and graphs"));
  setModel(model_);
  setItemDelegate(new ThumbnailDelegate(*model_, this));
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setLayoutMode(QListView::SinglePass);
  setMinimumWidth(150);
  setMaximumWidth(260);
  connect(model_, &QAbstractItemModel::rowsInserted, this, &PageList::hidePages);
  connect(model_, &QAbstractItemModel::modelReset, this, &PageList::hidePages);
  connect(&state_, &ImportState::currentChanged, this, &PageList::followState);
  connect(&state_, &ImportState::documentChanged, this,
          [this] { QMetaObject::invokeMethod(this, &PageList::reportVisible, Qt::QueuedConnection); });
}

void PageList::setGraphsOnly(bool only) {
  graphsOnly_ = only;
  hidePages();
  reportVisible();
}

void PageList::hidePages() {
  for (int row = 0; row < model_->rowCount(); ++row)
    setRowHidden(row, graphsOnly_ && model_->at(row).graph == 0);
}

void PageList::followState() {
  const ImportGraph* graph = state_.current();
  const int row = model_->rowOf({state_.currentPage(), graph ? graph->id.graph : 0});
  if (row < 0 || row == currentIndex().row()) return;
  following_ = true;
  setCurrentIndex(model_->index(row, 0));
  following_ = false;
}

void PageList::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QListView::currentChanged(current, previous);
  if (following_ || !current.isValid()) return;
  const PageListModel::Row row = model_->at(current.row());
  if (row.graph == 0) {
    state_.showPage(row.page);
  } else {
    state_.selectGraph({row.page, row.graph});
  }
}

void PageList::scrollContentsBy(int dx, int dy) {
  QListView::scrollContentsBy(dx, dy);
  reportVisible();
}

void PageList::resizeEvent(QResizeEvent* event) {
  QListView::resizeEvent(event);
  reportVisible();
}

void PageList::reportVisible() {
  if (model_->rowCount() == 0) return;
  const QModelIndex top = indexAt(QPoint(20, 4));
  QModelIndex bottom = indexAt(QPoint(20, viewport()->height() - 4));
  if (!top.isValid()) return;
  if (!bottom.isValid()) bottom = model_->index(model_->rowCount() - 1, 0);
  state_.setVisiblePages(model_->at(top.row()).page, model_->at(bottom.row()).page);
}

}  // namespace detent::editor
