// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pages and their graphs as thumbnails, in reading order; a tick chooses graphs to be imported together.

#include <QListView>

#include "editor/importing/import_state.h"

namespace detent::editor {

class PageListModel;

/// List of pages: blank at first, filled as pages are read; visible pages are read first.
class PageList : public QListView {
  Q_OBJECT

 public:
  /// `state` must outlive it.
  explicit PageList(ImportState& state, QWidget* parent = nullptr);

  /// Shows graphs without their pages.
  void setGraphsOnly(bool only);

 protected:
  void scrollContentsBy(int dx, int dy) override;
  void resizeEvent(QResizeEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  void followState();
  void reportVisible();
  void hidePages();

  ImportState& state_;
  PageListModel* model_;
  bool graphsOnly_ = false;
  bool following_ = false;  ///< the selection is being set from the state, not by the user
};

}  // namespace detent::editor
