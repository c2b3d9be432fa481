// SPDX-License-Identifier: GPL-3.0-or-later
// Curves among a page's paths: separated from everything else, joined from their pieces, cut into strokes;
// exact.

#include "importer/trace/trace_vector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <catch2/catch.hpp>

#include "importer/page/polyline.h"
#include "importer/trace/filled_outline.h"

using namespace detent;
using namespace detent::importer;

namespace {

using Polyline = std::vector<Point>;

const Box frameBox{100, 50, 900, 650};

PlotFrame frameWithGrid() {
  PlotFrame frame;
  frame.corners = {Point{frameBox.x0, frameBox.y0},
                   {frameBox.x1, frameBox.y0},
                   {frameBox.x1, frameBox.y1},
                   {frameBox.x0, frameBox.y1}};
  for (int i = 0; i <= 4; ++i) frame.xLines.push_back({frameBox.x0 + 200.0 * i, 1, true});
  for (int i = 0; i <= 4; ++i) frame.yLines.push_back({frameBox.y0 + 150.0 * i, 1, true});
  return frame;
}

/// Shares of the frame to view pixels, v upwards.
Point at(double u, double v) {
  return {frameBox.x0 + u * frameBox.width(), frameBox.y1 - v * frameBox.height()};
}

double pressForce(double u) { return 0.35 + 0.2 * u + 0.12 * std::exp(-std::pow((u - 0.4) / 0.08, 2)); }
double releaseForce(double u) { return pressForce(u) - 0.15 * (1 - u); }

template <class Force>
Polyline curve(Force force, double from = 0, double to = 0.95, int points = 200) {
  Polyline line;
  for (int i = 0; i <= points; ++i) {
    const double u = from + (to - from) * i / points;
    line.push_back(at(u, force(u)));
  }
  return line;
}

class Drawing {
 public:
  Drawing() {
    const PlotFrame frame = frameWithGrid();
    for (const GridLine& x : frame.xLines)
      stroke({{x.position_px, frameBox.y0}, {x.position_px, frameBox.y1}});
    for (const GridLine& y : frame.yLines)
      stroke({{frameBox.x0, y.position_px}, {frameBox.x1, y.position_px}});
    stroke({{frameBox.x0, frameBox.y0},
            {frameBox.x1, frameBox.y0},
            {frameBox.x1, frameBox.y1},
            {frameBox.x0, frameBox.y1}},
           true);
  }

  void stroke(const Polyline& line, bool closed = false) { stroke(std::vector<Polyline>{line}, closed); }
  void stroke(const std::vector<Polyline>& lines, bool closed = false) {
    VectorPath path;
    path.polylines = lines;
    path.closed.assign(lines.size(), closed);
    path.stroke = color;
    path.strokeWidth = width;
    path.dashed = dashed;
    path.clip = clip;
    path.box = {0, 0, 1000, 800};
    view.paths.push_back(path);
  }
  void fill(const Polyline& ring) {
    VectorPath path;
    path.polylines = {ring};
    path.closed = {true};
    path.fill = color;
    path.box = {0, 0, 1000, 800};
    view.paths.push_back(path);
  }

  std::vector<CurveTrace> traced(const TraceHints& hints = {}) const {
    return traceVector(view, frameWithGrid(), axes, hints);
  }

  Rgb color{0, 0, 0};
  double width = 2;
  bool dashed = false;
  std::optional<Box> clip;
  PageView view;
  AxesFound axes;
};

double distanceToSegment(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double farthest(const Polyline& from, const Polyline& to) {
  double worst = 0;
  for (const Point& p : from) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < to.size(); ++i)
      nearest = std::min(nearest, distanceToSegment(p, to[i - 1], to[i]));
    worst = std::max(worst, nearest);
  }
  return worst;
}

/// Largest distance between the two lines, both ways, pixels.
double apart(const Polyline& a, const Polyline& b) { return std::max(farthest(a, b), farthest(b, a)); }

