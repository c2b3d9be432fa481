// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play render`: a press to a sound file, sample for sample what live play gives.
void addRenderCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
