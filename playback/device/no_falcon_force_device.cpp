// SPDX-License-Identifier: GPL-3.0-or-later
// Replacement for builds without libusb.

#include "playback/device/falcon_force_device.h"

namespace detent::playback {

Result<std::unique_ptr<ForceDevice>> openFalcon(const FalconSettings&) {
  return Failure{FailureCode::deviceTrouble, "Novint Falcon", "",
                 Message("this build of Detent does not support the Novint Falcon"),
                 Message("Choose another force device, or install a build of Detent with the Falcon "
                         "(docs/guide/force-feedback.md)")};
}

}  // namespace detent::playback
