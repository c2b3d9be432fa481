// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/switches.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "importer/strokes/stroke_pair.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// A rising line of its own colour, `height_px` above the bottom of a 300 px plot; its legend entry in row
/// `row`.
CurveTrace tracedSwitch(std::string label, double height_px, std::uint8_t blue, int row = 0,
                        double column_px = 400) {
  CurveTrace t;
  t.color = {20, 40, blue};
  t.confidence = 1;
  for (double x = 0; x <= 300; ++x) t.points_px.push_back({x, 300 - height_px - 0.3 * x});
  t.label = std::move(label);
  if (!t.label.empty()) t.labelBox_px = {column_px, 10.0 + 20 * row, column_px + 60, 22.0 + 20 * row};
  return t;
}

std::vector<std::string> namesOf(const std::vector<PlotSwitch>& switches) {
  std::vector<std::string> names;
  for (const PlotSwitch& each : switches) names.push_back(each.name);
  return names;
}

using Names = std::vector<std::string>;

/// The two strokes of a switch of `travel_px`, the release up to `lag_px` lower; neither named.
std::vector<CurveTrace> loop(double baseline_px, double travel_px, double lag_px, std::uint8_t blue) {
  std::vector<CurveTrace> strokes{tracedSwitch("", 0, blue),
                                  tracedSwitch("", 0, static_cast<std::uint8_t>(blue + 1))};
  for (std::size_t k = 0; k < 2; ++k) {
    auto& points = strokes[k].points_px;
    points.clear();
    for (double x = 0; x <= travel_px; ++x) {
      const double lag = k == 0 ? 0 : lag_px * std::sin(M_PI * x / travel_px);
      points.push_back({x, 300 - baseline_px * std::min(1.0, x / 10) - 0.4 * x + lag});
    }
  }
  return strokes;
}

}  // namespace

TEST_CASE("A name is found without its accents", "[switches]") {
  const std::vector<CurveTrace> traces{tracedSwitch("Boton A", 10, 1), tracedSwitch("Boton B", 60, 2, 1)};
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 2);
  CHECK(switches[chosenSwitch(switches, traces, "Botón B").value()].name == "Boton B");
  CHECK(isNamed(switches, 1, traces, "Botón B"));
}

TEST_CASE("Where one of several names was not read its place says that it is a switch's", "[switches]") {
  std::vector<CurveTrace> traces{tracedSwitch("1.6 N", 10, 1), tracedSwitch("2.6 N", 60, 2, 1),
                                 tracedSwitch("", 90, 3, 2)};
  CHECK(switchesAmong(traces).size() != 3);  // a curve beside the legend's curves that no entry lists
  traces[2].labelBox_px = {400, 50, 460, 62};
  const auto switches = switchesAmong(traces);
  CHECK(namesOf(switches) == Names{"1.6 N", "2.6 N", ""});
  CHECK(chosenSwitch(switches, traces, "3").value() == 2);
  traces[1].label = "1.6 N release";  // then it may be a stroke of either
  CHECK(switchesAmong(traces).size() != 3);
}

TEST_CASE("Two curves that no legend parts are one switch's strokes", "[switches]") {
  for (const char* label : {"", "press", "Switch A"}) {
    const std::vector<CurveTrace> traces{tracedSwitch("", 10, 1), tracedSwitch(label, 60, 2)};
    const auto switches = switchesAmong(traces);
    REQUIRE(switches.size() == 1);
    CHECK(switches[0].traces.size() == 2);
    CHECK(chosenSwitch(switches, traces, "").value() == 0);
    CHECK(chosenSwitch(switches, traces, "1").value() == 0);
  }
}

