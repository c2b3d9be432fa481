// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The traced points of an import, as dots in the background of a force graph.

#include <vector>

#include "editor/canvas/unit_plot.h"
#include "model/stroke_curve.h"

namespace detent::editor {

/// Drawn with page and grid, because they do not move during a drag. GUI thread.
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
