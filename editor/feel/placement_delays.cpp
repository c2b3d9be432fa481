// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/placement_delays.h"

#include <cstdlib>
#include <QCoreApplication>

#include "editor/quantity/quantity.h"

namespace detent::editor {

QString measuredDelay(playback::EventPlacement placement, unsigned bufferFrames) {
  const PlacementDelay* nearest = nullptr;
  const auto far = [&](const PlacementDelay& d) {
    return std::abs(d.bufferFrames - static_cast<int>(bufferFrames));
  };
  for (const PlacementDelay& delay : placementDelays)
    if (delay.placement == placement && (nearest == nullptr || far(delay) < far(*nearest))) nearest = &delay;
  return QCoreApplication::translate("PlacementDelay", "%1 ms, spread %2 ms (%3 sample frames at 48 kHz)")
      .arg(fixedText(nearest->median_ms, 1), numberText(nearest->spread_ms, 2),
           numberText(nearest->bufferFrames));
}

}  // namespace detent::editor
