// SPDX-License-Identifier: GPL-3.0-or-later
// One-ink loops drawn by the test itself, with the faults of real vendor pages, and the exact curves beside
// them.

#include "importer/trace/trace_loop.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "importer/page/polyline.h"
#include "importer/trace/loop_pair.h"
#include "importer/trace/loop_structure.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::trace;

namespace {

using Curve = std::vector<Point>;

/// A plot in one colour; coordinates in view pixels, coverage of a stroke by exact distance.
class Plot {
 public:
  Plot(int width, int height, double stroke) : stroke_(stroke) {
    coverage_ = Plane(width, height);
    left_ = 0.1 * width;
    right_ = 0.95 * width;
    top_ = 0.06 * height;
    bottom_ = 0.92 * height;
    frame_.corners = {Point{left_, top_}, Point{right_, top_}, Point{right_, bottom_}, Point{left_, bottom_}};
  }

  /// Fractions of the frame, y upwards.
  Point at(double x, double y) const {
    return {left_ + x * (right_ - left_), bottom_ - y * (bottom_ - top_)};
  }
  Curve at(const Curve& fractions) const {
    Curve out;
    for (Point p : fractions) out.push_back(at(p.x, p.y));
    return out;
  }

  void line(const Curve& points, double width) {
    for (std::size_t i = 1; i < points.size(); ++i) segment(points[i - 1], points[i], width);
  }
  void curve(const Curve& points) { line(points, stroke_); }

  void grid(int columns, int rows, double width) {
    for (int i = 0; i <= columns; ++i) {
      line({at(double(i) / columns, 0), at(double(i) / columns, 1)}, width);
      frame_.xLines.push_back({at(double(i) / columns, 0).x, width, true});
    }
    for (int i = 0; i <= rows; ++i) {
      line({at(0, double(i) / rows), at(1, double(i) / rows)}, width);
      frame_.yLines.insert(frame_.yLines.begin(), {at(0, double(i) / rows).y, width, true});
    }
  }

  void dashedGuide(double x, double width) {
    for (double y = 0; y < 1; y += 0.024) line({at(x, y), at(x, y + 0.014)}, width);
  }

  /// Draws marks as dense as a word, and erases the background behind them.
  void word(double x, double y, int glyphs) {
    const double h = 0.035 * (bottom_ - top_), w = 0.6 * h;
    const Point corner = at(x, y);
    erase({corner.x - 3, corner.y - h - 3, corner.x + glyphs * w * 1.35 + 3, corner.y + 3});
    for (int g = 0; g < glyphs; ++g) {
      const double x0 = corner.x + g * w * 1.35;
      const double thin = std::max(1.0, 0.8 * stroke_);
      line({{x0, corner.y}, {x0, corner.y - h}}, thin);
      if (g % 3 != 1) line({{x0, corner.y - h}, {x0 + w, corner.y - h * 0.8}}, thin);
      if (g % 2 == 0)
        line({{x0, corner.y - 0.5 * h}, {x0 + w, corner.y - 0.4 * h}, {x0 + w, corner.y}}, thin);
    }
  }

  void erase(const Box& box) {
    for (int y = std::max(0, static_cast<int>(box.y0));
         y < std::min(coverage_.height, static_cast<int>(box.y1)); ++y)
      for (int x = std::max(0, static_cast<int>(box.x0));
           x < std::min(coverage_.width, static_cast<int>(box.x1)); ++x)
        pixel(x, y) = 0;
  }

  void dot(Point p, double radius) { segment(p, {p.x + 0.01, p.y}, 2 * radius); }

  Result<std::vector<CurveTrace>> trace(const TraceHints& hints = {}, const Progress& progress = {}) const {
    const PlotArea area = makePlotArea(picture(), frame_, {}, hints.masks_px);
    return traceLoop(area, coverageOn(area), {}, {}, progress);
  }
  PlotArea area() const { return makePlotArea(picture(), frame_); }
  /// The coverage that the area's picture shows.
  static Plane coverageOn(const PlotArea& area) {
    Plane coverage(area.raster.width_px, area.raster.height_px);
    for (std::size_t i = 0; i < coverage.values.size(); ++i)
      if (area.masked.empty() || !area.masked[i])
        coverage.values[i] = static_cast<float>(255 - area.raster.rgb[3 * i]) / 255;
    return coverage;
  }

  double stroke() const { return stroke_; }
  PlotFrame& frame() { return frame_; }

