// SPDX-License-Identifier: GPL-3.0-or-later
// Plots by their numbers alone, and on papers of two colours.

#include "importer/frame/labelled_plots.h"

#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// Numbers along two axes; nothing else.
cv::Mat numbersOf(int columns, int rows, int paper, int shade) {
  cv::Mat grey(520, 800, CV_8U, cv::Scalar(paper));
  const auto write = [&](const std::string& text, int cx, int cy) {
    cv::putText(grey, text, {cx - 6 * static_cast<int>(text.size()), cy + 6}, cv::FONT_HERSHEY_SIMPLEX, 0.55,
                cv::Scalar(shade), 1, cv::LINE_AA);
  };
  for (int k = 0; k < columns; ++k) write(std::to_string(k), 100 + 120 * k, 460);
  for (int k = 0; k < rows; ++k) write(std::to_string(20 * k + 10), 60, 430 - 70 * k);
  return grey;
}

Raster rasterOf(const cv::Mat& grey) {
  Raster raster;
  raster.width_px = grey.cols, raster.height_px = grey.rows;
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x)
      for (int c = 0; c < 3; ++c) raster.rgb.push_back(grey.at<std::uint8_t>(y, x));
  return raster;
}

std::vector<LabelledPlot> plotsIn(const cv::Mat& grey) {
  return findLabelledPlots(darkMaskOf(darknessOf(rasterOf(grey), PaperBy::region)), 80, 60);
}

}  // namespace

TEST_CASE("a row and a column of numbers enclose a plot, without any line") {
  for (const auto& [paper, shade] : {std::pair{255, 0}, {30, 230}, {110, 250}}) {
    const auto plots = plotsIn(numbersOf(6, 5, paper, shade));
    REQUIRE(plots.size() == 1);
    CHECK(plots.front().below >= 5);
    CHECK(plots.front().left == 5);
    CHECK(plots.front().box.x0 == Approx(100).margin(8));
    CHECK(plots.front().box.x1 == Approx(700).margin(8));
    CHECK(plots.front().box.y0 == Approx(150).margin(8));
    CHECK(plots.front().box.y1 == Approx(430).margin(8));
  }
}

TEST_CASE("a column of numbers at the right end of a row encloses a plot as well") {
  cv::Mat mirrored;
  cv::flip(numbersOf(6, 5, 255, 0), mirrored, 1);
  const auto plots = plotsIn(mirrored);
  REQUIRE(plots.size() == 1);
  CHECK(plots.front().left == 5);
  CHECK(plots.front().box.x0 == Approx(799 - 700).margin(8));
  CHECK(plots.front().box.x1 == Approx(799 - 100).margin(8));
}

TEST_CASE("a row of numbers over a column's head encloses a plot as well") {
  cv::Mat grey = numbersOf(0, 5, 255, 0);
  for (int k = 0; k < 6; ++k)
    cv::putText(grey, std::to_string(k), {94 + 120 * k, 126}, cv::FONT_HERSHEY_SIMPLEX, 0.55, cv::Scalar(0),
                1, cv::LINE_AA);
  const auto plots = plotsIn(grey);
  REQUIRE(plots.size() == 1);
  CHECK(plots.front().below == 6);
  CHECK(plots.front().box.x0 == Approx(100).margin(8));
  CHECK(plots.front().box.y0 == Approx(150).margin(8));
  CHECK(plots.front().box.y1 == Approx(430).margin(8));
}

TEST_CASE("a number that a title's letter stands close to is one of its column") {
  cv::Mat grey = numbersOf(6, 5, 255, 0);
  for (int k = 0; k < 5; ++k)  // letters that read upwards, close beside "70"
    cv::rectangle(grey, cv::Rect(29, 203 + 20 * k, 15, 17), cv::Scalar(0), 2);
  const auto plots = plotsIn(grey);
  REQUIRE(plots.size() == 1);
  CHECK(plots.front().left == 5);
}

TEST_CASE("a row's outermost numbers may stand flush with the axis' ends") {
  cv::Mat grey = numbersOf(0, 5, 255, 0);
  for (int k = 0; k < 6; ++k) {
    const double inwards = k == 0 ? 12 : k == 5 ? -12 : 0;
    cv::putText(grey, "0." + std::to_string(k), {static_cast<int>(100 + 120 * k + inwards) - 15, 466},
                cv::FONT_HERSHEY_SIMPLEX, 0.55, cv::Scalar(0), 1, cv::LINE_AA);
  }
  const auto plots = plotsIn(grey);
  REQUIRE(plots.size() == 1);
  CHECK(plots.front().box.x0 == Approx(100).margin(8));
  CHECK(plots.front().box.x1 == Approx(700).margin(8));
}

