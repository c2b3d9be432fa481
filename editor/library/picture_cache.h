// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Graph pictures for lists, drawn on another thread and kept.

#include <QCache>
#include <QImage>
#include <QObject>
#include <QSet>
#include <QThreadPool>

#include "editor/document/graph_colors.h"
#include "model/button.h"

namespace detent::editor {

/// GUI thread; a separate thread reads files and draws.
class PictureCache : public QObject {
  Q_OBJECT

 public:
  /// `size_px` in logical pixels.
  PictureCache(QSize size_px, QObject* parent = nullptr);
  /// Waits for the picture being drawn; those not begun are dropped.
  ~PictureCache() override;

  /// Picture of a button file in its present form; null while it is being made (ready() follows) and for
  /// files without a button. A changed file gets a new picture.
  QImage ofFile(const QString& path);
  /// Requests the picture of an open button; `key` identifies its document. ready(key) follows.
  void draw(const QString& key, const Button& button);
  /// The last picture drawn under this key.
  QImage drawn(const QString& key) const;
  void forget(const QString& key);

  QSize size_px() const { return size_px_; }
  /// The reason why a file has no picture: a sentence for a tool tip, empty if it has one.
  QString trouble(const QString& path) const;

  /// Sets colours and pixel ratio of the pictures; pictures made with other ones are dropped.
  void setDrawing(const GraphColors& colors, double devicePixelRatio);

 signals:
  /// `key`: a path or a document's key.
  void ready(const QString& key);

 private:
  void finished(const QString& key, const QString& stamp, const QImage& image, const QString& trouble,
                int appearance);

  struct Entry {
    QString stamp;  // state of the file from which it was made
    QImage image;
    QString trouble;
  };
  QSize size_px_;
  GraphColors colors_ = graphColors(false);
  double devicePixelRatio_ = 1;
  int appearance_ = 0;
  QCache<QString, Entry> files_{400};
  QHash<QString, QImage> open_;
  QSet<QString> making_;
  QThreadPool painter_;
};

}  // namespace detent::editor