 private:
  float& pixel(int x, int y) { return coverage_.at(x, y); }
  Raster picture() const {
    Raster raster{coverage_.width, coverage_.height, {}};
    for (float c : coverage_.values)
      raster.rgb.insert(raster.rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255 * (1 - c))));
    return raster;
  }
  void segment(Point a, Point b, double width) {
    const double reach = width / 2 + 1;
    const int x0 = std::max(0, static_cast<int>(std::min(a.x, b.x) - reach)),
              x1 = std::min(coverage_.width - 1, static_cast<int>(std::max(a.x, b.x) + reach) + 1);
    const int y0 = std::max(0, static_cast<int>(std::min(a.y, b.y) - reach)),
              y1 = std::min(coverage_.height - 1, static_cast<int>(std::max(a.y, b.y) + reach) + 1);
    const double vx = b.x - a.x, vy = b.y - a.y, l2 = vx * vx + vy * vy;
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const double f = l2 > 0 ? std::clamp(((x - a.x) * vx + (y - a.y) * vy) / l2, 0.0, 1.0) : 0;
        const double d = std::hypot(x - a.x - f * vx, y - a.y - f * vy);
        const double c = std::clamp(width / 2 + 0.5 - d, 0.0, std::min(1.0, width));
        pixel(x, y) = std::max(pixel(x, y), static_cast<float>(c));
      }
    }
  }

  Plane coverage_;
  PlotFrame frame_;
  double stroke_, left_, right_, top_, bottom_;
};

/// Smooth through (x, y) anchors, in fractions of the frame.
Curve through(const std::vector<Point>& anchors) {
  Curve out;
  for (std::size_t i = 1; i < anchors.size(); ++i) {
    const Point a = anchors[i - 1], b = anchors[i];
    constexpr int kPieces = 60;
    for (int k = i == 1 ? 0 : 1; k <= kPieces; ++k) {
      const double t = double(k) / kPieces, s = t * t * (3 - 2 * t);
      out.push_back({a.x + t * (b.x - a.x), a.y + s * (b.y - a.y)});
    }
  }
  return out;
}

double distanceTo(Point p, const Curve& curve) { return distance(p, nearestOn(curve, p)); }

/// Mean of both directions, as score.py does it; truth must be dense.
double meanDistance(const Curve& traced, const Curve& truth) {
  double forth = 0, back = 0;
  for (Point p : traced) forth += distanceTo(p, truth);
  for (Point p : truth) back += distanceTo(p, traced);
  return (forth / double(traced.size()) + back / double(truth.size())) / 2;
}

struct Loop {
  Curve press, release;  ///< fractions of the frame, both rising in x
};

/// Tactile switch: hump, valley, a common rise, a leaning bottom-out at the end.
Loop tactileLoop(double apart = 0.02) {
  const double x = 0.9;
  return {through({{0.02, 0.0},
                   {0.06, 0.33},
                   {0.16, 0.38},
                   {0.30, 0.55},
                   {0.45, 0.33},
                   {0.60, 0.42},
                   {x, 0.50},
                   {x + 0.03, 0.98}}),
          through({{0.03, 0.0},
                   {0.08, 0.16},
                   {0.18, 0.22},
                   {0.28, 0.36},
                   {0.42, 0.12},
                   {0.60, 0.42 - apart},
                   {x + 0.003, 0.50 - apart},
                   {x + 0.033, 0.98}})};
}

void draw(Plot& plot, const Loop& loop) {
  plot.curve(plot.at(loop.press));
  plot.curve(plot.at(loop.release));
}

/// Both strokes found, in order, each nearer to its own truth than `mean_px` on average.
void checkLoop(const Plot& plot, const Loop& loop, double mean_px, double confidence = 0.6) {
  const auto result = plot.trace();
  REQUIRE(result.ok());
  REQUIRE(result->size() == 2);
  const CurveTrace& press = result->front();
  const CurveTrace& release = result->back();
  REQUIRE(press.stroke == Stroke::press);
  REQUIRE(release.stroke == Stroke::release);
  CHECK(press.points_px.front().x < press.points_px.back().x);
  CHECK(release.points_px.front().x > release.points_px.back().x);
  CHECK(press.width_px.size() == press.points_px.size());
  CHECK(meanDistance(press.points_px, plot.at(loop.press)) < mean_px);
  CHECK(meanDistance(release.points_px, plot.at(loop.release)) < mean_px);
  CHECK(press.confidence >= confidence);
}

}  // namespace

