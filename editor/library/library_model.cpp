// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/library_model.h"

#include <algorithm>
#include <QDir>
#include <QIcon>
#include <QPixmap>

#include "editor/forecast/forecast_words.h"

namespace detent::editor {
namespace {

constexpr int openPictureDelay_ms = 150;
constexpr int folderDelay_ms = 200;

// An icon with the same picture in every mode, because Qt would tint it in selected rows. A transparent one
// keeps the row's height until the picture is available.
QIcon shown(const QImage& image, QSize size_px) {
  QPixmap picture = QPixmap::fromImage(image);
  if (image.isNull()) {
    picture = QPixmap(size_px);
    picture.fill(Qt::transparent);
  }
  QIcon icon(picture);
  icon.addPixmap(picture, QIcon::Selected);
  return icon;
}

QString nameOf(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  return name.endsWith(QLatin1String(".button.json")) ? name.chopped(12) : name;
}

}  // namespace

OpenButtonsModel::OpenButtonsModel(PictureCache& pictures, QObject* parent)
    : QAbstractListModel(parent), pictures_(pictures) {
  soon_.setSingleShot(true);
  soon_.setInterval(openPictureDelay_ms);
  connect(&soon_, &QTimer::timeout, this, &OpenButtonsModel::drawWaiting);
  connect(&pictures_, &PictureCache::ready, this, &OpenButtonsModel::tell);
}

void OpenButtonsModel::setDocuments(const std::vector<ButtonDocument*>& documents) {
  beginResetModel();
  std::vector<Row> rows;
  for (ButtonDocument* document : documents) {
    const auto known =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.document == document; });
    if (known != rows_.end()) {
      rows.push_back(*known);
      continue;
    }
    rows.push_back({document, "open:" + QString::number(nextKey_++), {}});
    connect(document, &ButtonDocument::titleChanged, this, [this, document] { drawSoon(document); });
    waiting_.push_back(document);
  }
  const auto kept = [&](ButtonDocument* document) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& r) { return r.document == document; });
  };
  for (const Row& row : rows_)
    // the document may be deleted, so only its key is used
    if (!kept(row.document)) pictures_.forget(row.key);
  std::erase_if(waiting_, [&](ButtonDocument* document) { return !kept(document); });
  rows_ = std::move(rows);
  nameRows();
  endResetModel();
  if (!waiting_.empty()) soon_.start();
}

void OpenButtonsModel::nameRows() {
  std::vector<ButtonDocument*> documents;
  for (const Row& row : rows_) documents.push_back(row.document);
  const QStringList titles = distinctTitles(documents);
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].title = titles[static_cast<qsizetype>(i)];
}

void OpenButtonsModel::drawSoon(ButtonDocument* document) {
  if (std::find(waiting_.begin(), waiting_.end(), document) == waiting_.end()) waiting_.push_back(document);
  if (!soon_.isActive()) soon_.start();
}

void OpenButtonsModel::drawWaiting() {
  for (const Row& row : rows_) {
    if (std::find(waiting_.begin(), waiting_.end(), row.document) == waiting_.end()) continue;
    pictures_.draw(row.key, row.document->button());
  }
  waiting_.clear();
  nameRows();  // a title may have changed, and with it those of other rows
  if (!rows_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
}

void OpenButtonsModel::redraw() {
  for (const Row& row : rows_) drawSoon(row.document);
}

void OpenButtonsModel::tell(const QString& key) {
  for (int i = 0; i < rowCount(); ++i)
    if (rows_[static_cast<std::size_t>(i)].key == key) emit dataChanged(index(i), index(i));
}

ButtonDocument* OpenButtonsModel::documentAt(const QModelIndex& index) const {
  return index.isValid() ? rows_[static_cast<std::size_t>(index.row())].document : nullptr;
}

int OpenButtonsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

void OpenButtonsModel::setForecasts(std::map<ButtonDocument*, playback::PredictedPair> forecasts) {
  forecasts_ = std::move(forecasts);
  if (!rows_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
}

QVariant OpenButtonsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const auto forecast = forecasts_.find(row.document);
  const bool foretold = forecast != forecasts_.end();
  switch (role) {
    case Qt::DisplayRole:
      return row.title + (row.document->history().modified() ? " *" : "") +
             (foretold ? "\n" + shortForecastWords(forecast->second) : QString());
    case Qt::DecorationRole:
      return shown(pictures_.drawn(row.key), pictures_.size_px());
    case Qt::ToolTipRole: {
      const QString file = row.document->path().isEmpty() ? tr("Not saved yet")
                                                          : QDir::toNativeSeparators(row.document->path());
      return foretold
                 ? tr("%1\nCompared with the button shown: %2").arg(file, forecastWords(forecast->second))
                 : file;
    }
    case Qt::AccessibleTextRole:
      return row.document->history().modified() ? tr("%1, with unsaved changes").arg(row.title) : row.title;
    default:
      return {};
  }
}

FolderModel::FolderModel(PictureCache& pictures, QObject* parent)
    : QAbstractListModel(parent), pictures_(pictures) {
  soon_.setSingleShot(true);
  soon_.setInterval(folderDelay_ms);
  connect(&soon_, &QTimer::timeout, this, &FolderModel::read);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &soon_, qOverload<>(&QTimer::start));
  connect(&pictures_, &PictureCache::ready, this, &FolderModel::tell);
}

void FolderModel::setFolder(const QString& folder) {
  if (!folder_.isEmpty()) watcher_.removePath(folder_);
  folder_ = folder;
  if (!folder_.isEmpty()) watcher_.addPath(folder_);
  read();
}

void FolderModel::setFilter(const QString& text) {
  filter_ = text;
  read();
}

void FolderModel::read() {
  beginResetModel();
  paths_.clear();
  if (!folder_.isEmpty()) {
    const QDir folder(folder_);
    const QStringList names =
        folder.entryList({"*.button.json"}, QDir::Files | QDir::Readable, QDir::Name | QDir::IgnoreCase);
    for (const QString& name : names)
      if (name.contains(filter_, Qt::CaseInsensitive)) paths_ << folder.absoluteFilePath(name);
  }
  endResetModel();
}

void FolderModel::redraw() {
  if (!paths_.isEmpty()) emit dataChanged(index(0), index(rowCount() - 1));
}

void FolderModel::tell(const QString& path) {
  if (const auto row = paths_.indexOf(path); row >= 0) {
    const QModelIndex at = index(static_cast<int>(row));
    emit dataChanged(at, at);
  }
}

QString FolderModel::pathAt(const QModelIndex& index) const {
  return index.isValid() ? paths_[index.row()] : QString();
}

int FolderModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(paths_.size());
}

QVariant FolderModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const QString& path = paths_[index.row()];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return nameOf(path);
    case Qt::DecorationRole:
      return shown(pictures_.ofFile(path), pictures_.size_px());
    case Qt::ToolTipRole: {
      const QString trouble = pictures_.trouble(path);
      return trouble.isEmpty() ? QDir::toNativeSeparators(path) : trouble;
    }
    default:
      return {};
  }
}

}  // namespace detent::editor
