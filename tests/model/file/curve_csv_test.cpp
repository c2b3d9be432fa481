// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/curve_csv.h"

#include <catch2/catch.hpp>

#include "model/file/travel_steps.h"
#include "model/templates.h"

using namespace detent;

namespace {

constexpr const char* header = "stroke,displacement_mm,force_N\n";

void requireCsvRefusal(const Result<ForceGraph>& result, int exitCode, const std::string& part) {
  REQUIRE_FALSE(result.ok());
  INFO(result.failure().sentence());
  CHECK(result.failure().exitCode() == exitCode);
  CHECK_THAT(result.failure().sentence(), Catch::Contains(part));
  CHECK(english(result.failure().subject.name) == "a.csv");
}

Result<ForceGraph> read(const std::string& rows) { return graphFromCsv(header + rows, "a.csv"); }

}  // namespace

TEST_CASE("rows are written in the order travelled, ends and vertical pieces exact") {
  const ForceGraph graph = tactileButton()->states()[0].graph;
  const std::string text = csvFrom(graph);
  CHECK(text.rfind(header, 0) == 0);
  const auto lines = polylinesFromCsv(text, "a.csv");
  REQUIRE(lines.ok());
  CHECK(lines->press == polylinesOf(graph).press);
  CHECK(lines->release == polylinesOf(graph).release);
  CHECK(lines->press.front() == CurvePoint{0, 0.3});
  CHECK(lines->press.back() == CurvePoint{4, 1.2});
  CHECK(lines->release.front() == CurvePoint{4, 1.2});
  CHECK(lines->press.size() < 400);
}

TEST_CASE("a graph survives the CSV within the stated tolerance") {
  for (const auto& button : {linearButton(), tactileButton(), clickyButton(), twoLevelButton()}) {
    const ForceGraph& graph = button->states()[0].graph;
    const auto again = graphFromCsv(csvFrom(graph), "a.csv");
    REQUIRE(again.ok());
    const auto distance = compare(polylinesOf(graph), polylinesOf(*again));
    REQUIRE(distance.ok());
    CHECK(distance->maxOfSpan < 4e-4);
    CHECK(again->press().knots().size() <= 2 * graph.press().knots().size() + 2);
  }
}

// As read off a page that prints 4 mm.
TEST_CASE("even steps end at the step that the end was printed as") {
  const auto press = StrokeCurve::throughPoints(std::vector<CurvePoint>{{0, 0.3}, {3.99976856638, 0.7}});
  REQUIRE(press.ok());
  const auto graph = ForceGraph::fromCurves(*press, {});
  REQUIRE(graph.ok());
  const auto travels_mm = travelsAtEach(0.1, *graph);
  REQUIRE(travels_mm.ok());
  CHECK(travels_mm->size() == 41);
  const std::string csv = csvAtTravels(*travels_mm, *graph);
  CHECK_THAT(csv, Catch::EndsWith("\npress,4,0.7\n"));
  CHECK(travelsWithin({4}, *graph).ok());
  CHECK_FALSE(travelsWithin({4.01}, *graph).ok());
  // An end between two steps stays where it is.
  const auto coarse_mm = travelsAtEach(1.5, *graph);
  REQUIRE(coarse_mm.ok());
  CHECK(*coarse_mm == std::vector<double>{0, 1.5, 3, 3.99976856638});
}