TEST_CASE("loop: two strokes on a grid of the same colour and width", "[trace_loop]") {
  for (double stroke : {1.3, 2.0, 3.5}) {
    Plot plot(640, 520, stroke);
    plot.grid(8, 6, stroke);
    const Loop loop = tactileLoop();
    draw(plot, loop);
    INFO("stroke " << stroke);
    checkLoop(plot, loop, 0.35);
  }
}

TEST_CASE("loop: without a grid the line is met to a few hundredths of a pixel", "[trace_loop]") {
  Plot plot(640, 520, 2);
  const Loop loop = tactileLoop(0.04);
  draw(plot, loop);
  const auto result = plot.trace();
  REQUIRE(result.ok());
  REQUIRE(result->size() == 2);
  std::vector<double> off;
  const Curve truth = plot.at(loop.press);
  for (Point p : result->front().points_px) off.push_back(distanceTo(p, truth));
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
  CHECK(off[off.size() / 2] < 0.06);
  CHECK(result->front().width_px[result->front().width_px.size() / 2] == Approx(2).margin(0.35));
}

TEST_CASE("loop: leaders, dots, words and dashed guides are no curve", "[trace_loop]") {
  Plot plot(640, 640, 1.8);
  plot.grid(8, 6, 1.2);
  const Loop loop = tactileLoop();
  draw(plot, loop);
  plot.word(0.10, 0.75, 14);
  plot.line({plot.at(0.26, 0.74), plot.at(0.30, 0.55)}, 1.8);
  plot.word(0.55, 0.70, 15);
  plot.line({plot.at(0.56, 0.69), plot.at(0.47, 0.335)}, 1.8);
  plot.dot(plot.at(0.47, 0.335), 4);
  plot.word(0.55, 0.10, 11);
  plot.line({plot.at(0.55, 0.12), plot.at(0.44, 0.13)}, 1.8);
  plot.dashedGuide(0.30, 1.2);
  plot.dashedGuide(0.47, 1.2);
  checkLoop(plot, loop, 0.5);
}

TEST_CASE("loop: strokes that merge to one band keep their own sides", "[trace_loop]") {
  const double stroke = 3;
  Plot plot(800, 600, stroke);
  plot.grid(8, 6, 1);
  const Loop loop = tactileLoop(0.6 * stroke / (0.86 * 600));
  draw(plot, loop);
  const auto result = plot.trace();
  REQUIRE(result.ok());
  REQUIRE(result->size() == 2);
  checkLoop(plot, loop, 0.45);
  // On the merged stretch the press stays above the release by about the drawn distance.
  const auto rowAt = [&](const CurveTrace& t, double x) {
    double y = 0, best = 1e9;
    for (Point p : t.points_px)
      if (std::abs(p.x - x) < best) {
        best = std::abs(p.x - x);
        y = p.y;
      }
    return y;
  };
  const double x = plot.at(0.75, 0).x;
  CHECK(rowAt(result->back(), x) - rowAt(result->front(), x) == Approx(0.6 * stroke).margin(0.7));
}

TEST_CASE("loop: strokes that share one line follow it both", "[trace_loop]") {
  Plot plot(640, 480, 2);
  plot.grid(8, 6, 2);
  Loop loop = tactileLoop();
  loop.release = through({{0.03, 0.0}, {0.08, 0.16}, {0.18, 0.30}, {0.36, 0.08}, {0.48, 0.16}, {0.60, 0.42}});
  for (Point p : loop.press)
    if (p.x > 0.60) loop.release.push_back(p);
  draw(plot, loop);
  checkLoop(plot, loop, 0.5);
}

TEST_CASE("loop: a peak that touches a gridline stays", "[trace_loop]") {
  Plot plot(640, 480, 2);
  plot.grid(8, 6, 2);
  Loop loop = tactileLoop();
  // The top of the hump lies on the gridline at one half.
  loop.press = through({{0.02, 0.0},
                        {0.06, 0.25},
                        {0.16, 0.30},
                        {0.30, 0.5},
                        {0.45, 0.29},
                        {0.60, 0.42},
                        {0.9, 0.53},
                        {0.93, 0.98}});
  draw(plot, loop);
  checkLoop(plot, loop, 0.5);
  const auto result = plot.trace();
  double top = 1e9;
  for (Point p : result->front().points_px)
    if (p.x < plot.at(0.5, 0).x) top = std::min(top, p.y);
  CHECK(top == Approx(plot.at(0, 0.5).y).margin(1.2));
}

