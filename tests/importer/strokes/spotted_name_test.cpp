// SPDX-License-Identifier: GPL-3.0-or-later
// Names that no text engine reads, drawn into a legend at a plot's size and requested.

#include "importer/strokes/spotted_name.h"

#include <array>

#include <catch2/catch.hpp>

#include "importer/page/drawn_words.h"

using namespace detent;
using namespace detent::importer;

namespace {

constexpr std::array<Rgb, 3> kColours{Rgb{200, 30, 30}, {30, 120, 200}, {30, 150, 60}};

/// A legend: one name below the other, each with a key in its curve's colour before it.
struct Legend {
  Raster picture;
  std::vector<CurveTrace> traces;
  std::vector<PlotSwitch> switches;
  std::vector<Box> words;

  explicit Legend(const std::vector<std::string>& names, int letters_px = 15) {
    picture.width_px = 240, picture.height_px = 200;
    picture.rgb.assign(3UL * 240 * 200, 255);
    for (const std::string& name : names) {
      const Raster word = wordsDrawn(name, letters_px).value();
      const Rgb colour = kColours[traces.size()];
      const int left = 60, top = 20 + 40 * static_cast<int>(traces.size());
      for (int y = 0; y < word.height_px; ++y)
        for (int x = 0; x < word.width_px; ++x) put(left + x, top + y, grey(word.at(x, y)[0]));
      for (int x = left - 40; x < left - 8; ++x)
        for (int y = 0; y < 2; ++y) put(x, top + word.height_px / 2 + y, colour);
      words.push_back(
          {double(left), double(top), double(left + word.width_px), double(top + word.height_px)});
      CurveTrace trace;
      trace.color = colour;
      trace.points_px = {{5, 190}, {50, 195}};
      switches.push_back({{}, colour, {}, {traces.size()}});
      traces.push_back(trace);
    }
  }
  static Rgb grey(std::uint8_t level) { return {level, level, level}; }
  void put(int x, int y, Rgb color) {
    std::uint8_t* const p = picture.rgb.data() + 3 * (picture.width_px * y + x);
    p[0] = color.r, p[1] = color.g, p[2] = color.b;
  }
  std::optional<std::size_t> spotted(const std::string& wanted) const {
    return switchSpotted(switches, traces, picture, wanted);
  }
};

}  // namespace

TEST_CASE("the switch whose name in the legend resembles the requested one is taken") {
  for (const int letters_px : {12, 15, 24}) {
    const Legend chinese({"红轴", "青轴", "茶轴"}, letters_px), korean({"적축", "청축", "갈축"}, letters_px);
    CHECK(chinese.spotted("红轴") == 0);
    CHECK(chinese.spotted("青轴") == 1);
    CHECK(chinese.spotted("茶轴") == 2);
    CHECK(korean.spotted("적축") == 0);
    CHECK(korean.spotted("청축") == 1);
    CHECK(korean.spotted("갈축") == 2);
  }
}

TEST_CASE("a name is found where the legend's line goes on with a stroke's word") {
  const Legend legend({"红轴 按下", "青轴 按下"});
  CHECK(legend.spotted("青轴") == 1);
}

TEST_CASE("a name that stands nowhere, or in two lines, is not found") {
  const Legend legend({"红轴", "青轴"});
  CHECK_FALSE(legend.spotted("静音开关"));
  CHECK_FALSE(Legend({"青轴", "青轴"}).spotted("青轴"));
}

TEST_CASE("a name that a curve runs through is not recognised") {
  Legend legend({"红轴", "青轴"});
  legend.traces[0].points_px.push_back(legend.words[1].middle());
  CHECK_FALSE(legend.spotted("青轴"));
  CHECK(legend.spotted("红轴") == 0);
}

TEST_CASE("a name in a curve's colour is not recognised, because what stands beside it may be writing") {
  Legend legend({"红轴", "青轴"});
  legend.traces[0].color = {0, 0, 0};
  CHECK_FALSE(legend.spotted("青轴"));
}

TEST_CASE("a name that the legend says once for each stroke of its switch is that switch's") {
  Legend legend({"红轴 下压", "红轴 回弹", "青轴"});
  legend.switches = {{{}, kColours[0], kColours[1], {0, 1}}, {{}, kColours[2], {}, {2}}};
  CHECK(legend.spotted("红轴") == 0);
  CHECK(legend.spotted("青轴") == 1);
  legend.switches = {{{}, kColours[0], {}, {0}}, {{}, kColours[1], {}, {1}}, {{}, kColours[2], {}, {2}}};
  CHECK_FALSE(legend.spotted("红轴"));
}

TEST_CASE("names of Latin letters and numbers are left to the reader") {
  const Legend legend({"红轴", "青轴"});
  CHECK_FALSE(legend.spotted("1"));
  CHECK_FALSE(legend.spotted("Red"));
  CHECK_FALSE(legend.spotted(""));
}
