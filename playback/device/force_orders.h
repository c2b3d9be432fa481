// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Stops a running force loop from outside: by a key of the terminal, a signal, or an OSC or FUDI-like message
// over UDP. Each acts within milliseconds on its own thread, whatever the program does meanwhile.

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "model/result.h"
#include "playback/device/force_loop.h"
#include "playback/device/signal_server.h"

namespace detent::playback {

struct ForceOrderSettings {
  bool keys = false;                     ///< keys of standard input, if it is a terminal
  bool signals = false;                  ///< SIGUSR1, and signals that end the program
  std::optional<std::uint16_t> oscPort;  /// 0: the system chooses
  std::string oscAddress = thisMachineOnly;
  /// the space bar and /detent/hold hold the force; otherwise the space bar stops it
  bool holdToRun = false;
};

/// Keys: `a` arms if no other key came within 0.2 s (the function keys of a terminal send several
/// characters); every other key stops. OSC: /detent/stop, /detent/hold. Arming needs somebody at the
/// terminal, so it is impossible over the network or by a signal.
class ForceOrders {
 public:
  /// The loop must outlive it. Failure if the port cannot be opened.
  static Result<std::unique_ptr<ForceOrders>> start(ForceLoop& loop, const ForceOrderSettings& settings);
  ~ForceOrders();
  ForceOrders(const ForceOrders&) = delete;
  ForceOrders& operator=(const ForceOrders&) = delete;

  std::uint16_t oscPort() const { return osc_ ? osc_->port() : 0; }
  /// Handles a pressed key; `time_s` on now_s().
  void key(char pressed, double time_s);

 private:
  ForceOrders(ForceLoop& loop, const ForceOrderSettings& settings) : loop_(loop), settings_(settings) {}
  void watchKeys();

  ForceLoop& loop_;
  ForceOrderSettings settings_;
  double otherKey_s_ = -1e9;
  std::unique_ptr<SignalServer> osc_;
  std::atomic<bool> ending_{false};
  std::thread keys_;
};

}  // namespace detent::playback
