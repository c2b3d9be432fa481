// SPDX-License-Identifier: GPL-3.0-or-later
// Differently coloured curves on plots drawn by the test itself: exact curves beside them, pixels by exact
// distance.

#include <algorithm>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/page/document.h"
#include "importer/page/polyline.h"
#include "importer/page/same_colour.h"
#include "importer/trace/bottom_outs.h"
#include "importer/trace/curve_trace.h"
#include "importer/trace/edge_cut.h"
#include "importer/trace/explanation.h"
#include "importer/trace/legend_words.h"
#include "importer/trace/plot_scene.h"

using namespace detent;
using namespace detent::importer;

namespace {

using Curve = std::vector<Point>;

constexpr Rgb kWhite{255, 255, 255}, kBlack{0, 0, 0}, kGrey{180, 180, 180};
constexpr Rgb kBlue{42, 96, 153}, kLime{187, 227, 61}, kRed{220, 30, 40}, kTeal{20, 150, 140};

double toPiece(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy;
  const double t = l2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / l2, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double distanceTo(Point p, const Curve& curve) {
  double best = INFINITY;
  for (std::size_t i = 1; i < curve.size(); ++i) best = std::min(best, toPiece(p, curve[i - 1], curve[i]));
  return best;
}

/// Points half a pixel apart along a curve.
Curve dense(const Curve& curve) {
  Curve out;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const int n = std::max(
        1, static_cast<int>(2 * std::hypot(curve[i].x - curve[i - 1].x, curve[i].y - curve[i - 1].y)));
    for (int k = 0; k < n; ++k) {
      const double t = static_cast<double>(k) / n;
      out.push_back({curve[i - 1].x + t * (curve[i].x - curve[i - 1].x),
                     curve[i - 1].y + t * (curve[i].y - curve[i - 1].y)});
    }
  }
  out.push_back(curve.back());
  return out;
}

double mean(const Curve& from, const Curve& to) {
  double sum = 0;
  const Curve points = dense(from);
  for (Point p : points) sum += distanceTo(p, to);
  return sum / static_cast<double>(points.size());
}

/// Symmetric mean distance, px.
double apart(const Curve& a, const Curve& b) { return 0.5 * (mean(a, b) + mean(b, a)); }

class Plot {
 public:
  Plot(int width, int height, Rgb paper = kWhite) {
    view_.raster.width_px = width;
    view_.raster.height_px = height;
    view_.raster.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < view_.raster.rgb.size(); i += 3) {
      view_.raster.rgb[i] = paper.r;
      view_.raster.rgb[i + 1] = paper.g;
      view_.raster.rgb[i + 2] = paper.b;
    }
    box_ = {std::round(0.1 * width), std::round(0.06 * height), std::round(0.93 * width),
            std::round(0.9 * height)};
    frame_.corners = {Point{box_.x0, box_.y0}, Point{box_.x1, box_.y0}, Point{box_.x1, box_.y1},
                      Point{box_.x0, box_.y1}};
    axes_.calibration.value.viewToUnits = {5 / box_.width(),
                                           0,
                                           -5 * box_.x0 / box_.width(),
                                           0,
                                           -1 / box_.height(),
                                           box_.y1 / box_.height(),
                                           0,
                                           0,
                                           1};
  }

  Point at(double x, double y) const { return {box_.x0 + x * box_.width(), box_.y1 - y * box_.height()}; }
  Curve at(const Curve& fractions) const {
    Curve out;
    for (Point p : fractions) out.push_back(at(p.x, p.y));
    return out;
  }

  /// One stroke of a pen: exact coverage, painted over the picture. Clipped to the frame on request.
  void line(const Curve& points, double width, Rgb color, bool clipped = false, double opacity = 1) {
    Raster& r = view_.raster;
    const double reach = 0.5 * width + 1;
    const Box all = clipped ? box_ : Box{0, 0, r.width_px - 1.0, r.height_px - 1.0};
    const auto pixelsAround = [&](double x0, double y0, double x1, double y1) {
      const cv::Point2d from(std::ceil(std::max(all.x0, std::trunc(x0 - reach))),
                             std::ceil(std::max(all.y0, std::trunc(y0 - reach))));
      const cv::Point2d to(std::floor(std::min(all.x1, std::trunc(x1 + reach) + 1)) + 1,
                           std::floor(std::min(all.y1, std::trunc(y1 + reach) + 1)) + 1);
      return from.x < to.x && from.y < to.y ? cv::Rect(cv::Point(from), cv::Point(to)) : cv::Rect();
    };
    const auto [left, right] = std::ranges::minmax(points, {}, &Point::x);
    const auto [top, lowest] = std::ranges::minmax(points, {}, &Point::y);
    const cv::Rect touched = pixelsAround(left.x, top.y, right.x, lowest.y);
    cv::Mat1f coverage(touched.size(), 0.0F);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point a = points[i - 1], b = points[i];
      const cv::Rect pixels =
          pixelsAround(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y));
      for (int y = pixels.y; y < pixels.br().y; ++y) {
        float* const row = coverage.ptr<float>(y - touched.y);
        for (int x = pixels.x; x < pixels.br().x; ++x) {
          const double d = toPiece({static_cast<double>(x), static_cast<double>(y)}, a, b);
          float& c = row[x - touched.x];
          c = std::max(c, static_cast<float>(std::clamp(0.5 * width + 0.5 - d, 0.0, std::min(1.0, width))));
        }
      }
    }
    const double colour[3] = {double(color.r), double(color.g), double(color.b)};
    for (int y = 0; y < touched.height; ++y) {
      const float* const row = coverage.ptr<float>(y);
      for (int x = 0; x < touched.width; ++x) {
        if (!(row[x] > 0)) continue;
        std::uint8_t* const pixel =
            &r.rgb[3 * static_cast<std::size_t>((y + touched.y) * r.width_px + x + touched.x)];
        const double c = opacity * static_cast<double>(row[x]);
        for (int k = 0; k < 3; ++k)
          pixel[k] = static_cast<std::uint8_t>(std::lround(c * colour[k] + (1 - c) * pixel[k]));
      }
    }
  }
  /// The area between a curve and the plot's bottom, as programs fill it; `opacity` at the top and at the
  /// bottom.
  void area(const Curve& points, Rgb color, double opacity, double atBaseline) {
    Raster& r = view_.raster;
    const double colour[3] = {double(color.r), double(color.g), double(color.b)};
    for (std::size_t i = 1; i < points.size(); ++i)
      for (double x = std::ceil(points[i - 1].x); x < points[i].x; ++x) {
        const double t = (x - points[i - 1].x) / (points[i].x - points[i - 1].x);
        const double from = std::max(box_.y0, std::lerp(points[i - 1].y, points[i].y, t));
        for (int y = static_cast<int>(from); y < box_.y1; ++y) {
          const double c = std::min(1.0, y + 1 - from) *
                           std::lerp(opacity, atBaseline, (y - box_.y0) / (box_.y1 - box_.y0));
          std::uint8_t* pixel = r.rgb.data() + 3 * (y * r.width_px + static_cast<int>(x));
          for (std::size_t k = 0; k < 3; ++k)
            pixel[k] = static_cast<std::uint8_t>(std::lround(c * colour[k] + (1 - c) * pixel[k]));
        }
      }
  }
  void grid(int columns, int rows, Rgb color, double width = 1) {
    for (int i = 0; i <= columns; ++i)
      line(at({{double(i) / columns, 0}, {double(i) / columns, 1}}), width, color);
    for (int i = 0; i <= rows; ++i) line(at({{0, double(i) / rows}, {1, double(i) / rows}}), width, color);
  }
  void letters(const std::string& words, double x, double y, double height, Rgb color, int stroke = 2) {
    cv::Mat picture(view_.raster.height_px, view_.raster.width_px, CV_8UC3, view_.raster.rgb.data());
    const Point p = at(x, y);
    cv::putText(picture, words, {static_cast<int>(p.x), static_cast<int>(p.y)}, cv::FONT_HERSHEY_SIMPLEX,
                height / 22, cv::Scalar(color.r, color.g, color.b), stroke, cv::LINE_AA);
  }
  /// As a display with sub-pixels draws black letters: an orange edge on one side, a blue one on the other.
  void fringedLetters(const std::string& words, double x, double y, double height) {
    const double px = 1 / box_.width();
    letters(words, x - px, y, height, {255, 190, 98}, 3);
    letters(words, x + px, y, height, {98, 190, 255}, 3);
    letters(words, x, y, height, kBlack, 3);
  }
  /// A pale arrow of a curve's hue between two points of the frame, heads at both ends.
  void arrow(double x, double y0, double y1, Rgb color) {
    line(at({{x, y0}, {x, y1}}), 3, color);
    for (double y : {y0, y1})
      for (int i = 0; i < 12; ++i) {
        const Point tip = at(x, y);
        line({{tip.x - 0.5 * i, tip.y + i}, {tip.x + 0.5 * i, tip.y + i}}, 1.5, color);
      }
  }
  void disc(double x, double y, double radius, Rgb color) {
    const Point p = at(x, y);
    line({p, {p.x + 0.01, p.y}}, 2 * radius, color);
  }
  /// A line of writing that is no word: a short name, or none that was read.
  void sayOther(std::string text, Box box) { axes_.otherLines.push_back({std::move(text), box, 0.9, 0}); }
  void say(const std::string& words, const Box& box) { axes_.texts.push_back({words, box, 1, 0}); }
  void sayTick(const std::string& number, const Box& box) {
    say(number, box);
    axes_.calibration.value.y.ticks.push_back({box.middle().y, 0, number, box});
  }

  Result<std::vector<CurveTrace>> trace(const TraceHints& hints = {}, const TraceOptions& options = {},
                                        const Progress& progress = {}) const {
    return traceCurves(view_, scene(hints.masks_px), axes_, hints, options, progress);
  }
  trace::PlotScene scene(const std::vector<Box>& masks_px = {}) const {
    return {view_.raster, frame_, axes_.texts, masks_px};
  }
  /// Stores the picture with loss: `extension` ".jpg" (colour at half resolution) or ".webp".
  void storeAs(const std::string& extension, int quality) {
    Raster& r = view_.raster;
    cv::Mat bgr;
    cv::cvtColor(cv::Mat(r.height_px, r.width_px, CV_8UC3, r.rgb.data()), bgr, cv::COLOR_RGB2BGR);
    const int key = extension == ".webp" ? cv::IMWRITE_WEBP_QUALITY : cv::IMWRITE_JPEG_QUALITY;
    std::vector<unsigned char> bytes;
    REQUIRE(cv::imencode(extension, bgr, bytes, {key, quality}));
    const auto document = Document::fromBytes(bytes, "plot");
    REQUIRE(document.ok());
    r = document->page(1)->overview;
  }
  const Box& box() const { return box_; }
  PageView& view() { return view_; }
  PlotFrame& frame() { return frame_; }

 private:
  PageView view_;
  PlotFrame frame_;
  AxesFound axes_;
  Box box_;
};

/// A tactile press: rise at 0, peak, valley, slope, bottom-out that leaves the frame at the top.
Curve press(double shift = 0) {
  Curve c = {{0.004, 0}, {0.012, 0.2}, {0.02, 0.33}};
  for (double x = 0.03; x <= 0.62; x += 0.01)
    c.push_back({x, 0.34 + 0.12 * std::sin(8.5 * x) + 0.25 * x * x + 0.004 * std::sin(90 * x + shift)});
  const double last = c.back().y;
  c.push_back({0.635, last + 0.06});
  c.push_back({0.648, 1.05});
  return c;
}

Curve release() {
  Curve c = {{0.006, 0}, {0.02, 0.14}};
  for (double x = 0.04; x <= 0.62; x += 0.01)
    c.push_back({x, 0.2 + 0.08 * std::sin(8.5 * x) + 0.28 * x * x + 0.1 * x});
  c.push_back({0.642, 0.55});
  c.push_back({0.655, 0.82});
  return c;
}

