// SPDX-License-Identifier: GPL-3.0-or-later
// Print of four by five pixels, typed here pixel by pixel, so that it is drawn by another hand than the
// reader's.

#include "importer/axes/small_labels.h"

#include <array>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/axes/equal_digits.h"
#include "importer/axes/small_units.h"

using namespace detent;
using namespace detent::importer;

namespace {

using Rows = std::array<std::string, 7>;  // two above and below are the brackets'

const std::map<char, Rows> kLetters{
    {'0', {"", " ## ", "#  #", "#  #", "#  #", " ## ", ""}},
    {'1', {"", " #  ", "##  ", " #  ", " #  ", "### ", ""}},
    {'2', {"", "### ", "   #", "  # ", " #  ", "####", ""}},
    {'4', {"", "  # ", " ## ", "# # ", "####", "  # ", ""}},
    {'5', {"", "### ", "#   ", "### ", "   #", "### ", ""}},
    {'6', {"", " ## ", "#   ", "### ", "#  #", " ## ", ""}},
    {'7', {"", "####", "   #", "  # ", "  # ", " #  ", ""}},
    {'8', {"", " ## ", "#  #", " ## ", "#  #", " ## ", ""}},
    {'.', {"", " ", " ", " ", " ", "#", ""}},
    {'(', {" #", "# ", "# ", "# ", "# ", "# ", " #"}},
    {')', {"# ", " #", " #", " #", " #", " #", "# "}},
    {'N', {"", "#   #", "##  #", "# # #", "#  ##", "#   #", ""}},
    {'c', {"", "", " ##", "#  ", "#  ", " ##", ""}},
    {'m', {"", "", "######", "#  # #", "#  # #", "#  # #", ""}},
    {'F', {"", "####", "#   ", "### ", "#   ", "#   ", ""}},
};

/// Writes a text with its top left corner here; returns the box of its pixels.
Box write(cv::Mat& darkness, const std::string& text, int x, int y) {
  const int from = x;
  int top = 7, bottom = 0;
  for (const char c : text) {
    const Rows& rows = kLetters.at(c);
    std::size_t width = 0;
    for (std::size_t v = 0; v < rows.size(); ++v) {
      width = std::max(width, rows[v].size());
      for (std::size_t u = 0; u < rows[v].size(); ++u) {
        if (rows[v][u] != '#') continue;
        darkness.at<std::uint8_t>(y + static_cast<int>(v), x + static_cast<int>(u)) = 200;
        top = std::min(top, static_cast<int>(v));
        bottom = std::max(bottom, static_cast<int>(v));
      }
    }
    x += static_cast<int>(width) + 1;
  }
  return {from - 0.5, y + top - 0.5, x - 1.5, y + bottom + 0.5};
}

struct Column {
  cv::Mat darkness = cv::Mat::zeros(220, 60, CV_8U);
  std::vector<Box> words;
  std::vector<double> centers_px;

  explicit Column(const std::vector<std::string>& texts, const std::vector<int>& rows) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
      words.push_back(write(darkness, texts[i], 20, rows[i]));
      centers_px.push_back(words.back().middle().y);
    }
  }

  std::vector<std::string> read() const {
    const auto labels = readSmallLabels(darkness, words, centers_px, false);
    return labels ? labels->texts : std::vector<std::string>{};
  }
};

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("small labels are read together") {
  const auto texts = GENERATE(Texts{"80", "60", "40", "20", "0"}, Texts{"125", "100", "75", "50", "25"},
                              Texts{"2.0", "1.5", "1.0", "0.5", "0.0"}, Texts{"400", "200", "0"});
  std::vector<int> rows;
  for (std::size_t i = 0; i < texts.size(); ++i) rows.push_back(10 + 40 * static_cast<int>(i));
  const Column column(texts, rows);
  // "0.0" may come out as "0": the same number.
  const Texts read = column.read();
  REQUIRE(read.size() == texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) CHECK(std::stod(read[i]) == std::stod(texts[i]));
}

