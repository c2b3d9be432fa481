// SPDX-License-Identifier: GPL-3.0-or-later
// Stimuli under a participant's finger, and refusals before the first question.
#include "playback/study/study_player.h"

#include <catch2/catch.hpp>

#include "tests/playback/study/trials/study_folder.h"

using namespace detent;
using namespace detent::test;

namespace {

StudyPlayerSettings onForceDevice() {
  StudyPlayerSettings settings;
  settings.rehearse = true;
  settings.force = *playback::forceDeviceFrom("sim:rig");
  return settings;
}

}  // namespace

TEST_CASE("a force device that runs one uploaded button is in no study", "[study]") {
  const StudyFolder made({}, {"A", "B"});
  StudyPlayerSettings settings = onForceDevice();
  {
    const auto player = StudyPlayer::start(*made.study, settings);
    REQUIRE(player);
    CHECK((*player)->sensed());
    CHECK_FALSE((*player)->sounding());
  }
  settings.force->uploadTable = true;
  const auto player = StudyPlayer::start(*made.study, settings);
  REQUIRE_FALSE(player);
  CHECK(player.failure().code == FailureCode::wrongUsage);
  CHECK_THAT(player.failure().sentence(), Catch::Contains("a study switches between buttons"));
  CHECK_THAT(player.failure().sentence(), Catch::Contains("upload of the force table"));
}

TEST_CASE("a force device is in no study of what only a vibration has, and none beside a sensor", "[study]") {
  StudyDesign clicks;
  clicks.modes = {FeedbackMode::full, FeedbackMode::clickOnly};
  const StudyFolder modes(clicks, {"A", "B"});
  StudyPlayerSettings settings = onForceDevice();
  const auto ofModes = StudyPlayer::start(*modes.study, settings);
  REQUIRE_FALSE(ofModes);
  CHECK(ofModes.failure().code == FailureCode::wrongUsage);
  StudyDesign events;
  events.kind = StudyKind::threshold;
  events.quantity = LevelQuantity::eventSize;
  const StudyFolder strength(events, {"B"});
  const auto ofStrength = StudyPlayer::start(*strength.study, settings);
  REQUIRE_FALSE(ofStrength);
  CHECK(ofStrength.failure().code == FailureCode::wrongUsage);
  const StudyFolder plain({}, {"A", "B"});
  settings.sensorPort = "/dev/null";
  const auto bothFingers = StudyPlayer::start(*plain.study, settings);
  REQUIRE_FALSE(bothFingers);
  CHECK_THAT(bothFingers.failure().sentence(), Catch::Contains("cannot be used as well"));
}