TEST_CASE("loop: a plateau that runs along a gridline keeps its own height", "[trace_loop]") {
  Plot plot(640, 480, 3);
  plot.grid(8, 6, 3);
  const double line = 2.0 / 6;
  const double height = line + 1.6 / (0.86 * 480);  // half hidden by the gridline
  const Loop loop{
      through(
          {{0.02, 0.0}, {0.06, 0.2}, {0.2, height}, {0.55, height}, {0.7, 0.45}, {0.9, 0.53}, {0.93, 0.98}}),
      through(
          {{0.03, 0.0}, {0.07, 0.1}, {0.3, 0.16}, {0.55, 0.18}, {0.7, 0.40}, {0.902, 0.5}, {0.933, 0.98}})};
  draw(plot, loop);
  checkLoop(plot, loop, 0.5);
  const auto result = plot.trace();
  double off = 0, count = 0;
  for (Point p : result->front().points_px) {
    if (p.x < plot.at(0.25, 0).x || p.x > plot.at(0.5, 0).x) continue;
    off += std::abs(p.y - plot.at(0, height).y);
    ++count;
  }
  CHECK(off / count < 0.3);
}

TEST_CASE("loop: pieces between the lines of a fine grid are not taken for letters", "[trace_loop]") {
  Plot plot(520, 420, 1.5);
  plot.grid(40, 30, 1.5);
  const Loop loop = tactileLoop(0.04);
  draw(plot, loop);
  checkLoop(plot, loop, 0.7, 0.3);
}

TEST_CASE("loop: intercepts on the force axis and a bottom-out on the last gridline", "[trace_loop]") {
  Plot plot(640, 480, 2);
  plot.grid(8, 6, 2);
  const Loop loop{through({{0.0, 0.30}, {0.3, 0.45}, {0.96, 0.70}}),
                  through({{0.0, 0.16}, {0.44, 0.36}, {0.50, 0.48}, {0.96, 0.66}})};
  Loop drawn = loop;
  drawn.press.push_back({0.999, 0.76});
  drawn.release.push_back({0.999, 0.72});
  draw(plot, drawn);
  checkLoop(plot, drawn, 0.5);
}

TEST_CASE("loop: a latch branch is not part of the strokes", "[trace_loop]") {
  Plot plot(800, 600, 2);
  plot.grid(8, 6, 2);
  const Loop loop{through({{0.01, 0.28}, {0.9, 0.80}, {0.93, 0.98}}),
                  through({{0.01, 0.2}, {0.35, 0.38}, {0.38, 0.47}, {0.905, 0.77}, {0.933, 0.98}})};
  draw(plot, loop);
  plot.curve(plot.at({{0.532, 0.575}, {0.524, 0.0}}));
  plot.curve(plot.at({{0.524, 0.0}, {0.56, 0.60}}));
  checkLoop(plot, loop, 0.6);
}

TEST_CASE("loop: the release of a key that locks ends at the baseline in the middle of the travel",
          "[trace_loop]") {
  Plot plot(800, 600, 2);
  plot.grid(8, 6, 0.5);
  const Loop loop{through({{0.0, 0.0}, {0.02, 0.18}, {0.55, 0.32}, {0.66, 0.26}, {0.82, 0.34}, {0.88, 0.8}}),
                  through({{0.58, 0.01}, {0.61, 0.18}, {0.83, 0.25}, {0.88, 0.8}})};
  draw(plot, loop);
  checkLoop(plot, loop, 0.6);
  CHECK(plot.trace()->front().confidence > 0.8);
}

TEST_CASE("loop: two switches in one colour are refused, whatever two of their strokes would resemble",
          "[trace_loop]") {
  Plot plot(800, 600, 2);
  plot.grid(8, 6, 1);
  const Loop loop = tactileLoop();
  draw(plot, loop);
  draw(plot,
       {through({{0.02, 0.0}, {0.06, 0.20}, {0.40, 0.62}, {0.55, 0.48}, {0.75, 0.60}, {0.80, 0.95}}),
        through({{0.03, 0.0}, {0.07, 0.12}, {0.41, 0.50}, {0.56, 0.37}, {0.752, 0.55}, {0.803, 0.95}})});
  const auto result = plot.trace();
  REQUIRE_FALSE(result.ok());
  CHECK(result.failure().code == FailureCode::notCertain);
  CHECK(result.failure().reason == nameOf(DoubtCode::tooManyCurves));
}

