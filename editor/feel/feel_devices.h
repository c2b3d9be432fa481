// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Access of the feel panel to sound and force devices: playback's public interface, or a test's replacement.

#include <functional>
#include <memory>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// All functions may take seconds and are called on separate threads.
struct FeelDevices {
  std::function<Result<std::unique_ptr<playback::LivePlayer>>(const playback::PlayerSettings&,
                                                              const playback::LiveProgram&)>
      open = playback::LivePlayer::start;
  std::function<Result<std::unique_ptr<playback::ForcePlayer>>(const Button&,
                                                               const playback::ForcePlayerSettings&)>
      openForce = playback::ForcePlayer::start;
  std::function<Result<std::vector<playback::SoundDevice>>()> list = playback::listSoundDevices;
};

}  // namespace detent::editor