TEST_CASE("Curves with names of their own are switches in the legend's order", "[switches]") {
  const std::vector<CurveTrace> traces{tracedSwitch("Switch B", 10, 1, 1), tracedSwitch("Switch C", 60, 2, 2),
                                       tracedSwitch("Switch A", 30, 3, 0)};
  const auto switches = switchesAmong(traces);
  REQUIRE(namesOf(switches) == Names{"Switch A", "Switch B", "Switch C"});
  CHECK(switches[0].pressColor == traces[2].color);
  CHECK_FALSE(switches[0].releaseColor);
  CHECK(namesOf(switchesAmong(
            {tracedSwitch("downstroke_a", 10, 1, 0), tracedSwitch("downstroke_b", 60, 2, 1)})) ==
        Names{"downstroke_a", "downstroke_b"});
}

TEST_CASE("A legend in one row counts from the left", "[switches]") {
  const auto switches =
      switchesAmong({tracedSwitch("Red", 10, 1, 0, 300), tracedSwitch("Blue", 30, 2, 0, 100),
                     tracedSwitch("Brown", 60, 3, 0, 200)});
  CHECK(namesOf(switches) == Names{"Blue", "Brown", "Red"});
}

TEST_CASE("Press and release come together by the rest of their names", "[switches]") {
  const std::vector<CurveTrace> traces{
      tracedSwitch("Switch 2 release", 50, 1, 3), tracedSwitch("Switch 1", 40, 2, 0),
      tracedSwitch("Switch 2", 60, 3, 2),         tracedSwitch("Switch 1 release", 30, 4, 1),
      tracedSwitch("T1 upstroke", 5, 5, 5),       tracedSwitch("T1 downstroke", 15, 6, 4)};
  const auto switches = switchesAmong(traces);
  REQUIRE(namesOf(switches) == Names{"Switch 1", "Switch 2", "T1"});
  CHECK(switches[0].pressColor == traces[1].color);
  CHECK(switches[0].releaseColor == traces[3].color);
  CHECK(switches[1].traces == std::vector<std::size_t>{2, 0});
  CHECK(switches[2].traces == std::vector<std::size_t>{5, 4});
}

TEST_CASE("Loops that the tracer parted in colours of their own need no legend", "[switches]") {
  std::vector<CurveTrace> traces{tracedSwitch("", 10, 1), tracedSwitch("", 20, 1), tracedSwitch("", 40, 2),
                                 tracedSwitch("", 50, 2)};
  traces[0].stroke = traces[2].stroke = Stroke::release;
  traces[1].stroke = traces[3].stroke = Stroke::press;
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 2);
  CHECK(switches[0].traces == std::vector<std::size_t>{3, 2});  // the higher one first
  CHECK(switches[1].traces == std::vector<std::size_t>{1, 0});
  CHECK(chosenSwitch(switches, traces, "2").value() == 1);
  // A legend by groups calls the strokes of each the same.
  traces[0].label = traces[2].label = "release", traces[1].label = traces[3].label = "press";
  CHECK(switchesAmong(traces).size() == 2);
}

TEST_CASE("Loops in one colour each have the name of their legend entry", "[switches]") {
  std::vector<CurveTrace> traces;
  for (const auto& [name, row] : {std::pair("Alpha", 0), {"Beta", 1}}) {
    std::vector<CurveTrace> strokes =
        loop(40 + 20 * row, 250 + 40 * row, 15, static_cast<std::uint8_t>(1 + 10 * row));
    strokes[1].color = strokes[0].color;
    strokes[0].stroke = Stroke::press, strokes[1].stroke = Stroke::release;
    for (CurveTrace& stroke : strokes) {
      stroke.label = name, stroke.labelBox_px = {400, 10.0 + 20 * row, 460, 22.0 + 20 * row};
      traces.push_back(stroke);
    }
  }
  CHECK(namesOf(switchesAmong(traces)) == Names{"Alpha", "Beta"});
}

TEST_CASE("Names that a program gives part no strokes of a loop, and join no curves that close none",
          "[switches]") {
  std::vector<CurveTrace> traces = loop(40, 300, 15, 1);
  traces[0].label = "data1", traces[1].label = "data2";
  REQUIRE(switchesAmong(traces).size() == 1);
  CHECK(switchesAmong(traces).front().traces == std::vector<std::size_t>{0, 1});
  traces[1].label = "Sample 2";
  CHECK(switchesAmong(traces).size() == 2);
  traces[1].label = "data2";
  for (Point& p : traces[1].points_px) p.y += 0.1 * p.x;
  REQUIRE(switchesAmong(traces).size() == 1);
  CHECK(switchesAmong(traces).front().sure == 0);
}

