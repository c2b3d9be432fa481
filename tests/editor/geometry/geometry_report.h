// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reports the positions of all widgets to tests that work the real window with mouse and keys
// (docs/develop/decisions/1061-finding-widgets.md).

#include <QObject>
#include <QTimer>

namespace detent::editor {

/// While it lives, writes names, classes, texts and screen rectangles of all visible widgets as JSON to a
/// file whenever they changed, atomically, ten times a second at most. Where nothing changed, only the file's
/// time does: a report that stays old is one of a program that is busy. Plots also give their axes, so that
/// values can be found on the screen. GUI thread.
class GeometryReport : public QObject {
  Q_OBJECT

 public:
  explicit GeometryReport(QString file, QObject* parent = nullptr);

 private:
  void write();
  QString file_;
  QByteArray last_;
  QTimer timer_;
};

/// The JSON it writes: {"windows": [{"title", "name", "active", "exposed", "rect"}], "widgets": [{"name",
/// "class", "window", "rect", "enabled", "focus", "text"?, "checked"?, "axes"?}]}; rect is [x, y, width,
/// height] in screen pixels, axes {"x": [label, left value, right value], "y": [label, lower, upper],
/// "rect"}.
QByteArray geometryJson();

}  // namespace detent::editor
