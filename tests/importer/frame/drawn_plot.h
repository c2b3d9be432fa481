// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plots drawn by the test, at places it knows to a fraction of a pixel.

#include <cmath>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/page/document.h"

namespace detent::importer::test {

struct PlotStyle {
  int width = 900, height = 600;
  double left = 100, top = 40, right = 820, bottom = 500;  ///< middle of the edges, pixel centres
  int xSteps = 8, ySteps = 6;                              ///< cells of the grid
  double xFrom = 0, xStep = 0.5, yFrom = 0, yStep = 20;    ///< values at the lines
  double lineWidth = 1;
  int lineGrey = 0, gridGrey = 200, paperGrey = 255, textGrey = 0;
  bool grid = true, box = true, topEdge = true, ticks = true, labels = true;
  int labelEvery = 1;
  std::string xTitle = "Travel [mm]", yTitle = "Force [cN]";
  bool curves = true;
  double textScale = 0.5;
  double labelDrop = 20;     ///< from the bottom edge to the middle of the x labels
  double xShiftOfFirst = 0;  ///< of the first x label, off its tick
  int oddLabel = -1;         ///< an x label with another text than its value
  std::string oddText;
  std::string xUnit, yUnit;  ///< behind each number, with the blank before it
  bool forceOnRight =
      false;                 ///< draws the force axis at the right: ticks, numbers and a title read downwards
  bool titleAtLeft = false;  ///< with forceOnRight, keeps the force axis' title at the left
  bool travelAtTop = false;  ///< draws the travel axis' tick labels and title at the top
};

/// Grey canvas on which lines cover parts of pixels.
class Canvas {
 public:
  Canvas(int width, int height, int paper) : grey_(height, width, CV_8U, cv::Scalar(paper)) {}

  /// Fills the box between pixel edges given in pixel centre coordinates, with exact partial cover.
  void fill(double x0, double y0, double x1, double y1, int shade) {
    for (int y = std::max(0, static_cast<int>(std::floor(y0)));
         y <= std::min(grey_.rows - 1, static_cast<int>(std::ceil(y1))); ++y)
      for (int x = std::max(0, static_cast<int>(std::floor(x0)));
           x <= std::min(grey_.cols - 1, static_cast<int>(std::ceil(x1))); ++x) {
        const double cx = std::min(x1, x + 0.5) - std::max(x0, x - 0.5),
                     cy = std::min(y1, y + 0.5) - std::max(y0, y - 0.5);
        if (cx <= 0 || cy <= 0) continue;
        auto& p = grey_.at<std::uint8_t>(y, x);
        p = cv::saturate_cast<std::uint8_t>(p + (shade - p) * cx * cy);
      }
  }
  void column(double x, double y0, double y1, double width, int shade) {
    fill(x - 0.5 * width, y0, x + 0.5 * width, y1, shade);
  }
  void row(double y, double x0, double x1, double width, int shade) {
    fill(x0, y - 0.5 * width, x1, y + 0.5 * width, shade);
  }

  /// Text centred at a point; `quarterTurns` counter-clockwise.
  void text(const std::string& s, double cx, double cy, int shade, double scale = 0.5, int quarterTurns = 0) {
    int base = 0;
    const auto size = cv::getTextSize(s, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &base);
    const int paper = grey_.at<std::uint8_t>(0, 0);
    cv::Mat box(size.height + base + 6, size.width + 6, CV_8U, cv::Scalar(paper));
    cv::putText(box, s, {3, size.height + 3}, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(shade), 1,
                cv::LINE_AA);
    for (int k = 0; k < quarterTurns; ++k) cv::rotate(box, box, cv::ROTATE_90_COUNTERCLOCKWISE);
    // Digits have no descender: their middle is half the ascent.
    const double middle = quarterTurns == 0 ? 3 + 0.5 * size.height : 0.5 * box.rows;
    const cv::Rect at(static_cast<int>(std::lround(cx - 0.5 * box.cols)),
                      static_cast<int>(std::lround(cy - middle)), box.cols, box.rows);
    const cv::Rect inside = at & cv::Rect(0, 0, grey_.cols, grey_.rows);
    if (inside.area() > 0) {
      const cv::Mat from = box(cv::Rect(inside.x - at.x, inside.y - at.y, inside.width, inside.height));
      cv::Mat to = grey_(inside);
      if (paper >= 128)
        cv::min(to, from, to);
      else
        cv::max(to, from, to);
    }
  }
  void curve(const std::vector<cv::Point2d>& points, int shade, double width) {
    for (std::size_t i = 1; i < points.size(); ++i)
      cv::line(grey_, cv::Point2d(points[i - 1]) * 256, cv::Point2d(points[i]) * 256, cv::Scalar(shade),
               static_cast<int>(width), cv::LINE_AA, 8);
  }
  cv::Mat& grey() { return grey_; }