TEST_CASE("Of several curves without names those that close a loop are one switch's", "[switches]") {
  std::vector<CurveTrace> traces = loop(40, 300, 15, 1);
  const std::vector<CurveTrace> shorter = loop(70, 250, 15, 3);
  traces.insert(traces.begin() + 1, shorter.rbegin(), shorter.rend());  // 0 A, 1 B's release, 2 B, 3 A's
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 2);
  CHECK(switches[0].traces == std::vector<std::size_t>{2, 1});
  CHECK(switches[1].traces == std::vector<std::size_t>{0, 3});
  CHECK_FALSE(separateStrokes(traces, AxesFound{}).ok());

  SECTION("Of two samples of one switch those pair up that end in one point") {
    traces = loop(40, 300, 15, 1);
    const std::vector<CurveTrace> sample = loop(42, 297, 15, 3);
    traces.insert(traces.begin() + 1, sample.rbegin(), sample.rend());
    REQUIRE(switchesAmong(traces).size() == 2);
    CHECK(switchesAmong(traces)[0].traces == std::vector<std::size_t>{2, 1});
  }
  SECTION("Three that rise: one is a press alone") {
    traces.pop_back();
    CHECK(switchesAmong(traces).size() == 2);
  }
  SECTION("Strokes that cross close no loop") {
    traces = loop(40, 300, 15, 1);
    for (Point& p : traces[1].points_px)
      if (p.x < 150) p.y = traces[0].points_px[static_cast<std::size_t>(p.x)].y - 10;
    traces.insert(traces.end(), shorter.begin(), shorter.end());
    CHECK(switchesAmong(traces).size() == 3);
  }
  SECTION("Names of two switches are no press and release") {
    traces[0].label = "Switch A";
    traces[3].label = "Switch B";
    CHECK(switchesAmong(traces).size() == 3);
  }
}

TEST_CASE("A quantity that only falls belongs to no loop, however its fall wavers", "[switches]") {
  std::vector<CurveTrace> traces = loop(40, 300, 15, 1);
  CurveTrace resistance = tracedSwitch("", 0, 3);
  for (Point& p : resistance.points_px) p.y = p.x < 150 ? 40 : 280;
  for (double y = 40; y < 280; ++y) resistance.points_px.push_back({150 + 0.4 * std::sin(y), y});
  traces.push_back(resistance);
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 1);
  CHECK(switches[0].traces == std::vector<std::size_t>{0, 1});
}

TEST_CASE("Nothing is joined that does not belong together", "[switches]") {
  std::vector<CurveTrace> onOneBottomOut = loop(40, 300, 15, 1);
  onOneBottomOut.push_back(loop(60, 300, 0, 3)[0]);
  onOneBottomOut.back().points_px.back() = onOneBottomOut[0].points_px.back();
  CHECK(switchesAmong(onOneBottomOut).size() == 2);
  CHECK(switchesAmong({tracedSwitch("Brown press", 10, 1), tracedSwitch("Red release", 30, 2)}).empty());
  CHECK(switchesAmong({tracedSwitch("A press", 10, 1), tracedSwitch("A release", 30, 2),
                       tracedSwitch("A release", 50, 3)})
            .empty());
  CHECK(switchesAmong({}).empty());
}

TEST_CASE("Beside press and release a mark without a name is none of them", "[switches]") {
  const auto switches = switchesAmong(
      {tracedSwitch("press", 10, 1), tracedSwitch("lease", 30, 2), tracedSwitch("", 50, 3)});  // misread
  REQUIRE(switches.size() == 1);
  CHECK(switches[0].traces.size() == 2);
}

