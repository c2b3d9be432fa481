// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play render`: writes a press to a sound file, with the same samples as live playback.
void addRenderCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
