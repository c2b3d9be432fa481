// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/label_rows.h"

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

constexpr Box kPlot{120, 70, 870, 540};

/// Boxes about equally high, `pitch_px` from middle to middle, right-aligned at `right_px`.
std::vector<Box> column(int count, double first_px, double pitch_px, double width_px, double height_px,
                        double right_px) {
  std::vector<Box> words;
  for (int k = 0; k < count; ++k) {
    const double y = first_px + k * pitch_px;
    words.push_back({right_px - width_px, y - 0.5 * height_px, right_px, y + 0.5 * height_px});
  }
  return words;
}

std::vector<Box> joined(std::vector<Box> a, const std::vector<Box>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("labels at even distances are taken, not the many letters of a title beside them", "[label rows]") {
  const auto labels = column(8, 90, 60, 16, 11, 108);
  const auto letters = column(18, 210, 10, 12, 8, 76);
  const std::vector<double> gridlines{90, 150, 210, 270, 330, 390, 450, 510};
  for (const auto& lines : {std::vector<double>{}, gridlines}) {
    const auto row = labelsLeft(joined(letters, labels), kPlot, lines);
    CHECK(row.regular == 8);
    CHECK(row.words == labels);
  }
}

TEST_CASE("of two columns as regular the one nearer to the axis is taken", "[label rows]") {
  const auto near = column(5, 90, 100, 16, 11, 108), far = column(5, 90, 100, 16, 11, 72);
  CHECK(labelsLeft(joined(far, near), kPlot, {}).words == near);
  CHECK(labelsLeft(joined(near, far), kPlot, {}).words == near);
}

TEST_CASE("three labels are better than nothing", "[label rows]") {
  const auto labels = column(3, 90, 220, 16, 11, 108);
  CHECK(labelsLeft(labels, kPlot, {}).words == labels);
}

TEST_CASE("Digits of numbers that read upwards, one above the other, make a column") {
  // 15, 10, 5 and 0 at even distances, 11 px a digit, and a title's letters farther out.
  std::vector<Box> digits;
  const auto digit = [&](double x, double y) { digits.push_back({x, y - 5, x + 14, y + 5}); };
  for (const double y : {94.0, 106.0, 194.0, 206.0, 300.0, 400.0}) digit(kPlot.x0 - 30, y);
  for (double y = 210; y < 300; y += 11) digit(kPlot.x0 - 60, y);
  const LabelRow column = labelsUpwards(digits, kPlot, {100, 200, 300, 400});
  CHECK(column.regular == 4);
  CHECK(column.height_px == 14);
  REQUIRE(column.words.size() == 4);
  CHECK(column.words.front().height() == 22);
}
