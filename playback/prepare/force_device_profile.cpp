// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

ForceDeviceProfile simulatedDevice() {
  ForceDeviceProfile p;
  p.name = "simulated device";
  p.step_mm = 0.001;
  p.limits.force_N = 10;
  return p;
}

ForceDeviceProfile falconDevice() {
  ForceDeviceProfile p;
  p.name = "Novint Falcon";
  p.mass_kg = 0.1;
  p.friction_N = 0.1;
  p.step_mm = 0.038;
  p.limits.force_N = 8;      // value of libnifalcon and CHAI3D
  p.limits.lowest_mm = -40;  // its reach is 100 mm, with the rest position at falconRest_mm
  p.limits.highest_mm = 70;
  p.guide = {true, 1.0, 0.002, 3};
  return p;
}

ForceDeviceProfile voiceCoilRig() {
  ForceDeviceProfile p;
  p.name = "voice coil, 10 µm encoder";
  p.step_mm = 0.01;
  p.limits.force_N = 10;
  return p;
}

}  // namespace detent::playback
