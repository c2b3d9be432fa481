// SPDX-License-Identifier: GPL-3.0-or-later
// A session with several requests, and documents of which some pages cannot be read.

#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "importer/importer.h"
#include "tests/samples/two_switches.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// A PDF of two pages: a line, and a line of 100 points.
std::string twoPages() {
  std::string longLine = "0 0 m ";
  for (int i = 0; i < 100; ++i) longLine += std::to_string(i) + " 5 l ";
  const auto stream = [](const std::string& content) {
    return "<</Length " + std::to_string(content.size()) + ">>\nstream\n" + content + "\nendstream";
  };
  const std::string page = "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 100]/Contents ";
  const std::string objects[] = {"<</Type/Catalog/Pages 2 0 R>>",
                                 "<</Type/Pages/Kids[3 0 R 4 0 R]/Count 2>>",
                                 page + "5 0 R>>",
                                 page + "6 0 R>>",
                                 stream("0 0 m 9 9 l S"),
                                 stream(longLine + "S")};
  std::string out = "%PDF-1.4\n";
  int number = 0;
  for (const std::string& object : objects) {
    ++number;
    out += std::to_string(number) + " 0 obj\n" + object + "\nendobj\n";
  }
  return out + "trailer\n<</Root 1 0 R>>\n%%EOF\n";  // a table is not needed: readers rebuild it
}

/// A file that is gone when the test is.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() / name) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("A list may be requested again, and an import after it") {
  auto session = ImportSession::open(std::string(DETENT_SOURCE_DIR) + "/samples/plots/white-vector.pdf");
  REQUIRE(session);
  const auto first = session->list();
  const auto again = session->list();
  REQUIRE(first);
  REQUIRE(again);
  REQUIRE(first->graphs.size() == 1);
  REQUIRE(again->graphs.size() == 1);
  CHECK(again->graphs.front().unit == PageUnit::point);
  CHECK(again->remarks.empty());
  const auto report = session->importGraph({});
  INFO((report ? "" : report.failure().sentence()));
  CHECK(report.ok());
}

TEST_CASE("A page that cannot be read costs only itself and is named") {
  const TemporaryFile file("detent-two-pages.pdf", twoPages());
  PageLimits limits;
  limits.maxPathPoints = 50;
  auto session = ImportSession::open(file.path(), limits);
  REQUIRE(session);
  const auto listed = session->list();
  INFO((listed ? "" : listed.failure().sentence()));
  REQUIRE(listed);
  CHECK(listed->graphs.empty());
  REQUIRE(listed->remarks.size() == 1);
  CHECK(listed->remarks.front().code == RemarkCode::pageUnreadable);
  CHECK(listed->remarks.front().values.at(0).number == 2);

  const auto report = session->importGraph({});
  REQUIRE_FALSE(report);
  CHECK(report.failure().code == FailureCode::noForceGraph);
  CHECK_THAT(report.failure().sentence(), Catch::Contains("page 2"));

  const auto alone = session->list(2);
  REQUIRE_FALSE(alone);
  CHECK(alone.failure().code == FailureCode::unreadableInput);
}

TEST_CASE("Graphs of one document are named by the titles above them") {
  const std::string plot = tests::twoSwitchesSvg();
  const std::size_t begin = plot.find('>') + 1;
  const auto titled = [&](int y, const std::string& title) {
    return "<g transform='translate(0," + std::to_string(y) +
           ")'><text font-family='sans-serif' font-size='15' x='340' y='28' text-anchor='middle'>" + title +
           "</text>" + plot.substr(begin, plot.rfind("</svg>") - begin) + "</g>";
  };
  const std::string sheet = "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='1000'>" +
                            titled(0, "Quiet model") + titled(500, "Loud model") + "</svg>";
  const auto nameOf = [](const std::string& svg, int graph) {
    auto session = ImportSession::fromBytes({svg.begin(), svg.end()}, "sheet.svg");
    REQUIRE(session.ok());
    ImportRequest request;
    request.page = 1, request.graph = graph;
    request.hints.strokes.curve = "Red";
    const auto report = session->importGraph(request);
    INFO((report.ok() ? "" : report.failure().sentence()));
    REQUIRE(report.ok());
    return report->button.name();
  };
  CHECK(nameOf(sheet, 1) == "sheet Quiet model Red");
  CHECK(nameOf(sheet, 2) == "sheet Loud model Red");
  CHECK(nameOf(plot, 1) == "sheet Red");  // alone on its page: the file's name says enough
}
