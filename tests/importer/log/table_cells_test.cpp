// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/table_cells.h"

#include <catch2/catch.hpp>

#include "importer/log/log_columns.h"

using namespace detent;
using namespace detent::importer;

TEST_CASE("the format of a table is told from its numbers") {
  const auto formatIs = [](const std::vector<std::string>& lines, char delimiter, char decimalSign) {
    const TableFormat format = formatOf(lines);
    return format.delimiter == delimiter && format.decimalSign == decimalSign;
  };
  CHECK(formatIs({"x,f", "0.1,2.5", "0.2,2.6"}, ',', '.'));
  CHECK(formatIs({"x;f", "0,1;2,5", "0,2;2,6"}, ';', ','));
  CHECK(formatIs({"x;f", "0.1;2.5", "0.2;2.6"}, ';', '.'));
  CHECK(formatIs({"x\tf", "0,1\t2,5", "0,2\t2,6"}, '\t', ','));
  CHECK(formatIs({"0,005 0,72", "0,010 0,80"}, ' ', ','));
  CHECK(formatIs({"0.005, 0.72", "0.010, 0.80"}, ',', '.'));
  CHECK(formatIs({"\"0,005\",\"0,72\"", "\"0,010\",\"0,80\""}, ',', ','));
  CHECK(formatIs({"1;2", "2;3"}, ';', '.'));
}

TEST_CASE("numbers in cells") {
  CHECK(wholeNumberIn("12.5", '.') == 12.5);
  CHECK(wholeNumberIn("+12.5", '.') == 12.5);
  CHECK(wholeNumberIn("-1e-3", '.') == -1e-3);
  CHECK(wholeNumberIn("12,5", ',') == 12.5);
  CHECK(wholeNumberIn("\xE2\x88\x92"
                      "0.5",
                      '.') == -0.5);
  CHECK(wholeNumberIn("12.5 gf", '.') == 12.5);
  CHECK(numberIn("12,5gf", ',')->rest == "gf");
  CHECK_FALSE(wholeNumberIn("12:30:01", '.'));
  CHECK_FALSE(wholeNumberIn("2024-05-01", '.'));
  CHECK_FALSE(wholeNumberIn("1,5", '.'));
  CHECK_FALSE(wholeNumberIn("gf", '.'));
  CHECK_FALSE(wholeNumberIn("", '.'));
}

TEST_CASE("columns are told by their titles in four languages") {
  struct Case {
    const char* header;
    LengthUnit x;
    ForceUnit f;
  };
  const Case cases[] = {{"Displacement (mm);Force (gf)", LengthUnit::millimetre, ForceUnit::gramForce},
                        {"Position [in];Load [lbf]", LengthUnit::inch, ForceUnit::poundForce},
                        {"Weg in mm;Kraft in cN", LengthUnit::millimetre, ForceUnit::centinewton},
                        {"Hub / \xC2\xB5m;Kraft / mN", LengthUnit::micrometre, ForceUnit::millinewton},
                        {"行程(mm);力(gf)", LengthUnit::millimetre, ForceUnit::gramForce},
                        {"位移 mm;载荷 N", LengthUnit::millimetre, ForceUnit::newton},
                        {"変位 (mm);荷重 (N)", LengthUnit::millimetre, ForceUnit::newton},
                        {"displacement_mm;force_N", LengthUnit::millimetre, ForceUnit::newton},
                        {"mm;g", LengthUnit::millimetre, ForceUnit::gramForce}};
  for (const Case& c : cases) {
    CAPTURE(c.header);
    const auto columns = columnsOf({c.header, "0;1", "1;2", "2;3"}, {';', '.'});
    REQUIRE(columns);
    REQUIRE(columns->pairs.size() == 1);
    CHECK(columns->pairs[0].displacement == 0);
    CHECK(columns->pairs[0].force == 1);
    CHECK(columns->xUnit == c.x);
    CHECK(columns->yUnit == c.f);
  }
}

TEST_CASE("force before displacement, clocks and row numbers are no trouble") {
  const auto columns =
      columnsOf({"No.;Time (s);Load (N);Travel (mm)", "1;0.0;0.1;0.00", "2;0.1;0.2;0.01", "3;0.2;0.3;0.02"},
                {';', '.'});
  REQUIRE(columns);
  CHECK(columns->pairs[0].displacement == 3);
  CHECK(columns->pairs[0].force == 2);

  const auto untitled =
      columnsOf({"0.0;0.00;0.10", "0.1;0.01;0.20", "0.2;0.02;0.25", "0.3;0.01;0.3"}, {';', '.'});
  REQUIRE(untitled);
  CHECK(untitled->pairs[0].displacement == 1);
  CHECK(untitled->pairs[0].force == 2);
}

TEST_CASE("units may stand in a line of their own or behind the numbers") {
  const auto below = columnsOf({"Position,Load", "mm,N", "0,1", "1,2", "2,3"}, {',', '.'});
  REQUIRE(below);
  CHECK(below->xUnit == LengthUnit::millimetre);
  CHECK(below->yUnit == ForceUnit::newton);
  const auto behind = columnsOf({"0 mm,10 gf", "1 mm,20 gf", "2 mm,30 gf"}, {',', '.'});
  REQUIRE(behind);
  CHECK(behind->xUnit == LengthUnit::millimetre);
  CHECK(behind->yUnit == ForceUnit::gramForce);
}

TEST_CASE("words for strokes") {
  CHECK(strokeNamed("Press force") == Stroke::press);
  CHECK(strokeNamed("Upstroke (gf)") == Stroke::release);
  CHECK(strokeNamed("Unloading") == Stroke::release);
  CHECK(strokeNamed("回程") == Stroke::release);
  CHECK(strokeNamed("Rückweg") == Stroke::release);
  CHECK_FALSE(strokeNamed("Force (gf)"));
}
