// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/progress_line.h"

#include <cstdio>

#include "importer/batch/terminal.h"

namespace detent::importer {

ProgressLine::ProgressLine() : onTerminal_(stderrIsTerminal()) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double fraction, std::string_view what) {
  if (!onTerminal_) return;
  shown_ = true;
  std::fprintf(stderr, "\r\033[K%3.0f %% %.*s", 100 * fraction, static_cast<int>(what.size()), what.data());
  std::fflush(stderr);
}

}  // namespace detent::importer