Curve clippedAtTop(const Plot& plot, Curve c) {
  while (c.size() > 1 && c[c.size() - 2].y < plot.box().y0) c.pop_back();
  const Point a = c[c.size() - 2], b = c.back();
  const double t = (plot.box().y0 - a.y) / (b.y - a.y);
  if (b.y < plot.box().y0) c.back() = {a.x + t * (b.x - a.x), plot.box().y0};
  return c;
}

const CurveTrace& ofColor(const std::vector<CurveTrace>& traces, Rgb color) {
  const auto far = [&](const CurveTrace& t) {
    return std::abs(t.color.r - color.r) + std::abs(t.color.g - color.g) + std::abs(t.color.b - color.b);
  };
  return *std::min_element(traces.begin(), traces.end(),
                           [&](const CurveTrace& a, const CurveTrace& b) { return far(a) < far(b); });
}

}  // namespace

TEST_CASE("Two coloured curves over a grid are traced to a tenth of a pixel", "[trace]") {
  Plot plot(900, 550);
  plot.grid(8, 10, kGrey);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 2.5, kLime, true);
  plot.line(down, 2.5, kBlue, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, clippedAtTop(plot, down)) < 0.1);
  CHECK(apart(ofColor(*traces, kLime).points_px, up) < 0.12);
  for (const CurveTrace& t : *traces) {
    CHECK(t.width_px.size() == t.points_px.size());
    CHECK(t.width_px.front() == Approx(2.5).margin(0.3));
    CHECK(t.confidence > 0.8);
    CHECK_FALSE(t.fromVector);
  }
  // Ends: the press runs to the frame's top edge, the release stops inside.
  CHECK(ofColor(*traces, kBlue).points_px.back().y == Approx(plot.box().y0).margin(0.3));
  CHECK(ofColor(*traces, kLime).points_px.back().y == Approx(up.back().y).margin(1.5));
}

TEST_CASE("Tints that compression leaves beside a line are no curves", "[trace]") {
  const Rgb navy{12, 26, 84}, ochre{146, 130, 40}, green{20, 115, 79}, wine{98, 12, 44};
  for (const auto& [pressColour, releaseColour] :
       {std::pair(navy, ochre), std::pair(ochre, navy), std::pair(wine, green)})
    for (const auto& [extension, quality] :
         {std::pair(".jpg", 75), std::pair(".jpg", 85), std::pair(".webp", 75)}) {
      INFO(extension << ", quality " << quality << ", press " << nameOf(pressColour));
      Plot plot(900, 550);
      plot.grid(8, 10, {214, 214, 214});
      const Curve down = plot.at(press()), up = plot.at(release());
      plot.line(up, 2, releaseColour, true);
      plot.line(down, 2, pressColour, true);
      plot.storeAs(extension, quality);
      const auto traces = plot.trace();
      REQUIRE(traces.ok());
      REQUIRE(traces->size() == 2);
      CHECK(apart(ofColor(*traces, pressColour).points_px, clippedAtTop(plot, down)) < 0.3);
      CHECK(apart(ofColor(*traces, releaseColour).points_px, up) <
            2);  // the press hides a part of the release
    }
}

TEST_CASE("Markers filled with a shade of their line are no curve beside it", "[trace]") {
  const Rgb wine{163, 0, 0}, red{243, 31, 45};
  Plot plot(700, 430);
  plot.grid(1, 1, kBlack);
  const Curve down = plot.at({{0, 0}, {0.1, 0.5}, {0.8, 0.7}, {0.85, 0.9}}),
              up = plot.at({{0, 0}, {0.15, 0.3}, {0.75, 0.5}, {0.85, 0.9}});
  plot.line(down, 2, kBlue);
  plot.line(up, 2, wine);
  for (const Curve points = densified(up, 1);
       const std::size_t k : {20U, 90U, 150U, 210U, 270U, 330U, 390U, 450U}) {
    const Point p = points[k];
    plot.line({{p.x - 4, p.y}, {p.x + 4, p.y}}, 9, red);
    plot.line(
        {{p.x - 4, p.y - 4}, {p.x + 4, p.y - 4}, {p.x + 4, p.y + 4}, {p.x - 4, p.y + 4}, {p.x - 4, p.y - 4}},
        1, wine);
  }
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, wine).points_px, up) < 1);
}

TEST_CASE("Shades that compression makes of thin lines on dark paper belong to their lines", "[trace]") {
  const Rgb night{28, 33, 58}, sky{78, 201, 190}, lime{195, 236, 82};
  Plot plot(720, 400, night);
  plot.grid(1, 6, {220, 220, 230});
  const auto line = [&](double below, double phase) {
    Curve c{{0, 0.02}, {0.03, 0.2 - below}};
    for (double x = 0.04; x < 0.75; x += 0.008)
      c.push_back({x, 0.2 - below + 0.5 * x + 0.006 * std::sin(phase + 300 * x)});
    c.push_back({0.8, 0.88});
    return plot.at(c);
  };
  const Curve down = line(0, 0), up = line(0.03, 1);
  plot.line(down, 1.5, sky);
  plot.line(up, 1.5, lime);
  plot.storeAs(".jpg", 80);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, sky).points_px, down) < 2);  // the other curve hides a part of it
  CHECK(apart(ofColor(*traces, lime).points_px, up) < 1);
}

TEST_CASE("A tolerance band around a curve is no second stroke", "[trace]") {
  Plot plot(900, 550);
  plot.grid(8, 10, kGrey);
  const Curve down = plot.at(press());
  SECTION("in another hue: the line in its middle") {
    plot.line(down, 30, kRed, true, 0.3);
    plot.line(down, 2.5, kBlue, true);
  }
  SECTION("in its own hue: not believed, if not distinguished") {
    plot.line(down, 44, kBlue, true, 0.25);
    plot.line(down, 2.5, kBlue, true);
    const auto traces = plot.trace();
    if (!traces.ok() || traces->front().confidence < 0.25) return;
  }
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 1);
  CHECK(apart(traces->front().points_px, clippedAtTop(plot, down)) < 0.3);
}

TEST_CASE("Areas under both curves are taken off the paper: even, fading, compressed, on dark paper",
          "[trace]") {
  struct Style {
    double opacity, atBaseline;
    const char* storedAs;
    Rgb paper, grid;
  };
  const Style style =
      GENERATE(Style{0.3, 0.3, "", kWhite, {225, 225, 225}}, Style{0.5, 0.5, "", kWhite, {225, 225, 225}},
               Style{0.6, 0, "", kWhite, {225, 225, 225}}, Style{0.3, 0.3, ".jpg", kWhite, {225, 225, 225}},
               Style{0.4, 0.4, "", {20, 22, 30}, {60, 62, 70}});
  CAPTURE(style.opacity, style.atBaseline, style.storedAs);
  Plot plot(900, 550, style.paper);
  plot.grid(8, 10, style.grid);
  const Rgb red{228, 60, 50}, sky{60, 150, 230};
  const Curve down = clippedAtTop(plot, plot.at(press())), up = plot.at(release());
  plot.area(down, red, style.opacity, style.atBaseline);
  plot.line(down, 2, red, true);
  plot.area(up, sky, style.opacity, style.atBaseline);
  plot.line(up, 2, sky, true);
  if (*style.storedAs) plot.storeAs(style.storedAs, 85);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, red).points_px, down) < 0.6);
  CHECK(apart(ofColor(*traces, sky).points_px, up) < 0.6);
}

TEST_CASE("Thin pale lines of a 300 px picture", "[trace]") {
  Plot plot(300, 220);
  plot.grid(4, 4, {235, 235, 235});
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(down, 0.9, {225, 120, 120}, true);
  plot.line(up, 0.9, {120, 170, 210}, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, {225, 120, 120}).points_px, clippedAtTop(plot, down)) < 0.15);
  CHECK(apart(ofColor(*traces, {120, 170, 210}).points_px, up) < 0.2);
}

TEST_CASE(
    "A bottom-out that loses its colour to half resolution is followed to its tip, and named as its stroke "
    "is",
    "[trace]") {
  const Rgb sky{0, 128, 255}, rose{255, 0, 255};
  for (const int quality : {75, 85, 92}) {
    INFO("quality " << quality);
    Plot plot(640, 480);
    plot.grid(1, 1, kBlack);
    Curve down, up;
    for (double x = 0; x <= 0.85; x += 0.01) {
      down.push_back({x, 0.8 * x * (1.6 - 1.3 * x)});
      up.push_back({x, 0.45 * x * (1.6 - 1.3 * x)});
    }
    down.insert(down.end(), {{0.86, down.back().y + 0.02}, {0.91, 0.95}});
    up.insert(up.end(), {{0.87, up.back().y + 0.02}, {0.91, 0.95}});
    plot.line(plot.at(down), 1, sky, true);
    plot.line(plot.at(up), 1, rose, true);
    plot.line(plot.at({{0.1, 0.9}, {0.16, 0.9}}), 2, sky);
    plot.line(plot.at({{0.1, 0.8}, {0.16, 0.8}}), 2, rose);
    for (const auto& [words, y] : {std::pair("Press", 0.9), std::pair("Return", 0.8)}) {
      plot.letters(words, 0.17, y - 0.01, 10, kBlack, 1);
      const Point p = plot.at(0.17, y);
      plot.say(words, {p.x, p.y - 6, p.x + 44, p.y + 6});
    }
    plot.storeAs(".jpg", quality);
    const auto traces = plot.trace();
    REQUIRE(traces.ok());
    REQUIRE(traces->size() == 2);
    CHECK(apart(ofColor(*traces, sky).points_px, plot.at(down)) < 0.5);
    CHECK(apart(ofColor(*traces, rose).points_px, plot.at(up)) < 0.5);
    CHECK(ofColor(*traces, sky).label == "Press");
    CHECK(ofColor(*traces, rose).label == "Return");
  }
}

TEST_CASE("A bottom-out that hides the other stroke's ends no stroke along a gridline", "[trace]") {
  const Rgb blue{37, 92, 148}, lime{190, 223, 58};
  Plot plot(614, 413);
  plot.grid(9, 24, {120, 120, 120});
  Curve down{{0.004, 0.3}, {0.01, 0.36}}, up{{0.01, 0.1}, {0.02, 0.25}};
  for (double x = 0.02; x <= 0.73; x += 0.01) {
    down.push_back({x, 0.37 + 0.18 * x + 0.004 * std::sin(60 * x)});
    up.push_back({x, 0.26 + 0.18 * x + 0.004 * std::sin(50 * x) + (x > 0.6 ? 0.8 * (x - 0.6) : 0)});
  }
  down.insert(down.end(), {{0.738, 0.52}, {0.744, 0.999}});
  up.insert(up.end(), {{0.738, 0.5}, {0.7405, 0.56}});
  plot.line(plot.at(up), 2, lime, true);
  plot.line(plot.at(down), 2, blue, true);
  plot.letters("Heading over lines", 0.015, 0.917, 20, kBlack,
               3);  // on the gridline that a stroke could run along
  const Point p = plot.at(0.015, 0.917);
  plot.say("Heading over lines", {p.x, p.y - 20, p.x + 270, p.y + 6});
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  for (const CurveTrace& trace : *traces)
    CHECK(std::ranges::max(trace.points_px, {}, &Point::x).x < plot.at(0.78, 0).x);
}

TEST_CASE("Dark paper, light frame", "[trace]") {
  const Rgb paper{0, 43, 54};
  Plot plot(640, 480, paper);
  plot.grid(1, 1, {131, 148, 150});
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(down, 1.4, {181, 137, 0}, true);
  plot.line(up, 1.4, {42, 161, 152}, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, {181, 137, 0}).points_px, clippedAtTop(plot, down)) < 0.12);
  CHECK(apart(ofColor(*traces, {42, 161, 152}).points_px, up) < 0.15);
}

