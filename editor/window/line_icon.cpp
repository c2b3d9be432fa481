// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/line_icon.h"

#include <QApplication>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QTextStream>

#include "model/check.h"

namespace detent::editor {
namespace {

constexpr double grid = 24;  // the drawings' own size

// M, L, C and Z of SVG paths, absolute.
const QHash<QString, QString>& drawings() {
  static const QHash<QString, QString> all = {
      {"new",
       "M 6 3 L 14 3 L 19 8 L 19 21 L 6 21 Z M 14 3 L 14 8 L 19 8 M 12.5 11 L 12.5 18 M 9 14.5 L 16 14.5"},
      {"open", "M 3 19 L 3 5 L 9 5 L 11 8 L 19 8 L 19 11 M 3 19 L 6.5 11 L 22 11 L 18.5 19 Z"},
      {"import", "M 12 3 L 12 14 M 8 10 L 12 14 L 16 10 M 4 13 L 4 20 L 20 20 L 20 13"},
      {"save",
       "M 4 4 L 17 4 L 20 7 L 20 20 L 4 20 Z M 8 4 L 8 9 L 15 9 L 15 4 M 7.5 20 L 7.5 13 L 16.5 13 L 16.5 "
       "20"},
      {"undo", "M 9 5 L 4 10 L 9 15 M 4 10 L 15 10 C 18 10 20 12 20 15 C 20 18 18 20 15 20 L 11 20"},
      {"redo", "M 15 5 L 20 10 L 15 15 M 20 10 L 9 10 C 6 10 4 12 4 15 C 4 18 6 20 9 20 L 13 20"},
      {"compare", "M 3 16 C 8 16 9 4 13 7 C 16 10 18 10 21 3 M 3 21 C 9 21 11 12 14 14 C 17 16 18 16 21 11"},
      {"feelDockToggle", "M 2 12 C 4 2 7 2 9 12 C 11 22 13 22 15 12 C 17 4 20 4 22 12"},
      {"toolSelect", "M 6 3 L 6 18 L 10 14.5 L 12.5 20 L 15 19 L 12.5 13.5 L 18 13 Z"},
      {"toolAddKnot",
       "M 3 19 C 7 19 8 11 12 11 C 15 11 16 15 21 15 M 10 9 L 14 9 L 14 13 L 10 13 Z M 18.5 3 L 18.5 9 M "
       "15.5 6 L "
       "21.5 6"},
      {"toolAddJump", "M 3 20 L 9 8 L 11 16 L 15 16 L 21 6"},
      {"toolPan",
       "M 12 3 L 12 21 M 3 12 L 21 12 M 9.5 5.5 L 12 3 L 14.5 5.5 M 9.5 18.5 L 12 21 L 14.5 18.5 M 5.5 9.5 L "
       "3 12 L "
       "5.5 14.5 M 18.5 9.5 L 21 12 L 18.5 14.5"},
  };
  return all;
}

QPainterPath pathOf(QString drawing) {
  QPainterPath path;
  QTextStream words(&drawing);
  const auto point = [&words] {
    double x = 0, y = 0;
    words >> x >> y;
    return QPointF(x, y);
  };
  while (!words.atEnd()) {
    QString command;
    words >> command;
    if (command == "M") {
      path.moveTo(point());
    } else if (command == "L") {
      path.lineTo(point());
    } else if (command == "C") {
      const QPointF first = point(), second = point();
      path.cubicTo(first, second, point());
    } else {
      DETENT_CHECK(command == "Z", "an icon is drawn with M, L, C and Z");
      path.closeSubpath();
    }
  }
  return path;
}

class LineIconEngine : public QIconEngine {
 public:
  explicit LineIconEngine(const QPainterPath& path) : path_(path) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / grid, rect.height() / grid);
    painter->setPen(QPen(QApplication::palette().color(group, QPalette::ButtonText), 1.6, Qt::SolidLine,
                         Qt::RoundCap, Qt::RoundJoin));
    painter->drawPath(path_);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new LineIconEngine(path_); }

 private:
  QPainterPath path_;
};

}  // namespace

QIcon lineIcon(const QString& actionName) {
  const auto drawing = drawings().constFind(actionName);
  return drawing == drawings().constEnd() ? QIcon() : QIcon(new LineIconEngine(pathOf(*drawing)));
}

}  // namespace detent::editor
