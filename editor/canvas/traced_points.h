// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The points that the importer traced, as dots on the ground of a force graph.

#include <vector>

#include "editor/canvas/unit_plot.h"
#include "model/stroke_curve.h"

namespace detent::editor {

/// They rest while curves are dragged, so they are drawn with page and grid. GUI thread.
class TracedPoints : public QCPLayerable {
 public:
  explicit TracedPoints(UnitPlot& plot);  ///< owned by the plot

  void setPoints(std::vector<CurvePoint> press, std::vector<CurvePoint> release);
  const std::vector<CurvePoint>& of(Stroke stroke) const {
    return stroke == Stroke::press ? press_ : release_;
  }
  bool empty() const { return press_.empty() && release_.empty(); }
  void setShown(bool shown) { shown_ = shown; }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;
  QRect clipRect() const override;

 private:
  UnitPlot& plot_;
  std::vector<CurvePoint> press_, release_;
  bool shown_ = false;
};

}  // namespace detent::editor
