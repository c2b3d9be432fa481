// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/force_orders.h"

#include <utility>

#include "playback/device/signal_watch.h"
#include "playback/device/steady_clock.h"
#include "playback/device/terminal.h"

namespace detent::playback {

namespace {

constexpr double aloneFor_s = 0.2;  // the characters of an escape sequence arrive together
constexpr double keyWait_s = 0.05;

}  // namespace

Result<std::unique_ptr<ForceOrders>> ForceOrders::start(ForceLoop& loop, const ForceOrderSettings& settings) {
  std::unique_ptr<ForceOrders> orders(new ForceOrders(loop, settings));
  if (settings.oscPort) {
    Result<std::unique_ptr<SignalServer>> osc =
        openOscServer(*settings.oscPort, settings.oscAddress, [&loop](const SignalMessage& message, double) {
          if (message.kind == SignalKind::stop) loop.emergencyStop();
          if (message.kind == SignalKind::hold) loop.hold(true);
        });
    if (!osc) return osc.failure();
    orders->osc_ = *std::move(osc);
  }
  if (settings.signals) setEmergencyDeed([&loop] { loop.emergencyStop(); });
  if (settings.keys) orders->keys_ = std::thread([raw = orders.get()] { raw->watchKeys(); });
  return orders;
}

ForceOrders::~ForceOrders() {
  if (settings_.signals) setEmergencyDeed({});
  ending_ = true;
  if (keys_.joinable()) keys_.join();
}

void ForceOrders::key(char pressed, double time_s) {
  if (settings_.holdToRun && pressed == ' ') return loop_.hold(true);
  if (pressed == 'a') {
    if (time_s - otherKey_s_ >= aloneFor_s) loop_.rearm();
    return;
  }
  otherKey_s_ = time_s;
  loop_.emergencyStop();
}

void ForceOrders::watchKeys() {
  RawTerminal terminal;
  while (!ending_ && terminal.interactive()) {
    if (const std::optional<char> pressed = terminal.key(keyWait_s)) key(*pressed, now_s());
  }
}

}  // namespace detent::playback