TEST_CASE("A black curve beside a red one, in a black frame with grey grid", "[trace]") {
  Plot plot(640, 480);
  plot.grid(5, 5, {211, 211, 211});
  plot.grid(1, 1, kBlack);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(down, 1.2, kBlack, true);
  plot.line(up, 1.2, {255, 0, 0}, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlack).points_px, clippedAtTop(plot, down)) < 0.2);
  CHECK(apart(ofColor(*traces, {255, 0, 0}).points_px, up) < 0.2);
}

TEST_CASE(
    "A black curve beside coloured ones is one more where those are of different switches, or a legend shows "
    "it",
    "[trace]") {
  Plot plot(700, 430);
  plot.grid(1, 1, kBlack);
  const auto ending = [&](double end, double height, double start = 0) {
    return plot.at(
        {{0, start}, {0.3 * end, height}, {0.6 * end, 0.6 * height}, {0.8 * end, 0.7 * height}, {end, 0.9}});
  };
  const bool apart = GENERATE(true, false);
  plot.line(ending(0.55, 0.7), 2, kRed);
  plot.line(ending(apart ? 0.9 : 0.55, 0.5), 2, kBlue);
  plot.line(ending(0.7, 0.3, 0.1), 2, kBlack);  // not from where the others begin
  CHECK(plot.trace()->size() == (apart ? 3U : 2U));
  if (apart) return;
  plot.line(plot.at({{0.75, 0.9}, {0.8, 0.9}}), 2, kBlack);
  plot.letters("Press", 0.82, 0.89, 14, kBlack, 1);
  CHECK(plot.trace()->size() == 3);
}

TEST_CASE("A curve with markers as large as they are drawn is a curve, no filled area", "[trace]") {
  Plot plot(700, 430);
  plot.grid(8, 6, kGrey);
  const Curve down = plot.at({{0, 0}, {0.1, 0.3}, {0.6, 0.4}, {0.8, 0.9}});
  plot.line(down, 3, kBlue);
  const Curve points = densified(down, 1);
  for (std::size_t k = 12; k + 12 < points.size(); k += 30) plot.line({points[k], points[k + 2]}, 15, kBlue);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 1);
  CHECK(::apart(traces->front().points_px, down) < 1.5);
  plot.line(plot.at({{0.1, 0.1}, {0.7, 0.1}}), 90, kRed);  // as high as a band
  const auto besideABand = plot.trace();
  REQUIRE(besideABand.ok());
  for (const CurveTrace& trace : *besideABand) CHECK(trace.color.b > trace.color.r);
}

TEST_CASE("A line along the frame's upper edge after a jump over bare paper belongs to no stroke",
          "[trace]") {
  Plot plot(700, 430);
  plot.grid(1, 1, kBlack);
  const Curve drawn = {{0, 0}, {0.5, 0.4}, {0.7, 0.8}};
  plot.line(plot.at(drawn), 2, kBlue);
  Curve followed = drawn;
  followed.insert(followed.end(), {{0.69, 1}, {1, 1}});
  CurveTrace stroke;
  stroke.points_px = dense(plot.at(followed));
  const bool fromRight = GENERATE(false, true);
  if (fromRight) std::ranges::reverse(stroke.points_px);
  stroke.color = kBlue;
  stroke.width_px.assign(stroke.points_px.size(), 2);
  std::vector<CurveTrace> traces{stroke};
  trace::cutAcrossToEdges(traces, plot.scene());
  const auto [left, right] = std::ranges::minmax(traces[0].points_px, {}, &Point::x);
  CHECK(std::abs(left.x - plot.at(0, 0).x) < 1);
  CHECK(std::abs(right.x - plot.at(0.7, 0).x) < 3);
  CHECK(traces[0].width_px.size() == traces[0].points_px.size());
  // Curve pixels lead up to the edge here, so nothing is cut.
  plot.line(plot.at({{0.7, 0.8}, {0.69, 1}}), 2, kBlue);
  traces = {stroke};
  trace::cutAcrossToEdges(traces, plot.scene());
  CHECK(traces[0].points_px.size() == stroke.points_px.size());
}

TEST_CASE("Grid in a curve's own hue", "[trace]") {
  Plot plot(800, 500);
  plot.grid(6, 6, {170, 190, 215});
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 2, kRed, true);
  plot.line(down, 2, kBlue, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, clippedAtTop(plot, down)) < 0.15);
  CHECK(apart(ofColor(*traces, kRed).points_px, up) < 0.15);
}

TEST_CASE("A curve that crosses the other and hides under it", "[trace]") {
  Plot plot(900, 550);
  plot.grid(8, 10, kGrey);
  Curve down = press(), up;
  for (Point p : down) {
    // Apart at first, across it twice, then exactly under it from 0.4 of the width to the top.
    const double lift = p.x < 0.4 ? -0.12 * std::sin(p.x / 0.4 * 3 * M_PI) : 0;
    up.push_back({p.x, p.y + (p.x < 0.02 ? 0 : lift)});
  }
  down = plot.at(down);
  up = plot.at(up);
  plot.line(up, 2.5, kLime, true);
  plot.line(down, 2.5, kBlue, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, clippedAtTop(plot, down)) < 0.12);
  const Curve& hidden = ofColor(*traces, kLime).points_px;
  CHECK(mean(clippedAtTop(plot, up), hidden) < 0.4);
  CHECK(mean(hidden, clippedAtTop(plot, up)) < 0.3);
}

TEST_CASE("A line half hidden along most of its length is not drawn to its visible side", "[trace]") {
  Plot plot(900, 550);
  plot.grid(1, 1, kGrey);
  const Curve down = plot.at(Curve{{0.05, 0.5}, {0.3, 0.55}, {0.6, 0.52}, {0.9, 0.62}});
  // Open at first, where its width shows; then with more than half of it under the other.
  Curve up = plot.at(Curve{{0.05, 0.3}, {0.2, 0.35}});
  for (Point p : down)
    if (p.x > plot.at(0.25, 0).x) up.push_back({p.x, p.y + 1.3});
  plot.line(up, 2.5, kLime, true);
  plot.line(down, 2.5, kBlue, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, down) < 0.1);
  CHECK(apart(ofColor(*traces, kLime).points_px, up) < 0.25);
}

TEST_CASE("Coloured edges of letters are no curves", "[trace]") {
  Plot plot(908, 551);
  plot.grid(9, 12, kGrey);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 2.5, {255, 150, 60}, true);
  plot.line(down, 2.5, kBlue, true);
  plot.fringedLetters("A title as long as the plot is wide,", 0.03, 0.92, 26);
  plot.fringedLetters("in two rows over the upper wall of it", 0.03, 0.84, 26);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, clippedAtTop(plot, down)) < 0.5);
  CHECK(apart(ofColor(*traces, {255, 150, 60}).points_px, up) < 0.5);
}

TEST_CASE("A pale arrow that stands on the curve near its bottom-out is no part of it", "[trace]") {
  Plot plot(908, 551);
  plot.grid(9, 12, kGrey);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.arrow(0.6, 0.1, 0.39, {226, 240, 170});
  plot.line(up, 2.5, kLime, true);
  plot.line(down, 2.5, kBlue, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kLime).points_px, up) < 0.3);
}

namespace {

/// Both strokes in one black colour that end on one line at a share of the width; a thin black grid under
/// them.
struct Loop {
  Curve press, release;
};

Loop loopEndingAt(double x) {
  Loop loop;
  for (double t = 0; t <= 1.0001; t += 0.01) {
    const double bump = 0.12 * std::exp(-std::pow((t - 0.4) / 0.12, 2));
    loop.press.push_back({x * t, 0.2 + 0.3 * t + bump});
    loop.release.push_back({x * t, 0.06 + 0.34 * t + 0.8 * bump});
  }
  return loop;
}

/// A line in dashes of 9 pixels, 6 apart.
std::vector<Curve> dashesOf(const Curve& line) {
  std::vector<Curve> dashes;
  const Curve points = densified(line, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 15 == 0) dashes.emplace_back();
    if (i % 15 < 9) dashes.back().push_back(points[i]);
  }
  return dashes;
}

const CurveTrace& strokeOf(const std::vector<CurveTrace>& traces, Stroke stroke) {
  return *std::find_if(traces.begin(), traces.end(), [&](const CurveTrace& t) { return t.stroke == stroke; });
}

}  // namespace

TEST_CASE(
    "A bottom-out that stands on a gridline, or on the frame's edge, belongs to the strokes that end there",
    "[trace]") {
  const double x = GENERATE(0.75, 1.0);
  Plot plot(700, 430);
  plot.grid(8, 6, kBlack, 1);
  Loop loop = loopEndingAt(x);
  plot.line(plot.at(loop.press), 3, kBlack);
  plot.line(plot.at(loop.release), 3, kBlack);
  plot.line(plot.at({{x, loop.release.back().y}, {x, 1}}), 3, kBlack);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    Curve whole = stroke == Stroke::press ? loop.press : loop.release;
    whole.push_back({x, 1});
    CHECK(apart(strokeOf(*traces, stroke).points_px, plot.at(whole)) < 0.6);
  }
}

TEST_CASE("A lost bottom-out is found whatever level line stands above its lower end", "[trace]") {
  const int rows = GENERATE(range(5, 13));
  INFO(rows);
  Plot plot(440, 260);
  plot.grid(8, rows, kBlack, 1);
  for (int i = 0; i <= rows; ++i)
    plot.frame().yLines.push_back({.position_px = plot.at(0, double(i) / rows).y, .spansFrame = true});
  CurveTrace stroke;
  stroke.points_px = plot.at(loopEndingAt(0.75).press), stroke.color = kBlack;
  plot.line(stroke.points_px, 3, kBlack);
  plot.line({stroke.points_px.back(), plot.at(0.75, 1)}, 3, kBlack);
  std::vector<CurveTrace> traces{stroke};
  trace::addLostBottomOuts(traces, plot.scene());
  CHECK(traces[0].points_px.back().y < plot.at(0.75, 0.97).y);
}

TEST_CASE("A bottom-out little thicker than the line it stands on is recognised by every row of it",
          "[trace]") {
  const double x = GENERATE(0.75, 1.0);
  Plot plot(700, 430);
  plot.grid(8, 6, kBlack, 2);
  Loop loop = loopEndingAt(x);
  plot.line(plot.at(loop.press), 2.6, kBlack);
  plot.line(plot.at(loop.release), 2.6, kBlack);
  plot.line(plot.at({{x, loop.release.back().y}, {x, 1}}), 2.6, kBlack);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  for (const CurveTrace& trace : *traces) {
    const auto highest = std::ranges::min_element(trace.points_px, {}, &Point::y);
    CHECK(std::abs(highest->y - plot.at(x, 1).y) < 2);
  }
}

TEST_CASE("A line drawn twice above a curve's end, as thin as the curve, is no bottom-out", "[trace]") {
  const double x = GENERATE(0.75, 1.0);
  Plot plot(700, 430);
  plot.grid(8, 6, kBlack, 2);
  Loop loop = loopEndingAt(x);
  plot.line(plot.at(loop.press), 2, kBlack);
  plot.line(plot.at(loop.release), 2, kBlack);
  plot.line(plot.at({{x, loop.press.back().y}, {x, 1}}), 2.2, kBlack);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  for (const CurveTrace& trace : *traces)
    for (const Point& p : trace.points_px) CHECK(p.y > plot.at(x, 0.65).y);
}

TEST_CASE("A gridline above a curve's end is no bottom-out", "[trace]") {
  const double x = GENERATE(0.75, 1.0);
  Plot plot(700, 430);
  plot.grid(8, 6, kBlack, 2);
  Loop loop = loopEndingAt(x);
  plot.line(plot.at(loop.press), 2, kBlack);
  plot.line(plot.at(loop.release), 2, kBlack);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  for (const CurveTrace& trace : *traces)
    for (const Point& p : trace.points_px) CHECK(p.y > plot.at(x, 0.65).y);
}

