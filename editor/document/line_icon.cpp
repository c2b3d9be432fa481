// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/line_icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

class LineIconEngine : public QIconEngine {
 public:
  explicit LineIconEngine(QByteArray drawing) : drawing_(std::move(drawing)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const GraphColors light = graphColors(false), shown = graphColors(isDark(palette));
    QByteArray colored = drawing_;
    colored.replace("currentColor", palette.color(group, QPalette::ButtonText).name().toLatin1());
    colored.replace(light.press.name().toLatin1(), shown.press.name().toLatin1());
    colored.replace(light.release.name().toLatin1(), shown.release.name().toLatin1());
    QSvgRenderer(colored).render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new LineIconEngine(drawing_); }

 private:
  QByteArray drawing_;
};

}  // namespace

QIcon lineIcon(const QString& name) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  return file.open(QIODevice::ReadOnly) ? QIcon(new LineIconEngine(file.readAll())) : QIcon();
}

}  // namespace detent::editor
