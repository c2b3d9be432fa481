// SPDX-License-Identifier: GPL-3.0-or-later
// Who stops a running force loop, how fast, and that the loop allocates nothing while it runs.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <lo/lo.h>
#include <pty.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include "playback/device/force_orders.h"
#include "playback/device/serial_force_device.h"
#include "playback/device/signal_watch.h"
#include "playback/device/steady_clock.h"
#include "playback/prepare/prepare_force.h"
#include "playback/prepare/spring_button.h"
#include "tests/playback/realtime/callback_guard.h"

namespace {

using namespace detent;
using namespace detent::playback;

ForceProgram benchProgram() {
  ForceDeviceProfile device = voiceCoilRig();
  device.limits.force_N = 5;
  const Result<Button> button = springButton("long spring", {{0.25}, {}, 40});
  REQUIRE(button);
  const auto prepared = prepareForce(*button, device);
  REQUIRE(prepared);
  return prepared->program;
}

/// A handle that stands 30 mm deep: the strongest force there is.
class DeepDevice : public ForceDevice {
 public:
  ForceReading exchange(const ForceCommand& command) override {
    if (command.force_N == 0 && force_N != 0) silent_s = now_s();
    force_N = command.force_N;
    return {30, {}, true};
  }
  void rearm() override { ++rearmed; }
  std::atomic<double> force_N{0}, silent_s{0};
  std::atomic<int> rearmed{0};
};

/// A loop at 1 kHz that has let the whole force through.
class Pressed {
 public:
  explicit Pressed(bool holdToRun = false) : program_(benchProgram()) {
    auto device = std::make_unique<DeepDevice>();
    device_ = device.get();
    loop_ = std::make_unique<ForceLoop>(std::move(device), program_, ForceLoopSettings{true, 0, holdToRun});
  }
  bool waitForForce(double force_N) {
    for (const double end_s = now_s() + 20; now_s() < end_s; sleepUntil(now_s() + 0.001)) {
      if (device_->force_N == force_N) return true;
    }
    return false;
  }
  /// In periods of the loop that ran meanwhile: a loaded machine delays a loop, which no loop can prevent.
  double secondsToSilence(const std::function<void()>& stop) {
    const std::uint64_t before = loop_->status().deadlines.steps;
    stop();
    CHECK(waitForForce(0));
    return static_cast<double>(loop_->status().deadlines.steps - before) * program_.period_s;
  }
  ForceLoop& loop() { return *loop_; }
  DeepDevice& device() { return *device_; }

 private:
  ForceProgram program_;
  DeepDevice* device_ = nullptr;
  std::unique_ptr<ForceLoop> loop_;
};

}  // namespace

TEST_CASE(
    "force stop: a key, an OSC message and a signal take the force away, and only the key a gives it back") {
  const SignalWatch watch(60, [] {});
  Pressed pressed;
  ForceOrderSettings settings;
  settings.signals = true;
  settings.oscPort = 0;
  auto orders = ForceOrders::start(pressed.loop(), settings);
  REQUIRE(orders);
  const lo_address target = lo_address_new("127.0.0.1", std::to_string((*orders)->oscPort()).c_str());
  double time_s = 100;
  const std::function<void()> stops[] = {
      [&] { (*orders)->key(' ', time_s); }, [&] { (*orders)->key('x', time_s); },
      [&] { lo_send(target, "/detent/stop", ""); },
      [&] { lo_send(target, "/detent/stop", "sf", "now", 1.0); }, [] { ::kill(::getpid(), SIGUSR1); }};
  int rearmed = 0;
  for (const auto& stop : stops) {
    REQUIRE(pressed.waitForForce(5));
    CHECK(pressed.secondsToSilence(stop) <= 0.015);
    sleepUntil(now_s() + 0.05);
    CHECK(pressed.device().force_N == 0);
    CHECK(pressed.loop().status().halt == ForceHalt::stopped);
    (*orders)->key('a', time_s + 0.1);  // a function key's letters
    (*orders)->key('[', time_s + 0.2);
    (*orders)->key('a', time_s + 0.2);
    sleepUntil(now_s() + 0.05);
    CHECK(pressed.device().force_N == 0);
    (*orders)->key('a', time_s += 1);
    REQUIRE(pressed.waitForForce(5));
    CHECK(pressed.device().rearmed > rearmed);
    rearmed = pressed.device().rearmed;
  }
  CHECK_FALSE(watch.seen());
  lo_address_free(target);
}

TEST_CASE("force stop: hold-to-run gives force while the key repeats and takes it when it is let go") {
  Pressed pressed(true);
  ForceOrderSettings settings;
  settings.holdToRun = true;
  auto orders = ForceOrders::start(pressed.loop(), settings);
  REQUIRE(orders);
  sleepUntil(now_s() + 0.05);
  CHECK(pressed.device().force_N == 0);
  std::atomic<bool> held{true};
  std::thread key([&] {
    while (held) {
      (*orders)->key(' ', 0);
      sleepUntil(now_s() + 0.01);
    }
  });
  CHECK(pressed.waitForForce(5));
  held = false;
  key.join();
  CHECK(pressed.waitForForce(0));
  CHECK(pressed.loop().status().halt == ForceHalt::notHeld);
}