TEST_CASE("loop: two switches whose straight strokes cross are refused in one colour", "[trace_loop]") {
  Plot plot(800, 500, 2);
  plot.grid(9, 6, 0.6);
  for (const double lower : {0.0, 0.09}) {
    plot.curve(plot.at({{0.02, 0.02},
                        {0.04, 0.16 - lower},
                        {0.23, 0.42 - lower},
                        {0.39, 0.30 - lower},
                        {0.76, 0.43 - lower},
                        {0.80, 0.56 - lower}}));
    plot.curve(plot.at({{0.04, 0.16 - lower},
                        {0.29, 0.38 - lower},
                        {0.35, 0.345 - lower},
                        {0.60, 0.40 - lower},
                        {0.64, 0.57 - lower}}));
  }
  const auto result = plot.trace();
  REQUIRE_FALSE(result.ok());
  CHECK(result.failure().reason == nameOf(DoubtCode::tooManyCurves));
}

TEST_CASE("loop: presses of two switches without their releases are refused in one colour", "[trace_loop]") {
  // A bottom-out at another travel is left over, or the lower press goes on farther than the upper.
  const auto [end, top] = GENERATE(table<double, double>({{0.62, 0.92}, {0.72, 0.9}}));
  CAPTURE(end, top);
  Plot plot(800, 600, 2);
  plot.grid(4, 6, 1);
  plot.curve(
      plot.at(Curve{{0.0, 0.05}, {0.05, 0.25}, {0.3, 0.5}, {0.4, 0.4}, {end - 0.05, 0.52}, {end, top}}));
  plot.curve(plot.at(Curve{{0.0, 0.02}, {0.05, 0.15}, {0.3, 0.38}, {0.4, 0.28}, {0.78, 0.36}, {0.84, 0.8}}));
  const auto result = plot.trace();
  CHECK_FALSE(result.ok());
}

TEST_CASE(
    "loop: two presses that cross are refused in one colour, bottom-outs that lie on each other or cross",
    "[trace_loop]") {
  const double end = GENERATE(0.84, 0.8);
  CAPTURE(end);
  Plot plot(800, 600, 2);
  plot.grid(4, 6, 1);
  plot.curve(plot.at(Curve{{0.0, 0.02}, {0.05, 0.15}, {0.3, 0.5}, {0.42, 0.3}, {0.78, 0.36}, {0.84, 0.8}}));
  plot.curve(plot.at(Curve{{0.0, 0.03}, {0.05, 0.25}, {end - 0.06, 0.6}, {end, 0.82}}));
  CHECK_FALSE(plot.trace().ok());
}

TEST_CASE("loop: a stroke that changes over to another line is refused", "[trace_loop]") {
  // Both strokes must end at the same travel: the upper one goes over to the lower one's line.
  Plot plot(800, 600, 2);
  plot.grid(4, 6, 0.5);
  plot.curve(plot.at(Curve{{0.0, 0.02}, {0.05, 0.26}, {0.6, 0.34}, {0.64, 0.6}}));
  plot.curve(plot.at(Curve{{0.0, 0.02}, {0.05, 0.13}, {0.84, 0.2}, {0.88, 0.62}}));
  CHECK_FALSE(plot.trace().ok());
}

TEST_CASE("loop: a bottom-out that goes on in dashes ends before the first of them", "[trace_loop]") {
  const double dash = GENERATE(0.1, 0.08), gap = dash < 0.1 ? 0.03 : 0.06;  // share of the frame's height
  constexpr double knee = 0.5;
  Plot plot(800, 600, 2);
  plot.grid(4, 6, 1);
  const Loop loop{{{0.0, 0.35}, {0.80, knee}}, {{0.0, 0.2}, {0.45, 0.25}, {0.5, 0.37}, {0.84, knee - 0.06}}};
  draw(plot, loop);
  for (const Point lowEnd : {loop.press.back(), loop.release.back()})
    for (double y = lowEnd.y; y < 0.95; y += dash + gap)
      plot.curve(plot.at(
          {{lowEnd.x + 0.1 * (y - lowEnd.y), y}, {lowEnd.x + 0.1 * (y + dash - lowEnd.y), y + dash}}));
  const auto result = plot.trace();
  REQUIRE(result.ok());
  REQUIRE(result->size() == 2);
  CHECK(result->front().points_px.back().y > plot.at(0, knee + 0.25 * dash).y);
  CHECK(result->back().points_px.front().y > plot.at(0, knee - 0.06 + 0.25 * dash).y);
}

