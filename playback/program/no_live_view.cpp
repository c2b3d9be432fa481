// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_command.h"

namespace detent::playback {

int runLive(const LiveArguments&, const std::vector<Button>&, const DeviceProfile&, const Cancelled&) {
  return fail({FailureCode::deviceTrouble, "live playback", "", "this build of Detent has no live playback",
               "Install a build of Detent with live playback, or write the vibration to a sound file with "
               "`detent-play render`"});
}

}  // namespace detent::playback
