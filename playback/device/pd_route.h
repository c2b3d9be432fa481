// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The paper's own route for comparison: readings become signal messages at once, and Pure Data makes the
// sound (samples/puredata/detent.pd).

#include <memory>

#include "playback/device/signal_server.h"
#include "playback/realtime/stroke_tracker.h"

namespace detent::playback {

/// Follows a program's tables and sends a message per crossing. One thread; keeps a copy of the program.
class PdRoute {
 public:
  PdRoute(const HapticProgram& program, std::unique_ptr<SignalSender> sender);
  void onForce(double force_N);
  void onResume(double force_N) { tracker_.placeAtForce(force_N); }
  std::uint64_t sent() const { return sent_; }

 private:
  std::unique_ptr<HapticProgram> program_;
  std::unique_ptr<SignalSender> sender_;
  StrokeTracker tracker_;
  std::uint64_t sent_ = 0;
};

}  // namespace detent::playback
