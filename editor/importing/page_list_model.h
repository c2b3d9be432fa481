// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of the page list: each page, followed by its graphs.

#include <QAbstractListModel>
#include <vector>

#include "editor/importing/import_state.h"

namespace detent::editor {

class PageListModel : public QAbstractListModel {
  Q_OBJECT

 public:
  /// `graph` 0: the page itself.
  struct Row {
    int page = 0, graph = 0;
    friend bool operator==(const Row&, const Row&) = default;
  };

  explicit PageListModel(ImportState& state, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  Row at(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  int rowOf(Row row) const;  ///< -1 if it is not there

 private:
  void rebuild();
  void refreshPage(int number);
  QVariant pageData(int number, int role) const;
  QVariant graphData(const ImportGraph& graph, int role) const;
  QImage pagePicture(int number) const;
  QImage graphPicture(const ImportGraph& graph) const;

  ImportState& state_;
  std::vector<Row> rows_;
};

/// "0–4 mm, 0–120 cN"; empty while nothing was read.
QString rangesOf(const ImportGraph& graph);

}  // namespace detent::editor
