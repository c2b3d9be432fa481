// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The paper's own route, for comparison: each event that the finger meets is sent as a signal message at
// once, and Pure Data makes the sound (samples/puredata/detent.pd).

#include <memory>

#include "playback/device/signal_server.h"
#include "playback/realtime/stroke_tracker.h"

namespace detent::playback {

/// Sends one message per crossing. One thread.
class PdRoute {
 public:
  explicit PdRoute(std::unique_ptr<SignalSender> sender) : sender_(std::move(sender)) {}
  /// `crossings`: of a tracker that follows `program`.
  void send(const Crossings& crossings, const HapticProgram& program);
  std::uint64_t sent() const { return sent_; }

 private:
  std::unique_ptr<SignalSender> sender_;
  std::uint64_t sent_ = 0;
};

}  // namespace detent::playback