TEST_CASE("A frame in a curve's colour is no bottom-out of a curve that runs into its lower corner",
          "[trace]") {
  const double frame_px = GENERATE(2.0, 3.0);
  Plot plot(700, 430);
  plot.grid(8, 6, {230, 230, 230}, 1);
  plot.line(plot.at({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}), frame_px, kBlack);
  for (int i = 0; i <= 8; ++i)
    plot.frame().xLines.push_back({.position_px = plot.at(i / 8.0, 0).x, .spansFrame = true});
  Curve falling;
  for (int i = 0; i <= 100; ++i) falling.push_back({i / 100.0, 0.9 / std::pow(1 + i / 20.0, 2)});
  CurveTrace curve;
  curve.points_px = plot.at(falling), curve.color = kBlack;
  plot.line(curve.points_px, 3, kBlack);
  std::vector<CurveTrace> traces{curve};
  trace::addLostBottomOuts(traces, plot.scene());
  CHECK(traces[0].points_px.back().y > plot.at(1, 0.1).y);
}

TEST_CASE("A bottom-out thinner than its curve is one, where only paper lies below it", "[trace]") {
  const double thickness_px = GENERATE(2.8, 1.5);
  Plot plot(700, 430);
  plot.grid(8, 6, kGrey, 1);
  CurveTrace stroke;
  stroke.points_px = plot.at(loopEndingAt(0.7).press), stroke.color = kBlack;
  plot.line(stroke.points_px, 5, kBlack);
  plot.line({stroke.points_px.back(), plot.at(0.7, 1)}, thickness_px, kBlack);
  std::vector<CurveTrace> traces{stroke};
  trace::addLostBottomOuts(traces, plot.scene());
  CHECK((traces[0].points_px.back().y < plot.at(0, 0.97).y) == (thickness_px > 2));
}

TEST_CASE("A bottom-out belongs to the stroke in whose colour it is drawn, also on a line of the plot",
          "[trace]") {
  Plot plot(700, 430);
  plot.grid(8, 6, kGrey, 1);
  plot.line(plot.at({{1, 0}, {1, 1}}), 2, kGrey);
  const Loop loop = loopEndingAt(1);
  CurveTrace press, release;
  press.points_px = plot.at(loop.press), press.color = kRed;
  release.points_px = plot.at(loop.release), release.color = kBlack;
  plot.line(release.points_px, 2, kBlack);
  plot.line(press.points_px, 2, kRed);
  plot.line({press.points_px.back(), plot.at(1, 0.9)}, 2, kRed);
  // The release was led along the press's bottom-out.
  const Point end = release.points_px.back();
  for (double y = end.y; y > plot.at(0, 0.7).y; y -= 1) release.points_px.push_back({end.x, y});
  std::vector<CurveTrace> traces{press, release};
  trace::addLostBottomOuts(traces, plot.scene());
  CHECK(std::abs(traces[0].points_px.back().y - plot.at(0, 0.9).y) < 3);
  CHECK(std::abs(traces[1].points_px.back().y - end.y) < 3);
}

TEST_CASE("A dashed release keeps its bottom-out above a press's, also on a gridline", "[trace]") {
  for (const bool traced : {true, false}) {
    INFO("its dashes on the press were " << (traced ? "" : "not ") << "traced");
    Plot plot(1400, 1000);
    plot.grid(8, 6, kGrey, 1);
    const Loop loop = loopEndingAt(0.75);
    CurveTrace press, release;
    press.points_px = plot.at(loop.press), press.color = kBlue;
    release.points_px = plot.at(loop.release), release.color = kRed;
    const double top = plot.at(0, 0.8).y;
    plot.line(press.points_px, 3, kBlue);
    plot.line(release.points_px, 3, kRed);
    plot.line({press.points_px.back(), plot.at(0.75, 0.8)}, 3, kBlue);
    // Dashes shorter than their gaps: most rows show the press only.
    const Point end = release.points_px.back();
    for (double y = end.y; y > top + 6; y -= 14) plot.line({{end.x, y}, {end.x, y - 3}}, 3, kRed);
    for (double y = press.points_px.back().y; y > top; y -= 1) press.points_px.push_back({end.x, y});
    if (traced)
      for (double y = end.y; y > top; y -= 1) release.points_px.push_back({end.x, y});
    std::vector<CurveTrace> traces{press, release};
    trace::addLostBottomOuts(traces, plot.scene());
    CHECK(std::abs(traces[0].points_px.back().y - top) < 3);
    CHECK(std::abs(traces[1].points_px.back().y - top) < 16);  // a dash and a gap
  }
}

TEST_CASE("A press reaches the force from which its release comes back, though the release hides it",
          "[trace]") {
  Plot plot(700, 430);
  plot.grid(8, 6, kGrey, 1);
  const Loop loop = loopEndingAt(0.7);
  CurveTrace press, release;
  press.points_px = plot.at(loop.press), press.color = kRed;
  release.points_px = plot.at(loop.release), release.color = kBlue;
  plot.line(press.points_px, 2, kRed);
  plot.line(release.points_px, 2, kBlue);
  plot.line({release.points_px.back(), plot.at(0.7, 0.9)}, 2, kBlue);
  for (double y = release.points_px.back().y; y > plot.at(0, 0.9).y; y -= 1)
    release.points_px.push_back({plot.at(0.7, 0).x, y});
  std::vector<CurveTrace> traces{press, release};
  trace::addLostBottomOuts(traces, plot.scene());
  CHECK(std::abs(traces[0].points_px.back().y - plot.at(0, 0.9).y) < 3);
}

TEST_CASE("What a result leaves unexplained is found, with its likeness to a curve", "[trace]") {
  Plot plot(700, 430);
  plot.grid(8, 6, kGrey, 1);
  Loop loop = loopEndingAt(0.7);
  plot.line(plot.at(loop.press), 3, kBlue);
  CurveTrace press;
  press.points_px = plot.at(loop.press), press.color = kBlue;
  const auto worst = [&](const std::vector<CurveTrace>& curves) {
    const Explanation found = explain(plot.scene(), curves);
    return found.left.empty() ? Remainder{} : found.left.front();
  };
  CHECK(worst({press}).likeness < 0.2);
  SECTION("a curve left out") {
    plot.line(plot.at(loop.release), 3, kBlue);
    const Remainder left = worst({press});
    CHECK(left.likeness > 0.9);
    CHECK(left.width == Approx(0.7).margin(0.05));
    CHECK_FALSE(left.pixels_px.empty());
    CurveTrace release = press;
    release.points_px = plot.at(loop.release);
    CHECK(worst({press, release}).likeness < 0.2);
  }
  SECTION("a stroke that goes on") {
    plot.line(plot.at({loop.press.back(), {0.72, 0.9}}), 3, kBlue);
    const Remainder left = worst({press});
    CHECK(left.atAnEnd);
    CHECK(left.likeness > 0.9);
  }
  SECTION("a bottom-out of one pixel that stands on a gridline") {
    Plot thin(700, 430);
    thin.grid(8, 6, kGrey, 1);
    loop = loopEndingAt(0.75);
    thin.line(thin.at(loop.press), 1, kBlue);
    press.points_px = thin.at(loop.press);
    const auto left = [&] { return explain(thin.scene(), {press}).left; };
    CHECK((left().empty() || left().front().likeness < 0.2));
    thin.line(thin.at({{0.75, loop.press.back().y}, {0.75, 0.95}}), 1, kBlue, false, 0.7);
    REQUIRE_FALSE(left().empty());
    CHECK(left().front().likeness > 0.9);
  }
  SECTION("thick lines of a document, straight between few points") {
    Plot thick(700, 430);
    press.points_px = thick.at({{0, 0.2}, {0.7, 0.5}, {0.72, 0.9}});
    press.fromVector = true;
    thick.line(press.points_px, 9, kBlue);
    const auto left = explain(thick.scene(), {press}).left;
    CHECK((left.empty() || left.front().likeness < 0.2));
  }
  SECTION("a straight leader") {
    plot.line(plot.at({{0.2, 0.9}, {0.35, 0.42}}), 3, kBlue);
    CHECK(worst({press}).likeness < 0.2);
  }
  SECTION("a curve in dashes left out") {
    for (const Curve& dash : dashesOf(plot.at(loop.release))) plot.line(dash, 3, kBlue);
    const Remainder left = worst({press});
    CHECK(left.dashed);
    CHECK(left.likeness > 0.9);
  }
  SECTION("a few dashes on from the curve's end, steeply") {
    const Point end = plot.at(loop.press.back().x, loop.press.back().y);
    for (const double from : {7, 23, 39, 55})
      plot.line({{end.x + 0.25 * from, end.y - from}, {end.x + 0.25 * (from + 7), end.y - from - 7}}, 3,
                kBlue);
    const Remainder left = worst({press});
    CHECK(left.dashed);
    CHECK(left.atAnEnd);
    CHECK(left.likeness > 0.9);
  }
  SECTION("marks on from the curve's end, up a bottom-out; level ones are a name's letters") {
    const bool level = GENERATE(false, true);
    const Point end = plot.at(loop.press.back().x, loop.press.back().y);
    for (const double on : {18, 40, 62, 84, 106}) {
      const Point mark = level ? Point{end.x + on, end.y - 0.4 * on} : Point{end.x + 0.05 * on, end.y - on};
      for (const double slope : {-1, 1})
        plot.line({{mark.x - 5, mark.y - 5 * slope}, {mark.x + 5, mark.y + 5 * slope}}, 2, kBlue);
    }
    const Remainder left = worst({press});
    CHECK((left.likeness > 0.9) == !level);
  }
  SECTION("a curve in dots left out") {
    const Curve points = densified(plot.at(loop.release), 1);
    for (std::size_t k = 4; k < points.size(); k += 6) plot.line({points[k], points[k]}, 3, kBlue);
    const Remainder left = worst({press});
    CHECK(left.dashed);
    CHECK(left.likeness > 0.5);
  }
  SECTION("markers on the curve") {
    const Curve points = densified(plot.at(loop.press), 1);
    for (std::size_t k = 20; k + 10 < points.size(); k += 26)
      plot.line({points[k], points[k + 9]}, 11, kBlue);
    CHECK(worst({press}).likeness < 0.2);
  }
  SECTION("a band in the curve's colour") {
    const auto patches = [&] { return explain(plot.scene(), {press}).patches.share; };
    CHECK(patches() == 0);
    Curve below = plot.at(loop.press);
    for (Point& p : below) p.y += 16;
    plot.line(below, 18, kBlue);
    CHECK(patches() > 0.5);
  }
  SECTION("a guide in dashes") {
    for (const Curve& dash : dashesOf(plot.at({{0.35, 0.45}, {0.35, 0.02}}))) plot.line(dash, 3, kBlue);
    CHECK(worst({press}).likeness < 0.2);
  }
  SECTION("a few dashes of a leader") {
    for (const Curve& dash : dashesOf(plot.at({{0.2, 0.5}, {0.24, 0.44}}))) plot.line(dash, 3, kBlue);
    CHECK(worst({press}).likeness < 0.2);
  }
  SECTION("another colour") {
    plot.line(plot.at(loop.release), 3, kRed);
    CHECK(worst({press}).likeness < 0.2);
  }
  SECTION("the sample beside the curve's name in the legend") {
    const Point from = plot.at(0.1, 0.9), to = plot.at(0.16, 0.9);
    plot.line({from, to}, 3, kBlue);
    const auto left = [&] { return explain(plot.scene(), {press}).left.size(); };
    CHECK(left() == 1);
    press.labelBox_px = {to.x + 6, to.y - 7, to.x + 60, to.y + 7};
    CHECK(left() == 0);
    // A text in another row, or far away, does not belong to this line.
    press.labelBox_px = {to.x + 6, to.y + 7, to.x + 60, to.y + 21};
    CHECK(left() == 1);
    press.labelBox_px = {to.x + 60, to.y - 7, to.x + 120, to.y + 7};
    CHECK(left() == 1);
  }
}

