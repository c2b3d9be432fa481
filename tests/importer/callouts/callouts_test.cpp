// SPDX-License-Identifier: GPL-3.0-or-later
// Points that a plot names: found by their leader, and by nothing that is drawn there anyway.
#include "importer/callouts/callouts.h"

#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

constexpr Box box{20, 10, 420, 310};

/// A plot with a straight press, and the words "operating point".
class NamedPoint {
 public:
  explicit NamedPoint(Box words, const std::string& text = "operating point") {
    view_.raster.width_px = 440, view_.raster.height_px = 330;
    view_.raster.rgb.assign(std::size_t{3} * 440 * 330, 255);
    frame_.corners = {Point{box.x0, box.y0}, Point{box.x1, box.y0}, Point{box.x1, box.y1},
                      Point{box.x0, box.y1}};
    axes_.texts.push_back({.utf8 = text, .box = words});
    for (int x = 20; x <= 400; ++x) {
      const Point p = onPress(x);
      strokes_.press.points_px.push_back(p);
      strokes_.press.points.push_back({p.x / 100, (310 - p.y) / 100});
    }
    line(onPress(20), onPress(400));
  }

  static Point onPress(double x) { return {x, 260 - 0.4 * x}; }

  void line(Point from, Point to) {
    const int steps = static_cast<int>(2 * distance(from, to));
    for (int i = 0; i <= steps; ++i) {
      const Point p = from + (static_cast<double>(i) / steps) * (to - from);
      for (int dx : {0, 1}) {
        const auto at = static_cast<std::size_t>(static_cast<int>(p.y) * 440 + static_cast<int>(p.x) + dx);
        for (std::size_t k = 0; k < 3; ++k) view_.raster.rgb[3 * at + k] = 0;
      }
    }
  }
  void gridline(double x) {
    line({x, box.y0}, {x, box.y1});
    frame_.xLines.push_back({x, 2, true});
  }

  /// Lets the press rise upright from its end to a row.
  void bottomOut(double top) {
    StrokePoints& press = strokes_.press;
    const Point corner = press.points_px.back();
    for (double y = corner.y; y >= top; y -= 1) {
      press.points_px.push_back({corner.x, y});
      press.points.push_back({corner.x / 100, (310 - y) / 100});
    }
    line(corner, {corner.x, top});
  }

  /// Keeps the ends of the press and a point of its straight way, as a document may draw it.
  void thinOut() {
    StrokePoints& press = strokes_.press;
    const std::size_t last = press.points.size() - 1;
    press.points = {press.points[0], press.points[150], press.points[last]};
    press.points_px = {press.points_px[0], press.points_px[150], press.points_px[last]};
  }

  std::vector<CalloutKind> printed() const { return printedCallouts(frame_, axes_); }
  std::vector<Callout> read() const { return readCallouts(view_, frame_, axes_, strokes_); }

 private:
  PageView view_;
  PlotFrame frame_;
  AxesFound axes_;
  StrokePair strokes_;
};

}  // namespace

TEST_CASE("a named point is where its leader meets the curve") {
  NamedPoint plot({60, 60, 160, 76});
  plot.line({140, 80}, NamedPoint::onPress(200));
  const auto found = plot.read();
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == CalloutKind::operatingPoint);
  CHECK(found[0].at_px.x == Approx(200).margin(6));
}

TEST_CASE("the curve beside its name is no leader, nor is a gridline") {
  const NamedPoint beside({60, 196, 160, 212});  // the curve runs on from the words' end
  CHECK(beside.read().empty());
  NamedPoint below({220, 230, 320, 246});
  below.gridline(250);
  CHECK(below.read().empty());
}

TEST_CASE("a longer leader that passes by the text belongs to another one") {
  NamedPoint plot({60, 60, 160, 76});
  plot.line({140, 80}, NamedPoint::onPress(200));
  plot.line({145.7, 30}, NamedPoint::onPress(230));
  const auto found = plot.read();
  REQUIRE(found.size() == 1);
  CHECK(found[0].at_px.x == Approx(200).margin(6));
}

TEST_CASE("a line from a word to the bottom-out is no leader") {
  NamedPoint plot({260, 40, 360, 56});
  plot.bottomOut(20);
  plot.line({364, 50}, {400, 70});
  CHECK(plot.read().empty());
  plot.line({300, 60}, NamedPoint::onPress(250));
  const auto found = plot.read();
  REQUIRE(found.size() == 1);
  CHECK(found[0].at_px.x == Approx(250).margin(6));
}

TEST_CASE("a press that a document draws with few points is no leader") {
  NamedPoint plot({300, 110, 400, 126});
  plot.thinOut();
  CHECK(plot.read().empty());
}

TEST_CASE("contact points are known by their names, in several languages and with a misread letter") {
  using enum CalloutKind;
  struct Case {
    std::string text;
    std::optional<CalloutKind> expected;
  };
  const auto& [text, expected] = GENERATE(values<Case>({{"Operating position", operatingPoint},
                                                        {"operafing point", operatingPoint},
                                                        {"Actuation point", operatingPoint},
                                                        {"Schaltpunkt", operatingPoint},
                                                        {"Betätigungspunkt", operatingPoint},
                                                        {"punto di azionamento", operatingPoint},
                                                        {"动作点", operatingPoint},
                                                        {"作動ポイント", operatingPoint},
                                                        {"reset point", resetPoint},
                                                        {"Release point", resetPoint},
                                                        {"Rückschaltpunkt", resetPoint},
                                                        {"复位点", resetPoint},
                                                        {"release", {}},
                                                        {"pressure point", {}},
                                                        {"operating and reset point", {}}}));
  INFO(text);
  const NamedPoint plot({60, 60, 160, 76}, text);
  CHECK(plot.printed() == (expected ? std::vector{*expected} : std::vector<CalloutKind>{}));
}
