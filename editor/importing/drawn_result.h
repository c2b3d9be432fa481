// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A result in page units, ready to be drawn over the page.

#include <optional>
#include <QPolygonF>
#include <QString>
#include <vector>

#include "editor/importing/import_queries.h"

namespace detent::editor {

/// A tick as found: its position and the value read there.
struct DrawnTick {
  importer::Point at;  ///< page units, on the axis
  double value = 0;
  QString text;      ///< as read; may be empty
  bool used = true;  ///< false: disagrees with the others, or with the ends that were given
};

/// A point with a name: tactile point, operating or reset point.
struct DrawnMark {
  enum class Kind { tactile, operating, reset } kind = Kind::tactile;
  Stroke stroke = Stroke::press;
  QPointF at;  ///< page units
  CurvePoint value;
};

struct DrawnStroke {
  QPolygonF fit, traced;
};

/// Elements of one result in page units. Elements of steps that did not run are empty.
struct DrawnResult {
  std::vector<DrawnTick> xTicks, yTicks;
  std::vector<QPointF> xLines, yLines;  ///< ends of gridlines and ticks on the axes, to snap to
  std::optional<DrawnStroke> press, release;
  std::vector<QPolygonF> traces;  ///< curves as traced, if they gave no strokes
  std::vector<DrawnMark> marks;
};

DrawnResult drawnFrom(const ImportedGraph& imported);

}  // namespace detent::editor
