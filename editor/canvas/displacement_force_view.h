// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The same graph the other way round: displacement over force, jumps as vertical lines (Kim & Lee 2013,
// Figure 2b). What a finger that controls force feels.

#include "editor/canvas/graph_canvas.h"

namespace detent::editor {

/// Shows what a GraphCanvas shows; nothing is edited here. GUI thread.
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