const CurveTrace& strokeOf(const std::vector<CurveTrace>& traces, Stroke stroke) {
  const auto found =
      std::find_if(traces.begin(), traces.end(), [&](const CurveTrace& t) { return t.stroke == stroke; });
  REQUIRE(found != traces.end());
  return *found;
}

void checkPair(const std::vector<CurveTrace>& traces, const Polyline& press, const Polyline& release,
               double tolerance_px) {
  REQUIRE(traces.size() == 2);
  CHECK(apart(strokeOf(traces, Stroke::press).points_px, press) <= tolerance_px);
  CHECK(apart(strokeOf(traces, Stroke::release).points_px, release) <= tolerance_px);
  for (const CurveTrace& trace : traces) {
    CHECK(trace.fromVector);
    CHECK(trace.width_px.empty());
  }
}

Polyline part(const Polyline& line, std::size_t from, std::size_t to) {
  return {line.begin() + static_cast<std::ptrdiff_t>(from),
          line.begin() + static_cast<std::ptrdiff_t>(to) + 1};
}

/// The outline of a line with butt ends: each segment's own edges; on a bend's inner side they meet over its
/// corner.
Polyline outlineOf(const Polyline& line, double width) {
  Polyline sides[2];
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point along = line[i] - line[i - 1];
    const Point off = width / (2 * norm(along)) * Point{-along.y, along.x};
    for (const int side : {0, 1}) {
      const double sign = side == 0 ? 1 : -1;
      if (i > 1 && sign * cross(line[i - 1] - line[i - 2], along) > 0) sides[side].push_back(line[i - 1]);
      sides[side].push_back(line[i - 1] + sign * off);
      sides[side].push_back(line[i] + sign * off);
    }
  }
  sides[0].insert(sides[0].end(), sides[1].rbegin(), sides[1].rend());
  return sides[0];
}

const Polyline press = curve(pressForce), release = curve(releaseForce);

}  // namespace

TEST_CASE("no curve among the paths: nothing") {
  Drawing drawing;
  CHECK(drawing.traced().empty());
  drawing.stroke({at(0.3, 0.9), at(0.45, 0.6)});   // a leader
  drawing.stroke({at(0.1, 0.52), at(0.5, 0.52)});  // a level of force
  CHECK(drawing.traced().empty());
}

TEST_CASE("two colours: exact points, each in its colour, legend words beside the samples") {
  Drawing drawing;
  drawing.color = {228, 26, 28};
  drawing.stroke(press);
  drawing.stroke({{700, 80}, {740, 80}});
  drawing.color = {55, 126, 184};
  drawing.stroke(release);
  drawing.stroke({{700, 110}, {740, 110}});
  drawing.axes.texts = {{"Press", {750, 72, 800, 88}, 1, 0}, {"Release", {750, 102, 810, 118}, 1, 0}};
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  const bool redFirst = traces[0].color == Rgb{228, 26, 28};
  const CurveTrace &red = traces[redFirst ? 0 : 1], &blue = traces[redFirst ? 1 : 0];
  CHECK(red.points_px == press);
  CHECK(blue.points_px == release);
  CHECK(red.label == "Press");
  CHECK(blue.label == "Release");
  CHECK_FALSE(red.stroke);
}

TEST_CASE("words of a legend's row are their own sample's alone") {
  Drawing drawing;
  drawing.color = {228, 26, 28};
  drawing.stroke(press);
  drawing.stroke({{500, 80}, {540, 80}});
  drawing.color = {55, 126, 184};
  drawing.stroke(release);
  drawing.stroke({{606, 80}, {646, 80}});  // the legend key of the curve whose text was not read
  drawing.axes.texts = {{"Old", {545, 72, 580, 88}, 1, 0}};
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  for (const CurveTrace& trace : traces) CHECK(trace.label == (trace.color == Rgb{228, 26, 28} ? "Old" : ""));
}

