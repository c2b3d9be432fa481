// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/swatch.h"

#include <QPainter>

namespace detent::editor {

QColor colorFrom(const importer::Rgb& rgb) { return {rgb.r, rgb.g, rgb.b}; }

QIcon swatchOf(const std::vector<QColor>& colors, const QPalette& palette) {
  QPixmap pixmap(22, 14);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  const int width_px = pixmap.width() / static_cast<int>(colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
    painter.fillRect(static_cast<int>(i) * width_px, 0, width_px, pixmap.height(), colors[i]);
  painter.setPen(palette.color(QPalette::Mid));
  painter.drawRect(0, 0, pixmap.width() - 1, pixmap.height() - 1);
  QIcon swatch(pixmap);
  swatch.addPixmap(pixmap, QIcon::Selected);  // a colour is not tinted where its row is chosen
  return swatch;
}

}  // namespace detent::editor
