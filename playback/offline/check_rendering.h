// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What can be said of a rendering before anything is computed or written.

#include "playback/offline/render_press.h"

namespace detent::playback {

/// Failure wrongUsage: settings outside their ranges, a trace without readings, one whose times begin more than a week after 0.
Result<Done> checkRendering(const PressTrace& trace, const RenderSettings& settings);

}  // namespace detent::playback
