// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/study/trials/study_folder.h"

namespace detent::test {

std::string sample(const std::string& name) {
  return std::string(DETENT_SOURCE_DIR) + "/samples/buttons/" + name + ".button.json";
}

}  // namespace detent::test
