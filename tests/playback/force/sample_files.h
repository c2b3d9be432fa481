// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The buttons of samples/buttons.

#include <stdexcept>
#include <string>
#include <vector>

#include "model/file/button_file.h"
#include "tests/playback/sample_buttons.h"

namespace detent::test {

inline std::vector<std::string> sampleNames() {
  return {"A", "B", "C", "D", "E", "F", "EF", "push", "latch"};
}

inline Button sampleButton(const std::string& name) {
  Result<Button> button = readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/" + name + ".button.json");
  if (!button) throw std::runtime_error(button.failure().sentence());
  return *std::move(button);
}

}  // namespace detent::test