TEST_CASE("a label that was not found leaves a gap in their steps") {
  CHECK(Column({"80", "60", "20", "0"}, {10, 50, 130, 170}).read() == Texts{"80", "60", "20", "0"});
}

TEST_CASE("small marks that are no numbers in even steps are not read") {
  SECTION("numbers out of order") {
    CHECK(Column({"80", "20", "40", "60"}, {10, 50, 90, 130}).read().empty());
  }
  SECTION("places that are not even") {
    CHECK(Column({"80", "60", "40", "20"}, {10, 63, 90, 130}).read().empty());
  }
  SECTION("letters") { CHECK(Column({"NN", "Fc", "cN", "F"}, {10, 50, 90, 130}).read().empty()); }
  SECTION("two labels") { CHECK(Column({"80", "60"}, {10, 50}).read().empty()); }
  SECTION("blots") {
    Column column({"80", "60", "40", "20"}, {10, 50, 90, 130});
    for (const Box& word : column.words)
      column
          .darkness(cv::Rect(static_cast<int>(word.x0 + 0.5), static_cast<int>(word.y0 + 0.5),
                             static_cast<int>(word.width()), static_cast<int>(word.height())))
          .setTo(200);
    CHECK(column.read().empty());
  }
}

TEST_CASE("the unit in a small title's brackets") {
  cv::Mat darkness = cv::Mat::zeros(40, 120, CV_8U);
  const auto unit = GENERATE(as<std::string>{}, "mm", "N", "cN");
  const Box upright = write(darkness, "F.(" + unit + ")", 10, 12);
  CHECK(bracketedUnit(darkness, upright, 0) == unit);
  // Upwards, as beside a y axis.
  cv::Mat upwards;
  cv::rotate(darkness, upwards, cv::ROTATE_90_COUNTERCLOCKWISE);
  const double last = darkness.cols - 1;
  CHECK(bracketedUnit(upwards, {upright.y0, last - upright.x1, upright.y1, last - upright.x0}, 1) == unit);
}

TEST_CASE("a small line that ends in no unit has none") {
  cv::Mat darkness = cv::Mat::zeros(40, 120, CV_8U);
  const Box line = write(darkness, "F(408)", 10, 12);
  CHECK_FALSE(bracketedUnit(darkness, line, 0));
}

TEST_CASE("a unit takes the place of what was read in the brackets") {
  CHECK(withUnit("Travel (rnre)", "mm") == "Travel (mm)");
  CHECK(withUnit("Fore (cNI", "cN") == "Fore (cN)");
  CHECK(withUnit("Travvel prmt)", "mm") == "Travvel (mm)");
  CHECK(withUnit("", "N") == "(N)");
}

namespace {

using Texts = std::vector<std::string>;

/// Labels in even steps by equal shapes, given the engine's readings.
std::optional<Texts> readAlike(const Texts& drawn, const Texts& engine, bool rising = true) {
  cv::Mat marks = cv::Mat::zeros(20, 40 * static_cast<int>(drawn.size()) + 40, CV_8U);
  std::vector<std::vector<LetterShape>> letters;
  std::vector<double> centers_px;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Box word = write(marks, drawn[i], 10 + 40 * static_cast<int>(i), 5);
    letters.push_back(lettersOf(marks, word));
    CHECK(letters.back().size() == drawn[i].size());
    centers_px.push_back(10 + 40.0 * static_cast<double>(i));
  }
  return readEqualDigits(letters, centers_px, rising, engine);
}

}  // namespace