TEST_CASE("a table at even steps holds both ends of each bottom-out") {
  struct Case {
    std::vector<Knot> press, release;
    const char *pressEnds, *releaseBegins;
  };
  const Case cases[] = {
      {{{0, 0.2, 0.1, 0.1}, {4, 0.6, 0.1, 0}, {4, 1, 0, 0}},  // vertical, at a step
       {{0, 0.1, 0.1, 0.1}, {4, 0.5, 0.1, 0}, {4, 1, 0, 0}},
       "press,3,0.5\npress,4,0.6\npress,4,1\n",
       "release,4,1\nrelease,4,0.5\nrelease,3,0.4\n"},
      {{{0, 0.2, 0.1, 0.1}, {4.0003, 0.60003, 0.1, 0}, {4.0003, 1, 0, 0}},  // as read off a page
       {{0, 0.1, 0.1, 0.1}, {4.0003, 0.50003, 0.1, 0}, {4.0003, 1, 0, 0}},
       "press,3,0.5\npress,4,0.60003\npress,4,1\n",
       "release,4,1\nrelease,4,0.50003\nrelease,3,0.4\n"},
      {{{0, 0.2, 0.1, 0.1}, {3.5, 0.55, 0.1, 5}, {3.6, 1.05, 5, 0}},  // steep, between steps
       {{0, 0.1, 0.1, 0.1}, {3.4, 0.44, 0.1, 3.05}, {3.6, 1.05, 3.05, 0}},
       "press,3.5,0.55\npress,3.6,1.05\n",
       "release,3.4,0.44\nrelease,3,0.4\n"},
  };
  for (const Case& each : cases) {
    const auto graph = ForceGraph::fromCurves(StrokeCurve::fromKnots(each.press).value(),
                                              StrokeCurve::fromKnots(each.release).value());
    REQUIRE(graph.ok());
    const auto travels_mm = travelsAtEach(1, *graph);
    REQUIRE(travels_mm.ok());
    const std::string csv = csvAtTravels(*travels_mm, *graph);
    CHECK_THAT(csv, Catch::Contains(each.pressEnds));
    CHECK_THAT(csv, Catch::Contains(each.releaseBegins));
  }
}

TEST_CASE("a press alone is a graph without release") {
  const auto graph = read("press,0,0\npress,1,1\n");
  REQUIRE(graph.ok());
  CHECK_FALSE(graph->release().has_value());
  CHECK(csvFrom(*graph).find("release") == std::string::npos);
}

TEST_CASE("a byte order mark, CRLF, spaces, blank lines and a missing last newline are tolerated") {
  const auto graph = graphFromCsv(
      "\xEF\xBB\xBFstroke,displacement_mm,force_N\r\npress, 0 ,+0.5\r\n\r\npress,1e0,1", "a.csv");
  REQUIRE(graph.ok());
  CHECK(graph->press().force_N(0) == 0.5);
}

TEST_CASE("faults are refused with their line") {
  requireCsvRefusal(graphFromCsv("", "a.csv"), 3, "line 1: the line is \"\", not the header");
  requireCsvRefusal(graphFromCsv("time,force\n1,2\n", "a.csv"), 3, "Use detent-import");
  requireCsvRefusal(read(""), 4, "has a header but no rows");
  requireCsvRefusal(read("release,1,1\nrelease,0,0\n"), 4, "has no press rows");
  requireCsvRefusal(read("press,0,0\npress,1\n"), 3, "line 3: the line does not have 3 fields");
  requireCsvRefusal(read("press,0,0\npush,1,1\n"), 3, "line 3: the line names the stroke \"push\"");
  requireCsvRefusal(read("press,0,0\npress,one,1\n"), 3, "line 3: displacement \"one\"");
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "", "1,5", "0x10", "1 2"})
    CHECK(read(std::string("press,0,0\npress,1,") + bad + "\n").failure().exitCode() == 3);
  requireCsvRefusal(read("press,0,0\n"), 3, "press rows");
  requireCsvRefusal(read("press,0,0\npress,1,1\npress,0.5,1\n"), 3,
                    "press rows, point 3: the displacement 0.5 mm lies before");
  requireCsvRefusal(read("press,0,0\npress,1,1\nrelease,0,0\nrelease,1,1\n"), 3, "release rows, point 1");
  requireCsvRefusal(read("press,-1,0\npress,1,1\n"), 3, "starts at -1 mm");
}
