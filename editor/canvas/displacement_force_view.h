// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The graph with exchanged axes: displacement over force, jumps as vertical lines (Kim & Lee 2013, Figure
// 2b). This is what a finger that controls force feels.

#include "editor/canvas/graph_canvas.h"

namespace detent::editor {

/// Shows the same as a GraphCanvas, without editing. GUI thread.
class DisplacementForceView : public UnitPlot {
  Q_OBJECT

 public:
  /// `canvas` must outlive it.
  DisplacementForceView(ButtonDocument& document, ViewSettings& settings, const GraphCanvas& canvas,
                        QWidget* parent = nullptr);
  void showFinger(std::optional<FingerPosition> finger);

 protected:
  void drawContent(QPainter& painter, const PlotMapping& map) const override;
  QRectF contentRange() const override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  const GraphCanvas& canvas_;
  std::optional<FingerPosition> finger_;
};

}  // namespace detent::editor
