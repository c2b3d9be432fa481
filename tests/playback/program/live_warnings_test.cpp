// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_warnings.h"

#include <set>

#include <catch2/catch.hpp>

#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

/// A player at whose sensor nothing is wrong.
PlayerStatus healthy() {
  PlayerStatus status;
  status.sensor = SensorCondition::running;
  return status;
}

}  // namespace

TEST_CASE("live warnings: nothing is said where nothing is wrong") {
  LiveWarnings warnings(true);
  for (int i = 0; i < 100; ++i) CHECK(warnings.update(healthy(), 0.05 * i).empty());
  CHECK_FALSE(warnings.mostUrgent().has_value());
}

TEST_CASE("live warnings: a fault stands on the line as long as it lasts, and is reported once") {
  const std::vector<std::pair<SensorCondition, LiveWarningCode>> troubles{
      {SensorCondition::unplugged, LiveWarningCode::sensorUnplugged},
      {SensorCondition::silent, LiveWarningCode::sensorSilent},
      {SensorCondition::stuck, LiveWarningCode::sensorStuck}};
  for (const auto& [condition, code] : troubles) {
    LiveWarnings warnings(true);
    PlayerStatus status = healthy();
    status.sensor = condition;
    const std::vector<LiveWarning> first = warnings.update(status, 0);
    REQUIRE(first.size() == 1);
    CHECK(first[0].code == code);
    CHECK(warnings.mostUrgent() == code);
    for (int i = 1; i < 200; ++i) CHECK(warnings.update(status, 0.05 * i).empty());
    CHECK(warnings.mostUrgent().has_value());
    CHECK(warnings.update(healthy(), 11).empty());
    CHECK_FALSE(warnings.mostUrgent().has_value());
    CHECK(warnings.update(status, 12).size() == 1);
  }
}

TEST_CASE("live warnings: a lost device comes before everything else") {
  LiveWarnings warnings(true);
  PlayerStatus status = healthy();
  status.sensor = SensorCondition::unplugged;
  warnings.update(status, 0);
  CHECK(warnings.mostUrgent() == LiveWarningCode::sensorUnplugged);
  status.deviceLost = true;
  CHECK(warnings.update(status, 0.1).size() == 1);
  CHECK(warnings.mostUrgent() == LiveWarningCode::deviceLost);
}

TEST_CASE("live warnings: counted faults are reported with their number, every ten seconds at most") {
  for (std::uint64_t PlayerStatus::*count :
       {&PlayerStatus::xruns, &PlayerStatus::droppedReadings, &PlayerStatus::droppedEvents,
        &PlayerStatus::rejectedReadings, &PlayerStatus::malformedLines, &PlayerStatus::malformedMessages,
        &PlayerStatus::limitedBlocks}) {
    LiveWarnings warnings(true);
    PlayerStatus status = healthy();
    status.*count = 3;
    const std::vector<LiveWarning> first = warnings.update(status, 0);
    REQUIRE(first.size() == 1);
    CHECK(first[0].count == 3);
    CHECK(english(messageOf(first[0])).front() == '3');
    std::size_t reported = 0;
    for (int i = 1; i <= 200; ++i) {
      ++(status.*count);
      reported += warnings.update(status, 0.05 * i).size();
    }
    CHECK(reported == 1);
    CHECK(warnings.mostUrgent().has_value());
    warnings.update(status, 14);
    CHECK_FALSE(warnings.mostUrgent().has_value());
  }
}

TEST_CASE("live warnings: counts without a calibration, and forces by message that come too seldom") {
  PlayerStatus status = healthy();
  status.sensorSendsCounts = true;
  CHECK(LiveWarnings(true).update(status, 0).empty());
  CHECK(LiveWarnings(false).update(status, 0).size() == 1);

  const auto warningsAt = [](double rate_Hz) {
    LiveWarnings warnings(true);
    PlayerStatus messages;
    std::size_t reported = 0;
    for (double t = 0; t < 5; t += 0.05) {
      messages.messageForces = static_cast<std::uint64_t>(t * rate_Hz);
      reported += warnings.update(messages, t).size();
    }
    return reported;
  };
  CHECK(warningsAt(50) == 1);
  CHECK(warningsAt(425) == 0);
}

TEST_CASE("live doubts: what this button or device cannot give is said before anybody presses") {
  ButtonState state = stateOf("", {{0, 0}, {2, 1}}, {});
  const auto doubts = [&](const LiveArguments& arguments, PlaybackSettings settings, const Button& button) {
    const Result<PreparedProgram> program = prepareProgram(button, {}, settings);
    REQUIRE(program);
    return doubtsAbout(arguments, button, {}, *program).size();
  };
  const Button plain = buttonOf("plain", {state});
  CHECK(doubts({}, {}, plain) == 0);
  LiveArguments arguments;
  arguments.sensor.port = "/dev/ttyACM0";
  CHECK(doubts(arguments, {}, plain) == 1);
  arguments = {};
  arguments.signalTarget = Endpoint{"localhost", 9001};
  CHECK(doubts(arguments, {}, plain) == 0);
  PlaybackSettings off;
  off.mode = FeedbackMode::off;
  CHECK(doubts(arguments, off, plain) == 1);
  arguments.pressFile = "press.csv";
  CHECK(doubts(arguments, {}, plain) == 1);
}

TEST_CASE("live warnings: every code has its own name, title and words") {
  std::set<std::string> names, titles, words;
  for (std::size_t i = 0; i < liveWarningCodes; ++i) {
    const auto code = static_cast<LiveWarningCode>(i);
    names.insert(nameOf(code));
    titles.insert(titleOf(code));
    words.insert(english(messageOf({code, 1})));
  }
  CHECK(names.size() == liveWarningCodes);
  CHECK(titles.size() == liveWarningCodes);
  CHECK(words.size() == liveWarningCodes);
}