 private:
  cv::Mat grey_;
};

inline std::string shown(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

inline void drawInto(Canvas& c, const PlotStyle& s) {
  const auto x = [&](int k) { return s.left + (s.right - s.left) * k / s.xSteps; };
  const auto y = [&](int k) { return s.bottom - (s.bottom - s.top) * k / s.ySteps; };
  const double w = s.lineWidth, half = 0.5 * w;
  if (s.grid) {
    for (int k = 1; k < s.xSteps; ++k) c.column(x(k), s.top, s.bottom, w, s.gridGrey);
    for (int k = 1; k < s.ySteps; ++k) c.row(y(k), s.left, s.right, w, s.gridGrey);
    if (!s.box) c.column(s.right, s.top, s.bottom, w, s.gridGrey);
  }
  if (s.curves) {
    std::vector<cv::Point2d> press, release;
    for (int k = 0; k <= 60; ++k) {
      const double t = k / 60.0, px = s.left + 0.02 * (s.right - s.left) + 0.9 * (s.right - s.left) * t;
      const double force = 0.35 + 0.2 * std::sin(5 * t) * (1 - t) + 0.25 * t;
      press.emplace_back(px, s.bottom - (s.bottom - s.top) * force);
      release.emplace_back(px, s.bottom - (s.bottom - s.top) * (force - 0.12 * (1 - t)));
    }
    c.curve(press, s.lineGrey, 1);
    c.curve(release, s.lineGrey, 1);
  }
  c.column(s.left, s.top - half, s.bottom + half, w, s.lineGrey);
  c.row(s.bottom, s.left - half, s.right + half, w, s.lineGrey);
  if (s.box) {
    c.column(s.right, s.top - half, s.bottom + half, w, s.lineGrey);
    if (s.topEdge) c.row(s.top, s.left - half, s.right + half, w, s.lineGrey);
  }
  if (s.ticks) {
    for (int k = 0; k <= s.xSteps; ++k) c.column(x(k), s.bottom, s.bottom + 6, w, s.lineGrey);
    for (int k = 0; k <= s.ySteps; ++k)
      c.row(y(k), s.forceOnRight ? s.right : s.left - 6, s.forceOnRight ? s.right + 6 : s.left, w,
            s.lineGrey);
  }
  if (s.labels) {
    for (int k = 0; k <= s.xSteps; k += s.labelEvery)
      c.text((k == s.oddLabel ? s.oddText : shown(s.xFrom + k * s.xStep)) + s.xUnit,
             x(k) + (k == 0 ? s.xShiftOfFirst : 0),
             s.travelAtTop ? s.top - s.labelDrop : s.bottom + s.labelDrop, s.textGrey, s.textScale);
    for (int k = 0; k <= s.ySteps; k += s.labelEvery) {
      const std::string text = shown(s.yFrom + k * s.yStep) + s.yUnit;
      const auto size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, s.textScale, 1, nullptr);
      c.text(text, s.forceOnRight ? s.right + 14 + 0.5 * size.width : s.left - 14 - 0.5 * size.width, y(k),
             s.textGrey, s.textScale);
    }
  }
  if (!s.xTitle.empty())
    c.text(s.xTitle, 0.5 * (s.left + s.right), s.travelAtTop ? s.top - 55 : s.bottom + 55, s.textGrey, 0.6);
  const bool titleAtRight = s.forceOnRight && !s.titleAtLeft;
  if (!s.yTitle.empty())
    c.text(s.yTitle, titleAtRight ? s.right + 65 : s.left - (s.forceOnRight ? 15 : 70),
           0.5 * (s.top + s.bottom), s.textGrey, 0.6, titleAtRight ? 3 : 1);
}

inline cv::Mat drawn(const PlotStyle& s) {
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  return c.grey();
}

inline Document documentOf(const cv::Mat& grey) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", grey, bytes);
  auto document = Document::fromBytes(std::move(bytes), "drawn.png");
  return std::move(document).value();
}

}  // namespace detent::importer::test
