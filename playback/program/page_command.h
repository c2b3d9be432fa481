// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play page`: buttons as one web page that anyone can press.
void addPageCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
