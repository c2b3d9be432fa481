// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sections.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "model/templates.h"
#include "tests/model/property.h"
#include "tests/model/random_curves.h"

using namespace detent;
using detent::tests::anyCurve;
using detent::tests::holdsAlways;

namespace {

StrokeCurve through(std::vector<CurvePoint> points) {
  auto curve = StrokeCurve::throughPoints(points);
  REQUIRE(curve.ok());
  return *curve;
}

std::vector<SectionKind> kinds(const std::vector<Section>& sections) {
  std::vector<SectionKind> out;
  for (const Section& s : sections) out.push_back(s.kind);
  return out;
}

constexpr auto slope = SectionKind::slope;
constexpr auto jump = SectionKind::jump;
constexpr auto bottomOut = SectionKind::bottomOut;

const std::vector<CurvePoint> tactilePress{{0, 0.3}, {1, 0.6}, {1.6, 0.4}, {3.9, 0.7}, {3.9, 1.5}};

}  // namespace

TEST_CASE("press of a tactile button: slope, jump, slope, bottom-out (Kim & Lee, Figure 2)") {
  const auto sections = sectionsOf(through(tactilePress), Stroke::press);
  REQUIRE(kinds(sections) == std::vector{slope, jump, slope, bottomOut});
  CHECK(sections[1].from_mm == 1);
  CHECK(sections[1].fromForce_N == 0.6);
  CHECK(sections[1].toForce_N == 0.6);
  CHECK(sections[1].to_mm > 1.6);
  CHECK(sections[3].from_mm == 3.9);
  CHECK(sections[3].fromForce_N == 0.7);
  CHECK(sections[3].toForce_N == 1.5);
}

TEST_CASE("a release jump whose force is never fallen below runs to complete release") {
  const StrokeCurve release = through({{0, 0.3}, {0.8, 0.45}, {1.5, 0.2}, {3.9, 0.65}});
  const auto sections = sectionsOf(release, Stroke::release);
  REQUIRE(kinds(sections) == std::vector{slope, jump});
  CHECK(sections[0].from_mm == 3.9);
  CHECK(sections[1].from_mm == 1.5);
  CHECK(sections[1].to_mm == 0);
  CHECK(sections[1].toForce_N == 0.3);
}

TEST_CASE("a release jump ends where the force falls below its tactile point") {
  const StrokeCurve release = through({{0, 0.0}, {0.8, 0.45}, {1.5, 0.2}, {3.9, 0.65}});
  const auto sections = sectionsOf(release, Stroke::release);
  REQUIRE(kinds(sections) == std::vector{slope, jump, slope});
  CHECK(sections[1].toForce_N == 0.2);
  CHECK(release.force_N(sections[1].to_mm) == Approx(0.2).epsilon(1e-12));
  CHECK(sections[2].to_mm == 0);
}

TEST_CASE("two levels give two jumps; a lower second point is hidden in the first jump") {
  const auto rising = sectionsOf(
      through({{0, 0.2}, {0.5, 0.6}, {0.8, 0.4}, {1.4, 1.2}, {1.7, 0.8}, {2, 1.5}}), Stroke::press);
  CHECK(kinds(rising) == std::vector{slope, jump, slope, jump, slope, bottomOut});
  const StrokeCurve falling = through({{0, 0.2}, {0.5, 1.2}, {0.8, 0.4}, {1.4, 0.8}, {1.7, 0.5}, {4, 1.5}});
  CHECK(tactilePoints(falling, Stroke::press).size() == 2);
  CHECK(kinds(sectionsOf(falling, Stroke::press)) == std::vector{slope, jump, slope, bottomOut});
}

TEST_CASE("a linear button has a slope and the end of its travel") {
  const auto press = sectionsOf(through({{0, 0.3}, {4, 0.8}}), Stroke::press);
  REQUIRE(kinds(press) == std::vector{slope, bottomOut});
  CHECK(press[1].from_mm == 4);
  CHECK(press[1].to_mm == 4);
  CHECK(kinds(sectionsOf(through({{0, 0.3}, {4, 0.8}}), Stroke::release)) == std::vector{slope});
}

