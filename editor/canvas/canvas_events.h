// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mouse and key events on the graph in plot coordinates, for the owner of the tools.

#include <QKeyEvent>
#include <QPoint>
#include <QPointF>

#include "model/stroke_curve.h"

namespace detent::editor {

struct PointerInput {
  QPointF at_px;
  CurvePoint at;                            ///< the position in axis values
  Qt::MouseButton button = Qt::NoButton;    ///< the changed button; none for moves
  Qt::MouseButtons buttons = Qt::NoButton;  ///< currently pressed buttons
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

/// Receives events of a GraphCanvas. Each returns true if it was handled; the canvas then ignores it. GUI
/// thread.
class CanvasEvents {
 public:
  virtual ~CanvasEvents() = default;
  virtual bool pointerPressed(const PointerInput& input) = 0;
  virtual bool pointerMoved(const PointerInput& input) = 0;
  virtual bool pointerReleased(const PointerInput& input) = 0;
  virtual bool doubleClicked(const PointerInput& input) = 0;
  virtual bool keyPressed(int key, Qt::KeyboardModifiers modifiers) = 0;
  /// Returns true if `keyPressed` would handle this key now. Then no window shortcut gets it.
  virtual bool wantsKey(int key, Qt::KeyboardModifiers modifiers) const = 0;
  virtual void pointerLeft() = 0;
  virtual void contextMenu(const PointerInput& input, QPoint global_px) = 0;
};

}  // namespace detent::editor
