// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Delay of this computer's own terminals, to distinguish a busy computer from a slow device.

namespace detent::playback {

/// Nine of ten lines take no longer from one end of a pseudo terminal to the other; 0 where none can be had. Takes some milliseconds.
double ownTerminalDelay_s();

}  // namespace detent::playback
