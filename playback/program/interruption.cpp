// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/interruption.h"

#include <csignal>

#include "model/staged_file.h"
#include "playback/device/signal_watch.h"

namespace detent::playback {

namespace {
// Acceptable delay after Ctrl-C (0.5 s) minus the time that the system needs to end a process.
constexpr double grace_s = 0.3;
}  // namespace

struct Interruption::Hearing {
  SignalWatch watch{grace_s, &StagedFile::removeAll};
};

// A file that reaches the system's size limit is treated like a full disk: the write fails with a message,
// instead of the signal ending the program silently.
Interruption::Interruption() : hearing_(std::make_unique<Hearing>()) { std::signal(SIGXFSZ, SIG_IGN); }
Interruption::~Interruption() = default;
bool Interruption::requested() const { return hearing_->watch.seen(); }

}  // namespace detent::playback
