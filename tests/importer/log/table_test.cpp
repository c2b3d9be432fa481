// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/table.h"

#include <catch2/catch.hpp>

#include "importer/log/column_words.h"
#include "importer/log/data_columns.h"

using namespace detent;
using namespace detent::importer;

namespace {

Table tableFrom(const std::string& text) {
  auto table = tableOfText(text, "table", {});
  REQUIRE(table);
  return std::move(*table);
}

}  // namespace

TEST_CASE("delimiter, decimal sign and thousands separator are decided for the whole file") {
  struct Case {
    const char* text;
    double first, last;  // of the last row
  };
  const Case cases[] = {
      {"x,f\n0.1,2.5\n0.2,2.6\n0.3,2.7\n", 0.3, 2.7},
      {"x;f\n0,1;2,5\n0,2;2,6\n0,3;2,7\n", 0.3, 2.7},
      {"x\tf\n0,1\t2,5\n0,2\t2,6\n0,3\t2,7\n", 0.3, 2.7},
      {"0,005 0,72\n0,010 0,80\n0,015 0,85\n", 0.015, 0.85},
      {"0.02 ,0.00 \n0.03 ,0.10 \n0.04 ,0.20 \n", 0.04, 0.2},
      {"\"0,005\",\"0,72\"\n\"0,010\",\"0,80\"\n\"0,015\",\"0,85\"\n", 0.015, 0.85},
      {"x;f\n998;1\n999;2\n1 000;3\n1 001;4\n", 1001, 4},
      {"x;f\n998;1\n999;2\n1\xE2\x80\xAF"
       "000;3\n1\xE2\x80\xAF"
       "001;4\n",
       1001, 4},
      {"x;f\n998;1\n999;2\n1'000;3\n1'001;4\n", 1001, 4},
      {"x;f\n998,5;1\n999,5;2\n1.000,5;3\n1.001,5;4\n", 1001.5, 4},
      {"\"998\",\"1\"\n\"999\",\"2\"\n\"1,000\",\"3\"\n\"1,001\",\"4\"\n", 1001, 4},
      {"0,0078,0,1062\n0,0157,0,2117\n0,0235,0,3243\n0,0313,0,4345\n", 0.0313, 0.4345},
      {"1;2\n2;3\n3;4\n", 3, 4},
  };
  for (const Case& c : cases) {
    CAPTURE(c.text);
    const Table table = tableFrom(c.text);
    const std::size_t row = table.rows() - 1;
    REQUIRE(table.number(row, 0));
    REQUIRE(table.number(row, 1));
    CHECK(table.number(row, 0)->value == Approx(c.first));
    CHECK(table.number(row, 1)->value == Approx(c.last));
  }
}

TEST_CASE("a quoted field may hold a line break and doubled quotes") {
  const Table table = tableFrom("\"Time\n(s)\",\"Travel \"\"A\"\" (mm)\"\n0,1\n1,2\n2,3\n");
  CHECK(table.rows() == 4);
  CHECK(table.cell(0, 0) == "Time\n(s)");
  CHECK(table.cell(0, 1) == "Travel \"A\" (mm)");
  CHECK(table.line(1) == 3);
}

TEST_CASE("numbers in cells") {
  const NumberStyle plain;
  const auto value = [&](std::string_view cell) -> std::optional<double> {
    const auto number = numberIn(cell, plain);
    return number ? std::optional(number->value) : std::nullopt;
  };
  CHECK(value("+12.5") == 12.5);
  CHECK(value("-1e-3") == -1e-3);
  CHECK(value("\xE2\x88\x92"
              "0.5") == -0.5);
  CHECK(value("12.5 gf") == 12.5);
  CHECK(numberIn("12.50gf", plain)->rest == "gf");
  CHECK(numberIn("12.50gf", plain)->decimals == 2);
  // The last digit counts as much with an exponent as without.
  CHECK(numberIn("0.00025", plain)->decimals == 5);
  CHECK(numberIn("2.5e-4", plain)->decimals == 5);
  CHECK(numberIn("+2.50E+01", plain)->decimals == 1);
  CHECK(numberIn("1.5e3", plain)->decimals == -2);
  CHECK(numberIn("2,5e-4 mm", NumberStyle{',', 0})->decimals == 5);
  CHECK_FALSE(numberIn("0000 mm;0", plain));
  for (const char* none : {"12:30:01", "2024-05-01", "1,5", "gf", "", "2026/03/11"}) {
    CAPTURE(none);
    CHECK_FALSE(value(none));
  }
}

TEST_CASE("text in any encoding") {
  CHECK(utf8From("\xEF\xBB\xBFmm") == "mm");
  CHECK(utf8From(std::string("\xFF\xFEm\0m\0", 6)) == "mm");
  CHECK(utf8From(std::string("\xFE\xFF\0m\0m", 6)) == "mm");
  CHECK(utf8From("Pr\xFC"
                 "fzeit") ==
        "Pr\xC3\xBC"
        "fzeit");
  CHECK_FALSE(utf8From(std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16)));
}

TEST_CASE("a charset of one country is recognised by the words that it gives") {
  struct Case {
    std::string bytes, text;
  };
  for (const Case& c :
       {Case{"\x95\xCF\x88\xCA,\x89\xD7\x8F"
             "d",
             "変位,荷重"},
        Case{"\xBA\xAF\xC0\xA7,\xC7\xCF\xC1\xDF", "변위,하중"}, Case{"\xCE\xBB\xD2\xC6,\xC1\xA6", "位移,力"},
        Case{"\xD3\xF1\xE8\xEB\xE8\xE5,\xD5\xEE\xE4", "Усилие,Ход"},
        Case{"Pr\xFC"
             "fkraft,Weg",
             "Prüfkraft,Weg"}}) {
    CAPTURE(c.text);
    CHECK(utf8From(c.bytes) == c.text);
  }
}