TEST_CASE("a tick with its number is no legend") {
  Drawing drawing;
  drawing.stroke(press);
  drawing.stroke({{frameBox.x0 - 8, 350}, {frameBox.x0, 350}});
  drawing.axes.texts = {{"50", {frameBox.x0 - 30, 342, frameBox.x0 - 12, 358}, 1, 0}};
  REQUIRE(drawing.traced().size() == 1);
  CHECK(drawing.traced()[0].label.empty());
}

TEST_CASE("one colour: press above release, whatever the order and direction of drawing") {
  Drawing drawing;
  drawing.stroke(Polyline(release.rbegin(), release.rend()));
  drawing.stroke(press);
  drawing.stroke({at(0.3, 0.9), at(0.4, pressForce(0.4))});  // leader that ends on the curve
  drawing.stroke({at(0.7, 0.2), at(0.6, releaseForce(0.6))});
  drawing.stroke(
      std::vector<Polyline>{{{300, 100}, {306, 90}, {312, 100}}, {{302, 97}, {310, 97}}});  // a letter
  checkPair(drawing.traced(), press, release, 1e-6);
}

TEST_CASE("pieces of one curve are joined: separate objects, subpaths, either direction, arcs and lines") {
  Drawing drawing;
  drawing.stroke(part(press, 120, 200));
  drawing.stroke(Polyline(press.rend() - 61, press.rend()));  // 60..0
  drawing.stroke(part(press, 60, 120));
  drawing.stroke(
      std::vector<Polyline>{part(release, 100, 200), part(release, 0, 30), part(release, 30, 100)});
  checkPair(drawing.traced(), press, release, 1e-6);
}

TEST_CASE("dashes drawn one by one are one curve") {
  Drawing drawing;
  drawing.stroke(press);
  std::vector<Polyline> dashes;
  for (std::size_t i = 0; i + 3 <= 200; i += 5) dashes.push_back(part(release, i, i + 3));
  drawing.stroke(dashes);
  checkPair(drawing.traced(), press, part(release, 0, 198), 1);
}

TEST_CASE("a line drawn in steps that touch is none of dashes, every other one") {
  Drawing drawing;
  const auto inSteps = [&](const Polyline& line) {
    for (std::size_t i = 1; i < line.size(); ++i) drawing.stroke(Polyline{line[i - 1], line[i]});
  };
  drawing.color = {228, 26, 28};
  inSteps(press);
  drawing.color = {55, 126, 184};
  inSteps(release);
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  for (const CurveTrace& trace : traces) CHECK(trace.points_px.size() == press.size());
}

TEST_CASE("an area's outline is the curve above it") {
  Drawing drawing;
  drawing.color = {228, 26, 28};
  Polyline area = press;
  area.push_back({press.back().x, frameBox.y1});
  area.push_back({press.front().x, frameBox.y1});
  drawing.stroke(area, true);
  drawing.view.paths.back().fill = Rgb{255, 200, 200};
  drawing.color = {55, 126, 184};
  drawing.stroke(release);
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  const CurveTrace& red = traces[traces[0].color == Rgb{228, 26, 28} ? 0 : 1];
  CHECK(red.points_px == press);
}

TEST_CASE("dashes and dots turned into outlines are one curve, however steeply and sharply it bends") {
  // A click that gives way within a hundredth of the travel, finely drawn.
  const double width = GENERATE(0.003, 0.005);
  const auto snap = [&](double u) { return 0.15 + 0.4 * u + 0.14 / (1 + std::exp((u - 0.52) / width)); };
  const Polyline line = densified(curve(snap, 0, 0.95, 2000), 0.5);
  const auto [dash_px, gap_px] = GENERATE(std::pair(12.0, 7.0), std::pair(10.0, 6.0), std::pair(4.0, 6.0));
  CAPTURE(dash_px, width);
  Drawing drawing;
  drawing.stroke(curve([&](double u) { return 0.75 * u + 0.2; }));
  const std::vector<double> arc = arcOf(line);
  for (double from = 0; from < arc.back(); from += dash_px + gap_px) {
    Polyline dash;
    for (std::size_t i = 0; i < line.size(); i += 3)
      if (arc[i] >= from && arc[i] <= from + dash_px) dash.push_back(line[i]);
    if (dash.size() > 1) drawing.fill(outlineOf(dash, 3));
  }
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  const Polyline& back = strokeOf(traces, Stroke::release).points_px;
  CHECK(apart(back, line) < 5);
  CHECK(std::abs(std::min(back.front().x, back.back().x) - line.front().x) < 12);
}