TEST_CASE("wiggles below the bar are no tactile points, the bar can be lowered") {
  const StrokeCurve noisy = through({{0, 0}, {1, 0.5}, {1.2, 0.49}, {2, 0.7}, {2.1, 0.69}, {4, 1}});
  CHECK(tactilePoints(noisy, Stroke::press).empty());
  SectionSettings fine;
  fine.minProminenceOfSpan = 0.005;
  CHECK(tactilePoints(noisy, Stroke::press, fine).size() == 2);
  fine.minProminence_N = 0.02;
  CHECK(tactilePoints(noisy, Stroke::press, fine).empty());
}

TEST_CASE("a wiggle on the flank of a peak is measured by its shallower side") {
  const StrokeCurve curve = through({{0, 0.3}, {1, 0.9}, {1.3, 0.6}, {1.4, 0.61}, {2, 0.4}, {4, 1.0}});
  const auto points = tactilePoints(curve, Stroke::press);
  REQUIRE(points.size() == 1);
  CHECK(points[0].displacement_mm == 1);
  CHECK(points[0].prominence_N == Approx(0.5));
}

TEST_CASE("the threshold is a share of the range below the bottom-out, not of the bottom-out") {
  // 0.06 N of 0.6 N is 10 %, but 0.6 % of the bottom-out's 10 N.
  const StrokeCurve curve = through({{0, 0}, {1, 0.5}, {1.5, 0.44}, {3, 0.6}, {3.02, 10}});
  CHECK(tactilePoints(curve, Stroke::press).size() == 1);
}

TEST_CASE("bottom-out: vertical, steep, with a rounded beginning, none") {
  const BottomOut vertical = bottomOutOf(through(tactilePress));
  CHECK(vertical.isSteep);
  CHECK(vertical.displacement_mm == 3.9);
  const BottomOut steep = bottomOutOf(through({{0, 0.4}, {3.6, 0.6}, {3.65, 1.2}}));
  CHECK(steep.isSteep);
  CHECK(steep.displacement_mm == Approx(3.6).margin(0.02));
  const BottomOut rounded =
      bottomOutOf(through({{0, 0.4}, {3.5, 0.6}, {3.6, 0.63}, {3.65, 0.75}, {3.7, 1.3}}));
  CHECK(rounded.isSteep);
  CHECK(rounded.displacement_mm == Approx(3.6).margin(0.05));
  // CHERRY's graphs end at the full travel without a bottom-out.
  const BottomOut open = bottomOutOf(through({{0, 0.3}, {1.2, 0.55}, {1.7, 0.41}, {2.1, 0.5}, {4, 0.6}}));
  CHECK_FALSE(open.isSteep);
  CHECK(open.displacement_mm == 4);
  CHECK(open.force_N == 0.6);
}

TEST_CASE("no false bottom-outs: stiffening springs, a steep start, a late peak") {
  CHECK_FALSE(bottomOutOf(through({{0, 0}, {1, 0.1}, {2, 0.3}, {3, 0.8}, {4, 1.6}})).isSteep);
  CHECK_FALSE(bottomOutOf(through({{0, 0}, {0.02, 0.5}, {4, 0.8}})).isSteep);
  CHECK_FALSE(bottomOutOf(through({{0, 0.2}, {3, 0.4}, {3.5, 0.9}, {4, 0.5}})).isSteep);
  // Free travel before the spring: the spring is no bottom-out, however steep against zero.
  CHECK_FALSE(bottomOutOf(through({{0, 0.1}, {1, 0.1001}, {4, 1}})).isSteep);
  // A rise at the *start* of a press is slope.
  const StrokeCurve start = through({{0, 0}, {0, 0.4}, {4, 0.8}});
  CHECK(kinds(sectionsOf(start, Stroke::press)) == std::vector{slope, bottomOut});
}

