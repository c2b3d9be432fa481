// SPDX-License-Identifier: GPL-3.0-or-later
// Rapid trigger and dead zones by their definition, worked by hand. Distances are binary fractions, so that
// limits are met exactly.
#include "playback/magnetic/magnetic_key.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace detent::test {

using namespace detent::playback;

namespace {

MagneticKeySettings keyOf(std::optional<RapidTrigger> rapid, double top_mm = 0, double bottom_mm = 0) {
  MagneticKeySettings settings;
  settings.actuate_mm = 2;
  settings.reset_mm = 1.5;
  settings.rapid = rapid;
  settings.topDeadZone_mm = top_mm;
  settings.bottomDeadZone_mm = bottom_mm;
  settings.travel_mm = 4;
  return settings;
}

/// '#' where the key is closed after that displacement, '.' where it is open.
std::string statesOf(const MagneticKeySettings& settings, const std::vector<double>& displacements_mm) {
  MagneticKey key(settings);
  std::string states;
  for (const double displacement_mm : displacements_mm) {
    key.follow(displacement_mm);
    states += key.closed() ? '#' : '.';
  }
  return states;
}

struct KeyCase {
  const char* name;
  MagneticKeySettings settings;
  std::vector<double> displacements_mm;
  std::string states;
};

}  // namespace

TEST_CASE("magnetic key: closed and open along a movement, as defined") {
  const RapidTrigger quarterDown{0.25, 0.5, false}, halfDown{0.5, 0.25, false}, longDown{1, 0.5, false};
  const RapidTrigger continuous{0.25, 0.5, true}, longest{4, 4, false}, small{0.125, 0.125, false};
  const KeyCase cases[] = {
      {"fixed points", keyOf({}), {0, 1.875, 2, 4, 1.625, 1.5, 1.875, 2}, "..###..#"},
      {"a distance for each direction: 0.5 up from 3 opens, 0.25 down from 2.25 closes",
       keyOf(quarterDown),
       {2, 3, 2.75, 2.5, 2.25, 2.375, 2.5, 2.25, 2},
       "###...##."},
      {"the distances exchanged", keyOf(halfDown), {2, 3, 2.75, 2.5, 2.75, 3}, "##...#"},
      {"above the actuation point it does not close",
       keyOf(quarterDown),
       {2, 3, 2.5, 1.625, 1.9375, 2},
       "##...#"},
      {"not released past the release point, the press distance counts",
       keyOf(longDown),
       {2, 3, 2.5, 1.625, 2, 2.625},
       "##...#"},
      {"released past it, the actuation point counts", keyOf(longDown), {2, 3, 2.5, 1.5, 2}, "##..#"},
      {"continuous: closes above the actuation point, until fully released",
       keyOf(continuous, 0.125),
       {2, 3, 2.5, 1, 1.25, 0.75, 0.25, 0.5, 0.125, 0.5, 1.875, 2},
       "##..#..#...#"},
      {"continuous without a dead zone: until rest",
       keyOf(continuous),
       {2, 1.5, 0.125, 0.375, 0, 0.5, 2},
       "#..#..#"},
      {"continuous, distances as long as the travel: opens when fully released",
       keyOf(RapidTrigger{4, 4, true}, 0.125),
       {2, 4, 0.25, 0.125, 2},
       "###.#"},
      {"distances as long as the travel: as fixed points",
       keyOf(longest),
       {2, 4, 1.625, 1.5, 1.875, 2},
       "###..#"},
      {"bottom dead zone: held, and closes on entering it; distances count from the deepest place",
       keyOf(halfDown, 0, 0.5),
       {2, 4, 3.5, 3.4375, 3.5, 3.625, 3.4375, 3.375},
       "###.###."},
      {"bottom dead zone with fixed points", keyOf({}, 0, 2), {1.9375, 2, 1.625, 1.5}, ".##."},
      {"top dead zone that meets the release point", keyOf(quarterDown, 1.5), {2, 3, 2.5, 1.5, 2}, "##..#"},
      {"sensor jitter of less than the distances",
       keyOf(small),
       {2.5, 2.5625, 2.4687, 2.5625, 2.4687},
       "#####"},
      {"sensor jitter as large as the distances",
       keyOf(small),
       {2.5, 2.5625, 2.4375, 2.5625, 2.4375},
       "##.#."},
      {"jitter at the end of the travel stays in the bottom dead zone",
       keyOf(small, 0, 0.25),
       {2.5, 4.0625, 3.9375, 3.75, 4.0625},
       "#####"},
      {"without a bottom dead zone it opens at the end of the travel, too",
       keyOf(small),
       {2, 4.25, 4},
       "##."},
      {"jitter at rest stays in the top dead zone",
       keyOf(RapidTrigger{0.125, 0.125, true}, 0.25),
       {2, 0.25, -0.0625, 0.1875, -0.0625, 0.25},
       "#....."},
      {"one scan from rest to the end and back", keyOf(quarterDown), {0, 4, 0, 4}, ".#.#"},
  };
  for (const KeyCase& each : cases) {
    INFO(each.name);
    CHECK(checked(each.settings).ok());
    CHECK(statesOf(each.settings, each.displacements_mm) == each.states);
  }
}

