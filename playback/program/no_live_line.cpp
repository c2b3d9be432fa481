// SPDX-License-Identifier: GPL-3.0-or-later
// A program without devices has nothing that runs while one watches.
#include "playback/program/live_line.h"

namespace detent::playback {

void LiveLine::show(const std::string&) {}
void LiveLine::end() {}

}  // namespace detent::playback
