// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/pd_route.h"

namespace detent::playback {

void PdRoute::send(const Crossings& crossings, const HapticProgram& program) {
  for (std::size_t i = 0; i < crossings.count; ++i) {
    const Crossing& c = crossings.items[i];
    const StateProgram& state = program.states[c.state];
    SignalMessage message;
    switch (c.kind) {
      case CrossingKind::grain:
        message.kind = SignalKind::grain;
        message.burst = program.grain;
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
        message.burst = program.bottomOut;
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
