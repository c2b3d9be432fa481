// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/xy_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "model/file/markup.h"
#include "model/file/svg_plot.h"

namespace detent::playback {

namespace {

// Pixels.
constexpr double width = 640, plotHeight = 300, left = 70, right = 20, top = 34, axisRoom = 46,
                 noteHeight = 16, legendHeight = 16;
constexpr int aboutTicks = 6;
constexpr double thinnest_px = 0.4;  // a point closer than this to the previous one is left out

template <class... Values>
void append(std::string& out, const char* format, Values... values) {
  char text[400];
  std::snprintf(text, sizeof text, format, values...);
  out += text;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  Ticks ticks() const {
    if (!(low <= high)) return niceTicks(0, 1, aboutTicks);
    // Values that differ only by rounding count as equal.
    const double rounding = 1e-9 * std::max(std::abs(low), std::abs(high));
    return high - low > rounding ? niceTicks(low, high, aboutTicks)
                                 : niceTicks(std::min(0.0, 2 * low), std::max(1e-9, 2 * high), aboutTicks);
  }
};

/// The horizontal axis: its range, and the values that are printed.
struct XAxis {
  XScale scale = XScale::even;
  double low = 0, high = 1;
  std::vector<double> at;
  int decimals = 0;

  double shareOf(double x) const {
    return scale == XScale::even ? (x - low) / (high - low) : std::log(x / low) / std::log(high / low);
  }
};

XAxis evenAxis(const Range& range) {
  const Ticks ticks = range.ticks();
  XAxis axis{XScale::even, ticks.at(0), ticks.last(), {}, ticks.decimals};
  for (int i = 0; i < ticks.count; ++i) axis.at.push_back(ticks.at(i));
  return axis;
}

// From the first value to the last, with labels at 1, 2 and 5 of each decade.
XAxis decadesAxis(const Range& range) {
  XAxis axis{XScale::decades, range.low, range.high, {}, 0};
  for (double decade = std::pow(10, std::floor(std::log10(range.low))); decade <= range.high; decade *= 10) {
    for (const double x : {decade, 2 * decade, 5 * decade})
      if (x >= range.low * (1 - 1e-9) && x <= range.high * (1 + 1e-3)) axis.at.push_back(x);
    if (decade < 1 && range.low < 1)
      axis.decimals = std::max(axis.decimals, static_cast<int>(std::ceil(-std::log10(decade) - 1e-9)));
  }
  return axis;
}

class Panel {
 public:
  Panel(const XyPlot& plot, double y) : plot_(plot), top_(y + top) {
    Range xs, ys;
    for (const PlotLine& line : plot.lines) {
      for (const PlotPoint& p : line.points) xs.add(p.x), ys.add(p.y);
    }
    x_ = plot.xScale == XScale::even ? evenAxis(xs) : decadesAxis(xs);
    y_ = ys.ticks();
  }

  std::string svg() const {
    std::string out;
    append(out, "<text x=\"%g\" y=\"%g\" font-weight=\"bold\">%s</text>\n", left, top_ - 14,
           escapedForMarkup(plot_.title).c_str());
    grid(out);
    for (const PlotLine& line : plot_.lines) draw(out, line);
    for (const PlotMark& mark : plot_.marks) draw(out, mark);
    words(out);
    return out;
  }

  static double heightOf(const XyPlot& plot) {
    const auto named = std::count_if(plot.lines.begin(), plot.lines.end(),
                                     [](const PlotLine& l) { return !l.name.empty(); });
    return top + plotHeight + axisRoom + noteHeight * static_cast<double>(plot.notes.size()) +
           legendHeight * static_cast<double>(named) + 10;
  }

 private:
  double px(double x) const { return left + x_.shareOf(x) * (width - left - right); }
  double py(double y) const {
    return top_ + plotHeight - (y - y_.at(0)) / (y_.last() - y_.at(0)) * plotHeight;
  }

