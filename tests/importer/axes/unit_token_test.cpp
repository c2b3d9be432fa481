// SPDX-License-Identifier: GPL-3.0-or-later
// Units at the end of titles in scripts that the text engine does not know.

#include "importer/axes/unit_token.h"

#include <catch2/catch.hpp>

#include "importer/axes/read_text.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "tests/importer/frame/drawn_plot.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::test;

namespace {

constexpr double square_px = 26;

/// A square letter of two parts, as no Latin one is.
void square(Canvas& c, double x, double y) {
  const double end = x + square_px;
  for (const double row : {y, y + 9, y + square_px}) c.row(row, x, end, 2, 0);
  c.column(x + 4, y + 9, y + square_px, 2, 0);
  c.column(end - 4, y + 9, y + square_px, 2, 0);
  c.row(y - 5, x + 6, end - 6, 2, 0);
}

/// The unit behind two such letters, `gap_px` after them.
std::optional<UnitToken> behindSquares(const std::string& latin, double gap_px, bool upwards = false) {
  const int width = 420, height = 90;
  Canvas c(width, height, 255);
  square(c, 40, 30);
  square(c, 74, 30);
  int below = 0;
  const double wideText_px = cv::getTextSize(latin, cv::FONT_HERSHEY_DUPLEX, 0.9, 1, &below).width;
  cv::Mat grey = c.grey();
  cv::putText(grey, latin, {static_cast<int>(100 + gap_px), 54}, cv::FONT_HERSHEY_DUPLEX, 0.9, cv::Scalar(0),
              1, cv::LINE_AA);
  REQUIRE(wideText_px < 250);
  if (upwards) cv::rotate(grey, grey, cv::ROTATE_90_COUNTERCLOCKWISE);
  const auto document = documentOf(grey);
  const auto page = document.page(1).value();
  const auto view = document.view(page, {-0.5, -0.5, grey.cols - 0.5, grey.rows - 0.5}).value();
  TextReader reader(view);
  auto letters = glyphBoxes(darkMaskOf(darknessOf(view.raster)), 2, 60);
  const int turns = upwards ? 1 : 0;
  for (Box& letter : letters) letter = turned(letter, turns);
  return unitAtEnd(reader, letters, turns, upwards ? 90 : 0);
}

}  // namespace

TEST_CASE("a unit is read by itself, whatever stands before it") {
  if (!TextReader::available()) return;
  const auto [latin, unit] = GENERATE(table<std::string, std::string>(
      {{"(cN)", "cN"}, {"/ N", "N"}, {"[gf]", "gf"}, {"(oz)", "ozf"}, {"/ mm", "mm"}, {"(N)", "N"}}));
  const bool upwards = GENERATE(false, true);
  CAPTURE(latin, upwards);
  const auto token = behindSquares(latin, 12, upwards);
  REQUIRE(token.has_value());
  CHECK(token->symbol == unit);
  CHECK(token->apart);
  CHECK(token->endOf("xx yy").find(" (" + unit + ")") != std::string::npos);
}

TEST_CASE("what is no unit by itself is none") {
  if (!TextReader::available()) return;
  const auto latin = GENERATE(as<std::string>{}, "N", "kPa", "(N/mm)", "(x10 gf)", "of", "no");
  CAPTURE(latin);
  CHECK_FALSE(behindSquares(latin, 12).has_value());
}
