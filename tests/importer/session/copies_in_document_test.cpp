// SPDX-License-Identifier: GPL-3.0-or-later
// Copies drawn on two pages of a document the test writes: the import knows them and says so.

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "importer/importer.h"

using namespace detent;
using namespace detent::importer;

namespace {

std::string line(double x0, double y0, double x1, double y1) {
  char text[96];
  std::snprintf(text, sizeof text, "%.2f %.2f m %.2f %.2f l S\n", x0, y0, x1, y1);
  return text;
}

std::string words(const std::string& what, double x, double y, double size) {
  char text[160];
  std::snprintf(text, sizeof text, "BT /F1 %.1f Tf %.2f %.2f Td (%s) Tj ET\n", size, x, y, what.c_str());
  return text;
}

/// One stroke as a polyline over 3.8 mm, `share` of the press' force until it comes to its end.
std::string stroke(double left, double bottom, double size, double bump_cN, double share) {
  std::string out;
  for (int i = 0; i <= 120; ++i) {
    const double mm = 3.8 * i / 120;
    const double lost = (1 - share) * std::min(1.0, 2 * (3.8 - mm));
    const double force_cN = (1 - lost) * (40 + 8 * mm + bump_cN * std::exp(-5 * (mm - 1.2) * (mm - 1.2)));
    char text[64];
    std::snprintf(text, sizeof text, "%.3f %.3f %c ", left + size * mm / 4,
                  bottom + 0.7 * size * force_cN / 100, i == 0 ? 'm' : 'l');
    out += text;
  }
  return out + "S\n";
}

/// A force graph of 4 mm and 100 cN whose frame is `size` points wide.
std::string graph(double left, double bottom, double size, double bump_cN) {
  std::string out = "0 G 0.6 w\n";
  const double height = 0.7 * size, letter = 0.025 * size;
  for (int k = 0; k <= 4; ++k) {
    const double x = left + size * k / 4;
    out += line(x, bottom, x, bottom + height);
    out += words(std::to_string(k), x - 0.28 * letter, bottom - 2 * letter, letter);
  }
  for (int k = 0; k <= 5; ++k) {
    const double y = bottom + height * k / 5;
    const std::string label = std::to_string(20 * k);
    out += line(left, y, left + size, y);
    out += words(label, left - 0.6 * letter * (static_cast<double>(label.size()) + 1), y - 0.35 * letter,
                 letter);
  }
  out += words("Travel [mm]", left + 0.4 * size, bottom - 5 * letter, letter);
  out += words("Force [cN]", left, bottom + height + letter, letter);
  out += "1.2 w 0.8 0 0 RG " + stroke(left, bottom, size, bump_cN, 1);
  return out + "0 0 0.8 RG " + stroke(left, bottom, size, bump_cN, 0.7);
}

std::vector<unsigned char> documentOf(const std::string& first, const std::string& second) {
  const auto stream = [](const std::string& content) {
    return "<</Length " + std::to_string(content.size()) + ">>\nstream\n" + content + "\nendstream";
  };
  const std::string page =
      "<</Type/Page/Parent 2 0 R/MediaBox[0 0 800 600]/Resources<</Font<</F1 7 0 R>>>>/Contents ";
  const std::string objects[] = {"<</Type/Catalog/Pages 2 0 R>>",
                                 "<</Type/Pages/Kids[3 0 R 4 0 R]/Count 2>>",
                                 page + "5 0 R>>",
                                 page + "6 0 R>>",
                                 stream(first),
                                 stream(second),
                                 "<</Type/Font/Subtype/Type1/BaseFont/Helvetica>>"};
  std::string out = "%PDF-1.4\n";
  int number = 0;
  for (const std::string& object : objects) {
    ++number;
    out += std::to_string(number) + " 0 obj\n" + object + "\nendobj\n";
  }
  out += "trailer\n<</Root 1 0 R>>\n%%EOF\n";  // a table is not needed: readers rebuild it
  return {out.begin(), out.end()};
}

ImportReport importedFrom(std::vector<unsigned char> document) {
  auto session = ImportSession::fromBytes(std::move(document), "two.pdf");
  REQUIRE(session);
  auto report = session->importGraph({});
  if (!report) FAIL(report.failure().sentence());
  return std::move(report).value();
}

bool saysOfCopies(const ImportReport& report, RemarkCode code) {
  return std::any_of(report.remarks.begin(), report.remarks.end(),
                     [code](const Remark& remark) { return remark.code == code; });
}

}  // namespace

TEST_CASE("One graph on two pages is one graph", "[copies]") {
  const auto report = importedFrom(documentOf(graph(100, 100, 560, 25), graph(150, 200, 320, 25)));
  CHECK(saysOfCopies(report, RemarkCode::sameGraphSeveralTimes));
  CHECK_FALSE(saysOfCopies(report, RemarkCode::severalGraphs));
  CHECK(report.button.states().front().graph.travel_mm() == Approx(3.8).margin(0.02));
}

TEST_CASE("A curve that was held against its copies is not traced again", "[copies]") {
  auto session =
      ImportSession::fromBytes(documentOf(graph(100, 100, 560, 25), graph(150, 200, 320, 25)), "two.pdf");
  REQUIRE(session);
  REQUIRE(session->importGraph({}));
  for (const int page : {1, 2}) {
    ImportRequest request;
    request.page = page, request.graph = 1;
    const auto report = session->importGraph(request);
    REQUIRE(report);
    CHECK(report->seconds.count(ImportStep::trace) == 0);
  }
}

TEST_CASE("Two switches on equal axes stay two graphs", "[copies]") {
  const auto report = importedFrom(documentOf(graph(100, 100, 560, 25), graph(150, 200, 320, 5)));
  CHECK_FALSE(saysOfCopies(report, RemarkCode::sameGraphSeveralTimes));
  CHECK(saysOfCopies(report, RemarkCode::severalGraphs));
}