TEST_CASE("equal digits are read as the same one everywhere, unequal ones as others") {
  const Texts tenths{"0.0", "0.2", "0.4", "0.6", "0.8"};
  CHECK(readAlike(tenths, {"6.0", "6.2", "6.4", "6.6", "6.8"}) == tenths);
  CHECK(readAlike(tenths, {"8.0", "8.2", "8.4", "0.0", "8.8"}) == tenths);
  CHECK(readAlike(tenths, tenths) == tenths);
  const Texts tens{"80", "60", "40", "20", "0"};
  CHECK(readAlike(tens, {"88", "6o", "40", "28", "8"}, false) == tens);
  // A label that the engine lost in part still counts as far as it was read.
  CHECK(readAlike(tens, {"8", "60", "40", "20", ""}, false) == tens);
}

TEST_CASE("shapes that fit no scale, or several as well, are not read") {
  CHECK_FALSE(readAlike({"0.0", "0.2", "0.4", "0.6", "0.2"}, {"6.0", "6.2", "6.4", "6.6", "6.8"}));
  CHECK_FALSE(readAlike({"0", "1", "2", "4", "5"}, {"", "", "", "", ""}));
  CHECK_FALSE(readAlike({"0.0", "0.2"}, {"0.0", "0.2"}));
  CHECK_FALSE(readAlike({"0.0", "0.2", "0.4"}, {"77", "77", "77"}));
}

TEST_CASE("digits that touch, or are smoothed, have no shapes of their own") {
  cv::Mat marks = cv::Mat::zeros(20, 240, CV_8U);
  std::vector<std::vector<LetterShape>> letters;
  std::vector<double> centers_px;
  for (const std::string text : {"80", "60", "40", "20", "0"}) {
    const int x = 10 + 40 * static_cast<int>(letters.size());
    letters.push_back(lettersOf(marks, write(marks, text, x, 5)));
    centers_px.push_back(x);
  }
  const Texts engine{"100", "60", "40", "20", "0"};
  CHECK(readEqualDigits(letters, centers_px, false, engine));
  LetterShape& touching = letters[0][0];
  touching.width *= 2;
  touching.isDark.insert(touching.isDark.end(), touching.isDark.begin(), touching.isDark.end());
  CHECK_FALSE(readEqualDigits(letters, centers_px, false, engine));
  cv::Mat darkness = cv::Mat::zeros(20, 60, CV_8U);
  const std::vector<Box> words{write(darkness, "0.6", 5, 5), write(darkness, "45", 35, 5)};
  CHECK(isUnsmoothed(darkness, words));
  cv::GaussianBlur(darkness, darkness, {}, 0.5);
  CHECK_FALSE(isUnsmoothed(darkness, words));
  CHECK_FALSE(isUnsmoothed(darkness, {}));
}

TEST_CASE("the digits of both axes are known where their print is not smoothed") {
  cv::Mat marks = cv::Mat::zeros(20, 60, CV_8U);
  AxisCalibration axes;
  for (const auto& [text, left] : {std::pair{"0.6", 5}, {"60", 35}}) {
    TickLabel tick;
    tick.text = text, tick.box = write(marks, text, left, 5), tick.used = true;
    axes.x.ticks.push_back(tick);
  }
  const std::vector<LetterShape> digits = digitsOf(marks, marks, axes);
  REQUIRE(digits.size() == 2);
  CHECK((digits[0].sign == '0' && digits[1].sign == '6'));
  cv::Mat smoothed;
  cv::GaussianBlur(marks, smoothed, {}, 0.5);
  CHECK(digitsOf(smoothed, marks, axes).empty());
}

TEST_CASE("digits known by their shape stand in names, whatever the engine makes of them") {
  cv::Mat marks = cv::Mat::zeros(20, 120, CV_8U);
  const std::vector<LetterShape> name = lettersOf(marks, write(marks, "1.0N", 10, 5));
  std::vector<LetterShape> known = lettersOf(marks, write(marks, "10", 60, 5));
  known[0].sign = '1', known[1].sign = '0';
  CHECK(withKnownDigits("1.6 N", name, known) == "1.0 N");
  CHECK(withKnownDigits("1.6 NN", name, known) == "1.6 NN");  // not letter for letter
  CHECK(withKnownDigits("1.6 N", name, {}) == "1.6 N");
}