TEST_CASE("A line without a name that only falls is no stroke beside a named one", "[switches]") {
  CurveTrace arrow = tracedSwitch("", 0, 3);
  for (Point& p : arrow.points_px) p.y = 100 + 0.5 * p.x;
  std::ranges::reverse(arrow.points_px);  // traced from its tip
  const std::vector<CurveTrace> traces{tracedSwitch("press", 60, 1), arrow, tracedSwitch("", 10, 2)};
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 1);
  CHECK(switches[0].traces == std::vector<std::size_t>{0, 2});

  SECTION("One with a name is another curve") {
    CurveTrace named = arrow;
    named.label = "Voltage";
    named.labelBox_px = {400, 30, 460, 42};
    CHECK(switchesAmong({tracedSwitch("press", 60, 1), named, tracedSwitch("release", 10, 2, 1)}).size() ==
          2);
  }
  SECTION("One that rises again may be a stroke") {
    CurveTrace dip = arrow;
    for (Point& p : dip.points_px) p.y = 100 + std::abs(p.x - 200);
    CHECK(switchesAmong({tracedSwitch("press", 60, 1), dip, tracedSwitch("", 10, 2)}).empty());
  }
  SECTION("Where no legend names a stroke nothing is left out") {
    CHECK(switchesAmong({tracedSwitch("", 60, 1), arrow, tracedSwitch("", 10, 2)}).front().sure == 0);
  }
}

TEST_CASE("Two colours given by hand are a pair whatever the legend says", "[switches]") {
  std::vector<CurveTrace> traces{tracedSwitch("Switch A", 10, 1), tracedSwitch("Switch B", 30, 2)};
  traces[0].stroke = Stroke::press;
  traces[1].stroke = Stroke::release;
  CHECK(switchesAmong(traces).size() == 1);
}

TEST_CASE("Names that no list has are strokes' where their curves end in one point", "[switches]") {
  const auto found = [](const char* first, const char* second, double shorter_px = 0) {
    std::vector<CurveTrace> traces = loop(40, 300, 15, 1);
    traces[0].label = first, traces[1].label = second;
    for (Point& p : traces[1].points_px) p.x *= 1 - shorter_px / 300;
    return switchesAmong(traces);
  };
  REQUIRE(found("Plonger", "Sortir").size() == 1);
  CHECK(found("Plonger", "Sortir").front().name.empty());
  CHECK(found("Plonger", "Sortir").front().traces.size() == 2);
  CHECK(found("Plonger", "Sortir", 6).empty());  // with a bottom-out of its own
  for (const char* name : {"Brown", "Sortir 2", "K", "Type Sortir", "used"}) {
    INFO(name);
    CHECK(found("Plonger", name).size() == 2);
  }
}

TEST_CASE("A switch is requested by name or number", "[switches]") {
  const std::vector<CurveTrace> traces{tracedSwitch("Switch A", 40, 1, 0), tracedSwitch("Switch 8", 20, 2, 1),
                                       tracedSwitch("Gateron", 60, 3, 2),
                                       tracedSwitch("Gateron upstroke", 50, 4, 3)};
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 3);
  for (const auto& [wanted, index] : {std::pair{"Switch A", 0U},
                                      {"switch-a", 0U},
                                      {"SWITCH B", 1U},
                                      {"gateron", 2U},
                                      {"Gateron Upstroke", 2U},
                                      {"3", 2U},
                                      {"1", 0U}}) {
    INFO(wanted);
    const auto chosen = chosenSwitch(switches, traces, wanted);
    REQUIRE(chosen.ok());
    CHECK(*chosen == index);
  }
  for (const char* wanted : {"Switch C", "Switch", "4", "0", "-1", "1.5", "?"}) {
    INFO(wanted);
    const auto chosen = chosenSwitch(switches, traces, wanted);
    REQUIRE_FALSE(chosen.ok());
    CHECK(chosen.failure().code == FailureCode::wrongUsage);
    CHECK_THAT(chosen.failure().sentence(), Catch::Contains("\"Gateron\"") && Catch::Contains(wanted));
  }
}

