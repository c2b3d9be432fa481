// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/pd_route.h"

namespace detent::playback {

PdRoute::PdRoute(const HapticProgram& program, std::unique_ptr<SignalSender> sender)
    : program_(std::make_unique<HapticProgram>(program)), sender_(std::move(sender)) {
  tracker_.use(program_.get());
}

void PdRoute::onForce(double force_N) {
  const Crossings& crossings = tracker_.updateForce(force_N);
  for (std::size_t i = 0; i < crossings.count; ++i) {
    const Crossing& c = crossings.items[i];
    const StateProgram& state = program_->states[c.state];
    SignalMessage message;
    switch (c.kind) {
      case CrossingKind::grain:
        message.kind = SignalKind::grain;
        message.burst = program_->grain;
        break;
      case CrossingKind::pressJump:
        message.kind = SignalKind::jump;
        message.burst = state.press.jumps[c.jump].burst;
        break;
      case CrossingKind::releaseJump:
        message.kind = SignalKind::jump;
        message.burst = state.release.jumps[c.jump].burst;
        break;
      case CrossingKind::bottomOut:
        message.kind = SignalKind::bottomOut;
        message.burst = program_->bottomOut;
        break;
      case CrossingKind::contactClosed:
      case CrossingKind::contactOpened:
        continue;
    }
    sender_->send(message);
    ++sent_;
  }
}

}  // namespace detent::playback
