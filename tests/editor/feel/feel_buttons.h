// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Buttons and devices for the tests of the feel panel.

#include <atomic>
#include <memory>
#include <stdexcept>

#include "editor/feel/feel_devices.h"
#include "tests/playback/sample_buttons.h"

namespace detent::test {

/// A machine without a sound device. Counts the requests for one.
struct NoDevices {
  std::shared_ptr<std::atomic<int>> opened = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<std::atomic<int>> listed = std::make_shared<std::atomic<int>>(0);

  editor::FeelDevices devices() const {
    editor::FeelDevices d;
    d.open = [count = opened](const playback::PlayerSettings&,
                              const playback::LiveProgram&) -> Result<std::unique_ptr<playback::LivePlayer>> {
      ++*count;
      return Failure{FailureCode::deviceTrouble, "default device", "", "no sound output was found",
                     "Connect a sound device, or start a JACK server"};
    };
    d.list = [count = listed]() -> Result<std::vector<playback::SoundDevice>> {
      ++*count;
      return std::vector<playback::SoundDevice>{};
    };
    return d;
  }
};

}  // namespace detent::test
