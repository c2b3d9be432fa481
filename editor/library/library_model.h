// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lists of buttons with small pictures, for item views.

#include <map>
#include <QAbstractListModel>
#include <QFileSystemWatcher>
#include <QTimer>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/library/picture_cache.h"
#include "playback/study.h"

namespace detent::editor {

/// The documents that are open, in the order of the tabs. Does not own them. GUI thread.
class OpenButtonsModel : public QAbstractListModel {
  Q_OBJECT

 public:
  /// `pictures` must outlive this.
  explicit OpenButtonsModel(PictureCache& pictures, QObject* parent = nullptr);

  void setDocuments(const std::vector<ButtonDocument*>& documents);
  ButtonDocument* documentAt(const QModelIndex& index) const;
  /// Forecasts of the difference between each button and the shown one, by document; a button without one
  /// shows nothing.
  void setForecasts(std::map<ButtonDocument*, playback::PredictedPair> forecasts);
  /// Draws all pictures again after the colours changed.
  void redraw();

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  struct Row {
    ButtonDocument* document;
    QString key;
    QString title;  ///< that no other row has
  };
  void nameRows();
  void drawSoon(ButtonDocument* document);
  void drawWaiting();
  void tell(const QString& key);

  PictureCache& pictures_;
  std::vector<Row> rows_;
  std::map<ButtonDocument*, playback::PredictedPair> forecasts_;
  std::vector<ButtonDocument*> waiting_;
  QTimer soon_;  // delay for pictures, because a drag changes a button sixty times a second
  int nextKey_ = 1;
};

/// The button files of one folder, by name; follows changes on the disk.
class FolderModel : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit FolderModel(PictureCache& pictures, QObject* parent = nullptr);

  /// Empty: no folder.
  void setFolder(const QString& folder);
  const QString& folder() const { return folder_; }
  /// Files whose name contains this, whatever the case.
  void setFilter(const QString& text);
  QString pathAt(const QModelIndex& index) const;
  void redraw();

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  void read();
  void tell(const QString& path);

  PictureCache& pictures_;
  QString folder_, filter_;
  QStringList paths_;
  QFileSystemWatcher watcher_;
  QTimer soon_;
};

}  // namespace detent::editor