TEST_CASE("loop: gaps in a stroke are bridged", "[trace_loop]") {
  Plot plot(640, 480, 2);
  const Loop loop = tactileLoop();
  draw(plot, loop);
  for (double x : {0.12, 0.36, 0.52, 0.7}) {
    const Point p = plot.at(x, 0);
    plot.erase({p.x - 4, 0, p.x + 4, 480});
  }
  checkLoop(plot, loop, 0.4);
}

TEST_CASE("loop: a dashed release is found, words beside a lone press are not", "[trace_loop]") {
  const Loop loop = tactileLoop(0.04);
  Plot dashed(640, 480, 2);
  dashed.grid(8, 6, 1);
  dashed.curve(dashed.at(loop.press));
  const Curve release = dashed.at(loop.release);
  double along = 0;
  for (std::size_t i = 1; i < release.size(); ++i) {
    along += std::hypot(release[i].x - release[i - 1].x, release[i].y - release[i - 1].y);
    if (std::fmod(along, 20) < 9) dashed.curve({release[i - 1], release[i]});
  }
  checkLoop(dashed, loop, 0.8, 0.5);

  Plot lone(640, 480, 2);
  lone.curve(lone.at(loop.press));
  lone.word(0.2, 0.15, 14);
  lone.line({lone.at(0.28, 0.20), lone.at(0.30, 0.55)}, 2);
  lone.word(0.5, 0.2, 14);
  const auto result = lone.trace();
  REQUIRE(result.ok());
  CHECK(result->size() == 1);
}

TEST_CASE("loop: a press-only graph gives one stroke", "[trace_loop]") {
  Plot plot(640, 480, 2);
  plot.grid(8, 6, 1);
  const Loop loop = tactileLoop();
  plot.curve(plot.at(loop.press));
  const auto result = plot.trace();
  REQUIRE(result.ok());
  REQUIRE(result->size() == 1);
  CHECK(result->front().stroke == Stroke::press);
  CHECK(meanDistance(result->front().points_px, plot.at(loop.press)) < 0.4);
}

TEST_CASE("loop: a large page is followed on a small plane and refined at full size", "[trace_loop]") {
  Plot plot(2600, 1900, 5);
  plot.grid(10, 6, 5);
  const Loop loop = tactileLoop();
  draw(plot, loop);
  checkLoop(plot, loop, 0.9);
}

TEST_CASE("loop: a plot that stands slightly askew", "[trace_loop]") {
  Plot plot(700, 560, 2);
  const double angle = 0.02;
  const auto turned = [&](Point p) -> Point {
    const double dx = p.x - 350, dy = p.y - 280;
    return {350 + dx * std::cos(angle) - dy * std::sin(angle),
            280 + dx * std::sin(angle) + dy * std::cos(angle)};
  };
  const Loop loop = tactileLoop();
  Curve press, release;
  for (Point p : plot.at(loop.press)) press.push_back(turned(p));
  for (Point p : plot.at(loop.release)) release.push_back(turned(p));
  for (Point& c : plot.frame().corners) c = turned(c);
  plot.curve(press);
  plot.curve(release);
  const auto result = plot.trace();
  REQUIRE(result.ok());
  REQUIRE(result->size() == 2);
  CHECK(meanDistance(result->front().points_px, press) < 0.35);
  CHECK(meanDistance(result->back().points_px, release) < 0.35);
}

namespace {

struct Explained {
  WorkPlane plane;
  Structure structure;
  Point corner;  ///< of the area, in view pixels
};

Explained explain(Plot& plot) {
  Explained out;
  const PlotArea area = plot.area();
  out.plane = makeWorkPlane(Plot::coverageOn(area), area);
  out.structure = explainStructure(out.plane, findStraightLines(out.plane, {}, {}), {});
  out.corner = area.toView({0, 0});
  return out;
}

/// Mean unexplained coverage along a line given in view pixels.
double meanCoverage(const Explained& e, const Curve& view) {
  double sum = 0;
  for (Point p : view) sum += double(e.structure.remainingCoverage.sample(e.plane.fromArea(p - e.corner)));
  return sum / double(view.size());
}

Curve straight(Point a, Point b) {
  Curve out;
  for (int k = 0; k <= 200; ++k) out.push_back({a.x + (b.x - a.x) * k / 200, a.y + (b.y - a.y) * k / 200});
  return out;
}

}  // namespace

