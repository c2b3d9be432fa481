// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/picture_cache.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>

#include "editor/document/message_words.h"
#include "editor/files/input_kind.h"
#include "editor/library/graph_picture.h"
#include "model/file/button_file.h"

namespace detent::editor {
namespace {

QString stampOf(const QString& path) {
  const QFileInfo info(path);
  return QString::number(info.lastModified().toMSecsSinceEpoch()) + ':' + QString::number(info.size());
}

}  // namespace

PictureCache::PictureCache(QSize size_px, QObject* parent) : QObject(parent), size_px_(size_px) {
  painter_.setMaxThreadCount(1);
}

PictureCache::~PictureCache() {
  painter_.clear();
  painter_.waitForDone();
}

void PictureCache::setDrawing(const GraphColors& colors, double devicePixelRatio) {
  colors_ = colors;
  devicePixelRatio_ = devicePixelRatio;
  ++appearance_;
  files_.clear();
  making_.clear();
}

QImage PictureCache::ofFile(const QString& path) {
  const QString stamp = stampOf(path);
  if (const Entry* entry = files_.object(path); entry && entry->stamp == stamp) return entry->image;
  if (making_.contains(path)) return {};
  making_.insert(path);
  painter_.start([this, path, stamp, size = size_px_, ratio = devicePixelRatio_, colors = colors_,
                  appearance = appearance_] {
    const auto button = readButtonFile(QFile::encodeName(path).toStdString());
    const QImage image = button ? graphPicture(*button, size, ratio, colors) : QImage();
    const QString why = button ? QString() : sentenceOf(button.failure());
    QMetaObject::invokeMethod(
        this, [=, this] { finished(path, stamp, image, why, appearance); }, Qt::QueuedConnection);
  });
  return {};
}

void PictureCache::finished(const QString& key, const QString& stamp, const QImage& image,
                            const QString& trouble, int appearance) {
  if (appearance != appearance_) return;  // drawn with previous colours
  making_.remove(key);
  files_.insert(key, new Entry{stamp, image, trouble});
  emit ready(key);
}

QString PictureCache::trouble(const QString& path) const {
  const Entry* entry = files_.object(path);
  return entry ? entry->trouble : QString();
}

void PictureCache::draw(const QString& key, const Button& button) {
  painter_.start([this, key, button, size = size_px_, ratio = devicePixelRatio_, colors = colors_,
                  appearance = appearance_] {
    const QImage image = graphPicture(button, size, ratio, colors);
    QMetaObject::invokeMethod(
        this,
        [=, this] {
          if (appearance != appearance_) return;
          open_.insert(key, image);
          emit ready(key);
        },
        Qt::QueuedConnection);
  });
}

QImage PictureCache::drawn(const QString& key) const { return open_.value(key); }

void PictureCache::forget(const QString& key) { open_.remove(key); }

}  // namespace detent::editor
