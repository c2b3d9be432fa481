// SPDX-License-Identifier: GPL-3.0-or-later
// The Falcon's USB side: Debian's libusb against a device of umockdev.
#include <cmath>

#include <catch2/catch.hpp>

#include "playback/device/falcon_force_device.h"
#include "playback/device/falcon_kinematics.h"
#include "playback/device/steady_clock.h"
#include "tests/playback/device/falcon_rig.h"

namespace {

using namespace detent;
using namespace detent::playback;
using detent::test::anyFalconFirmware;
using detent::test::FalconRig;

constexpr double period_s = 0.2;  // a loaded machine answers within half of this

FalconSettings settingsWith(std::vector<std::uint8_t> firmware) {
  FalconSettings settings;
  settings.firmware = std::move(firmware);
  settings.period_s = period_s;
  return settings;
}

std::unique_ptr<ForceDevice> opened(const FalconSettings& settings = settingsWith(anyFalconFirmware())) {
  auto device = openFalcon(settings);
  if (!device) FAIL(device.failure().sentence());
  return std::move(*device);
}

/// Moves the handle as near to a place as whole counts allow; gives the place.
FalconPlace_mm moveTo(FalconRig& rig, const FalconPlace_mm& place_mm) {
  FalconAngles_rad angles = falconAngles_rad(place_mm).value();
  for (std::size_t i = 0; i < 3; ++i) {
    rig.counts[i] = static_cast<int>(
        std::lround((angles[i] - falconAngle_rad(0)) / (falconAngle_rad(1) - falconAngle_rad(0))));
    angles[i] = falconAngle_rad(rig.counts[i]);
  }
  return falconPlace_mm(angles, place_mm).value();
}

/// The answer to a command comes with the next exchange or the one after.
ForceReading settled(ForceDevice& device, const ForceCommand& command = {}) {
  ForceReading reading;
  for (int i = 0; i < 4; ++i) reading = device.exchange(command);
  return reading;
}

bool within(double seconds, const std::function<bool()>& happens) {
  for (const double end_s = now_s() + seconds; now_s() < end_s;) {
    if (happens()) return true;
    sleepUntil(now_s() + 0.01);
  }
  return false;
}

}  // namespace

TEST_CASE("Falcon: the firmware goes up byte for byte; 2,000 exchanges, none bad; no force at the end") {
  FalconRig rig;
  {
    auto device = opened();
    CHECK(rig.firmware() == anyFalconFirmware());
    CHECK(device->counts().firmwareTries == 1);
    ForceCommand command;
    command.force_N = 2;
    int fresh = 0;
    double worst_mm = 0;
    FalconPlace_mm before{0, 0, falconRest_mm};
    for (int i = 0; i < 2000; ++i) {
      const FalconPlace_mm at =
          moveTo(rig, {3 * std::sin(i * 0.01), 2 * std::cos(i * 0.02), 135 - 15 * std::sin(i * 0.005)});
      const ForceReading reading = device->exchange(command);
      fresh += reading.fresh ? 1 : 0;
      // A reading was true when its packet came: now or one exchange ago.
      const auto off = [&](const FalconPlace_mm& p) {
        return std::hypot(falconRest_mm - p[2] - reading.position_mm, p[0] - reading.sideways_mm[0],
                          p[1] - reading.sideways_mm[1]);
      };
      if (reading.fresh) worst_mm = std::max(worst_mm, std::min(off(at), off(before)));
      before = at;
    }
    CHECK(fresh == 2000);
    CHECK(worst_mm < 1e-6);
    CHECK(device->counts().malformed == 0);
    CHECK(device->counts().late == 0);
    CHECK(device->state() == ForceDeviceState::ready);
    CHECK(rig.motors[0] != 0);
    CHECK(rig.light == 2);
  }
  for (const auto& motor : rig.motors) CHECK(motor == 0);
  CHECK(rig.light == 0);
}

TEST_CASE("Falcon: motors push the handle towards the person, sideways too, and never beyond their limit") {
  FalconRig rig;
  auto device = opened();
  const FalconPlace_mm place = moveTo(rig, {5, -3, 120});
  settled(*device);
  ForceCommand command;
  command.force_N = 1.5;
  command.sideways_N = {0.5, -0.25};
  settled(*device, command);
  const auto torques_Nm = falconTorques_Nm(place, {0.5, -0.25, 1.5});
  for (std::size_t i = 0; i < 3; ++i) CHECK(rig.motors[i] == std::lround(-10000 * (*torques_Nm)[i]));
  command.force_N = 500;
  settled(*device, command);
  int largest = 0;
  for (const auto& motor : rig.motors) largest = std::max(largest, std::abs(motor.load()));
  CHECK(largest == 4096);
}

