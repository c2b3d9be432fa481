// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/recorded_switches.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "importer/log/force_log.h"
#include "tests/importer/log/written_sheet.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::test;

namespace {

class WrittenFile {
 public:
  WrittenFile(const std::string& name, const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() /
              ("detent-" + std::to_string(std::hash<std::string>{}(bytes)) + name)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~WrittenFile() { std::filesystem::remove(path_); }
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

FailureCode codeOf(const std::string& name, const std::string& bytes, const LogHints& hints = {}) {
  const WrittenFile file(name, bytes);
  const auto log = readForceLog(file.path(), hints);
  REQUIRE_FALSE(log.ok());
  return log.failure().code;
}

}  // namespace

TEST_CASE("A curve meter's spreadsheet is read in each layout") {
  const auto layout = GENERATE(SheetLayout::oneLine, SheetLayout::twoLines, SheetLayout::rawOnly);
  const WrittenFile file(".ods", switchSheet(layout, 1));
  const auto log = readForceLog(file.path());
  REQUIRE(log.ok());
  const std::vector<CurvePoint>& press = log->strokes.press.points;
  REQUIRE(log->strokes.release);
  CHECK(press.size() >= 780);
  CHECK(press.back().displacement_mm == Approx(4));
  CHECK(press.back().force_N == Approx(forceOf_gf(4, 1, true) * 0.00980665).epsilon(1e-6));
  CHECK(log->strokes.release->points.front().displacement_mm == Approx(4).margin(0.006));
  CHECK(log->operatingPoint_mm.has_value() == (layout != SheetLayout::twoLines));
  if (layout == SheetLayout::twoLines) return;
  CHECK(*log->operatingPoint_mm == Approx(1.9975).margin(1e-6));  // between two samples
  CHECK(*log->resetPoint_mm == Approx(1.8).margin(0.006));
}

TEST_CASE("Of several switches in a sheet one has to be chosen") {
  std::vector<std::vector<double>> rows;
  for (int i = 0; i <= 100; ++i) {
    const double x = 0.04 * i;
    rows.push_back({x, forceOf_gf(x, 1, true), 4 - x, forceOf_gf(4 - x, 1, false), NAN, x,
                    forceOf_gf(x, 2, true), 4 - x, forceOf_gf(4 - x, 2, false)});
  }
  const std::string sheet =
      zipOf("content.xml", sheetXml({{"Corrected Downstroke", "", "Corrected Upstroke (Boba &amp; U4)", "",
                                      "", "Corrected Downstroke", "", "Corrected Upstroke (Halo)"},
                                     {"X (mm)", "Force (gf)", "X (mm)", "Force (gf)", "", "X (mm)",
                                      "Force (gf)", "X (mm)", "Force (gf)"}},
                                    rows));
  CHECK(codeOf(".ods", sheet) == FailureCode::notCertain);
  CHECK(codeOf(".ods", sheet, {{}, {}, false, "Polia"}) == FailureCode::wrongUsage);
  const WrittenFile file(".ods", sheet);
  CHECK(recordNames(file.path()) == std::vector<std::string>{"Boba & U4", "Halo"});
  const auto second = readForceLog(file.path(), {{}, {}, false, "halo"});
  REQUIRE(second.ok());
  CHECK(second->strokes.press.points.front().force_N == Approx(forceOf_gf(0, 2, true) * 0.00980665));
  CHECK(readForceLog(file.path(), {{}, {}, false, "2"}).ok());
}

TEST_CASE("Runs that only titles tell apart are switches of their own, each in its last form") {
  std::vector<std::vector<double>> rows;
  for (int i = 0; i <= 100; ++i) {
    const double x = 0.04 * i;
    rows.push_back({1000 * x, forceOf_gf(x, 1, true), NAN, 1000 * x, forceOf_gf(x, 2, true), NAN, x,
                    forceOf_gf(x, 3, true)});
  }
  const auto sheetOf = [&](const std::vector<std::string>& titles) {
    return zipOf(
        "content.xml",
        sheetXml({titles,
                  {"X (microns)", "Force (gf)", "", "X (microns)", "Force (gf)", "", "X (mm)", "Force (gf)"}},
                 rows));
  };
  const WrittenFile file(".ods", sheetOf({"63.5g Slow", "", "", "Long spring", "", "", "63.5g Slow"}));
  CHECK(recordNames(file.path()) == std::vector<std::string>{"Long spring", "63.5g Slow"});
  LogHints second;
  second.curve = "2";
  const auto log = readForceLog(file.path(), second);
  REQUIRE(log.ok());
  CHECK(log->strokes.press.points.back().displacement_mm == Approx(4));
  CHECK(log->strokes.press.points.back().force_N == Approx(forceOf_gf(4, 3, true) * 0.00980665));
  CHECK(codeOf(".ods", sheetOf({"", "", "", "Long spring", "", "", "63.5g Slow"})) ==
        FailureCode::notCertain);
}

TEST_CASE("Headings with results beside them are headings, however many") {
  std::vector<std::vector<double>> rows;
  for (int i = 0; i <= 100; ++i)
    rows.push_back({0.04 * i, forceOf_gf(0.04 * i, 1, true), NAN, 2, 45, 1.8, 30, 2.1, 50});
  std::string xml = sheetXml({{"Corrected Downstroke (Boba)"}, {"X (mm)", "Force (gf)"}}, rows);
  const std::string heading = "Force (gf)</text:p></table:table-cell>";
  xml.insert(
      xml.find(heading) + heading.size(),
      "<table:table-cell/><table:table-cell office:value=\"2\"/><table:table-cell office:value=\"45\"/>"
      "<table:table-cell office:value=\"1.8\"/>");
  const WrittenFile file(".ods", zipOf("content.xml", xml));
  CHECK(recordNames(file.path()) == std::vector<std::string>{"Boba"});
}

TEST_CASE("A tester's JSON has the way up from its deepest place on") {
  const WrittenFile file(
      ".json",
      R"({"down_x":[0.1,1,2,3],"down_y":[10,40,50,100],"up_x":[0.1,1,2,3],"up_y":[98,45,35,5],"pressPoint":[2.0,50],"releasePoint":[1.5,40]})");
  const auto log = readForceLog(file.path());
  REQUIRE(log.ok());
  REQUIRE(log->strokes.release);
  CHECK(log->strokes.release->points.front() == CurvePoint{3, 98 * 0.00980665});
  CHECK(log->operatingPoint_mm == 2.0);
  CHECK(log->resetPoint_mm == 1.5);
  CHECK(log->remarks.front().code == RemarkCode::forceScaleDoubtful);
}

TEST_CASE("What is no measurement is refused, whatever an archive claims") {
  const std::string sheet = switchSheet(SheetLayout::oneLine, 1);
  CHECK(codeOf(".ods", "no archive") == FailureCode::unreadableInput);
  CHECK(codeOf(".ods", zipOf("other.xml", "x")) == FailureCode::unreadableInput);
  CHECK(codeOf(".ods", zipOf("content.xml", "<table:table table:name=\"a\"><table:table-row")) ==
        FailureCode::unreadableInput);
  const WrittenFile nameless(".ods",
                             zipOf("content.xml", sheetXml({{"a", "b", "c"}}, {{1, 2, 3}, {2, 3, 4}})));
  const auto unsure = readForceLog(nameless.path());
  CHECK((!unsure.ok() || unsure->confidence < 0.5));
  CHECK(codeOf(".json", "{\"a\":1}") == FailureCode::noForceGraph);
  CHECK(codeOf(".json", "{\"a\":") == FailureCode::unreadableInput);
  CHECK(codeOf(".json", R"({"down_x":"a","down_y":[null]})") == FailureCode::noForceGraph);
  // Every cut and every changed byte: an answer or a refusal.
  for (std::size_t at = 0; at < sheet.size(); at += 97) {
    (void)tablesOfSpreadsheet(sheet.substr(0, at), "cut");
    std::string changed = sheet;
    changed[at] = static_cast<char>(~changed[at]);
    (void)tablesOfSpreadsheet(changed, "changed");
  }
  // A thousandfold: refused at the bound, not at the end of the memory.
  const std::string bomb = zipOf("content.xml", std::string(std::size_t{65} << 20, ' '));
  CHECK(bomb.size() < 200000);
  CHECK(codeOf(".ods", bomb) == FailureCode::unreadableInput);
}

TEST_CASE("Entities of a document type are not expanded, in any number") {
  std::string xml = sheetXml({{"Displacement (mm)", "&big;"}}, {{0, 0}, {1, 1}});
  xml.insert(xml.find("?>") + 2, "<!DOCTYPE x [<!ENTITY a \"Force\"><!ENTITY big \"&a;&a;&a;&a; (N)\">]>");
  const auto tables = tablesOfSpreadsheet(zipOf("content.xml", xml), "entities");
  REQUIRE(tables.ok());
  REQUIRE(tables->size() == 1);
  CHECK(tables->front().cell(0, 1) == "&big;");
}

TEST_CASE("Results beside the headings do not pass for the first row of numbers") {
  const std::vector<std::string> titles{"Corrected Downstroke", "", "Corrected Upstroke", ""};
  std::string xml = sheetXml({titles}, {});
  const std::string headings =
      "<table:table-row>" + cellOf("X (mm)") + cellOf("Force (gf)") + cellOf("X (mm)") +
      cellOf("Force (gf)") + cellOf(2.1) + cellOf(70.) + cellOf(2.0) + "</table:table-row><table:table-row>" +
      cellOf(0.) + cellOf(10.) + cellOf(1.) + cellOf(40.) + "</table:table-row><table:table-row>" +
      cellOf(1.) + cellOf(45.) + cellOf(0.) + cellOf(5.) + "</table:table-row>";
  xml.insert(xml.find("<table:table-row table:number-rows-repeated"), headings);
  const WrittenFile file(".ods", zipOf("content.xml", xml));
  const auto log = readForceLog(file.path());
  REQUIRE(log.ok());
  CHECK(log->strokes.press.points == std::vector<CurvePoint>{{0, 10 * 0.00980665}, {1, 45 * 0.00980665}});
}

TEST_CASE("Cells that claim to repeat without end are bounded") {
  const std::string xml =
      "<table:table table:name=\"a\"><table:table-row table:number-rows-repeated=\"99999999999\">"
      "<table:table-cell office:value=\"1\" "
      "table:number-columns-repeated=\"4\"/></table:table-row></table:table>";
  CHECK(codeOf(".ods", zipOf("content.xml", xml)) == FailureCode::noForceGraph);
}
