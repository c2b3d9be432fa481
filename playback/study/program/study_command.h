// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play study new|run|status|report: studies whether people can distinguish these buttons.

#include "playback/program/command.h"

namespace detent::playback {

void addStudyCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