TEST_CASE(
    "loop: gridlines are explained, a marker line to the curve is weakened, the curve keeps its coverage",
    "[trace_loop]") {
  Plot plot(500, 420, 2);
  plot.grid(8, 6, 2);
  const Loop loop = tactileLoop(0.04);
  draw(plot, loop);
  const Curve guide = straight(plot.at(0.005, 0.42), plot.at(0.36, 0.42));
  plot.curve(guide);
  const Explained e = explain(plot);
  CHECK(meanCoverage(e, straight(plot.at(0.05, 5.0 / 6), plot.at(0.85, 5.0 / 6))) < 0.1);
  CHECK(meanCoverage(e, straight(plot.at(0.01, 0.42), plot.at(0.12, 0.42))) < 0.5);
  CHECK(meanCoverage(e, plot.at(loop.release)) > 0.6);
}

TEST_CASE("loop: flat waves cut up by a grid are no row of letters", "[trace_loop]") {
  Plot plot(500, 420, 1.5);
  plot.grid(24, 6, 1.5);
  std::vector<Point> anchors;
  for (int k = 0; k <= 48; ++k) anchors.push_back({0.01 + 0.02 * k, k % 2 ? 0.425 : 0.395});
  const Curve wave = plot.at(through(anchors));
  plot.curve(wave);
  CHECK(meanCoverage(explain(plot), wave) > 0.5);
}

TEST_CASE("loop: a gridline cut by writing is a gridline still, not a dashed one", "[trace_loop]") {
  Plot plot(240, 200, 3);
  plot.grid(6, 6, 1.5);
  draw(plot, tactileLoop());
  // Holes for four lines of writing over the first two columns: the line beside them ends within a stretch.
  for (const double y : {0.13, 0.34, 0.62, 0.80}) {
    const Point a = plot.at(0.1, y + 0.1), b = plot.at(0.4, y);
    plot.erase({a.x, a.y, b.x, b.y});
  }
  const Explained e = explain(plot);
  for (const double x : {1.0 / 6, 2.0 / 6})
    CHECK(meanCoverage(e, straight(plot.at(x, 0.91), plot.at(x, 0.99))) < 0.2);
}

TEST_CASE("loop: two leaders side by side are no strokes", "[trace_loop]") {
  Plot plot(640, 520, 2);
  plot.line({plot.at(0.3, 0.39), plot.at(0.57, 0.72)}, 2);
  plot.dot(plot.at(0.3, 0.39), 5);
  plot.line({plot.at(0.33, 0.19), plot.at(0.6, 0.1)}, 2);
  plot.line({plot.at(0.62, 0.3), plot.at(0.95, 0.25)}, 2);
  const auto result = plot.trace();
  if (result.ok() && result->size() == 2) CHECK(result->front().confidence < 0.35);
  Plot apart(640, 520, 2);
  apart.line({apart.at(0.1, 0.4), apart.at(0.45, 0.7)}, 2);
  apart.line({apart.at(0.55, 0.2), apart.at(0.9, 0.1)}, 2);
  const auto none = apart.trace();
  if (none.ok() && none->size() == 2) CHECK(none->front().confidence < 0.15);
}

TEST_CASE("loop: a path that climbs a leader is sent back", "[trace_loop]") {
  // The loop ends before the frame does. The leader is thick, long and nearly upright, so that more pixels
  // lie along it than along the rest of the stroke, and the tracer is tempted to follow it.
  Plot plot(640, 560, 4);
  const Loop loop{through({{0.02, 0.3}, {0.25, 0.45}, {0.5, 0.35}, {0.8, 0.45}}),
                  through({{0.02, 0.15}, {0.3, 0.25}, {0.45, 0.1}, {0.8, 0.40}})};
  draw(plot, loop);
  plot.line(plot.at({{0.5, 0.36}, {0.53, 0.97}}), 4);
  checkLoop(plot, loop, 0.9, 0.3);
}

TEST_CASE("loop: an arrow's head that touches a stroke is no part of it", "[trace_loop]") {
  Plot plot(640, 520, 2);
  plot.grid(6, 6, 1.2);
  const Loop loop = tactileLoop(0.04);
  draw(plot, loop);
  const Point tip = plot.at(0.42, 0.12), tail = plot.at(0.49, 0.01);
  const double length = distance(tip, tail);
  const Point along = (1 / length) * (tail - tip), across{-along.y, along.x};
  for (double off = -7; off <= 7; off += 1) plot.line({tip, tip + 20 * along + off * across}, 1.5);
  plot.line({tip + 20 * along, tail}, 4);
  checkLoop(plot, loop, 0.5);
  const auto release = plot.trace()->back().points_px;
  const auto lowest =
      std::ranges::max_element(release, {}, [&](Point p) { return std::abs(p.x - tip.x) < 60 ? p.y : 0; });
  CHECK(lowest->y < tip.y + 3);
}