TEST_CASE("units are parsed whole") {
  using Kind = ColumnUnit::Kind;
  struct Case {
    const char* text;
    Kind kind;
    double size;
  };
  for (const Case& c :
       {Case{"mm", Kind::displacement, 1}, Case{"(N)", Kind::force, 1}, Case{"daN", Kind::force, 10},
        Case{"kgF", Kind::force, 9.80665}, Case{"(x0.1 N)", Kind::force, 0.1},
        Case{"10^-3 N", Kind::force, 1e-3}, Case{"mN", Kind::force, 1e-3}, Case{"mm/mm", Kind::other, 1},
        Case{"mm/s", Kind::other, 1}, Case{"N/mm\xC2\xB2", Kind::other, 1}, Case{"N/mm", Kind::other, 1},
        Case{"N\xC2\xB7mm", Kind::other, 1}, Case{"MPa", Kind::other, 1}, Case{"N m", Kind::other, 1},
        Case{"N s", Kind::other, 1}, Case{"1/10 mm", Kind::displacement, 0.1},
        Case{"1/64 in", Kind::displacement, 25.4 / 64}, Case{"furlong", Kind::unknown, 1},
        Case{"", Kind::none, 1}}) {
    CAPTURE(c.text);
    CHECK(unitOf(c.text).kind == c.kind);
    CHECK(unitOf(c.text).size == Approx(c.size));
  }
}

TEST_CASE("a title is a name and a unit") {
  struct Case {
    const char* title;
    const char* name;
    ColumnUnit::Kind kind;
  };
  using Kind = ColumnUnit::Kind;
  for (const Case& c :
       {Case{"Displacement (mm)", "Displacement", Kind::displacement},
        Case{"Weg in mm", "Weg", Kind::displacement}, Case{"Kraft / mN", "Kraft", Kind::force},
        Case{"force_N", "force", Kind::force}, Case{"Weg in Schritten", "Weg in Schritten", Kind::none},
        Case{"mm", "", Kind::displacement}, Case{"Force A (gf)", "Force A", Kind::force},
        Case{"Force min (N)", "Force min", Kind::force}, Case{"ForceLb", "Force", Kind::force},
        Case{"TravelIn", "Travel", Kind::displacement}, Case{"loadGf", "load", Kind::force},
        Case{"travelUm", "travel", Kind::displacement}, Case{"Force Lb", "Force", Kind::force},
        Case{"Force [Lb]", "Force", Kind::force}, Case{"PlugIn", "PlugIn", Kind::none},
        Case{"ForceIn", "ForceIn", Kind::none},
        Case{"\xE8\x8D\xB7\xE9\x87\x8D(N)", "\xE8\x8D\xB7\xE9\x87\x8D", Kind::force}}) {
    CAPTURE(c.title);
    const SplitTitle split = splitTitle(c.title);
    CHECK(split.name == c.name);
    CHECK(split.unit.kind == c.kind);
  }
}

TEST_CASE("columns are called what their words and units say") {
  struct Case {
    const char* header;
    std::size_t displacement, force;
  };
  for (const Case& c : {Case{"Displacement (mm);Force (gf)", 0, 1}, Case{"Weg in mm;Kraft in cN", 0, 1},
                        Case{"Standardweg (mm);Standardkraft (N)", 0, 1},
                        Case{"\xE8\xA1\x8C\xE7\xA8\x8B(mm);\xE5\x8A\x9B(gf)", 0, 1},
                        Case{"Charge (N);D\xC3\xA9placement (mm)", 1, 0}, Case{"mm;g", 0, 1},
                        Case{"Load line displacement (mm);Load (N)", 0, 1},
                        Case{"Force gauge position (mm);Force (N)", 0, 1}}) {
    CAPTURE(c.header);
    const auto data = dataIn(tableFrom(std::string(c.header) + "\n0;1\n1;2\n2;3\n"));
    REQUIRE(data);
    REQUIRE(data->columns.size() == 2);
    CHECK(data->columns[c.displacement].displacement >= 2);
    CHECK(data->columns[c.force].force >= 2);
    CHECK(data->columns[c.displacement].force < 0);
    CHECK(data->columns[c.force].displacement < 0);
  }
}

TEST_CASE("ounces are a force where a force is named") {
  const auto forceOf = [](const char* header) {
    const auto data = dataIn(tableFrom(std::string(header) + "\n0;1\n1;2\n2;3\n"));
    return data->columns[1].force;
  };
  CHECK(forceOf("Travel (mm);Force (oz)") >= 2);
  CHECK(forceOf("mm;oz") >= 2);
  CHECK(forceOf("Crosshead (mm);Δύναμη (oz)") >= 2);  // words of lists have no accents
  CHECK(forceOf("Travel (mm);Filling (oz)") < 0);
}

TEST_CASE("delimiter and decimal comma are distinguished where units stand behind the numbers") {
  const Table table = tableFrom("Weg;Kraft\n0,0 um;0,0004 N\n27,5 um;0,0285 N\n55,0 um;0,0573 N\n");
  CHECK(table.style.decimalSign == ',');
  CHECK(table.cells(1) == 2);
}