TEST_CASE("One letter within a long word may be misread; one that distinguishes switches may not",
          "[switches]") {
  const auto chosen = [](const Names& read, const std::string& wanted) -> std::optional<std::size_t> {
    std::vector<CurveTrace> traces;
    for (const std::string& name : read)
      traces.push_back(tracedSwitch(name, 10 + 20 * static_cast<double>(traces.size()),
                                    static_cast<std::uint8_t>(traces.size() + 1),
                                    static_cast<int>(traces.size())));
    const auto found = chosenSwitch(switchesAmong(traces), traces, wanted);
    return found ? std::optional(*found) : std::nullopt;
  };
  CHECK(chosen({"Linear 45", "Tactlle 45"}, "Tactile 45") == 1U);
  CHECK(chosen({"Linear 45", "Tachile 45"}, "Tactile 45") == 1U);
  CHECK_FALSE(chosen({"Linear 45", "Tachlle 45"}, "Tactile 45"));
  CHECK_FALSE(chosen({"Linear 45", "Tactlle 55"}, "Tactile 45"));
  CHECK_FALSE(chosen({"Tactale", "Tactele"}, "Tactile"));
  CHECK_FALSE(chosen({"SwitchA", "SwitchC"}, "SwitchB"));
  CHECK_FALSE(chosen({"SwitchA", "Tactile"}, "SwitchB"));
  CHECK_FALSE(chosen({"Switch", "Tactile"}, "Kwitch"));
  CHECK_FALSE(chosen({"Alpha1x", "Tactile"}, "Alpha2x"));
  CHECK_FALSE(chosen({"Alpha1", "Alpha3"}, "Alpha2"));
  CHECK_FALSE(chosen({"Rod", "Blue"}, "Red"));
}

TEST_CASE("A name that was read near to the requested one is reported", "[switches]") {
  AxesFound axes;
  axes.calibration.value.viewToUnits = {0.01, 0, 0, 0, -0.005, 2, 0, 0, 1};
  const std::vector<CurveTrace> traces{tracedSwitch("Linear 45", 40, 1, 0),
                                       tracedSwitch("Tachile 4S", 20, 2, 1)};
  const auto near = [&](const std::string& wanted) {
    StrokeHints hints;
    hints.curve = wanted;
    const auto found = separateStrokes(traces, axes, hints);
    REQUIRE(found.ok());
    return std::ranges::count(found->evidence, EvidenceCode::nameNearly, &EvidenceItem::code) == 1;
  };
  CHECK(near("Tactile 4S"));
  CHECK(near("Holy Tachile 4S"));  // found by its end
  for (const char* wanted : {"tachile-45", "2", "Linear 45"}) CHECK_FALSE(near(wanted));
}

