// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play without studies.

#include "playback/study/program/study_commands.h"

namespace detent::playback {

void addStudyCommands(CLI::App&, Action&) {}

}  // namespace detent::playback
