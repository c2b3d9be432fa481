// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The stability margin of a force device, drawn over the curves. Shown only on the screen, not in exported
// pictures.

#include <memory>
#include <QWidget>

#include "editor/canvas/graph_canvas.h"
#include "playback/playback.h"

namespace detent::editor {

/// A broad band along both curves of the shown state: green where the device renders the slope easily, amber
/// near its limit, red and hatched beyond it. The steepest places have their values as labels. Drawn over the
/// canvas, which owns it; ignores the mouse. GUI thread.
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