TEST_CASE("Presses in colours of their own that no switch could have both are offered by number",
          "[switches]") {
  AxesFound axes;
  axes.calibration.value.viewToUnits = {0.01, 0, 0, 0, -0.005, 2, 0, 0, 1};
  const std::vector<CurveTrace> shorter = loop(80, 220, 0, 1), longer = loop(20, 300, 0, 5);
  const std::vector<CurveTrace> shortest = loop(110, 150, 0, 7);
  CHECK(switchesAmong({longer[0], shorter[0]}).size() == 1);  // a release may have been cut short
  const std::vector<CurveTrace> apart{longer[0], shorter[0], shortest[0]};
  REQUIRE(switchesAmong(apart).size() == 3);
  CHECK_FALSE(separateStrokes(apart, axes).ok());
  StrokeHints hints;
  hints.curve = "1";
  const auto first = separateStrokes(apart, axes, hints);
  REQUIRE(first.ok());
  CHECK_FALSE(first->value.release);
  CHECK(first->value.press.points_px == shortest[0].points_px);  // the upper one counts first
  CHECK(first->confidence <= 0.6);  // nothing shows that this switch has no release

  SECTION("they end together, and cross") {
    std::vector<CurveTrace> crossing{tracedSwitch("", 10, 1), tracedSwitch("", 10, 5)};
    for (Point& p : crossing[0].points_px) p.y -= 30 * std::sin(2 * M_PI * p.x / 300);
    CHECK(switchesAmong(crossing).size() == 2);
    for (Point& p : crossing[0].points_px)  // a snap that comes earlier on the way back
      if (p.x > 150 && p.x < 240) p.y = 300 - 10 - 0.3 * p.x - 10;
    CHECK(switchesAmong(crossing).size() == 1);
    for (Point& p : crossing[0].points_px) p.x *= 0.95;  // a curve that ends elsewhere is another press
    CHECK(switchesAmong(crossing).size() == 2);
    crossing[0].color = crossing[1].color;  // strokes of one colour that the tracer may have exchanged
    CHECK(switchesAmong(crossing).size() == 1);
  }
  SECTION("of three and more each ends beside the others' lines, which no release does") {
    std::vector<CurveTrace> bottomOuts{tracedSwitch("", 10, 1), tracedSwitch("", 30, 2),
                                       tracedSwitch("", 50, 3)};
    CHECK(switchesAmong(bottomOuts).size() == 3);
    bottomOuts[1].label = "2.6 N";  // the one name that was read may be another curve's
    CHECK(switchesAmong(bottomOuts).empty());
    CHECK(switchesAmong({bottomOuts[0], bottomOuts[2]}).size() == 1);
  }
  SECTION("a mark beside a press") {
    CurveTrace mark = tracedSwitch("", 80, 7);
    mark.points_px.resize(60);
    CHECK(switchesAmong({longer[0], mark}).size() == 1);
  }
}

TEST_CASE("Strokes whose names were read alike are one switch's where they close a loop", "[switches]") {
  std::vector<CurveTrace> traces = loop(40, 300, 15, 1);
  traces[0].label = traces[1].label = "往路";
  CHECK(switchesAmong(traces).size() == 1);
  traces[1].points_px.resize(200);
  CHECK(switchesAmong(traces).size() == 2);
}

TEST_CASE("A name of which the legend key hid the beginning is found by its end", "[switches]") {
  const std::vector<CurveTrace> traces{tracedSwitch("ple 1", 40, 1, 0), tracedSwitch("Sample 2", 20, 2, 1),
                                       tracedSwitch("ple 3", 60, 3, 2)};
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 3);
  CHECK(chosenSwitch(switches, traces, "Sample 1").value() == 0);
  CHECK(chosenSwitch(switches, traces, "Sample 3").value() == 2);
  CHECK_FALSE(chosenSwitch(switches, traces, "Sample 4").ok());
}

TEST_CASE("Of two switches called the same only a number chooses", "[switches]") {
  const std::vector<CurveTrace> traces{tracedSwitch("Red", 40, 1, 0), tracedSwitch("Red", 20, 2, 1)};
  const auto switches = switchesAmong(traces);
  REQUIRE(switches.size() == 2);
  CHECK(chosenSwitch(switches, traces, "Red").failure().code == FailureCode::wrongUsage);
  CHECK(chosenSwitch(switches, traces, "2").value() == 1);
}

TEST_CASE("Several switches and none chosen: a doubt that names them", "[switches]") {
  AxesFound axes;
  axes.calibration.value.viewToUnits = {0.01, 0, 0, 0, -0.005, 2, 0, 0, 1};
  const std::vector<CurveTrace> traces{tracedSwitch("Switch A", 90, 1, 0),
                                       tracedSwitch("Switch B", 20, 2, 1)};
  const auto refused = separateStrokes(traces, axes);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.failure().code == FailureCode::notCertain);
  CHECK(refused.failure().reason == nameOf(DoubtCode::severalSwitches));
  CHECK_THAT(refused.failure().sentence(), Catch::Contains("1 \"Switch A\" (#142801), 2 \"Switch B\"") &&
                                               Catch::Contains("--curve NAME|N"));
  StrokeHints hints;
  hints.curve = "Switch C";
  const auto notThere = separateStrokes(traces, axes, hints);
  REQUIRE_FALSE(notThere.ok());
  CHECK(notThere.failure().code == FailureCode::wrongUsage);
  CHECK(notThere.failure().reason == nameOf(DoubtCode::severalSwitches));  // the editor lists them again
  hints.curve = "Switch B";
  const auto second = separateStrokes(traces, axes, hints);
  REQUIRE(second.ok());
  CHECK_FALSE(second->value.release);
  CHECK(second->value.press.points_px == traces[1].points_px);
}

