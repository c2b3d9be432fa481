// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play identify-device over the links of a microcontroller and an ODrive, in real time. Issue 25,
// section 2.

#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "playback/measurement/force_profile_file.h"
#include "tests/cli/run_program.h"
#include "tests/playback/plant/closed_loop.h"
#include "tests/playback/plant/finger.h"
#include "tests/playback/plant/judged.h"
#include "tests/playback/plant/odrive_emulator.h"
#include "tests/playback/plant/serial_emulator.h"

using namespace detent;
using namespace detent::test;

namespace {

// Heavy: a machine that others use pauses, and a light handle would leave its range meanwhile.
HandleSettings handleOnLink() {
  HandleSettings handle;
  handle.mass_kg = 0.4;
  handle.coulomb_N = 0.06;
  handle.static_N = 0.07;
  handle.damping_Ns_per_mm = 0.002;
  handle.motorLag_s = 0.001;
  return handle;
}

struct OnLink {
  int exitCode = 0;
  std::string said;  ///< stderr
  nlohmann::json found;
  bool profileKept = false;
  double largestMotor_N = 0;
  Witness device{};
  bool near(const char* figure, double truth, double within) const {
    return std::abs(found.at(figure).get<double>() - truth) <= within;
  }
  bool right() const {
    return exitCode == 0 && near("mass_kg", 0.4, 0.02) && near("friction_N", 0.06, 0.01) &&
           near("damping_Ns_per_mm", 0.002, 0.0003);
  }
};

// Slow enough that delays of a busy machine do not matter beside the device's own time.
template <class Emulator, class Settings>
OnLink identifiedOn(const std::string& kind) {
  const tests::ProgramFolder folder("plant_identify");
  Settings settings;
  settings.pty.handle = handleOnLink();
  settings.pty.plan = holding(-30);
  settings.pty.period_s = 0.005;  // --rate
  Emulator device(settings);
  const tests::ProgramResult result =
      folder.run(DETENT_PLAY, {"identify-device", "--device", kind + device.port(), "--range", "30", "--rate",
                               "200", "--step-mm", "0.001", "--json", "-o", "own.device"});
  device.halt();
  return {result.exitCode,
          result.err,
          nlohmann::json::parse(result.out, nullptr, false),
          static_cast<bool>(playback::readForceDevice((folder.path() / "own.device").string())),
          device.largestMotor_N(),
          device.witness(1.01)};
}

template <class Emulator, class Settings>
void checkOnLink(const std::string& kind) {
  const OnLink run = undisturbed([&] { return identifiedOn<Emulator, Settings>(kind); },
                                 [](const OnLink& r) { return r.right(); });
  if (!judged(run.device, kind + " identify-device")) return;
  INFO(run.said << "\n" << run.found.dump(1));
  CHECK(run.right());
  CHECK(run.profileKept);
  CHECK(run.largestMotor_N <= 1.01);  // an ODrive's torques have six digits
}

}  // namespace

TEST_CASE("a microcontroller's device is measured over its link", "[serial]") {
  checkOnLink<SerialEmulator, SerialEmulatorSettings>("serial:");
}

TEST_CASE("an ODrive's device is measured over its link", "[odrive]") {
  checkOnLink<OdriveEmulator, OdriveEmulatorSettings>("odrive:");
}
