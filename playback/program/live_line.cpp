// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_line.h"

#include <algorithm>
#include <cstdio>

#include "playback/device/terminal.h"

namespace detent::playback {

namespace {

constexpr int narrowestTerminal = 20;

}  // namespace

void LiveLine::show(const std::string& text) {
  if (!errorIsTerminal()) return;
  std::string line = text;
  line.resize(static_cast<std::size_t>(std::max(terminalColumns() - 1, narrowestTerminal)), ' ');
  std::fprintf(stderr, "\r%s", line.c_str());
  begun_ = true;
}

void LiveLine::end() {
  if (begun_) std::fprintf(stderr, "\n");
  begun_ = false;
}

}  // namespace detent::playback