TEST_CASE(
    "A line up from a curve's end is left over if neither the lane below nor the plot's other columns "
    "explain it",
    "[trace]") {
  struct Row {
    const char* name;
    double at;              // of the frame's width
    double width, opacity;  // of the line above the end
    Rgb colour;
    double grid_px;  // 0: none
    bool goesDown;   // the line goes on below the end
    bool left;
  };
  const Row row = GENERATE(values<Row>({
      {"a hair line on paper", 0.7, 0.4, 1, kBlue, 0, false, true},
      {"a pale line on paper", 0.7, 1, 0.4, kBlue, 0, false, true},
      {"a hair line on a gridline", 0.75, 0.5, 1, kBlue, 1, false, true},
      {"a line on a gridline beyond a lost level stretch", 0.735, 2, 1, kBlue, 1, false, true},
      {"a legend's frame", 0.7, 1, 0.3, kBlack, 0, false, false},
      {"a marker line", 0.7, 1, 1, kBlue, 0, true, false},
      {"a gridline", 0.75, 0, 0, kBlue, 1, false, false},
      {"nothing", 0.7, 0, 0, kBlue, 0, false, false},
      {"a broad area", 0.7, 60, 0.3, kBlue, 0, false, false},
  }));
  INFO(row.name);
  Plot plot(700, 430);
  if (row.grid_px > 0) plot.grid(8, 6, kGrey, row.grid_px);
  for (int i = 0; row.grid_px > 0 && i <= 8; ++i)
    plot.frame().xLines.push_back({.position_px = plot.at(i / 8.0, 0).x, .spansFrame = true});
  const Loop loop = loopEndingAt(row.at);
  const double end = loop.press.back().y, lane = row.grid_px > 0 ? 0.75 : row.at;
  if (row.width > 0)
    plot.line(plot.at({{lane, row.goesDown ? 0 : end}, {lane, 1}}), row.width, row.colour, false,
              row.opacity);
  plot.line(plot.at(loop.press), 3, kBlue);
  CurveTrace press;
  press.points_px = plot.at(loop.press), press.color = kBlue;
  const auto left = trace::unprovenBottomOuts({press}, plot.scene());
  CHECK((left.size() == 1) == row.left);
}

TEST_CASE("A gridline is as thick as itself below a curve's end, though others are thicker", "[trace]") {
  Plot plot(700, 430);
  plot.grid(8, 6, kBlack, 2);
  for (int i = 0; i <= 8; ++i) {
    plot.frame().xLines.push_back({.position_px = plot.at(i / 8.0, 0).x, .spansFrame = true});
    if (i != 6) plot.line(plot.at({{i / 8.0, 0}, {i / 8.0, 1}}), 2.6, kBlack);
  }
  CurveTrace stroke;
  stroke.points_px = plot.at(loopEndingAt(0.75).press), stroke.color = kBlack;
  plot.line(stroke.points_px, 2.8, kBlack);
  plot.line({stroke.points_px.back(), plot.at(0.75, 1)}, 3.2, kBlack);
  std::vector<CurveTrace> traces{stroke};
  trace::addLostBottomOuts(traces, plot.scene());
  CHECK(traces[0].points_px.back().y < plot.at(0, 0.97).y);
}

TEST_CASE("Gridlines of dots in the curve's colour are the plot's, a solid bottom-out on one of them is not",
          "[trace]") {
  Plot plot(700, 430);
  const Loop loop = loopEndingAt(0.7);
  const auto dots = [&](Point from, Point to) {
    const Curve line = densified(plot.at({from, to}), 1);
    for (std::size_t k = 0; k + 2 < line.size(); k += 4) plot.line({line[k], line[k + 1]}, 1.5, kBlack);
  };
  for (const double at : {0.25, 0.5, 0.75}) {
    dots({at, 0}, {at, 1}), dots({0, at}, {1, at});
    // Known by their ticks, as lines that curves cross often are.
    plot.frame().xLines.push_back({.position_px = plot.at(at, 0).x});
    plot.frame().yLines.push_back({.position_px = plot.at(0, at).y});
  }
  plot.line(plot.at(loop.press), 3, kBlack);
  CurveTrace press;
  press.points_px = plot.at(loop.press), press.color = kBlack;
  const auto widest = [&] {
    double most = 0;
    for (const Remainder& left : explain(plot.scene(), {press}).left) most = std::max(most, left.length);
    return most;
  };
  CHECK(widest() < 0.1);
  plot.line(plot.at({{0.75, 0.3}, {0.75, 0.9}}), 1.5, kBlack);
  CHECK(widest() > 0.2);
}

TEST_CASE("A stroke drawn through that takes the way of a line of dashes is seen", "[trace]") {
  Plot plot(700, 430);
  const Loop loop = loopEndingAt(0.7);
  plot.line(plot.at(loop.press), 3, kBlue);
  for (const Curve& dash : dashesOf(plot.at(loop.release))) plot.line(dash, 3, kBlue);
  CurveTrace press, release;
  press.color = release.color = kBlue;
  press.points_px = plot.at(loop.press), release.points_px = plot.at(loop.release);
  const auto jumps = [&] { return explain(plot.scene(), {press, release}).jumps; };
  CHECK(jumps().empty());
  // Each goes over to the other's way gently: nowhere does one turn sharply.
  for (std::size_t i = 0; i < press.points_px.size(); ++i) {
    Point &a = press.points_px[i], &b = release.points_px[i];
    const double share = static_cast<double>(i) / static_cast<double>(press.points_px.size());
    const double over = std::clamp((share - 0.3) / 0.3, 0.0, 1.0);
    const Point middle = 0.5 * (a + b), half = (0.5 - over) * (a - b);
    a = middle - half, b = middle + half;
  }
  CHECK_FALSE(jumps().empty());
}

TEST_CASE("A line thinner than a pixel is none of dashes where it lies between two rows", "[trace]") {
  Plot plot(700, 430);
  const Curve way{plot.at(0.05, 0.05), plot.at(0.3, 0.45), plot.at(0.9, 0.51)};
  plot.line(way, 0.5, kBlue);
  CurveTrace press;
  press.color = kBlue, press.points_px = way;
  CHECK(explain(plot.scene(), {press}).jumps.empty());
}

TEST_CASE("A line of dashes is not drawn through where some of them are longer", "[trace]") {
  Plot plot(900, 550);
  const Curve way{plot.at(0.05, 0.05), plot.at(0.9, 0.6)}, points = densified(way, 1);
  for (std::size_t at = 0, dash = 30; at + dash < points.size(); at += dash + 12) {
    if (at > 450) dash = 55;
    plot.line({points[at], points[at + dash]}, 2, kBlue);
  }
  CurveTrace press;
  press.color = kBlue, press.points_px = way;
  CHECK(explain(plot.scene(), {press}).jumps.empty());
}

TEST_CASE("A curve that crosses bare paper where its pixels do not lead is seen", "[trace]") {
  Plot plot(700, 430);
  Loop loop = loopEndingAt(0.7);
  plot.line(plot.at(loop.press), 3, kBlue);
  plot.line(plot.at(loop.release), 3, kBlue);
  CurveTrace jumping;
  jumping.color = kBlue;
  for (const Point& p : loop.release)
    if (p.x < 0.5) jumping.points_px.push_back(plot.at(p.x, p.y));
  const auto jumps = [&] { return explain(plot.scene(), {jumping}).jumps; };
  CHECK(jumps().empty());
  for (const Point& p : loop.press)
    if (p.x >= 0.5) jumping.points_px.push_back(plot.at(p.x, p.y));
  REQUIRE(jumps().size() == 1);
  CHECK(jumps().front().from_px.x == Approx(plot.at(0.5, 0).x).margin(8));
}

TEST_CASE("A title across the bottom-out, arrows in the curve's hue, a legend beside its keys", "[trace]") {
  Plot plot(908, 551);
  plot.grid(9, 12, kGrey);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 2.5, kLime, true);
  plot.line(down, 2.5, kBlue, true);
  plot.line(plot.at({{0.4, 0.6}, {0.4, 0.8}}), 3, kBlue, false, 0.35);
  plot.line(plot.at({{0.3, 0.02}, {0.3, 0.14}}), 3, kLime, false, 0.4);
  plot.disc(0.3, 0.14, 6, {230, 244, 180});
  plot.letters("Housing with a long title", 0.2, 0.9, 24, kBlack, 3);
  plot.letters("Press", 0.8, 0.25, 14, kBlack, 1);
  plot.letters("Release", 0.8, 0.15, 14, kBlack, 1);
  plot.line(plot.at({{0.73, 0.263}, {0.785, 0.263}}), 2.5, kBlue);
  plot.line(plot.at({{0.73, 0.163}, {0.785, 0.163}}), 2.5, kLime);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, clippedAtTop(plot, down)) < 0.25);
  CHECK(apart(ofColor(*traces, kLime).points_px, up) < 0.25);
}

TEST_CASE("A box over the curves is bridged", "[trace]") {
  Plot plot(800, 500);
  plot.grid(6, 6, kGrey);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 2, kRed, true);
  plot.line(down, 2, kTeal, true);
  plot.line(plot.at({{0.30, 0.5}, {0.34, 0.5}}), 60, kWhite);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  // The gap is joined by a nearly straight piece; everywhere else the line is exact.
  CHECK(mean(down, ofColor(*traces, kTeal).points_px) < 1);
  CHECK(ofColor(*traces, kTeal).points_px.front().x < plot.at(0.03, 0).x);
  CHECK(ofColor(*traces, kTeal).points_px.back().x > plot.at(0.63, 0).x);
}

TEST_CASE("A legend's box hides the middle of a curve and more than is left of its start", "[trace]") {
  Plot plot(900, 550);
  plot.grid(1, 1, kBlack);
  Curve down = {{0.05, 0.3}, {0.15, 0.31}, {0.5, 0.34}, {0.8, 0.5}, {0.9, 0.95}};
  Curve up = {{0.05, 0.6}, {0.5, 0.7}, {0.85, 0.75}};
  plot.line(plot.at(down), 2, kBlue, true);
  plot.line(plot.at(up), 2, kRed, true);
  plot.line(plot.at({{0.2, 0.36}, {0.42, 0.36}}), 90, kWhite);
  plot.letters("Downstroke", 0.24, 0.38, 14, kBlack, 1);
  plot.letters("Upstroke", 0.24, 0.30, 14, kBlack, 1);
  plot.line(plot.at({{0.18, 0.39}, {0.23, 0.39}}), 2, kBlue);
  plot.line(plot.at({{0.18, 0.31}, {0.23, 0.31}}), 2, kRed);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, plot.at(down)) < 0.6);
}

TEST_CASE("Dashes of a colour of their own are linked", "[trace]") {
  Plot plot(800, 500);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.grid(1, 1, kBlack);
  plot.line(down, 2, kBlue, true);
  const Curve points = dense(up);
  for (std::size_t i = 0; i + 16 < points.size(); i += 28)
    plot.line(Curve(points.begin() + static_cast<std::ptrdiff_t>(i),
                    points.begin() + static_cast<std::ptrdiff_t>(i) + 16),
              2, kRed, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kRed).points_px, up) < 0.5);
}

TEST_CASE("The gaps of a dashed curve are not taken for places where its neighbour hides it", "[trace]") {
  Plot plot(900, 550);
  Curve down = {{0, 0}, {0.1, 0.4}, {0.7, 0.45}, {0.8, 0.9}}, up = down;
  for (Point& p : up) p.y -= p.y > 0.3 ? 0.011 : 0;  // five pixels below, of lines of three
  for (const Curve& dash : dashesOf(plot.at(up))) plot.line(dash, 3, kRed);
  plot.line(plot.at(down), 3, kTeal);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  const Curve &followed = ofColor(*traces, kRed).points_px, path = plot.at(up);
  double worst = 0;
  for (const Point& p : followed)
    if (p.x > plot.at(0.15, 0).x && p.x < plot.at(0.65, 0).x) worst = std::max(worst, distanceTo(p, path));
  CHECK(worst < 1);
}