TEST_CASE("magnetic key: settings that contradict each other are refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const RapidTrigger good{0.25, 0.5, false};
  const auto at = [](double actuate_mm, double reset_mm) {
    MagneticKeySettings settings = keyOf({});
    settings.actuate_mm = actuate_mm;
    settings.reset_mm = reset_mm;
    return settings;
  };
  const std::pair<MagneticKeySettings, const char*> cases[] = {
      {keyOf(RapidTrigger{0, 0.5}), "press distance: 0 mm is not greater than 0"},
      {keyOf(RapidTrigger{0.5, 0}), "release distance: 0 mm is not greater than 0"},
      {keyOf(RapidTrigger{-1, 0.5}), "press distance: -1 mm is not greater"},
      {keyOf(RapidTrigger{0.5, nan}), "release distance: "},
      {keyOf(RapidTrigger{4.5, 0.5}),
       "press distance: 4.5 mm is longer than the travel, 4 mm. Set at most 4 mm"},
      {keyOf(RapidTrigger{0.5, 4.5}), "release distance: 4.5 mm is longer than the travel"},
      {at(4.5, 1), "actuation point: 4.5 mm lies beyond the travel, 4 mm"},
      {at(nan, 1), "actuation point: "},
      {at(2, 2),
       "release point: 2 mm does not lie between rest and the actuation point, 2 mm. Set less than 2 mm"},
      {at(2, -0.5), "release point: -0.5 mm"},
      {keyOf(good, 1.75),
       "top dead zone: the top dead zone of 1.75 mm is not between 0 and the release point, which is at 1.5 "
       "mm. Set at most 1.5"},
      {keyOf(good, -0.5), "top dead zone: the top dead zone of -0.5 mm is not between 0"},
      {keyOf(good, nan), "top dead zone: "},
      {keyOf(good, 0, 2.5),
       "bottom dead zone: the bottom dead zone of 2.5 mm is not between 0 and 2 mm, the distance from the "
       "actuation point to the end of the travel. Set at most 2 mm"},
      {keyOf(good, 0, -0.5), "bottom dead zone: the bottom dead zone of -0.5 mm is not between 0"},
      {keyOf(good, 3, 3), "top dead zone: the top dead zone of 3 mm"},  // they overlap
  };
  for (const auto& [settings, words] : cases) {
    const Result<Done> result = checked(settings);
    INFO(words);
    REQUIRE(!result.ok());
    CHECK(result.failure().code == FailureCode::wrongUsage);
    CHECK(result.failure().sentence().find(words) == 0);
  }
}

TEST_CASE("magnetic key: distances of rapid trigger are worded as given") {
  CHECK(textOf(std::optional<RapidTrigger>()) == "off");
  CHECK(textOf(RapidTrigger{0.1, 0.1}) == "0.1 mm");
  CHECK(textOf(RapidTrigger{0.0015, 0.25}) == "0.0015/0.25 mm");
}

TEST_CASE("magnetic key: events along a press and a second one") {
  const std::vector<double> turns_mm = {0, 4, 1, 4, 0};
  const auto check = [&](const MagneticKeySettings& settings, const std::vector<KeyEvent>& expected) {
    const std::vector<KeyEvent> events = eventsAlong(turns_mm, settings);
    REQUIRE(events.size() == expected.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      CHECK(events[i].closes == expected[i].closes);
      CHECK(events[i].displacement_mm == Approx(expected[i].displacement_mm).margin(1e-9));
      CHECK(events[i].path_mm == Approx(expected[i].path_mm).margin(1e-9));
    }
  };
  check(keyOf({}), {{2, 2, true}, {6.5, 1.5, false}, {8, 2, true}, {12.5, 1.5, false}});
  check(keyOf(RapidTrigger{0.25, 0.5, true}, 0.125),
        {{2, 2, true}, {4.5, 3.5, false}, {7.25, 1.25, true}, {10.5, 3.5, false}});
  check(keyOf(RapidTrigger{0.25, 0.5, false}, 0, 1),
        {{2, 2, true}, {5.001, 2.999, false}, {8, 2, true}, {11.001, 2.999, false}});
  CHECK(eventsAlong({0, 1e6, 0}, keyOf({})).size() == 2);  // a long travel takes no longer
  CHECK(eventsAlong({}, keyOf({})).empty());
  CHECK(eventsAlong({3, 3}, keyOf({})).empty());  // no movement
}

}  // namespace detent::test
