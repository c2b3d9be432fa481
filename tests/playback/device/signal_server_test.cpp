// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/signal_server.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <vector>

#include <catch2/catch.hpp>
#include <lo/lo.h>

#include "playback/device/pd_route.h"
#include "playback/device/steady_clock.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

struct Inbox {
  std::mutex mutex;
  std::vector<SignalMessage> messages;
  SignalReceiver receiver() {
    return [this](const SignalMessage& m, double arrival_s) {
      const std::lock_guard lock(mutex);
      CHECK(std::fabs(arrival_s - now_s()) < 1);
      messages.push_back(m);
    };
  }
  std::size_t size() {
    const std::lock_guard lock(mutex);
    return messages.size();
  }
  bool waitFor(std::size_t count) {
    for (const double end = now_s() + 2; now_s() < end; sleepUntil(now_s() + 0.005)) {
      if (size() >= count) return true;
    }
    return size() >= count;
  }
};

}  // namespace

TEST_CASE("FUDI over UDP: what is sent arrives, rubbish is counted") {
  Inbox inbox;
  auto server = openFudiServer(0, thisMachineOnly, inbox.receiver());
  REQUIRE(server);
  auto sender = SignalSender::open("127.0.0.1", (*server)->port());
  REQUIRE(sender);
  SignalMessage m;
  m.kind = SignalKind::jump;
  m.burst = {390, 0.02, 0.8};
  for (int i = 0; i < 100; ++i) {
    (*sender)->send(m);
    sleepUntil(now_s() + 0.001);
  }
  CHECK(inbox.waitFor(100));
  SignalMessage bad = m;
  bad.burst.amplitude = 7;
  (*sender)->send(bad);
  for (const double end = now_s() + 1; now_s() < end && (*server)->counts().malformed == 0;)
    sleepUntil(now_s() + 0.01);
  CHECK((*server)->counts().malformed == 1);
  CHECK((*server)->counts().messages == 100);
  Inbox other;
  CHECK_FALSE(openFudiServer((*server)->port(), thisMachineOnly, other.receiver()));
}

TEST_CASE("OSC: messages of several number types arrive, others are counted") {
  Inbox inbox;
  auto server = openOscServer(0, thisMachineOnly, inbox.receiver());
  REQUIRE(server);
  const lo_address target = lo_address_new("127.0.0.1", std::to_string((*server)->port()).c_str());
  lo_send(target, "/detent/jump", "fff", 390.0, 20.0, 0.5);
  lo_send(target, "/detent/force", "d", 1.25);
  lo_send(target, "/detent/bottom", "iif", 200, 30, 0.5);
  lo_send(target, "/detent/grain", "F");  // a toggle that is let go: no grain
  lo_send(target, "/detent/grain", "f", 0.0);
  lo_send(target, "/detent/grain", "");
  lo_send(target, "/detent/grain", "T");
  lo_send(target, "/detent/grain", "i", 127);
  CHECK(inbox.waitFor(6));
  CHECK(inbox.messages.size() == 6);
  CHECK((inbox.messages[4].bare && inbox.messages[5].bare));
  CHECK(inbox.messages[1].value == 1.25);
  CHECK(inbox.messages[2].burst.duration_s == Approx(0.030));
  lo_send(target, "/detent/jump", "s", "loud");
  lo_send(target, "/elsewhere", "f", 1.0);
  for (const double end = now_s() + 1; now_s() < end && (*server)->counts().malformed < 2;)
    sleepUntil(now_s() + 0.01);
  CHECK((*server)->counts().malformed == 2);
  lo_address_free(target);
}

TEST_CASE("Pd route: a message per grain and jump, in order") {
  Inbox inbox;
  auto server = openFudiServer(0, thisMachineOnly, inbox.receiver());
  REQUIRE(server);
  auto sender = SignalSender::open("127.0.0.1", (*server)->port());
  REQUIRE(sender);
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  PdRoute route(std::move(*sender));
  StrokeTracker tracker;
  tracker.use(program.get());
  for (int i = 0; i <= 200; ++i) {
    route.send(tracker.updateForce(i * 0.005), *program);
    sleepUntil(now_s() + 0.0005);
  }
  CHECK(inbox.waitFor(route.sent()));
  std::size_t jumps = 0, grains = 0, bottoms = 0;
  for (const SignalMessage& m : inbox.messages) {
    jumps += m.kind == SignalKind::jump ? 1 : 0;
    grains += m.kind == SignalKind::grain ? 1 : 0;
    bottoms += m.kind == SignalKind::bottomOut ? 1 : 0;
  }
  CHECK(jumps == 1);
  CHECK(bottoms == 1);
  CHECK(grains > 30);
}