TEST_CASE("markers on a line are no line of their own, dots beside it are") {
  Drawing drawing;
  drawing.color = {200, 30, 30};
  drawing.stroke(curve(pressForce));
  const auto mark = [&](double from_v) {
    for (const Point& p : curve(pressForce, 0.01, 0.94, 60)) {
      Polyline ring;
      for (int i = 0; i < 16; ++i)
        ring.push_back({p.x + 3 * std::cos(i * M_PI / 8), p.y - from_v + 3 * std::sin(i * M_PI / 8)});
      drawing.fill(ring);
    }
  };
  mark(0);
  CHECK(drawing.traced().size() == 1);
  mark(-40);
  CHECK(drawing.traced().size() == 2);
}

TEST_CASE("a line broken off where a word stands goes on behind it") {
  for (const bool bothStrokes : {true, false}) {
    Drawing drawing;
    drawing.stroke(std::vector<Polyline>{part(press, 0, 126), part(press, 139, 200)});
    if (bothStrokes) drawing.stroke(release);
    const auto traces = drawing.traced();
    REQUIRE(traces.size() == (bothStrokes ? 2 : 1));
    CHECK(apart(bothStrokes ? strokeOf(traces, Stroke::press).points_px : traces[0].points_px, press) < 1);
  }
}

TEST_CASE("paths that leave the rest of a stroke over are not taken: the picture decides") {
  Drawing drawing;
  SECTION("too far away") {
    drawing.stroke(part(press, 0, 100));
    drawing.stroke(part(press, 140, 200));
  }
  SECTION("not in line: the peak is missing") {
    drawing.stroke(part(press, 0, 72));
    drawing.stroke(part(press, 92, 200));
    drawing.stroke(release);
  }
  SECTION("two parts that could each be a stroke") {
    drawing.stroke(part(press, 0, 85));
    drawing.stroke(part(press, 125, 200));
    drawing.color = {228, 26, 28};
    drawing.stroke(release);
  }
  SECTION("a straight rest") {
    drawing.stroke(part(press, 0, 140));
    drawing.stroke({at(0.8, pressForce(0.8)), at(0.95, pressForce(0.95))});
  }
  CHECK(drawing.traced().empty());
}

TEST_CASE("two presses in one colour are not taken for press and release: the picture decides") {
  Drawing drawing;
  drawing.stroke(press);
  SECTION("lines that cross") {
    drawing.stroke(curve([](double u) { return 0.25 + 0.5 * u; }));
  }
  SECTION("the lower one goes on farther") {
    drawing.stroke(curve([](double u) { return 0.2 + 0.1 * u; }, 0, 0.99));
  }
  CHECK(drawing.traced().empty());
}

TEST_CASE("a leader beyond a stroke's end is no rest of it") {
  Drawing drawing;
  drawing.stroke(part(press, 0, 140));
  drawing.stroke({at(0.7, 0.9), at(0.9, 0.7)});
  REQUIRE(drawing.traced().size() == 1);
}

