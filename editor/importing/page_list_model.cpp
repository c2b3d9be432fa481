// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/page_list_model.h"

#include <algorithm>
#include <QPainter>

#include "editor/importing/axis_quantity.h"
#include "editor/importing/finding_words.h"

namespace detent::editor {
namespace {

constexpr QSize pageIcon(150, 190), graphIcon(150, 104);

QString rangeOf(const importer::AxisReading& axis) {
  const double span = axis.max - axis.min;
  return QObject::tr("%1–%2 %3")
      .arg(endText(axis.min, span), endText(axis.max, span), QString::fromStdString(axis.unit));
}

QImage blank(QSize size) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(QColor(128, 128, 128, 60));
  return image;
}

QString stateOf(const ImportGraph& graph) {
  if (const auto brief = graph.brief()) {
    if (brief->failed) return QObject::tr("not readable yet");
    const QString sure = QObject::tr("Confidence %1 %").arg(qRound(100 * brief->confidence));
    return brief->doubtful ? sure + QObject::tr(", check it") : sure;
  }
  if (graph.listed) return QObject::tr("Confidence %1 %").arg(qRound(100 * graph.listed->confidence));
  return QObject::tr("plot frame drawn by hand");
}

}  // namespace

QString rangesOf(const ImportGraph& graph) {
  std::optional<importer::AxisReading> x, y;
  const auto brief = graph.brief();
  if (brief && brief->x) {
    x = brief->x, y = brief->y;
  } else if (graph.listed) {
    x = graph.listed->x, y = graph.listed->y;
  }
  if (!x || !y) return {};
  return rangeOf(*x) + QStringLiteral(", ") + rangeOf(*y);
}

PageListModel::PageListModel(ImportState& state, QObject* parent)
    : QAbstractListModel(parent), state_(state) {
  connect(&state_, &ImportState::documentChanged, this, &PageListModel::rebuild);
  connect(&state_, &ImportState::graphsChanged, this, &PageListModel::rebuild);
  connect(&state_, &ImportState::pageChanged, this, &PageListModel::refreshPage);
}

void PageListModel::rebuild() {
  std::vector<Row> rows;
  const auto graphs = state_.graphs();
  for (int page = 1; page <= state_.pageCount(); ++page) {
    rows.push_back({page, 0});
    for (const GraphId id : graphs) {
      if (id.page == page) rows.push_back({page, id.graph});
    }
  }
  if (rows == rows_) {
    if (!rows_.empty()) emit dataChanged(index(0), index(static_cast<int>(rows_.size()) - 1));
    return;
  }
  // Inserts rows between the existing ones, so that the list neither moves nor loses its selection.
  if (rows.size() > rows_.size() && !rows_.empty() &&
      std::includes(rows.begin(), rows.end(), rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
        return std::pair(a.page, a.graph) < std::pair(b.page, b.graph);
      })) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i < rows_.size() && rows_[i] == rows[i]) continue;
      beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
      rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(i), rows[i]);
      endInsertRows();
    }
    emit dataChanged(index(0), index(static_cast<int>(rows_.size()) - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

void PageListModel::refreshPage(int number) {
  const int row = rowOf({number, 0});
  if (row >= 0) emit dataChanged(index(row), index(row));
}

int PageListModel::rowOf(Row row) const {
  const auto found = std::find(rows_.begin(), rows_.end(), row);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int PageListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

Qt::ItemFlags PageListModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.isValid() && at(index.row()).graph != 0) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

QVariant PageListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row row = at(index.row());
  if (row.graph == 0) return pageData(row.page, role);
  const ImportGraph* graph = state_.graph({row.page, row.graph});
  return graph ? graphData(*graph, role) : QVariant();
}

QImage PageListModel::pagePicture(int number) const {
  const ImportPage& page = state_.page(number);
  if (page.thumbnail.isNull()) return blank(pageIcon);
  QImage picture = page.thumbnail.convertToFormat(QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&picture);
  const double sx = picture.width() / page.bounds.width(), sy = picture.height() / page.bounds.height();
  painter.setPen(QPen(QColor("#00805c"), 3));
  for (const GraphId id : state_.graphs()) {
    const ImportGraph* graph = state_.graph(id);
    const auto corners = id.page == number ? graph->corners() : std::nullopt;
    if (!corners) continue;
    QPolygonF outline;
    for (const auto& c : *corners)
      outline << QPointF((c.x - page.bounds.left()) * sx, (c.y - page.bounds.top()) * sy);
    painter.drawPolygon(outline);
  }
  return picture;
}

QVariant PageListModel::pageData(int number, int role) const {
  const ImportPage& page = state_.page(number);
  switch (role) {
    case Qt::DecorationRole:
      return pagePicture(number);
    case Qt::DisplayRole:
      if (page.failure) return tr("Page %1: cannot be read").arg(number);
      return page.searched ? tr("Page %1").arg(number) : tr("Page %1 …").arg(number);
    case Qt::AccessibleTextRole:
      return tr("Page %1 of %2").arg(number).arg(state_.pageCount());
    case Qt::ToolTipRole:
      if (page.failure) return adviceFor(*page.failure, state_.documentName()).problem;
      return page.searched ? tr("Page %1").arg(number)
                           : tr("Page %1 is still being searched for graphs").arg(number);
    default:
      return {};
  }
}

/// A graph framed by hand has no picture of its own, so it gets a part of its page's picture.
QImage PageListModel::graphPicture(const ImportGraph& graph) const {
  if (!graph.thumbnail.isNull()) return graph.thumbnail;
  const auto corners = graph.corners();
  const bool paged = graph.id.page <= state_.pageCount();
  if (!corners || !paged || state_.page(graph.id.page).thumbnail.isNull()) return blank(graphIcon);
  const ImportPage& page = state_.page(graph.id.page);
  QPolygonF outline;
  for (const auto& c : *corners) outline << QPointF(c.x - page.bounds.left(), c.y - page.bounds.top());
  const QRectF frame = outline.boundingRect();
  const double sx = page.thumbnail.width() / page.bounds.width(),
               sy = page.thumbnail.height() / page.bounds.height();
  const QRectF part(frame.left() * sx, frame.top() * sy, frame.width() * sx, frame.height() * sy);
  const QRect seen = part.toAlignedRect().adjusted(-4, -4, 4, 4) & page.thumbnail.rect();
  return seen.isEmpty() ? blank(graphIcon) : page.thumbnail.copy(seen);
}

QVariant PageListModel::graphData(const ImportGraph& graph, int role) const {
  switch (role) {
    case Qt::DecorationRole:
      return graphPicture(graph);
    case Qt::DisplayRole:
      return tr("Graph %1, %2\n%3").arg(graph.id.graph).arg(stateOf(graph), rangesOf(graph));
    case Qt::CheckStateRole:
      return graph.ticked ? Qt::Checked : Qt::Unchecked;
    case Qt::AccessibleTextRole:
      return tr("Page %1, graph %2, %3, %4")
          .arg(graph.id.page)
          .arg(graph.id.graph)
          .arg(stateOf(graph), rangesOf(graph));
    case Qt::ToolTipRole:
      return tr("Graph %1 of page %2: %3. Tick several to import them together.")
          .arg(graph.id.graph)
          .arg(graph.id.page)
          .arg(rangesOf(graph));
    default:
      return {};
  }
}

bool PageListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || !index.isValid()) return false;
  const Row row = at(index.row());
  if (row.graph == 0) return false;
  state_.setTicked({row.page, row.graph}, value.toInt() == Qt::Checked);
  return true;
}

}  // namespace detent::editor
