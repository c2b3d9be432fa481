// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_command.h"

namespace detent::playback {

int runLive(const LiveArguments&, const std::vector<Button>&, const DeviceProfile&, const Cancelled&) {
  return fail({FailureCode::deviceTrouble, "live playback", "", "is not part of this build",
               "Build with -DDETENT_WITH_DEVICE=ON, or use `detent-play render`"});
}

}  // namespace detent::playback
