// SPDX-License-Identifier: GPL-3.0-or-later
// In a program without devices nothing runs that could be watched live.
#include "playback/program/live_line.h"

namespace detent::playback {

void LiveLine::show(const std::string&) {}
void LiveLine::end() {}

}  // namespace detent::playback
