// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mouse and keys on the graph, in plot coordinates, for whoever holds the tools.

#include <QKeyEvent>
#include <QPoint>
#include <QPointF>

#include "model/stroke_curve.h"

namespace detent::editor {

struct PointerInput {
  QPointF at_px;
  CurvePoint at;                            ///< the same place on the axes
  Qt::MouseButton button = Qt::NoButton;    ///< that changed; none for moves
  Qt::MouseButtons buttons = Qt::NoButton;  ///< that are down now
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

/// Receives what happens on a GraphCanvas. Each answers whether it was handled; the canvas then does nothing
/// of its own with it. GUI thread.
class CanvasEvents {
 public:
  virtual ~CanvasEvents() = default;
  virtual bool pointerPressed(const PointerInput& input) = 0;
  virtual bool pointerMoved(const PointerInput& input) = 0;
  virtual bool pointerReleased(const PointerInput& input) = 0;
  virtual bool doubleClicked(const PointerInput& input) = 0;
  virtual bool keyPressed(int key, Qt::KeyboardModifiers modifiers) = 0;
  /// Would `keyPressed` take this key now? Then no shortcut of the window gets it.
  virtual bool wantsKey(int key, Qt::KeyboardModifiers modifiers) const = 0;
  virtual void pointerLeft() = 0;
  virtual void contextMenu(const PointerInput& input, QPoint global_px) = 0;
};

}  // namespace detent::editor