TEST_CASE("a bottom-out is found whatever its height against the rest") {
  for (double top : {0.75, 1.2, 5.0, 100.0, 1e5}) {
    const BottomOut found = bottomOutOf(through({{0, 0.3}, {3.8, 0.6}, {3.83, top}}));
    CHECK(found.isSteep);
    CHECK(found.displacement_mm == Approx(3.8).margin(0.03));
  }
}

TEST_CASE("jump regained inside the bottom-out ends there") {
  const StrokeCurve curve = through({{0, 0.3}, {1, 0.8}, {2, 0.4}, {3.9, 0.5}, {3.9, 1.5}});
  const auto sections = sectionsOf(curve, Stroke::press);
  REQUIRE(kinds(sections) == std::vector{slope, jump, bottomOut});
  CHECK(sections[1].to_mm == 3.9);
  CHECK(sections[2].fromForce_N == 0.8);
}

TEST_CASE("a flat tactile point is its middle") {
  const StrokeCurve curve = through({{0, 0.3}, {1, 0.6}, {1.2, 0.6}, {1.6, 0.4}, {4, 0.8}});
  const auto points = tactilePoints(curve, Stroke::press);
  REQUIRE(points.size() == 1);
  CHECK(points[0].displacement_mm == Approx(1.1));
  const auto sections = sectionsOf(curve, Stroke::press);
  REQUIRE(sections.size() >= 2);
  CHECK(sections[1].to_mm > 1.6);
}

TEST_CASE("the area of a jump is that under its horizontal; a degenerate jump has none") {
  // Triangular valley: straight down to 0.2 and back.
  auto curve = strokeFrom({{{0, 0}, {1, 0.6}, {2, 0.2}, {3, 0.6}, {4, 0.7}}, {0, 1, 2, 3}});
  REQUIRE(curve.ok());
  const auto press = sectionsOf(*curve, Stroke::press);
  REQUIRE(press.size() >= 2);
  CHECK(jumpArea_mJ(*curve, press[1]) == Approx(0.5 * 2 * 0.4));
  CHECK(jumpArea_mJ(*curve, {jump, 1.5, 1.5, 0.6, 0.6}) == 0);
  const auto release = sectionsOf(*curve, Stroke::release);
  REQUIRE(release.size() >= 2);
  CHECK(release[1].from_mm == 2);
  CHECK(jumpArea_mJ(*curve, release[1]) > 0);
}

TEST_CASE("sections touch and cover the stroke, jumps begin at tactile points") {
  holdsAlways("sectionsOf", [] {
    const StrokeCurve curve = anyCurve();
    for (Stroke stroke : {Stroke::press, Stroke::release}) {
      const bool press = stroke == Stroke::press;
      const auto sections = sectionsOf(curve, stroke);
      const auto points = tactilePoints(curve, stroke);
      RC_ASSERT(!sections.empty());
      RC_ASSERT(sections.front().from_mm == (press ? curve.start_mm() : curve.end_mm()));
      RC_ASSERT(sections.back().to_mm == (press ? curve.end_mm() : curve.start_mm()));
      for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section& s = sections[i];
        RC_ASSERT((press ? s.from_mm <= s.to_mm : s.from_mm >= s.to_mm));
        if (i > 0) {
          RC_ASSERT(s.from_mm == sections[i - 1].to_mm);
          RC_ASSERT(s.fromForce_N == sections[i - 1].toForce_N);
        }
        if (s.kind != jump) continue;
        RC_ASSERT(jumpArea_mJ(curve, s) >= 0);
        RC_ASSERT(std::any_of(points.begin(), points.end(),
                              [&](const TactilePoint& p) { return p.displacement_mm == s.from_mm; }));
      }
    }
  });
}
