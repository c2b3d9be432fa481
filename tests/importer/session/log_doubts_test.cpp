// SPDX-License-Identifier: GPL-3.0-or-later
// What a force meter's log is doubted for: it has no page that contradicts it, only itself.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "importer/importer.h"

using namespace detent;
using namespace detent::importer;

namespace {

struct LogFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("detent-log-" + std::to_string(::getpid()) + ".csv");
  explicit LogFile(const std::string& text) { std::ofstream(path) << text; }
  ~LogFile() { std::filesystem::remove(path); }
};

/// A click of 0.6 N on 4 mm, down and up, as an instrument writes it; row `broken` reads as given.
std::string logOf(double perMm = 1, double perN = 1, int broken = -1, const std::string& instead = "") {
  std::string text = "Displacement (mm),Force (N)\n";
  constexpr int rows = 400;
  for (int i = 0; i <= 2 * rows; ++i) {
    const double x = 4.0 * (i <= rows ? i : 2 * rows - i) / rows;
    const double force =
        0.1 + 0.12 * x + 0.2 * std::exp(-std::pow((x - 1.5) / 0.4, 2)) - (i > rows ? 0.05 : 0);
    char line[64];
    std::snprintf(line, sizeof line, "%.4f,%.4f\n", x * perMm, force * perN);
    text += i == broken ? instead + "\n" : line;
  }
  return text;
}

Result<ImportReport> importedLog(const std::string& text, const ImportRequest& request = {}) {
  const LogFile file(text);
  auto session = ImportSession::open(file.path.string());
  REQUIRE(session.ok());
  return session->importGraph(request);
}

void refusedFor(const std::string& text, const char* reason) {
  INFO(reason);
  const auto report = importedLog(text);
  REQUIRE_FALSE(report.ok());
  CHECK(report.failure().code == FailureCode::notCertain);
  CHECK(report.failure().reason == reason);
  CHECK_FALSE(report.failure().remedies.empty());
}

}  // namespace

TEST_CASE("A log of a button is not doubted") {
  const auto report = importedLog(logOf());
  REQUIRE(report.ok());
  CHECK(report->confidence > 0.99);
  CHECK(report->button.provenance()->confidence == report->confidence);
}

TEST_CASE("What no button measures is doubted: sentinels, sizes, signs") {
  refusedFor(logOf(1, 1, 200, "-9999,0.3"), "implausible-travel");
  refusedFor(logOf(1, 1, 200, "9999,0.3"), "implausible-travel");
  refusedFor(logOf(1, 1, 200, "2.0,-9999"), "negative-force");
  refusedFor(logOf(10), "implausible-travel");  // a tensile test's, or another unit
  refusedFor(logOf(1e-3),
             "implausible-travel");  // micrometres written as millimetres would be 1000 times more
  refusedFor(logOf(1, 100), "implausible-force");
}

TEST_CASE(
    "A unit given by hand settles the size it answers, and a lower bar lets a doubt pass with its figure") {
  ImportRequest given;
  given.hints.axes.xUnit = LengthUnit::millimetre;
  const auto settled = importedLog(logOf(10), given);
  REQUIRE(settled.ok());
  CHECK(settled->button.states()[0].graph.press().travel_mm() == Approx(40).margin(0.5));
  ImportRequest forces = given;
  CHECK_FALSE(importedLog(logOf(1, 100), forces).ok());
  ImportRequest unsure;
  unsure.sure = 0.3;
  const auto passed = importedLog(logOf(10), unsure);
  REQUIRE(passed.ok());
  CHECK(passed->confidence < 0.5);
  CHECK_FALSE(passed->remarks.empty());
}