namespace {

/// A pty whose other end is answered between two exchanges, on the same thread, so that each exchange finds
/// its answer waiting.
class AnsweredPty {
 public:
  AnsweredPty() {
    char name[64] = {};
    termios mode{};
    ::cfmakeraw(&mode);
    REQUIRE(::openpty(&master_, &slave_, name, &mode, nullptr) == 0);
    ::fcntl(master_, F_SETFL, O_NONBLOCK);
    port = name;
  }
  ~AnsweredPty() {
    ::close(master_);
    ::close(slave_);
  }
  void say(const std::string& text) { REQUIRE(::write(master_, text.data(), text.size()) > 0); }
  std::string heard() {
    char bytes[1024];
    const ssize_t count = ::read(master_, bytes, sizeof bytes);
    return {bytes, count > 0 ? static_cast<std::size_t>(count) : 0};
  }
  std::string port;

 private:
  int master_ = -1, slave_ = -1;
};

}  // namespace

namespace {

/// Device whose handle is at 2 mm. The program then pauses between a question and its answer while the
/// finger pushes the handle to 6 mm.
class PausingDevice : public ForceDevice {
 public:
  ForceReading exchange(const ForceCommand& command) override {
    if (paused) forces_N.push_back(command.force_N);
    force_N = command.force_N;
    ForceReading reading;
    reading.position_mm = paused ? 6 : 2;
    if (!paused && pauses) {
      sleepUntil(now_s() + 0.06);
      paused = true;
    }
    return reading;
  }
  std::atomic<double> force_N{0};
  std::atomic<bool> pauses{false};
  bool paused = false;
  std::vector<double> forces_N;  ///< since the pause
};

}  // namespace

TEST_CASE("force loop: an answer from before a pause is not believed, and the force rises from nothing") {
  const ForceProgram program = benchProgram();  // 0.25 N/mm
  auto owned = std::make_unique<PausingDevice>();
  PausingDevice& device = *owned;
  ForceLoop loop(std::move(owned), program, ForceLoopSettings{});
  const auto waitFor = [&](double force_N) {
    const double end_s = now_s() + 20;
    while (std::abs(device.force_N - force_N) > 0.005 && now_s() < end_s) sleepUntil(now_s() + 0.001);
    CHECK(device.force_N == Approx(force_N).margin(0.005));
  };
  waitFor(0.5);
  device.pauses = true;
  waitFor(1.5);
  CHECK(loop.status().halt == ForceHalt::none);
  loop.stop();
  while (!loop.status().finished) sleepUntil(now_s() + 0.001);
  const double perStep_N = 1.5 * program.period_s / program.limits.startRamp_s;
  int aboveRamp = 0;
  for (std::size_t i = 0; i < device.forces_N.size(); ++i)
    aboveRamp += device.forces_N[i] > perStep_N * static_cast<double>(i + 1) + 1e-9 ? 1 : 0;
  CHECK(aboveRamp == 0);
}

TEST_CASE("force loop: a step allocates nothing") {
  if (!test::guardWorks()) return;
  const ForceProgram program = benchProgram();
  AnsweredPty pty;
  std::atomic<bool> opening{true};
  std::thread board([&] {
    while (opening) {
      const std::string line = pty.heard();
      if (line.find("?*") != std::string::npos) pty.say(forceLine("I,fake,10000,5000000,4000,64,2"));
      if (const std::size_t at = line.find("L,"); at != std::string::npos)
        pty.say(forceLine(line.substr(at, line.find('*', at) - at)));
      sleepUntil(now_s() + 0.001);
    }
  });
  auto device = SerialForceDevice::open(pty.port, 230400, 0.002, program.limits);
  opening = false;
  board.join();
  REQUIRE(device);
  ForceEngine engine(program);
  ForceCommand command;
  std::uint32_t fresh = 0;
  test::resetGuard();
  for (unsigned i = 1; i <= 500; ++i) {
    pty.heard();
    const std::string fields = std::to_string(i) + "," + std::to_string(1000 * i) + ",1000000,0";
    pty.say(i % 7 == 0 ? "rubbish\n" : forceLine("P," + fields));
    const test::GuardedScope guarded;
    const ForceReading reading = (*device)->exchange(command);
    command = engine.step(reading);
    fresh += reading.fresh ? 1 : 0;
  }
  CHECK(fresh > 400);
  CHECK(test::guardHits() > 0);  // calls to the port were guarded
  CHECK(test::guardedMemoryCalls() == 0);
}