TEST_CASE("A curve of several that the legend names twice is no press alone", "[switches]") {
  AxesFound axes;
  axes.calibration.value.viewToUnits = {0.01, 0, 0, 0, -0.005, 2, 0, 0, 1};
  const std::vector<CurveTrace> traces{tracedSwitch("Switch A", 90, 1, 0),
                                       tracedSwitch("Lark / Finch", 20, 2, 1)};
  StrokeHints hints;
  hints.curve = "2";
  const auto chosen = separateStrokes(traces, axes, hints);
  REQUIRE_FALSE(chosen.ok());
  CHECK(chosen.failure().reason == nameOf(DoubtCode::tooManyCurves));
  hints.curve = "1";
  CHECK(separateStrokes(traces, axes, hints).ok());
}

TEST_CASE("A curve whose end another switch's covers is not taken for the whole", "[switches]") {
  AxesFound axes;
  axes.calibration.value.viewToUnits = {0.01, 0, 0, 0, -0.005, 2, 0, 0, 1};
  CurveTrace whole = tracedSwitch("Switch A", 90, 1, 0), part = tracedSwitch("Switch B", 20, 2, 1);
  for (double y = whole.points_px.back().y; y > 0; --y) whole.points_px.push_back({301, y});
  StrokeHints hints;
  hints.curve = "Switch B";
  CHECK(separateStrokes({whole, part}, axes, hints).ok());
  for (double y = part.points_px.back().y; y > 110; --y)
    part.points_px.push_back({301, y});  // up the same bottom-out
  const auto hidden = separateStrokes({whole, part}, axes, hints);
  REQUIRE_FALSE(hidden.ok());
  CHECK(hidden.failure().code == FailureCode::notCertain);
  CHECK_THAT(hidden.failure().sentence(), Catch::Contains("covers it") && Catch::Contains("--press-line"));
  hints.curve = "Switch A";
  CHECK(separateStrokes({whole, part}, axes, hints).ok());
}

TEST_CASE("A stroke whose beginning lies under another switch's runs down with that one", "[switches]") {
  AxesFound axes;
  axes.calibration.value.viewToUnits = {0.01, 0, 0, 0, -0.005, 2, 0, 0, 1};
  CurveTrace steep = tracedSwitch("Switch A", 90, 1, 0), covered = tracedSwitch("Switch B", 40, 2, 1);
  steep.points_px.clear(), covered.points_px.clear();
  for (double x = 0; x < 9; x += 0.5) steep.points_px.push_back({x, 300 - 10 * x});
  for (double x = 9; x <= 300; ++x) steep.points_px.push_back({x, 210 - 0.3 * (x - 9)});
  for (double x = 4; x <= 300; ++x) covered.points_px.push_back({x, 260 - 0.2 * (x - 4)});
  StrokeHints hints;
  hints.curve = "Switch B";
  const auto found = separateStrokes({steep, covered}, axes, hints);
  REQUIRE(found.ok());
  const auto& points = found->value.press.points_px;
  CHECK(points.front() == Point{0, 300});
  CHECK(std::ranges::is_sorted(points, {}, &Point::x));
  CHECK(found->evidence.back().code == EvidenceCode::startUnderAnother);
  hints.curve = "Switch A";
  CHECK(separateStrokes({steep, covered}, axes, hints)->evidence.back().code !=
        EvidenceCode::startUnderAnother);
  hints.curve = "Switch B";
  // One that comes from afar is passed, not run down along.
  CurveTrace passing = steep;
  for (Point& p : passing.points_px)
    if (p.x < 9) p = {p.x * 10 - 81, 270 - 10 * p.x / 9};
  CHECK_FALSE(separateStrokes({passing, covered}, axes, hints).ok());
}