TEST_CASE("a loop drawn as one line is cut at its turn") {
  Polyline loop = press;
  loop.push_back(at(0.95, 0.9));  // a bottom-out, up and down again
  loop.insert(loop.end(), release.rbegin(), release.rend());
  Polyline up = press;
  up.push_back(at(0.95, 0.9));
  SECTION("open") {
    Drawing drawing;
    drawing.stroke(loop);
    const auto traces = drawing.traced();
    REQUIRE(traces.size() == 2);
    CHECK(farthest(press, strokeOf(traces, Stroke::press).points_px) < 1e-6);
    CHECK(farthest(release, strokeOf(traces, Stroke::release).points_px) < 1e-6);
  }
  SECTION("closed") {
    Drawing drawing;
    drawing.stroke(loop, true);
    const auto traces = drawing.traced();
    REQUIRE(traces.size() == 2);
    CHECK(farthest(press, strokeOf(traces, Stroke::press).points_px) < 1e-6);
  }
}

TEST_CASE("a force that drops and comes back while the line goes on is one stroke") {
  Drawing drawing;
  Polyline noisy = part(press, 0, 150);
  const Point p = noisy.back();
  noisy.push_back({p.x + 0.4, p.y - 14});
  noisy.push_back({p.x + 0.8, p.y});
  for (const Point& q : part(press, 151, 200)) noisy.push_back(q);
  drawing.stroke(noisy);
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 1);
  CHECK(apart(traces[0].points_px, noisy) <= 1e-6);
}

TEST_CASE("a release that runs into the press shares its rest") {
  Drawing drawing;
  drawing.stroke(press);
  const auto falling = [](double u) { return pressForce(u) - 0.15 * std::max(0.0, 1 - u / 0.6); };
  Polyline own = curve(falling, 0, 0.6, 120);
  drawing.stroke(own);
  Polyline whole = own;
  for (const Point& p : press)
    if (p.x > own.back().x) whole.push_back(p);
  checkPair(drawing.traced(), press, whole, 0.3);
}

TEST_CASE("a bottom-out drawn on its own belongs to both strokes; a thin continuation mark to none") {
  Drawing drawing;
  const double top = pressForce(0.95);
  drawing.stroke(press);
  Polyline down = release;
  down.push_back(at(0.95, top));
  drawing.stroke(release);
  drawing.stroke({at(0.95, releaseForce(0.95)), at(0.95, 0.93)});
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  for (const CurveTrace& trace : traces) CHECK(trace.points_px.back().y == Approx(at(0, 0.93).y));

  Drawing marked;
  marked.stroke(press);
  marked.stroke(release);
  marked.width = 0.5;
  for (int i = 0; i < 5; ++i) marked.stroke({at(0.95, top + 0.05 * i), at(0.95, top + 0.05 * i + 0.03)});
  for (const CurveTrace& trace : marked.traced()) CHECK(trace.points_px.back().y > at(0, top + 0.02).y);
}

TEST_CASE("a bottom-out on a gridline begins where a stroke ends, if it is seen; the gridline does not") {
  const Polyline down = curve(releaseForce, 0, 0.75), up = curve(pressForce, 0, 0.75);
  Drawing drawing;
  drawing.stroke(up);
  drawing.stroke(down);
  const auto highest = [&] {
    double row = frameBox.y1;
    for (const CurveTrace& trace : drawing.traced())
      for (const Point& p : trace.points_px) row = std::min(row, p.y);
    return row;
  };
  const double bump = highest();
  CHECK(bump > at(0, 0.7).y);
  drawing.stroke({at(0.75, pressForce(0.75)), at(0.75, 0.9)});
  CHECK(highest() == bump);  // as thick as the gridline and in its colour: nobody sees it
  drawing.width = 2.3;
  drawing.stroke({at(0.75, pressForce(0.75)), at(0.75, 0.92)});
  REQUIRE(drawing.traced().size() == 2);
  CHECK(highest() == Approx(at(0, 0.92).y).margin(0.5));
}

TEST_CASE("a bottom-out drawn over a gridline of another colour belongs to its stroke") {
  Drawing drawing;
  drawing.color = {200, 30, 30};
  drawing.stroke(curve(pressForce, 0, 0.75));
  drawing.stroke({at(0.75, pressForce(0.75)), at(0.75, 0.9)});
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 1);
  CHECK(traces.front().points_px.back().y == Approx(at(0, 0.9).y).margin(0.5));
}