TEST_CASE("A dotted curve is followed from end to end, however steep and however wide its gaps", "[trace]") {
  const auto [drawn, period] =
      GENERATE(table<std::size_t, std::size_t>({{4, 16}, {2, 20}, {30, 60}}));  // half pixels
  CAPTURE(drawn, period);
  Plot plot(800, 500);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.grid(1, 1, kBlack);
  plot.line(down, 2, kBlue, true);
  const Curve points = dense(up);
  for (std::size_t i = 0; i + drawn < points.size(); i += period)
    plot.line(Curve(points.begin() + static_cast<std::ptrdiff_t>(i),
                    points.begin() + static_cast<std::ptrdiff_t>(i + drawn)),
              2, kRed, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kRed).points_px, up) < 0.5);
}

TEST_CASE("Dots scattered over the plot are no curve", "[trace]") {
  Plot plot(800, 500);
  plot.grid(1, 1, kBlack);
  plot.line(plot.at(press()), 2, kBlue, true);
  for (int i = 0; i < 60; ++i)
    plot.disc(0.03 + 0.9 * ((i * 37) % 60) / 60, 0.05 + 0.9 * ((i * 23) % 61) / 61, 3, kRed);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  CHECK(traces->size() == 1);
}

TEST_CASE("One curve alone is one trace; more than two are all given", "[trace]") {
  Plot one(700, 450);
  one.grid(5, 5, kGrey);
  one.line(one.at(press()), 2, kBlue, true);
  const auto single = one.trace();
  REQUIRE(single.ok());
  CHECK(single->size() == 1);

  Plot many(700, 450);
  many.grid(5, 5, kGrey);
  const Rgb colours[] = {kBlue, kRed, kTeal, {230, 160, 20}};
  for (int i = 0; i < 4; ++i) {
    Curve c = press();
    for (Point& p : c) p = {0.9 * p.x + 0.02 * i, 0.8 * p.y - 0.1 * i + 0.1};
    many.line(many.at(c), 2, colours[i], true);
  }
  const auto all = many.trace();
  REQUIRE(all.ok());
  CHECK(all->size() == 4);
}

TEST_CASE("Both strokes in one colour are distinguished by their path", "[trace]") {
  Plot plot(800, 500);
  plot.grid(6, 6, kBlack);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 2.5, kRed, true);
  plot.line(down, 2.5, kRed, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(traces->front().stroke.has_value());
  CHECK(traces->front().stroke != traces->back().stroke);
}

TEST_CASE("Beside loops in colours of their own one in the frame's colour is another switch", "[trace]") {
  Plot plot(800, 500);
  plot.grid(6, 6, {214, 214, 214});
  plot.line(plot.at({{0, 1}, {0, 0}, {1, 0}}), 2, kBlack);
  const auto loop = [&](double loopWidth, double high, Rgb colour) {
    for (const Curve& stroke : {release(), press()}) {
      Curve scaled;
      for (const Point p : stroke) scaled.push_back({loopWidth * p.x, high * p.y});
      plot.line(plot.at(scaled), 2.5, colour);
    }
  };
  loop(1.4, 0.9, kRed);
  CHECK(plot.trace()->size() == 2);
  loop(1.2, 0.5, kBlack);
  const auto bothStrokes = plot.trace();
  REQUIRE(bothStrokes.ok());
  REQUIRE(bothStrokes->size() == 4);
  for (const Rgb colour : {kRed, kBlack})
    CHECK(std::ranges::count_if(*bothStrokes,
                                [&](const CurveTrace& t) { return isSameColour(t.color, colour); }) == 2);
  loop(1.4, 0.7, kBlue);  // ends where the red one does
  CHECK(plot.trace()->size() == 6);
}

TEST_CASE("A drawing moved by a part of a pixel moves the trace by as much", "[trace]") {
  const auto tracedAt = [](double dx, double dy) {
    Plot plot(500, 350);
    Curve down = plot.at(press()), up = plot.at(release());
    for (Curve* c : {&down, &up})
      for (Point& p : *c) p = {p.x + dx, p.y + dy};
    plot.line(up, 1.6, kRed, true);
    plot.line(down, 1.6, kBlue, true);
    const auto traces = plot.trace();
    REQUIRE(traces.ok());
    REQUIRE(traces->size() == 2);
    return ofColor(*traces, kBlue).points_px;
  };
  const Curve base = tracedAt(0, 0);
  for (const Point shift : {Point{0.25, 0}, Point{0, 0.4}, Point{0.5, 0.5}, Point{-0.3, 0.7}}) {
    Curve moved = tracedAt(shift.x, shift.y);
    for (Point& p : moved) p = {p.x - shift.x, p.y - shift.y};
    CHECK(apart(base, moved) < 0.12);
  }
}

TEST_CASE("A frame that stands askew is traced upright and brought back", "[trace]") {
  Plot plot(800, 600);
  const double angle = 0.15;
  const auto turned = [&](Point p) {
    const Point c{400, 300};
    return Point{c.x + std::cos(angle) * (p.x - c.x) - std::sin(angle) * (p.y - c.y),
                 c.y + std::sin(angle) * (p.x - c.x) + std::cos(angle) * (p.y - c.y)};
  };
  Curve down = plot.at(press()), up = plot.at(release());
  down.pop_back();
  for (Curve* c : {&down, &up})
    for (Point& p : *c) p = turned(p);
  for (Point& p : plot.frame().corners) p = turned(p);
  plot.line(up, 2.5, kRed);
  plot.line(down, 2.5, kBlue);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, down) < 0.25);
  CHECK(apart(ofColor(*traces, kRed).points_px, up) < 0.25);
}

TEST_CASE("Huge pictures are shrunk, not given up", "[trace]") {
  Plot plot(4000, 2800);
  plot.grid(5, 5, kGrey, 3);
  const Curve down = plot.at(press()), up = plot.at(release());
  plot.line(up, 9, kRed, true);
  plot.line(down, 9, kBlue, true);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(apart(ofColor(*traces, kBlue).points_px, clippedAtTop(plot, down)) < 0.4);
  CHECK(apart(ofColor(*traces, kRed).points_px, up) < 0.5);
}

TEST_CASE("Hints: colours given decide, masks hide, spacing is kept", "[trace]") {
  Plot plot(800, 500);
  plot.grid(6, 6, kGrey);
  const Curve down = plot.at(press()), up = plot.at(release());
  Curve third = release();
  for (Point& p : third) p.y *= 0.6;
  plot.line(plot.at(third), 2, kTeal, true);
  plot.line(up, 2, kRed, true);
  plot.line(down, 2, kBlue, true);
  TraceHints hints;
  hints.pressColor = kBlue;
  hints.releaseColor = kRed;
  TraceOptions options;
  options.pointSpacing_px = 4;
  const auto traces = plot.trace(hints, options);
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(ofColor(*traces, kBlue).stroke == Stroke::press);
  CHECK(ofColor(*traces, kRed).stroke == Stroke::release);
  const Curve& points = ofColor(*traces, kBlue).points_px;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    CHECK(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y) > 3.5);

  hints.pressColor = Rgb{200, 0, 255};
  hints.releaseColor = Rgb{255, 230, 0};
  const auto none = plot.trace(hints);
  REQUIRE_FALSE(none.ok());
  CHECK(none.failure().code == FailureCode::noForceGraph);
  CHECK(none.failure().remedies.include(RemedyKind::pickPress));

  TraceHints masked;
  masked.masks_px.push_back({plot.at(0, 0).x - 5, plot.at(0, 0.4).y, plot.at(1, 0).x, plot.at(0, 0).y + 5});
  Plot upper(800, 500);
  upper.line(upper.at({{0.05, 0.5}, {0.3, 0.6}, {0.6, 0.9}}), 2, kBlue);
  upper.line(upper.at({{0.05, 0.1}, {0.3, 0.3}, {0.6, 0.35}}), 2, kRed);
  const auto half = upper.trace(masked);
  REQUIRE(half.ok());
  CHECK(half->size() == 1);
}

TEST_CASE("The legend's words are put to the curve whose sample stands beside them", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(6, 6, kGrey);
  plot.line(plot.at(release()), 2, kRed, true);
  plot.line(plot.at(press()), 2, kBlue, true);
  plot.line({{935, 100}, {955, 100}}, 2, kRed);
  plot.line({{935, 120}, {955, 120}}, 2, kBlue);
  plot.say("upstroke", {960, 94, 996, 106});
  plot.say("downstroke", {960, 114, 998, 126});
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 2);
  CHECK(ofColor(*traces, kRed).label == "upstroke");
  CHECK(ofColor(*traces, kBlue).label == "downstroke");
}

TEST_CASE("A short way back that begins where the press ends is a curve, a leader there is none", "[trace]") {
  const Curve in{{0.02, 0.02}, {0.1, 0.3}, {0.5, 0.4}, {0.8, 0.5}, {0.9, 0.95}};
  const Curve back{{0.9, 0.95}, {0.86, 0.4}, {0.57, 0.25}, {0.55, 0.03}}, leader{{0.9, 0.95}, {0.7, 0.7}};
  const Rgb colour = GENERATE(kRed, kBlack);
  for (const bool latches : {true, false}) {
    Plot plot(1000, 500);
    plot.grid(6, 6, kGrey);
    plot.line(plot.at(in), 2, kBlue, true);
    plot.line(plot.at(latches ? back : leader), 2, colour, true);
    const auto traces = plot.trace();
    REQUIRE(traces.ok());
    CHECK(traces->size() == (latches ? 2 : 1));
  }
}

TEST_CASE("Short names of a legend, and the places of those not read, come to its curves if all have one",
          "[trace]") {
  Plot plot(1000, 500);
  plot.grid(6, 6, kGrey);
  plot.line(plot.at(release()), 2, kRed, true);
  plot.line(plot.at(press()), 2, kBlue, true);
  plot.line({{935, 100}, {955, 100}}, 2, kRed);
  plot.line({{935, 120}, {955, 120}}, 2, kBlue);
  const double far = GENERATE(0.0, 6.0);  // px from a legend key to its text
  const Box red{960 + far, 94, 996, 106}, blue{960 + far, 114, 998, 126};
  Plot one = plot, read = plot, unread = plot;
  one.sayOther("TS-10", red);
  read.sayOther("TS-10", red), read.sayOther("TS-12", blue);
  unread.sayOther("", red), unread.sayOther("TS-12", blue);
  const auto ofOne = one.trace().value(), ofRead = read.trace().value(), ofUnread = unread.trace().value();
  CHECK(ofColor(ofRead, kRed).label == "TS-10");
  CHECK(ofColor(ofRead, kBlue).label == "TS-12");
  for (const Rgb color : {kRed, kBlue}) {
    CHECK(ofColor(ofOne, color).label.empty());  // a callout
    CHECK(ofColor(ofOne, color).labelBox_px.empty());
    CHECK(ofColor(ofUnread, color).label.empty());
  }
  CHECK(ofColor(ofUnread, kRed).labelBox_px == red);
  CHECK(ofColor(ofUnread, kBlue).labelBox_px == blue);
}

