// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The stability margin of a force device, laid over the curves it is about. On the screen only: pictures for
// others go without.

#include <memory>
#include <QWidget>

#include "editor/canvas/graph_canvas.h"
#include "playback/playback.h"

namespace detent::editor {

/// A broad band along both curves of the state that is shown: green where the device bears the slope easily,
/// amber where it is near what it bears, red and hatched where it is more; the steepest places carry their
/// numbers. Lies over the canvas, which owns it, and lets the mouse through. GUI thread.
class MarginOverlay : public QWidget {
  Q_OBJECT

 public:
  /// `document` is the canvas' own.
  MarginOverlay(GraphCanvas& canvas, const ButtonDocument& document);
  void setMargin(std::shared_ptr<const playback::StabilityMargin> margin);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintWorst(QPainter& painter, const PlotMapping& map, const ButtonState& state,
                  std::size_t shown) const;

  GraphCanvas& canvas_;
  const ButtonDocument& document_;
  std::shared_ptr<const playback::StabilityMargin> margin_;
};

}  // namespace detent::editor