TEST_CASE("a corner left open between a slope and a level line is bridged") {
  Drawing drawing;
  drawing.stroke(press);
  const double level = 0.3;
  drawing.stroke({at(0, 0.1), at(0.5, 0.13), at(0.6, level - 0.006)});
  drawing.stroke({at(0.61, level), at(0.95, level + 0.02)});
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 2);
  CHECK(strokeOf(traces, Stroke::release).points_px.back().x == Approx(at(0.95, 0).x).margin(0.5));
}

TEST_CASE("curves are cut where the document clips them") {
  Drawing drawing;
  drawing.clip = frameBox;
  drawing.stroke({at(0.0, 0.3), at(0.5, 0.4), at(0.6, 0.45), at(0.9, 1.5)});
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 1);
  CHECK(traces[0].points_px.back().y == Approx(frameBox.y0));
}

TEST_CASE("a thick line turned into an outline gives its centre line") {
  Polyline ring;
  const Polyline middle = curve(pressForce);
  const auto normalAt = [&](std::size_t i) {
    const Point a = middle[i == 0 ? 0 : i - 1], b = middle[std::min(i + 1, middle.size() - 1)];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return Point{-(b.y - a.y) / length, (b.x - a.x) / length};
  };
  for (std::size_t i = 0; i < middle.size(); ++i)
    ring.push_back({middle[i].x + 2 * normalAt(i).x, middle[i].y + 2 * normalAt(i).y});
  for (std::size_t i = middle.size(); i-- > 0;)
    ring.push_back({middle[i].x - 2 * normalAt(i).x, middle[i].y - 2 * normalAt(i).y});
  const auto centre = centreOfOutline(ring, 20);
  REQUIRE(centre);
  CHECK(centre->width_px == Approx(4).epsilon(0.02));
  CHECK(apart(centre->points, middle) < 0.15);

  Drawing drawing;
  drawing.fill(ring);
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 1);
  CHECK(apart(traces[0].points_px, middle) < 0.15);

  CHECK_FALSE(centreOfOutline({{0, 0}, {40, 0}, {40, 30}, {0, 30}}, 50));    // a box
  CHECK_FALSE(centreOfOutline({{0, 0}, {20, 0}, {10, 17}}, 50));             // an arrow head
  CHECK_FALSE(centreOfOutline({{0, 0}, {100, 0}, {100, 30}, {0, 30}}, 20));  // too wide for a line
}

TEST_CASE("a thick curve of many short steps is no box, however long one of its steps is") {
  Drawing drawing;
  drawing.width = 9;  // a quarter of it is more than the steps' widths
  Polyline falling =
      curve([](double u) { return u < 0.4 ? 0.3 + 0.5 * u : 0.35 + 0.3 * (u - 0.4); }, 0, 0.95, 800);
  drawing.stroke(falling);
  const auto traces = drawing.traced();
  REQUIRE(traces.size() == 1);
  CHECK(traces[0].points_px == falling);
  // A box of a thick line, its corners rounded in short steps, still is one.
  Drawing framed;
  framed.width = 9;
  const Box b{200, 150, 800, 400};
  framed.stroke(
      {{b.x0 + 1, b.y0}, {b.x1 - 1, b.y0}, {b.x1, b.y0 + 1}, {b.x1, b.y1}, {b.x0, b.y1}, {b.x0, b.y0 + 1}},
      true);
  CHECK(framed.traced().empty());
}

TEST_CASE("of two colours given, one of which no line has, the other's line is not taken alone") {
  Drawing drawing;
  drawing.color = {200, 0, 0};
  drawing.stroke(press);
  TraceHints hints;
  hints.releaseColor = Rgb{200, 0, 0};
  CHECK(drawing.traced(hints).size() == 1);
  hints.pressColor = Rgb{0, 160, 0};
  CHECK(drawing.traced(hints).empty());
}

