// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/program/study_commands.h"

#include "playback/study/program/between_command.h"
#include "playback/study/program/confusion_command.h"
#include "playback/study/program/study_command.h"

namespace detent::playback {

void addStudyCommands(CLI::App& program, Action& chosen) {
  addConfusionCommand(program, chosen);
  addBetweenCommand(program, chosen);
  addStudyCommand(program, chosen);
}

}  // namespace detent::playback
