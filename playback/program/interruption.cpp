// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/interruption.h"

#include "playback/device/signal_watch.h"

namespace detent::playback {

namespace {
constexpr double grace_s =
    0.35;  // what nobody minds after Ctrl-C, less what the system needs to end a process
}

struct Interruption::Hearing {
  SignalWatch watch{grace_s};
};

Interruption::Interruption() : hearing_(std::make_unique<Hearing>()) {}
Interruption::~Interruption() = default;
bool Interruption::requested() const { return hearing_->watch.seen(); }

}  // namespace detent::playback
