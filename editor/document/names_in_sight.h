// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Table views whose row names stay visible.

#include <algorithm>
#include <QHeaderView>
#include <QStyle>
#include <QStyleOptionHeader>
#include <QTableView>

namespace detent::editor {

/// A header that elides its text; Qt's header cuts it off. GUI thread.
class ShorteningHeader : public QHeaderView {
 public:
  ShorteningHeader(Qt::Orientation orientation, Qt::TextElideMode side, QTableView* table)
      : QHeaderView(orientation, table), side_(side) {
    setSectionsClickable(true);
  }

 protected:
  void initStyleOptionForIndex(QStyleOptionHeader* option, int index) const override {
    QHeaderView::initStyleOptionForIndex(option, index);
    const int room_px = orientation() == Qt::Vertical ? width() : sectionSize(index);
    const int margins_px = 2 * style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, this);
    if (!option->text.contains('\n'))
      option->text = option->fontMetrics.elidedText(option->text, side_, room_px - margins_px);
  }

 private:
  Qt::TextElideMode side_;
};

/// Width that a table has for its row names and columns together, in pixels. Qt gives and takes the vertical
/// header's part of the viewport later than it shows or hides the header, so that their widths added would be
/// wrong in between.
inline int widthForColumns_px(const QTableView& table) {
  return table.viewport()->geometry().right() + 1 - table.contentsRect().left();
}

/// Space needed by a table, in pixels.
struct NamedTable {
  int nameColumn = 0;
  int names_px = 0;              ///< width of the widest name
  int numbers_px = 0;            ///< width of the other columns together
  int leastNames_px = names_px;  ///< names may be elided to this width
};

/// Shows the row names in their column if the whole table, with elided names, has space; else in the vertical
/// header, which the model must fill too (best a ShorteningHeader) and which stays while the numbers scroll.
/// The names then have half of the table at most. GUI thread.
inline void keepNamesInSight(QTableView& table, const NamedTable& needed) {
  QHeaderView& names = *table.verticalHeader();
  const int room_px = widthForColumns_px(table);
  const bool narrow = std::min(needed.names_px, needed.leastNames_px) + needed.numbers_px > room_px;
  table.setColumnHidden(needed.nameColumn, narrow);
  names.setVisible(narrow);
  if (!narrow) return table.setColumnWidth(needed.nameColumn, room_px - needed.numbers_px);
  names.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  names.setHighlightSections(false);
  names.setSectionResizeMode(QHeaderView::Fixed);
  names.setFixedWidth(std::min(needed.names_px, std::max(room_px / 2, room_px - needed.numbers_px)));
}

}  // namespace detent::editor