TEST_CASE("A filled square beside a name is its curve's sample", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(6, 6, kGrey);
  plot.line(plot.at(release()), 2, kRed, true);
  plot.line(plot.at(press()), 2, kBlue, true);
  const double half = GENERATE(6.0, 20.0);  // half height of the key; letters are 12 px high
  const double apart = 2 * half + 8;
  plot.line({{940, 100}, {956, 100}}, 2 * half, kRed);
  plot.line({{940, 100 + apart}, {956, 100 + apart}}, 2 * half, kBlue);
  plot.say("Old", {980, 94, 999, 106});
  plot.say("New", {980, 94 + apart, 999, 106 + apart});
  const auto traces = plot.trace().value();
  // A bar much higher than the letters is something else beside them.
  CHECK(ofColor(traces, kRed).label == (half < 10 ? "Old" : ""));
  CHECK(ofColor(traces, kBlue).label == (half < 10 ? "New" : ""));
}

TEST_CASE("A tick label level with a legend key names no curve", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(6, 6, kGrey);
  plot.line(plot.at(release()), 2, kRed, true);
  plot.line(plot.at(press()), 2, kBlue, true);
  const Point red = plot.at(0.02, 0.95);
  plot.line({red, {red.x + 20, red.y}}, 2, kRed);
  const Box number{plot.box().x0 - 14, red.y - 6, plot.box().x0 - 4, red.y + 6};
  const bool isTick = GENERATE(true, false);
  if (isTick)
    plot.sayTick("2", number);
  else
    plot.say("2", number);
  CHECK(ofColor(plot.trace().value(), kRed).label == (isTick ? "" : "2"));
}

TEST_CASE("Where a legend has no keys its letters' colours are the key", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(6, 6, kGrey);
  plot.line(plot.at(release()), 2, kRed, true);
  plot.line(plot.at(press()), 2, kBlue, true);
  const bool oneInColour = GENERATE(false, true);
  plot.letters("Old", 0.05, 0.9, 14, kRed);
  plot.letters("New", 0.05, 0.84, 14, oneInColour ? kBlack : kBlue);
  const Point first = plot.at(0.05, 0.9), second = plot.at(0.05, 0.84);
  plot.say("Old", {first.x - 1, first.y - 15, first.x + 34, first.y + 1});
  plot.say("New", {second.x - 1, second.y - 15, second.x + 38, second.y + 1});
  const auto traces = plot.trace().value();
  REQUIRE(traces.size() == 2);
  CHECK(ofColor(traces, kRed).label == (oneInColour ? "" : "Old"));  // all of them or none
  CHECK(ofColor(traces, kBlue).label == (oneInColour ? "" : "New"));
}

TEST_CASE("Names that stand at their curves' ends", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(5, 5, kGrey);
  plot.line(plot.at({{0, 0.05}, {0.5, 0.5}, {0.7, 0.9}}), 2, kRed);
  plot.line(plot.at({{0, 0.02}, {0.5, 0.35}, {0.8, 0.7}}), 2, kBlue);
  const Point red = plot.at(0.7, 0.9), blue = plot.at(0.8, 0.7);
  const double away = GENERATE(0.0, 60.0);  // from where the second curve ends
  plot.say("Heron", {red.x + 6, red.y - 6, red.x + 50, red.y + 6});
  plot.say("Kite", {blue.x + 6, blue.y - 6 + away, blue.x + 40, blue.y + 6 + away});
  const auto traces = plot.trace().value();
  CHECK(ofColor(traces, kRed).label == (away > 0 ? "" : "Heron"));
  CHECK(ofColor(traces, kBlue).label == (away > 0 ? "" : "Kite"));
}

TEST_CASE("The minus of a short name is no sample, and a sample in small print is seen to its end",
          "[trace]") {
  Plot plot(1000, 600);
  plot.grid(5, 5, kGrey);
  plot.line(plot.at({{0, 0.05}, {0.5, 0.5}, {1, 0.9}}), 2, kRed);
  plot.line(plot.at({{0, 0.02}, {0.5, 0.35}, {1, 0.7}}), 2, kBlue);
  plot.line({{935, 100}, {960, 100}}, 2, kRed);
  plot.line({{935, 120}, {960, 120}}, 2, kBlue);
  const Box red{969, 95, 990, 105}, blue{973, 115, 994, 125};
  plot.line({{968, 120}, {970, 120}}, 1, kBlack);
  plot.sayOther("23 C", red), plot.sayOther("20 C", blue);
  const auto traces = plot.trace().value();
  CHECK(ofColor(traces, kRed).label == "23 C");
  CHECK(ofColor(traces, kBlue).label == "20 C");
}

TEST_CASE("The name of a curve in the frame's colour is found in line with the others", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(1, 1, kBlack);
  const auto ending = [&](double end, double height) {
    return plot.at({{0, 0}, {0.3 * end, height}, {0.8 * end, 0.7 * height}, {end, 0.9}});
  };
  plot.line(ending(0.55, 0.7), 2, kRed);
  plot.line(ending(0.9, 0.5), 2, kBlue);
  plot.line(ending(0.7, 0.3), 2, kBlack);
  const double beside = plot.box().x0 + 74;  // as far as the longest sample is looked for
  int row = 0;
  for (const Rgb colour : {kRed, kBlue, kBlack}) {
    const double y = 50 + 20 * row++;
    plot.line({{beside - 25, y}, {beside - 5, y}}, 2, colour);
    plot.say("KSC" + std::to_string(row), {beside, y - 6, beside + 30, y + 6});
    plot.line({{plot.box().x0 - 8, y + 100}, {plot.box().x0, y + 100}}, 2,
              kBlack);  // a tick beside its number
    plot.say(std::to_string(row), {plot.box().x0 - 20, y + 94, plot.box().x0 - 12, y + 106});
  }
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 3);
  CHECK(ofColor(*traces, kRed).label == "KSC1");
  CHECK(ofColor(*traces, kBlue).label == "KSC2");
  CHECK(ofColor(*traces, kBlack).label == "KSC3");
}

TEST_CASE("The paper of a large picture is as it is, to a tenth of a level", "[trace]") {
  const Plot plot(1900, 1200, {253, 252, 248});
  const auto paper = plot.scene().paper();
  CHECK(paper.r == Approx(253).margin(0.1));
  CHECK(paper.g == Approx(252).margin(0.1));
  CHECK(paper.b == Approx(248).margin(0.1));
}

TEST_CASE("Three switches, each a line and dashes in a colour of its own near the others'", "[trace]") {
  // Violet lies between red and blue: their edges are no third line in it.
  const Rgb red{226, 74, 51}, blue{52, 138, 189}, violet{152, 142, 213};
  Plot plot(700, 500);
  const auto strokeOf = [&](double end, double level) {
    return plot.at({{0.01, 0},
                    {0.04, level},
                    {0.35 * end, 1.4 * level},
                    {0.5 * end, level},
                    {0.85 * end, 1.3 * level},
                    {end, 0.95}});
  };
  const auto dashes = [&](const Curve& way, Rgb colour) {
    const Curve points = densified(way, 1);
    for (std::size_t i = 0; i + 7 < points.size(); i += 11)
      plot.line({points.begin() + static_cast<std::ptrdiff_t>(i),
                 points.begin() + static_cast<std::ptrdiff_t>(i + 7)},
                2, colour);
  };
  for (const auto& [colour, end, level] :
       {std::tuple(red, 0.8, 0.4), std::tuple(blue, 0.7, 0.5), std::tuple(violet, 0.9, 0.27)}) {
    plot.line(strokeOf(end, level), 2, colour);
    dashes(strokeOf(end, level - 0.1), colour);
  }
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 6);
  for (const CurveTrace& trace : *traces) CHECK(trace.stroke);
}

namespace {

/// Dashes of seven pixels, gaps of four.
void drawDashes(Plot& plot, const Curve& way, Rgb colour, double width) {
  const Curve points = densified(way, 1);
  for (std::size_t i = 0; i + 7 < points.size(); i += 11)
    plot.line({points.begin() + static_cast<std::ptrdiff_t>(i),
               points.begin() + static_cast<std::ptrdiff_t>(i + 7)},
              width, colour);
}

/// A press, or a release that begins where it ends and comes to lie at its edge on the bottom-out.
Curve upToABottomOut(double below) {
  return {{0, 0},      {0.08, 0.35 - below}, {0.4, 0.5 - below}, {0.43, 0.4 - below}, {0.8, 0.55 - below},
          {0.87, 0.95}};
}

}  // namespace

TEST_CASE("A line in dashes of a paler shade of the other's colour is a curve of its own", "[trace]") {
  const Rgb darkGrey{34, 34, 34}, paleGrey{170, 170, 170}, sky{150, 180, 208}, gridColour{225, 225, 225};
  for (const auto& [colour, shade] :
       {std::pair(darkGrey, paleGrey), std::pair(kBlue, sky), std::pair(kBlue, paleGrey)}) {
    INFO(nameOf(colour) << " and " << nameOf(shade));
    Plot plot(900, 550);
    for (int i = 1; i < 8; ++i) {
      drawDashes(plot, plot.at({{i / 8.0, 0}, {i / 8.0, 1}}), gridColour, 1);
      plot.frame().xLines.push_back({plot.at(i / 8.0, 0).x});
    }
    plot.grid(1, 1, kBlack);
    const Curve down = plot.at(upToABottomOut(0)), up = plot.at(upToABottomOut(0.1));
    plot.line(down, 2.5, colour);
    drawDashes(plot, up, shade, 2);
    const auto traces = plot.trace();
    REQUIRE(traces.ok());
    REQUIRE(traces->size() == 2);
    CHECK(apart(ofColor(*traces, colour).points_px, down) < 0.5);
    const Curve& paler = ofColor(*traces, shade).points_px;
    CHECK(apart(paler, up) < 1);
    // On the bottom-out the paler line is hidden by the edge of the other one; its trace must still go up to
    // the end.
    CHECK(std::ranges::min(paler, {}, &Point::y).y == Approx(up.back().y).margin(10));
  }
}

TEST_CASE("A pale line that was not traced is seen beside one that was", "[explanation]") {
  for (const bool drawn : {false, true}) {
    INFO(drawn);
    Plot plot(900, 550);
    plot.grid(1, 1, kBlack);
    plot.line(plot.at(upToABottomOut(0)), 2.5, kBlack);
    if (drawn) drawDashes(plot, plot.at(upToABottomOut(0.1)), {238, 238, 238}, 1);
    const auto traces = plot.trace();
    REQUIRE(traces.ok());
    const double share = explain(plot.scene(), {ofColor(*traces, kBlack)}).beside.share;
    CHECK((drawn ? share > 0.5 : share < 0.1));
  }
}

TEST_CASE(
    "Releases in dashes close below their presses are recognised, led up the bottom-outs and named by their "
    "keys",
    "[trace]") {
  // Nearer than two lines of one colour that are separated by their paths.
  constexpr double below = 0.016, width_px = 2;
  Plot plot(1000, 600);
  plot.grid(5, 5, kGrey);
  const auto strokeOf = [&](double end, double level, double under) {
    return plot.at({{0, 0}, {0.04 * end, level - under}, {0.92 * end, 1.3 * level - under}, {end, 0.9}});
  };
  int row = 0;
  for (const auto& [colour, end, level, name] :
       {std::tuple(kRed, 0.7, 0.5, "Heron"), std::tuple(kBlue, 0.85, 0.25, "Kite")}) {
    plot.line(strokeOf(end, level, 0), width_px, colour);
    Curve release = densified(strokeOf(end, level, below), 1);
    const double baseline_px = plot.at(0.92 * end, 0).x;
    std::erase_if(release, [&](Point p) { return p.x > baseline_px; });  // the bottom-out is the press' own
    drawDashes(plot, release, colour, width_px);
    const double y = 50 + 40 * row++;
    plot.line({{935, y}, {955, y}}, width_px, colour);
    for (const double x : {935.0, 943.0, 951.0}) plot.line({{x, y + 20}, {x + 3, y + 20}}, width_px, colour);
    plot.say(std::string(name) + " down", {960, y - 6, 998, y + 6});
    plot.say(std::string(name) + " up", {960, y + 14, 990, y + 26});
  }
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 4);
  for (std::size_t i = 0; i < 4; i += 2) {
    const CurveTrace &press = (*traces)[i], &release = (*traces)[i + 1];
    CHECK(press.color == release.color);
    CHECK(press.stroke == Stroke::press);
    CHECK(release.stroke == Stroke::release);
    CHECK(distance(release.points_px.back(), press.points_px.back()) < 2);
    CHECK(press.label.ends_with(" down"));
    CHECK(release.label.ends_with(" up"));
  }
}

