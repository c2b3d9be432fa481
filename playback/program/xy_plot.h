// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Line plots over two axes as SVG, for runs and recordings.

#include <string>
#include <vector>

namespace detent::playback {

struct PlotPoint {
  double x = 0, y = 0;
};

/// One line; a NaN breaks it.
struct PlotLine {
  std::string name;   ///< name in the legend; empty: not listed
  std::string color;  ///< of SVG, "#1f5fa8"
  std::vector<PlotPoint> points;
  bool dashed = false;
};

/// Scale of the horizontal axis: equal steps, or decades (values > 0).
enum class XScale { even, decades };

/// A named position on the horizontal axis.
struct PlotMark {
  double x = 0;
  std::string name;
};

struct XyPlot {
  std::string title, xTitle, yTitle;
  std::vector<std::string> notes;  ///< lines of text under the plot: equations, settings
  std::vector<PlotLine> lines;
  XScale xScale = XScale::even;
  std::vector<PlotMark> marks = {};
};

/// An SVG document with the plots below one another. Lines are thinned to what a screen can show.
/// Deterministic.
std::string svgOf(const std::vector<XyPlot>& plots);

}  // namespace detent::playback
