// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/interruption.h"

#include "model/staged_file.h"
#include "playback/device/signal_watch.h"

namespace detent::playback {

namespace {
// What nobody minds after Ctrl-C (0.5 s), less what the system needs to end a process.
constexpr double grace_s = 0.3;
}  // namespace

struct Interruption::Hearing {
  SignalWatch watch{grace_s, &StagedFile::removeAll};
};

Interruption::Interruption() : hearing_(std::make_unique<Hearing>()) {}
Interruption::~Interruption() = default;
bool Interruption::requested() const { return hearing_->watch.seen(); }

}  // namespace detent::playback
