// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play latency`: measures the delay from force to vibration.
void addLatencyCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