TEST_CASE("a row alone, a column alone, and nothing") {
  CHECK(plotsIn(numbersOf(6, 0, 255, 0)).empty());
  CHECK(plotsIn(numbersOf(0, 5, 255, 0)).empty());
  CHECK(plotsIn(numbersOf(0, 0, 255, 0)).empty());
}

TEST_CASE("by region: white words on a black page and black ones on its white panel both stand out") {
  cv::Mat grey(300, 400, CV_8U, cv::Scalar(20));
  grey(cv::Rect(120, 40, 260, 200)).setTo(255);
  grey(cv::Rect(60, 100, 3, 12)).setTo(240);
  grey(cv::Rect(200, 100, 3, 12)).setTo(10);
  const cv::Mat region = darknessOf(rasterOf(grey), PaperBy::region);
  CHECK(region.at<std::uint8_t>(105, 61) > 200);
  CHECK(region.at<std::uint8_t>(105, 201) > 200);
  CHECK(region.at<std::uint8_t>(150, 50) == 0);
  CHECK(region.at<std::uint8_t>(150, 300) == 0);
}

TEST_CASE("numbers on a dark page close beside its white panel stand out with their gaps") {
  cv::Mat grey(520, 800, CV_8U, cv::Scalar(36));
  grey(cv::Rect(75, 60, 690, 385)).setTo(255);
  const auto write = [&](const std::string& text, cv::Point at) {
    cv::putText(grey, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, cv::Scalar(245), 1, cv::LINE_AA);
  };
  for (int k = 0; k < 6; ++k) write(std::to_string(k), {96 + 120 * k, 460});
  for (int k = 0; k < 5; ++k)
    write(std::to_string(100 + 20 * k), {44, 435 - 70 * k});  // ends 3 px from the panel
  const auto plots = plotsIn(grey);
  REQUIRE(plots.size() == 1);
  CHECK(plots.front().below == 6);
  CHECK(plots.front().left == 5);
  // Digits, not blocks: the paper shows in the hole of a zero.
  const cv::Mat region = darknessOf(rasterOf(grey), PaperBy::region);
  const cv::Mat zero = region(cv::Rect(54, 424, 9, 12));
  CHECK(cv::countNonZero(zero > 100) < 0.75 * static_cast<double>(zero.total()));
  CHECK(region.at<std::uint8_t>(250, 74) < 20);  // the panel's edge is no line
  CHECK(region.at<std::uint8_t>(250, 75) < 20);
}

TEST_CASE("a tick that reaches a number is no minus behind it") {
  const std::vector<Box> glyphs{{10, 10, 16, 20}, {18, 10, 24, 20}, {26, 14, 36, 17}};
  const auto words = numberBoxes(glyphs);
  REQUIRE(words.size() == 1);
  CHECK(words.front() == Box{10, 10, 24, 20});
  // A minus stands in front, and a decimal point is no dash.
  CHECK(numberBoxes({{0, 14, 8, 16}, {10, 10, 16, 20}}).front() == Box{0, 10, 16, 20});
  CHECK(numberBoxes({{10, 10, 16, 20}, {18, 18, 20, 20}}).front() == Box{10, 10, 20, 20});
}

TEST_CASE("a line at the bottom parts the names of columns and not the words") {
  const Box force{10, 10, 50, 20}, stroke{51, 21.5, 57, 23}, unit{58, 12, 64, 23};
  REQUIRE(wordBoxes({force, stroke, unit}, 1.3).size() == 1);
  CHECK(wordBoxes({force, {51, 27, 57, 28}}, 1.3).size() == 2);  // under the line
  CHECK(wordBoxes({force, {51, 21, 75, 22}}, 1.3).size() == 2);  // longer than a letter
}

TEST_CASE("a comma that hangs below the line belongs to its number") {
  const Box one{10, 10, 13, 20}, comma{15, 19.4, 17, 23}, zeros{20, 10, 38, 20};
  REQUIRE(numberBoxes({one, comma, zeros}).size() == 1);
  CHECK(numberBoxes({one, comma, zeros}).front() == Box{10, 10, 38, 23});
  CHECK(numberBoxes({one, {15, 22, 17, 26}}).size() == 2);    // lower than a comma hangs
  CHECK(numberBoxes({one, {15, 19.4, 25, 29}}).size() == 2);  // larger than one
}
