// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/number_table.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "tests/model/file/test_folder.h"

using namespace detent;

TEST_CASE(
    "a table's lines: blank ones and comments are counted and passed over, fields stand without blanks") {
  NumberTable table("\xEF\xBB\xBF# why\r\n\r\n time_s , force_N\r\n1, +2.5 ,\n\n  #\n3");
  REQUIRE(table.next());
  CHECK(table.number() == 3);
  CHECK(table.line() == "time_s , force_N");
  CHECK(table.columns({"force_N", "time_s"}) == std::vector<std::size_t>{1, 0});
  CHECK_FALSE(table.columns({"force_N", "raw"}));
  REQUIRE(table.next());
  CHECK(table.place() == "line 4");
  CHECK(table.fields() == std::vector<std::string_view>{"1", "+2.5", ""});
  CHECK(table.finite(1) == 2.5);
  CHECK_FALSE(table.finite(2));
  CHECK_FALSE(table.finite(3));
  REQUIRE(table.next());
  CHECK(table.number() == 7);
  CHECK_FALSE(table.next());
  CHECK_FALSE(NumberTable("\n# nothing\n").next());
}

TEST_CASE("a table's fields may stand in quotation marks, as R's write.csv and jsPsych's csv() write them") {
  using Fields = std::vector<std::string_view>;
  NumberTable table(
      "\"participant\",\"press_s\"\r\n\"P 1\",0.5\n\"a,b\" , \"say "
      "\"\"no\"\"\"\n\"two\r\nlines\",\"\"\n5\",\"\n\"open,1\n\"x\"y,2\nz,3");
  REQUIRE(table.next());
  CHECK(table.is({"participant", "press_s"}));
  CHECK_FALSE(table.is({"participant"}));
  CHECK(table.columns({"press_s"}) == std::vector<std::size_t>{1});
  REQUIRE(table.next());
  CHECK(table.fields() == Fields{"P 1", "0.5"});
  CHECK(table.finite(1) == 0.5);
  REQUIRE(table.next());
  CHECK(table.fields() == Fields{"a,b", "say \"no\""});
  REQUIRE(table.next());
  CHECK(table.fields() == Fields{"two\r\nlines", ""});
  CHECK(table.number() == 4);
  REQUIRE(table.next());  // "5," and a lone mark
  CHECK(table.number() == 6);
  CHECK(table.place() != "line 6");
  REQUIRE(table.next());
  CHECK(table.number() == 7);
  CHECK(table.fields() == Fields{"\"open", "1"});
  CHECK(table.place() != "line 7");
  REQUIRE(table.next());
  CHECK(table.place() != "line 8");
  REQUIRE(table.next());
  CHECK(table.place() == "line 9");
  CHECK(table.fields() == Fields{"z", "3"});
  CHECK_FALSE(table.next());
}

TEST_CASE("a first column without a name, where R and pandas number their rows, is left out") {
  for (const char* text : {"\"\",\"time_s\",\"force_N\"\n\"1\",0,0.5\n", ",time_s,force_N\n0,0,0.5\n"}) {
    NumberTable table(text);
    REQUIRE(table.next());
    CHECK(table.is({"time_s", "force_N"}));
    REQUIRE(table.next());
    CHECK(table.finite(0) == 0);
    CHECK(table.finite(1) == 0.5);
    CHECK(table.fields().size() == 2);
  }
}

TEST_CASE("a field is a number as a whole or not at all") {
  CHECK(numberFrom(" -1e-3\r") == -1e-3);
  CHECK(std::isnan(*numberFrom("nan")));
  CHECK(std::isinf(*numberFrom("1e999")));
  for (const char* none : {"", " ", "+", "1 2", "1,5", "0x10", "--1", "1e"}) {
    INFO(none);
    CHECK_FALSE(numberFrom(none));
  }
  for (const char* none : {"nan", "inf", "-inf", "1e999", "one"}) CHECK_FALSE(finiteNumberFrom(none));
}

TEST_CASE("numbers are written with the fewest digits, without an exponent") {
  CHECK(shortestText(1e9) == "1000000000");
  CHECK(shortestText(0.001) == "0.001");
  CHECK(shortestText(-2.5) == "-2.5");
  CHECK(shortestText(0) == "0");
}

TEST_CASE("a table that cannot be read says why and what to give") {
  const TestFolder folder;
  const auto missing = readTable(folder / "none.csv", 100, "Give a table");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().code == FailureCode::unreadableInput);
  CHECK_FALSE(missing.failure().remedies.empty());
  CHECK_FALSE(readTable(folder.path().string(), 100, "Give a table"));
  std::ofstream(folder / "table.csv") << std::string(101, '1');
  CHECK_FALSE(readTable(folder / "table.csv", 100, "Give a table"));
  CHECK(readTable(folder / "table.csv", 101, "Give a table")->size() == 101);
  std::ofstream(folder / "empty.csv").close();
  CHECK(readTable(folder / "empty.csv", 100, "Give a table")->empty());
}