TEST_CASE("Falcon: a firmware that is taken at the third try, one that is never taken, and none at all") {
  FalconRig rig;
  auto none = openFalcon(settingsWith({}));
  REQUIRE_FALSE(none);
  CHECK(english(none.failure().problem) == "the Falcon was switched on and has no firmware yet");
  rig.badEchoes = 2;
  {
    auto device = opened();
    CHECK(device->counts().firmwareTries == 3);
    CHECK(settled(*device).fresh);
  }
  // The device keeps its firmware: no file is needed until it is switched off.
  CHECK(opened(settingsWith({}))->counts().firmwareTries == 0);
  rig.powerCycle();
  rig.badEchoes = 1000;
  auto never = openFalcon(settingsWith(anyFalconFirmware()));
  REQUIRE_FALSE(never);
  CHECK(english(never.failure().problem) == "the Falcon did not accept the firmware in 10 attempts");
}

TEST_CASE("Falcon: until it knows where it is, there are no readings and no force") {
  FalconRig rig;
  rig.homed = false;
  auto device = opened();
  ForceCommand command;
  command.force_N = 3;
  CHECK_FALSE(settled(*device, command).fresh);
  CHECK(device->state() == ForceDeviceState::homing);
  CHECK(rig.motors[0] == 0);
  CHECK(rig.light == 8);
  rig.homed = true;
  CHECK(settled(*device, command).fresh);
  CHECK(device->state() == ForceDeviceState::ready);
  CHECK(rig.motors[0] != 0);
}

TEST_CASE("Falcon: moved out and in it has found its place; one packet that says otherwise changes nothing") {
  FalconRig rig;
  auto device = opened();
  CHECK(settled(*device).zero == ForceReading::Zero::kept);
  const auto next = [&] {
    ForceReading reading;
    CHECK(within(2, [&] { return (reading = device->exchange({})).fresh; }));
    return reading.zero;
  };
  rig.homed = false;
  CHECK(within(2, [&] {
    device->exchange({});
    return device->state() == ForceDeviceState::homing;
  }));
  rig.homed = true;
  CHECK(next() == ForceReading::Zero::kept);
  rig.homed = false;
  const double moving_s = now_s();
  while (now_s() - moving_s < 0.6) device->exchange({});
  rig.homed = true;
  CHECK(next() == ForceReading::Zero::found);
  CHECK(next() == ForceReading::Zero::kept);
}

TEST_CASE("Falcon: no answer, half an answer, nonsense are no readings; two answers are one") {
  FalconRig rig;
  auto settings = settingsWith(anyFalconFirmware());
  settings.period_s = 0.02;
  auto device = opened(settings);
  CHECK(settled(*device).fresh);
  for (const FalconRig::Answer bad :
       {FalconRig::Answer::none, FalconRig::Answer::half, FalconRig::Answer::nonsense}) {
    rig.answer = bad;
    CHECK_FALSE(settled(*device).fresh);
    rig.answer = FalconRig::Answer::good;
    CHECK(within(2, [&] { return device->exchange({}).fresh; }));
  }
  CHECK(device->counts().late > 3);
  CHECK(device->counts().malformed > 2);
  const std::uint64_t repeated = device->counts().repeated;
  rig.answer = FalconRig::Answer::twice;
  CHECK(settled(*device).fresh);
  CHECK(device->counts().repeated > repeated);
  // Encoders no handle can have: not a number, which the guard takes for a bad reading.
  rig.answer = FalconRig::Answer::good;
  rig.counts[0] = 3000, rig.counts[1] = -3000;
  CHECK(within(2, [&] { return std::isnan(device->exchange({}).position_mm); }));
}

TEST_CASE("Falcon: unplugged it is lost, and comes back with its firmware and without force") {
  FalconRig rig;
  auto settings = settingsWith(anyFalconFirmware());
  settings.period_s = 0.02;
  auto device = opened(settings);
  CHECK(settled(*device).fresh);
  rig.unplug();
  CHECK(within(2, [&] { return !device->exchange({}).fresh && device->state() == ForceDeviceState::lost; }));
  rig.powerCycle();
  rig.plugIn();
  ForceReading back;
  CHECK(within(20, [&] { return (back = device->exchange({})).fresh; }));
  CHECK(back.zero == ForceReading::Zero::lost);
  CHECK(device->counts().reconnects == 1);
  CHECK(device->counts().firmwareTries == 2);
  auto second = openFalcon({.number = 1, .firmware = {}, .period_s = 0.01});
  REQUIRE_FALSE(second);
  CHECK(english(second.failure().problem) == "the Falcon is not connected");
}