TEST_CASE(
    "a short way back in a colour of its own is a stroke where it ends as the press does, a leader is none") {
  const auto low = [](double u) { return 0.2 + 0.3 * (u - 0.7) + 4 * std::pow(u - 0.7, 2); };
  const auto traced = [&](const Polyline& line) {
    Drawing drawing;
    drawing.stroke(press);
    drawing.color = {200, 0, 0};
    drawing.stroke(line);
    return drawing.traced();
  };
  const Polyline back = curve(low, 0.7, 0.95);
  const auto bothStrokes = traced(back);
  REQUIRE(bothStrokes.size() == 2);
  CHECK(std::ranges::any_of(bothStrokes, [&](const CurveTrace& trace) { return trace.points_px == back; }));
  CHECK(traced(curve(low, 0.6, 0.85)).size() == 1);
  CHECK(traced({at(0.7, 0.2), at(0.8, 0.3), at(0.95, 0.4)}).size() == 1);
  CHECK(traced(curve(low, 0.87, 0.95)).size() == 1);
}

TEST_CASE("hints: colours choose and name, masks cut") {
  Drawing drawing;
  drawing.color = {200, 0, 0};
  drawing.stroke(press);
  drawing.color = {0, 0, 200};
  drawing.stroke(release);
  drawing.color = {0, 160, 0};
  drawing.stroke(curve([](double u) { return 0.1 + 0.1 * u * u; }));
  TraceHints hints;
  hints.pressColor = Rgb{0, 0, 190};
  hints.releaseColor = Rgb{210, 0, 0};
  const auto traces = drawing.traced(hints);
  REQUIRE(traces.size() == 2);
  CHECK(strokeOf(traces, Stroke::press).points_px == release);
  hints.masks_px = {{800, 0, 1000, 800}};
  for (const CurveTrace& trace : drawing.traced(hints)) CHECK(trace.points_px.back().x == Approx(800));
}

TEST_CASE("a copy drawn over a curve costs no confidence; another curve in the colour does") {
  Drawing drawing;
  drawing.stroke(press);
  drawing.stroke(release);
  const double alone = drawing.traced()[0].confidence;
  Drawing other = drawing;
  drawing.stroke(press);
  REQUIRE(drawing.traced().size() == 2);
  CHECK(drawing.traced()[0].confidence == Approx(alone));
  other.stroke(curve([](double u) { return 0.05 + 0.2 * u * u; }));
  for (const CurveTrace& trace : other.traced()) CHECK(trace.confidence < 0.6);
}

TEST_CASE("a curve drawn again over the area that covered it is one") {
  Drawing drawing;
  drawing.color = {228, 26, 28};
  for (int i = 0; i < 2; ++i) drawing.stroke(press);
  drawing.color = {55, 126, 184};
  drawing.stroke(release);
  CHECK(drawing.traced().size() == 2);
}

TEST_CASE("numbers at the extremes: an empty frame, a vertical curve, a hundred thousand letters") {
  Drawing drawing;
  PlotFrame flat = frameWithGrid();
  for (Point& corner : flat.corners) corner.y = 50;
  CHECK(traceVector(drawing.view, flat, drawing.axes).empty());
  drawing.stroke(press);
  drawing.stroke(release);
  for (int i = 0; i < 100000; ++i) {
    const Point p{120.0 + i % 700, 60.0 + (i / 700) % 80};
    drawing.stroke({p, {p.x + 3, p.y + 4}, {p.x + 6, p.y}});
  }
  CHECK(drawing.traced().size() == 2);
}

TEST_CASE("strokes that begin in one point, drawn in one line through it") {
  Drawing drawing;
  const Point start = at(0, 0.1);
  drawing.stroke({press[10], start, release[12]});
  drawing.stroke(part(press, 10, 200));
  drawing.stroke(part(release, 12, 200));
  Polyline up{start}, down{start};
  up.insert(up.end(), press.begin() + 10, press.end());
  down.insert(down.end(), release.begin() + 12, release.end());
  checkPair(drawing.traced(), up, down, 1e-6);
}
