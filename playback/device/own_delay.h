// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Delay of this computer's own terminals, to distinguish a busy computer from a slow device.

namespace detent::playback {

/// Delay from one end of a pseudo terminal to the other: nine of ten lines take no longer. 0 if none can be
/// opened. Takes some milliseconds.
double ownTerminalDelay_s();

}  // namespace detent::playback