  void grid(std::string& out) const {
    for (const double value : x_.at) {
      const double x = px(value);
      append(out, "<path d=\"M%.2f %.2fV%.2f\" stroke=\"#ddd\"/>\n", x, top_, top_ + plotHeight);
      append(out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"middle\">%.*f</text>\n", x,
             top_ + plotHeight + 16, x_.decimals, value);
    }
    for (int i = 0; i < y_.count; ++i) {
      const double y = py(y_.at(i));
      append(out, "<path d=\"M%.2f %.2fH%.2f\" stroke=\"#ddd\"/>\n", left, y, width - right);
      append(out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"end\">%.*f</text>\n", left - 6, y + 4,
             y_.decimals, y_.at(i));
    }
    append(out, "<rect x=\"%g\" y=\"%.2f\" width=\"%g\" height=\"%g\" fill=\"none\" stroke=\"#444\"/>\n",
           left, top_, width - left - right, plotHeight);
    append(out, "<text x=\"%g\" y=\"%.2f\" text-anchor=\"middle\">%s</text>\n", (left + width - right) / 2,
           top_ + plotHeight + 34, escapedForMarkup(plot_.xTitle).c_str());
    append(out, "<text transform=\"translate(16 %.2f) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
           top_ + plotHeight / 2, escapedForMarkup(plot_.yTitle).c_str());
  }

  void draw(std::string& out, const PlotLine& line) const {
    out += "<path fill=\"none\" stroke=\"" + line.color + "\" stroke-width=\"1.4\"" +
           (line.dashed ? " stroke-dasharray=\"6 4\"" : "") + " d=\"";
    bool pen = false;
    double lastX = 0, lastY = 0;
    for (const PlotPoint& p : line.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        pen = false;
        continue;
      }
      const double x = px(p.x), y = py(p.y);
      if (pen && std::abs(x - lastX) + std::abs(y - lastY) < thinnest_px) continue;
      append(out, "%c%.2f %.2f", pen ? 'L' : 'M', x, y);
      pen = true;
      lastX = x;
      lastY = y;
    }
    out += "\"/>\n";
  }

  void draw(std::string& out, const PlotMark& mark) const {
    const double x = px(mark.x);
    append(out, "<path d=\"M%.2f %.2fV%.2f\" stroke=\"#a02020\" stroke-dasharray=\"3 3\"/>\n", x, top_ + 16,
           top_ + plotHeight);
    append(out, "<text x=\"%.2f\" y=\"%.2f\" fill=\"#a02020\" text-anchor=\"middle\">%s</text>\n", x,
           top_ + 12, escapedForMarkup(mark.name).c_str());
  }

  void words(std::string& out) const {
    double y = top_ + plotHeight + axisRoom + 8;
    for (const PlotLine& line : plot_.lines) {
      if (line.name.empty()) continue;
      append(out, "<path d=\"M%g %.2fh24\" stroke=\"%s\" stroke-width=\"2\"%s/>\n", left, y - 4,
             line.color.c_str(), line.dashed ? " stroke-dasharray=\"6 4\"" : "");
      append(out, "<text x=\"%g\" y=\"%.2f\">%s</text>\n", left + 32, y, escapedForMarkup(line.name).c_str());
      y += legendHeight;
    }
    for (const std::string& note : plot_.notes) {
      append(out, "<text x=\"%g\" y=\"%.2f\" fill=\"#444\">%s</text>\n", left, y,
             escapedForMarkup(note).c_str());
      y += noteHeight;
    }
  }

  const XyPlot& plot_;
  double top_;
  XAxis x_;
  Ticks y_;
};

}  // namespace

std::string svgOf(const std::vector<XyPlot>& plots) {
  double height = 0;
  std::string body;
  for (const XyPlot& plot : plots) {
    body += Panel(plot, height).svg();
    height += Panel::heightOf(plot);
  }
  std::string out;
  append(out,
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
         "font-family=\"sans-serif\" "
         "font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
         width, height, width, height);
  return out + body + "</svg>\n";
}

}  // namespace detent::playback
