// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/specs/printed_spec.h"

#include <catch2/catch.hpp>

#include "model/force_graph.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// A page whose rows stand 20 pt apart, each split into cells.
Page pageWith(const std::vector<std::vector<std::string>>& rows) {
  Page page;
  page.number = 3;
  double y = 100;
  for (const auto& cells : rows) {
    double x = 50;
    for (const auto& cell : cells) {
      page.texts.push_back({cell, {x, y, x + 40, y + 10}, 0});
      x += 60;
    }
    y += 20;
  }
  return page;
}

PrintedSpec only(const std::vector<std::vector<std::string>>& rows) {
  const auto specs = readPrintedSpecs(pageWith(rows));
  REQUIRE(specs.size() == 1);
  return specs.front();
}

Button tactileButton() {
  auto press =
      StrokeCurve::fromKnots({{0, 0.3, 0, 0.1}, {1.2, 0.55, 0, 0}, {1.8, 0.40, 0, 0}, {4.0, 0.60, 0.1, 0}});
  REQUIRE(press);
  auto graph = ForceGraph::fromCurves(*press, {});
  REQUIRE(graph);
  auto button = Button::fromStates("b", {{"", *graph, 2.0, {}, {}}});
  REQUIRE(button);
  return *button;
}

}  // namespace

TEST_CASE("Tolerances in the forms of datasheets become bounds in mm and N") {
  const auto pressure = only({{"• Pressure point force: 55 ± 25 cN"}});
  CHECK(pressure.quantity == SpecQuantity::tactileForce);
  CHECK(pressure.nominal == Approx(0.55));
  CHECK(pressure.smallest.value() == Approx(0.30));
  CHECK(pressure.largest.value() == Approx(0.80));
  CHECK(pressure.page == 3);

  const auto travel = only({{"Actuator travel: 4,0 – 0,4 mm"}});
  CHECK(travel.quantity == SpecQuantity::totalTravel);
  CHECK(travel.smallest.value() == Approx(3.6));
  CHECK(travel.largest.value() == Approx(4.0));

  const auto uneven = only({{"Pre-Travel 1.7+0.4/-0.3 mm"}});
  CHECK(uneven.nominal == Approx(1.7));
  CHECK(uneven.smallest.value() == Approx(1.4));
  CHECK(uneven.largest.value() == Approx(2.1));

  const auto unitInside = only({{"Pre Travel 预: 1.3mm±0.30"}});
  CHECK(unitInside.nominal == Approx(1.3));
  CHECK(unitInside.largest.value() == Approx(1.6));

  const auto numbered = only({{"9.Total travel:4.0mm"}});
  CHECK(numbered.nominal == Approx(4));
  CHECK(only({{"4.0 mm", "Total travel"}}).nominal == Approx(4));

  const auto minimum = only({{"Actuation force: 30 cN min."}});
  CHECK(minimum.smallest.value() == Approx(0.3));
  CHECK_FALSE(minimum.largest);
}

TEST_CASE("Cells of one row of a table are read together, whatever the language") {
  const auto force = only({{"OF(操作力)", "gf", "50±10"}});
  CHECK(force.quantity == SpecQuantity::operatingForce);
  CHECK(force.nominal == Approx(50 * 0.00980665));
  CHECK(only({{"TT（总行程）", "mm", "3.5±0.4"}}).quantity == SpecQuantity::totalTravel);
  CHECK(only({{"PT (导通行程)", "mm", "1.40±0.4"}}).nominal == Approx(1.4));
  CHECK(only({{"Vorlaufweg 2 ± 0,6 mm"}}).quantity == SpecQuantity::preTravel);
}

TEST_CASE("Of a row with several variants the one counts that the graph shows") {
  const auto checked = [](const std::vector<std::string>& cells) {
    const auto checks = checkAgainst(readPrintedSpecs(pageWith({cells})), tactileButton());
    REQUIRE(checks.size() == 1);
    return checks.front();
  };
  CHECK(checked({"Total travel", "3,0", "4,0", "mm"}).agrees);
  CHECK(checked({"Total travel", "3 mm", "4,0 mm"}).spec.nominal == Approx(4));
  CHECK(checked({"Total travel (mm)", "3.0±0.2", "4.0±0.2", "5.0±0.2"}).agrees);
  const auto none = checked({"Total travel", "3,0", "3,4", "mm"});
  CHECK_FALSE(none.agrees);
  CHECK(none.spec.nominal == Approx(3.4));
  // A value of another unit, or of a bound, is no variant.
  CHECK(only({{"Total travel 3.5 mm (4.0 inch)"}}).nominal == Approx(3.5));
  CHECK(only({{"Total travel 3.5 mm, min. 4 mm"}}).nominal == Approx(3.5));
}

TEST_CASE("Rows that say nothing about the graph give nothing") {
  CHECK(readPrintedSpecs(pageWith({{"Soldering temperature 350±5 °C"}})).empty());
  CHECK(readPrintedSpecs(pageWith({{"Total travel"}, {"see drawing"}})).empty());
  CHECK(readPrintedSpecs(pageWith({{"Operating force 60 ± 20"}})).empty());  // no unit: no guess
  CHECK(readPrintedSpecs(pageWith({{"50 of 60 mm"}})).empty());              // "of" is a word here
  CHECK(readPrintedSpecs(Page{}).empty());
}

TEST_CASE("The word \"in\" is no inch") {
  // A section number, a quantity, a direction.
  CHECK(readPrintedSpecs(pageWith({{"3.1 Total travel in operating direction"}})).empty());
  CHECK(readPrintedSpecs(pageWith({{"3.1 总行程 in operating direction"}})).empty());
  CHECK(only({{"Total travel: 0.16 in"}}).nominal == Approx(0.16 * 25.4));
  CHECK(only({{"Total travel (in): 0.16"}}).nominal == Approx(0.16 * 25.4));
  CHECK(only({{"Total travel [in]", "0.16"}}).nominal == Approx(0.16 * 25.4));
  CHECK(only({{"Total travel in mm: 4.0"}}).nominal == Approx(4));
  const auto variants = readPrintedSpecs(pageWith({{"Total travel 0.12 in", "0.16 in"}}));
  REQUIRE(variants.size() == 2);
  CHECK(variants.back().nominal == Approx(0.16 * 25.4));
}

TEST_CASE("Printed values are held against what the graph shows") {
  const auto specs = readPrintedSpecs(pageWith(
      {{"Pressure point force 55 ± 5 cN"}, {"Total travel 3.5 ± 0.2 mm"}, {"Pretravel 2 ± 0.6 mm"}}));
  const auto checks = checkAgainst(specs, tactileButton());
  REQUIRE(checks.size() == 3);
  CHECK(checks[0].agrees);
  CHECK_FALSE(checks[1].agrees);
  CHECK(checks[1].read == Approx(4.0));
  CHECK_THAT(english(messageOf(checks[1])),
             Catch::Contains("total travel differs from the page: 4 mm read, 3.5 mm printed (page 3"));
  CHECK(checks[2].agrees);
}
