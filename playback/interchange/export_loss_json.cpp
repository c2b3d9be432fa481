// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/export_loss_json.h"

namespace detent::playback {

nlohmann::ordered_json jsonOf(const ExportLoss& loss) {
  nlohmann::ordered_json kept;
  for (std::size_t band = 0; band < feltBands.size(); ++band) {
    kept[feltBands[band].name] = nullptr;
    if (loss.energyKept[band]) kept[feltBands[band].name] = *loss.energyKept[band];
  }
  return {{"energy_kept", kept},
          {"worst_timing_error_ms", loss.worstTimingError_ms},
          {"grains_merged", loss.grainsMerged},
          {"frequency_moved_Hz", loss.frequencyMoved_Hz},
          {"dropped", loss.dropped}};
}

}  // namespace detent::playback