TEST_CASE("loop: an arrow by itself is no part of the strokes, a dash as long is", "[trace_loop]") {
  Plot plot(640, 520, 2);
  draw(plot, tactileLoop(0.04));
  const Curve shaft = straight(plot.at(0.5, 0.12), plot.at(0.62, 0.15)),
              dash = straight(plot.at(0.3, 0.05), plot.at(0.42, 0.08));
  plot.curve(shaft), plot.curve(dash);
  const Point tip = shaft.back();
  plot.curve({{tip.x - 12, tip.y - 6}, tip, {tip.x - 12, tip.y + 9}});
  const Explained e = explain(plot);
  CHECK(meanCoverage(e, shaft) < 0.1);
  CHECK(meanCoverage(e, dash) > 0.6);
}

TEST_CASE("loop: random loops are never swapped and never far off", "[trace_loop]") {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 8; ++n) {
    Plot plot(560, 460, 1.2 + 1.5 * unit(random));
    plot.grid(6 + n % 3, 5, 1 + 0.8 * unit(random));
    const double level = 0.3 + 0.15 * unit(random), hump = 0.2 * unit(random),
                 below = 0.06 + 0.12 * unit(random);
    const double end = 0.8 + 0.12 * unit(random), operate = 0.5 + 0.15 * unit(random);
    const Loop loop{through({{0.02, 0},
                             {0.06, level - 0.03},
                             {0.2, level},
                             {0.32, level + hump},
                             {0.47, level - 0.02},
                             {operate + 0.05, level + 0.08},
                             {end, level + 0.15},
                             {end + 0.03, 0.98}}),
                    through({{0.03, 0},
                             {0.075, level - below - 0.03},
                             {0.3, level - below + hump / 2},
                             {operate - 0.08, level - below},
                             {operate + 0.06, level + 0.065},
                             {end + 0.002, level + 0.135},
                             {end + 0.032, 0.98}})};
    draw(plot, loop);
    INFO("loop " << n);
    checkLoop(plot, loop, 0.6, 0.3);
  }
}

TEST_CASE("loop: rubbish is not believed", "[trace_loop]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  int believed = 0;
  for (int n = 0; n < 6; ++n) {
    Plot plot(600, 450, 2);
    plot.grid(8, 6, 2);
    for (int k = 0; k < 30; ++k) {
      const double x = unit(random), y = unit(random);
      plot.curve({plot.at(x, y), plot.at(x + 0.2 * (unit(random) - 0.5), y + 0.3 * (unit(random) - 0.5))});
    }
    const auto result = plot.trace();
    if (result.ok() && result->front().confidence > 0.5) ++believed;
  }
  CHECK(believed == 0);
}

TEST_CASE("loop: an empty frame, words alone, a cancelled run and a mask over everything", "[trace_loop]") {
  Plot empty(400, 300, 2);
  empty.grid(6, 5, 2);
  const auto nothing = empty.trace();
  if (nothing.ok()) CHECK(nothing->front().confidence < 0.2);
  Plot blank(400, 300, 2);
  REQUIRE_FALSE(blank.trace().ok());
  CHECK(blank.trace().failure().code == FailureCode::noForceGraph);
  CHECK_FALSE(blank.trace().failure().remedies.empty());

  Plot words(400, 300, 1.5);
  for (int k = 0; k < 4; ++k) words.word(0.2, 0.2 + 0.15 * k, 12);
  const auto text = words.trace();
  if (text.ok()) CHECK(text->front().confidence < 0.2);

  Plot plot(400, 300, 2);
  const Loop loop = tactileLoop();
  draw(plot, loop);
  Progress stop;
  stop.cancelled = [] { return true; };
  const auto cancelled = plot.trace({}, stop);
  REQUIRE_FALSE(cancelled.ok());
  CHECK(cancelled.failure().code == FailureCode::cancelled);
  TraceHints hidden;
  hidden.masks_px = {{0, 0, 400, 300}};
  CHECK_FALSE(plot.trace(hidden).ok());
}
