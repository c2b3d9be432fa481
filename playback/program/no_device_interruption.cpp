// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include "playback/program/interruption.h"

namespace detent::playback {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void onInterrupt(int number) {
  interrupted = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

struct Interruption::Hearing {};

Interruption::Interruption() {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}
Interruption::~Interruption() = default;
bool Interruption::requested() const { return interrupted != 0; }

}  // namespace detent::playback