TEST_CASE("Rims of the markers on press and release are no strokes in dashes", "[trace]") {
  const int corners = GENERATE(24, 3);  // circles; triangles, whose lower sides stand in a line
  CAPTURE(corners);
  Plot plot(1000, 600);
  for (const auto& [colour, level] : {std::pair(kRed, 0.6), std::pair(kBlue, 0.35)}) {
    const Curve way = densified(plot.at({{0, 0}, {0.05, level}, {0.85, 1.2 * level}, {0.93, 0.95}}), 1);
    plot.line(way, 2, colour);
    for (std::size_t i = 12; i < way.size(); i += 24) {
      Curve rim;
      for (int k = 0; k <= corners; ++k) {
        const double angle = M_PI / 2 + 2 * M_PI * k / corners;
        rim.push_back({way[i].x + 7 * std::cos(angle), way[i].y - 7 * std::sin(angle)});
      }
      plot.line(rim, 1.5, colour);
    }
  }
  CHECK(plot.trace()->size() == 2);
}

TEST_CASE("Beside two shades of a colour two shades of the frame's colour are another switch's strokes",
          "[trace]") {
  const Rgb pink{217, 38, 121}, palePink{247, 168, 208}, slate{47, 64, 84}, paleSlate{145, 161, 184};
  Plot plot(900, 550);
  plot.grid(6, 6, {224, 224, 230});
  plot.line(plot.at({{0, 1}, {0, 0}, {1, 0}}), 1.5, slate);
  const auto stroke = [&](double high, double lag, Rgb colour) {
    Curve path = upToABottomOut(lag);
    for (Point& p : path) p.y *= high;
    plot.line(plot.at(path), 2, colour);
    return plot.at(path);
  };
  stroke(1, 0, pink), stroke(1, 0.1, palePink);
  CHECK(plot.trace()->size() == 2);
  const Curve down = stroke(0.5, 0, slate), up = stroke(0.5, 0.15, paleSlate);
  const auto traces = plot.trace();
  REQUIRE(traces.ok());
  REQUIRE(traces->size() == 4);
  CHECK(apart(ofColor(*traces, slate).points_px, down) < 1);
  CHECK(apart(ofColor(*traces, paleSlate).points_px, up) < 1);
}

TEST_CASE("Beside two curves in colours one in the frame's colour begins where they do", "[trace]") {
  const auto drawn = [](Point from, double end) {
    Plot plot(900, 500);
    plot.grid(6, 6, {214, 214, 214});
    plot.line(plot.at({{0, 1}, {0, 0}, {1, 0}}), 2, kBlack);
    plot.line(plot.at(upToABottomOut(0)), 2, kRed);
    plot.line(plot.at(upToABottomOut(0.1)), 2, kBlue);
    plot.line(plot.at({from, {0.3, 0.35}, {0.6, 0.3}, {end, 0.5}}), 2, kBlack);
    return plot.trace()->size();
  };
  CHECK(drawn({0, 0}, 0.85) == 3);
  CHECK(drawn({0, 0.3}, 0.85) == 2);  // a band's edge, a callout
  CHECK(drawn({0, 0}, 0.65) == 2);    // a leader
}

TEST_CASE("Beside three curves in colours one in the frame's colour is a curve as well", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(1, 1, kBlack);
  const auto ending = [&](double height) {
    return plot.at({{0, 0}, {0.3, height}, {0.7, 0.7 * height}, {0.9, height + 0.1}});
  };
  plot.line(ending(0.8), 2, kRed);
  plot.line(ending(0.6), 2, kBlue);
  plot.line(ending(0.45), 2, kTeal);
  plot.line(ending(0.3), 2, kBlack);
  CHECK(plot.trace()->size() == 4);
}

TEST_CASE("Names in their curves' colours, wherever they stand beside three curves and more", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(5, 5, kGrey);
  const bool three = GENERATE(false, true);
  int count = 0;
  for (const auto& [colour, name, height] :
       {std::tuple(kRed, "Old", 0.8), std::tuple(kBlue, "New", 0.5), std::tuple(kTeal, "Raw", 0.25)}) {
    if (!three && count == 2) break;
    plot.line(plot.at({{0, 0}, {0.2, height}, {0.9, height + 0.1}}), 2, colour);
    const Point at = plot.at(0.3 + 0.15 * count++, height - 0.1);
    plot.letters(name, (at.x - plot.box().x0) / plot.box().width(), height - 0.1, 14, colour);
    plot.say(name, {at.x - 1, at.y - 15, at.x + 38, at.y + 1});
  }
  const auto traces = plot.trace().value();
  CHECK(ofColor(traces, kRed).label ==
        (three ? "Old" : ""));  // of two they may be callouts of one switch's strokes
  CHECK(ofColor(traces, kBlue).label == (three ? "New" : ""));
}

TEST_CASE("Of two curves the words for press and release in their colours name them", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(5, 5, kGrey);
  const std::string second = GENERATE("Upstroke", "Downstroke");
  for (const auto& [colour, name, height] :
       {std::tuple(kRed, std::string("Downstroke"), 0.8), std::tuple(kBlue, second, 0.4)}) {
    plot.line(plot.at({{0, 0}, {0.2, height}, {0.9, height + 0.1}}), 2, colour);
    const Point at = plot.at(0.5 - 0.2 * height, height - 0.1);
    plot.letters(name, (at.x - plot.box().x0) / plot.box().width(), height - 0.1, 14, colour);
    plot.say(name, {at.x - 1, at.y - 15, at.x + 130, at.y + 1});
  }
  const auto traces = plot.trace().value();
  CHECK(ofColor(traces, kBlue).label == (second == "Upstroke" ? "Upstroke" : ""));
}

TEST_CASE("The names of a line and of its dashes go by their samples, in whatever order they were read",
          "[trace]") {
  Plot plot(700, 500);
  const Box pressName{220, 60, 270, 74}, releaseName{220, 90, 290, 104};
  plot.line({{150, 67}, {210, 67}}, 2, kRed);
  drawDashes(plot, {{150, 97}, {210, 97}}, kRed, 2);
  AxesFound axes;
  axes.texts = {{"press", pressName, 1, 0}, {"release", releaseName, 1, 0}};
  CurveTrace through, dashed;
  through.points_px = densified(plot.at(upToABottomOut(0)), 1),
  dashed.points_px = densified(plot.at(upToABottomOut(0.1)), 1);
  plot.line(through.points_px, 2, kRed);
  drawDashes(plot, dashed.points_px, kRed, 2);
  for (CurveTrace* trace : {&through, &dashed}) {
    trace->color = kRed, trace->labelBox_px = pressName.joined(releaseName);
    trace->label = "release" + std::string(kLabelParting) + "press";
  }
  trace::nameByDashes(through, dashed, axes, plot.view(), plot.scene());
  CHECK(through.label == "press");
  CHECK(dashed.label == "release");
}

TEST_CASE("A sample may have its curve's marker in the middle, and a box behind it", "[trace]") {
  Plot plot(1000, 500);
  plot.grid(6, 6, kGrey);
  const Rgb slate{44, 62, 80};
  plot.line(plot.at(release()), 2, kRed, true);
  plot.line(plot.at(press()), 2, slate, true);
  // a curve without a name in the legend
  plot.line(plot.at({{0, 0}, {0.4, 0.15}, {0.9, 0.2}}), 2, kTeal, true);
  const double x = plot.box().x0 + 120;
  for (const double y : {60.0, 80.0}) plot.line({{x, y}, {x + 26, y}}, 2, y > 70 ? slate : kRed);
  // Names behind their legend keys, or before them.
  const auto [toName, radius] = GENERATE(std::pair(32.0, 5.0), std::pair(-58.0, 8.0));
  plot.disc((x + 13 - plot.box().x0) / plot.box().width(), (plot.box().y1 - 60) / plot.box().height(), radius,
            kRed);
  plot.line({{x - 12, 40}, {x - 12, 100}}, 4, {120, 130, 140});  // the legend's box, in the slate's hue
  plot.say("Old one", {x + toName, 54, x + toName + 48, 66});
  plot.say("New one", {x + toName, 74, x + toName + 52, 86});
  const auto traces = plot.trace().value();
  CHECK(ofColor(traces, kRed).label == "Old one");
  CHECK(ofColor(traces, slate).label == "New one");
}

TEST_CASE("Error bars are left out, and a few marks across a curve are not error bars", "[trace]") {
  Plot plot(900, 600);
  plot.grid(5, 5, kGrey, 1);
  const bool capped = GENERATE(true, false);
  const bool several = GENERATE(true, false);  // at each point, or as drop lines at three
  const Curve drawn[] = {plot.at(press()), plot.at(release())};
  const Rgb colours[] = {kBlue, kRed};
  constexpr double arm = 18, halfCap = 6;  // px
  std::size_t bars = 0;
  for (int k = 0; k < 2; ++k) {
    plot.line(drawn[k], 2, colours[k]);
    const Curve points = dense(drawn[k]);
    const std::size_t step = points.size() / (several ? 16 : 4);
    for (std::size_t i = step; i + step / 2 < points.size(); i += step) {
      const Point p = points[i];
      plot.line({{p.x, p.y - arm}, {p.x, p.y + arm}}, 2, colours[k]);
      ++bars;
      for (const double end : {-arm, arm})
        if (capped) plot.line({{p.x - halfCap, p.y + end}, {p.x + halfCap, p.y + end}}, 2, colours[k]);
    }
  }
  const auto traces = plot.trace().value();
  REQUIRE(traces.size() == 2);
  CHECK((traces[0].errorBars > bars / 2) == several);
  CHECK((traces[0].errorBars > 0) == several);
  if (!several) return;
  CHECK(apart(ofColor(traces, kBlue).points_px, drawn[0]) < 0.3);
  CHECK(apart(ofColor(traces, kRed).points_px, drawn[1]) < 0.3);
}

TEST_CASE("Nothing to trace is said in a sentence", "[trace]") {
  Plot empty(600, 400);
  empty.grid(5, 5, kGrey);
  const auto none = empty.trace();
  REQUIRE_FALSE(none.ok());
  CHECK(none.failure().code == FailureCode::noForceGraph);
  CHECK(none.failure().sentence().size() > 30);

  Plot outside(600, 400);
  outside.frame().corners = {Point{700, 500}, Point{900, 500}, Point{900, 700}, Point{700, 700}};
  const auto gone = outside.trace();
  REQUIRE_FALSE(gone.ok());
  CHECK(gone.failure().code == FailureCode::noForceGraph);

  Plot dot(600, 400);
  dot.view().raster = Raster{1, 1, {255, 255, 255}};
  CHECK_FALSE(dot.trace().ok());
  dot.view().raster = Raster{};
  CHECK_FALSE(dot.trace().ok());
}

TEST_CASE("Wrong spacing and a cancelled trace are refused", "[trace]") {
  Plot plot(600, 400);
  plot.line(plot.at(press()), 2, kBlue, true);
  for (double spacing : {0.0, -1.0, 17.0, static_cast<double>(NAN)}) {
    TraceOptions options;
    options.pointSpacing_px = spacing;
    const auto traces = plot.trace({}, options);
    REQUIRE_FALSE(traces.ok());
    CHECK(traces.failure().code == FailureCode::wrongUsage);
  }
  Progress progress;
  progress.cancelled = [] { return true; };
  const auto traces = plot.trace({}, {}, progress);
  REQUIRE_FALSE(traces.ok());
  CHECK(traces.failure().code == FailureCode::cancelled);
}
