// SPDX-License-Identifier: GPL-3.0-or-later
// Replacement for builds without libusb.

#include "playback/device/falcon_force_device.h"

namespace detent::playback {

Result<std::unique_ptr<ForceDevice>> openFalcon(const FalconSettings&) {
  return Failure{FailureCode::deviceTrouble, "Novint Falcon", "", Message("is not part of this build"),
                 Message("Build with libusb-1.0-0-dev and -DDETENT_WITH_FALCON=ON")};
}

}  // namespace detent::playback
