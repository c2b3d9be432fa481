// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace detent::playback {

/// The table "Hits and misses" of docs/reference/press-forecast.md as lines of a help text, one effect each;
/// generated from that page when the build is configured.
extern const char* const pressEffects;

}  // namespace detent::playback
