// SPDX-License-Identifier: GPL-3.0-or-later
// Serial force devices over pseudo terminals: the sample firmware on a simulated board, an ODrive, and what
// goes wrong.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "playback/device/force_loop.h"
#include "playback/device/odrive_force_device.h"
#include "playback/device/port_names.h"
#include "playback/device/sensor_line.h"
#include "playback/device/serial_force_device.h"
#include "playback/device/serial_link.h"
#include "playback/device/steady_clock.h"
#include "playback/prepare/prepare_force.h"
#include "playback/prepare/spring_button.h"
#include "tests/playback/device/force_firmware.h"
#include "tests/playback/sample_buttons.h"

namespace {

using namespace detent;
using namespace detent::playback;
namespace fs = std::filesystem;

/// The other end of a serial line, behind a link with a stable name: answers each line by a function, on a
/// thread of its own.
class FakeDevice {
 public:
  using Answer = std::function<std::string(const std::string& line)>;
  explicit FakeDevice(Answer answer) : answer_(std::move(answer)) {
    static int devices = 0;
    port = (std::filesystem::temp_directory_path() /
            ("detent-force-" + std::to_string(::getpid()) + "-" + std::to_string(devices++)))
               .string();
    plugIn();
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeDevice() {
    ending_ = true;
    thread_.join();
    unplug();
  }
  void plugIn() {
    const std::lock_guard lock(mutex_);
    char name[64] = {};
    termios mode{};
    ::cfmakeraw(&mode);
    REQUIRE(::openpty(&master_, &slave_, name, &mode, nullptr) == 0);
    REQUIRE(::symlink(name, port.c_str()) == 0);
  }
  void unplug() {
    const std::lock_guard lock(mutex_);
    ::unlink(port.c_str());
    ::close(master_);
    ::close(slave_);
    master_ = slave_ = -1;
  }
  std::string port;

 private:
  void serve() {
    std::string received;
    while (!ending_) {
      sleepUntil(now_s() + 0.0002);
      const std::lock_guard lock(mutex_);
      pollfd poll{master_, POLLIN, 0};
      if (master_ < 0 || ::poll(&poll, 1, 1) <= 0) continue;
      char bytes[256];
      const ssize_t count = ::read(master_, bytes, sizeof bytes);
      if (count <= 0) continue;
      received.append(bytes, static_cast<std::size_t>(count));
      for (std::size_t end = 0; (end = received.find('\n')) != std::string::npos;
           received.erase(0, end + 1)) {
        const std::string text = answer_(received.substr(0, end));
        if (!text.empty()) [[maybe_unused]]
          const ssize_t written = ::write(master_, text.data(), text.size());
      }
    }
  }
  Answer answer_;
  std::mutex mutex_;
  int master_ = -1, slave_ = -1;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

constexpr double slow_s = 2;  // a period so long that a loaded machine answers within it

std::string bodyOf(const std::string& line) { return std::string(forceLineBody(line).value_or("")); }
std::string sequenceOf(const std::string& body) { return body.substr(2, body.find(',', 2) - 2); }

/// A board that answers as the protocol says; `position_nm` is what it measures.
std::string goodBoard(const std::string& line, long position_nm) {
  const std::string body = bodyOf(line);
  if (body == "?") return forceLine("I,fake,10000,5000000,4000,64,2");
  if (body.starts_with("F,") || body.starts_with("H,")) {
    return forceLine("P," + sequenceOf(body) + "," + sequenceOf(body) + "000," + std::to_string(position_nm) +
                     ",0");
  }
  if (body.starts_with("L,")) return forceLine(body);
  return body.empty() || body == "X" || body == "S" || body == "U" ? "" : forceLine("A");
}

// On a loaded machine the other end may miss whole periods, so each test repeats the request that it needs.
constexpr int tries = 30;

/// As the devices here have: 5 N.
ForceLimits benchLimits() { return {}; }

ForceProgram benchProgram(const Button& button, double limit_N = 5) {
  ForceDeviceProfile device = voiceCoilRig();
  device.limits.force_N = limit_N;
  const auto prepared = prepareForce(button, device);
  REQUIRE(prepared);
  return prepared->program;
}

/// Reaches 5 N at 5 mm, well within its travel.
Button longSpring() {
  const Result<Button> button = springButton("long spring", {{1}, {}, 20});
  REQUIRE(button);
  return *button;
}

std::unique_ptr<SerialForceDevice> opened(const FakeDevice& fake, double period_s = slow_s,
                                          const ForceLimits& limits = benchLimits()) {
  auto device = SerialForceDevice::open(fake.port, 230400, period_s, limits);
  for (int i = 1; i < tries && !device; ++i)
    device = SerialForceDevice::open(fake.port, 230400, period_s, limits);
  REQUIRE(device);
  return std::move(*device);
}

/// The next reading that is one. Where it has come, the other end has dealt with every line before it.
ForceReading answered(ForceDevice& device, const ForceCommand& command = {}) {
  ForceReading reading = device.exchange(command);
  for (int i = 1; i < tries && !reading.fresh; ++i) reading = device.exchange(command);
  CHECK(reading.fresh);
  return reading;
}

bool takesTable(SerialForceDevice& device, const ForceProgram& program) {
  for (int i = 0; i < tries; ++i) {
    if (device.upload(program)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("serial force device: forces go out, positions come back") {
  std::atomic<long> force_uN{0};
  FakeDevice fake([&](const std::string& line) {
    const std::string body = bodyOf(line);
    if (body.starts_with("F,")) force_uN = std::atol(body.substr(body.rfind(',') + 1).c_str());
    return goodBoard(line, 1250000);
  });
  auto device = opened(fake);
  CHECK(device->info().step_mm == Approx(0.01));
  CHECK(device->info().force_N == Approx(5));
  ForceCommand command;
  command.force_N = 1.5;
  const ForceReading reading = answered(*device, command);
  CHECK(reading.position_mm == Approx(1.25));
  CHECK(force_uN == 1500000);
}

TEST_CASE("serial force device: late, repeated, broken and half answers are no readings, and are counted") {
  std::atomic<int> mode{0};
  FakeDevice fake([&](const std::string& line) -> std::string {
    const std::string good = goodBoard(line, 0);
    if (!good.starts_with("P")) return good;
    switch (mode.load()) {
      case 0:
        return good + good;
      case 1:
        return "";
      case 2:
        return good.substr(0, good.size() / 2);
      case 3:
        return "P,1,2,3*00\n";
      default:
        return forceLine("P,1,1,1") + good;
    }
  });
  auto device = opened(fake, 1);
  answered(*device);
  mode = 1;
  CHECK_FALSE(device->exchange({}).fresh);
  CHECK(device->counts().late >= 1);
  mode = 2;
  CHECK_FALSE(device->exchange({}).fresh);
  mode = 3;
  CHECK_FALSE(device->exchange({}).fresh);
  CHECK(device->counts().malformed >= 1);
  mode = 4;
  answered(*device);
  CHECK(device->counts().repeated >= 1);
}

TEST_CASE("serial force device: nobody there, a wrong port and a table that does not fit are reported") {
  CHECK_FALSE(SerialForceDevice::open("/dev/null", 230400, 0.001, benchLimits()));
  CHECK_FALSE(SerialForceDevice::open("/nowhere", 230400, 0.001, benchLimits()));
  FakeDevice silent([](const std::string&) { return std::string(); });
  CHECK_FALSE(SerialForceDevice::open(silent.port, 230400, 0.001, benchLimits()));
  FakeDevice small([](const std::string& line) {
    return bodyOf(line) == "?" ? forceLine("I,small,10000,5000000,4000,0,2") : goodBoard(line, 0);
  });
  auto device = opened(small);
  CHECK_FALSE(device->upload(benchProgram(test::linearButton())));
}

TEST_CASE("serial force device: the sample firmware takes a table and renders the button with it") {
  firmware::setup();
  CHECK(firmware::exchange("?*3F").starts_with("I,force1d,10000,5000000,4000,256,2*"));
  CHECK(firmware::exchange("?*00").empty());
  FakeDevice board([](const std::string& line) { return firmware::exchange(line); });
  auto device = opened(board);
  const Button button = test::linearButton();
  REQUIRE(takesTable(*device, benchProgram(button)));
  firmware::counts = 0;
  for (int i = 0; i < 20; ++i) {  // the ramp
    answered(*device);
    firmware::run(10000);
  }
  for (int i = 0; i <= 200; ++i) {  // 2 mm inwards, slowly
    firmware::counts = i;
    answered(*device);
    firmware::run(20000);
  }
  CHECK(firmware::force_uN * 1e-6 == Approx(button.states().front().graph.press().force_N(2)).margin(0.01));
  CHECK(firmware::pwm > 0);
  // Silence: no force.
  firmware::run(60000);
  CHECK(firmware::pwm == 0);
}

namespace {

/// The sample firmware with a table, its handle at 2 mm and its force risen. From then on every `lost`th row
/// does not get through; 0: none.
class TableBoard {
 public:
  explicit TableBoard(std::size_t lost = 0) {
    firmware::setup();
    firmware::counts = 200;
    device_ = opened(fake_);
    REQUIRE(takesTable(*device_, benchProgram(test::linearButton())));
    exchanges(40);
    lost_ = lost;
  }
  SerialForceDevice& device() { return *device_; }
  /// 10 ms of the board's time each; the largest force there was meanwhile.
  double exchanges(int count) {
    double most_N = 0;
    for (int i = 0; i < count; ++i) {
      firmware::counts = firmware::counts ^ 1;  // a finger trembles
      answered(*device_);
      most_N = std::max(most_N, force_N());
      firmware::run(10000);
      most_N = std::max(most_N, force_N());
    }
    return most_N;
  }
  static double force_N() { return std::abs(firmware::force_uN) * 1e-6; }
  std::size_t rows() const { return rows_; }

 private:
  std::string heard(const std::string& line) {
    const bool row = bodyOf(line).starts_with("R,");
    rows_ += row ? 1 : 0;
    if (row && lost_ > 0 && rows_ % lost_ == 0) return {};
    return firmware::exchange(line);
  }

  std::atomic<std::size_t> lost_{0}, rows_{0};
  FakeDevice fake_{[this](const std::string& line) { return heard(line); }};
  std::unique_ptr<SerialForceDevice> device_;
};

double pressAt2_N(const Button& button) { return button.states().front().graph.press().force_N(2); }

}  // namespace

TEST_CASE("serial force device: another button takes the table's place, without force meanwhile") {
  for (const std::size_t lost : {std::size_t{0}, std::size_t{5}}) {
    TableBoard board(lost);
    CHECK(board.force_N() > 0.3);
    const Button other = test::tactileButton();
    board.device().setProgram(benchProgram(other));
    answered(board.device());
    CHECK(board.force_N() == 0);
    const std::size_t before = board.rows();
    CHECK(board.exchanges(200) == 0);  // of 256 rows
    CHECK(board.rows() >= before + 190);
    double rising_N = 0;
    for (int i = 0; i < 150 && rising_N == 0; ++i) rising_N = board.exchanges(1);
    CHECK(rising_N > 0);
    CHECK(rising_N < 5 * 0.011 / 0.2);  // along the ramp
    board.exchanges(40);
    // The force came to rest at 2 mm between release and press, because it rose from 0.
    const StrokeCurve& release = *other.states().front().graph.release();
    CHECK(board.force_N() > release.force_N(2) - 0.02);
    CHECK(board.force_N() < pressAt2_N(other) + 0.02);
    firmware::counts = 0;
    board.exchanges(10);
    for (int i = 0; i <= 200; i += 2) firmware::counts = i, board.exchanges(1);
    board.exchanges(30);
    CHECK(board.force_N() == Approx(pressAt2_N(other)).margin(0.01));
  }
}

TEST_CASE("serial force device: a row that may be on its way is not sent with every question") {
  std::atomic<bool> deaf{false};
  std::atomic<int> rows{0};
  FakeDevice fake([&](const std::string& line) {
    rows += bodyOf(line).starts_with("R,") ? 1 : 0;
    return deaf ? std::string() : goodBoard(line, 0);
  });
  auto device = opened(fake);
  REQUIRE(takesTable(*device, benchProgram(test::linearButton())));
  const int uploaded = rows;
  device->setProgram(benchProgram(test::tactileButton()));
  for (int i = 0; i < 10; ++i) answered(*device);
  const int before = rows;
  CHECK(before >= uploaded + 8);  // one with each answer
  CHECK(device->setPace(0.02));   // no answer will come: each question below waits for nothing
  deaf = true;
  for (int i = 0; i < 7; ++i) device->exchange({});
  CHECK(rows <= before + 1);
  for (int i = 0; i < 20; ++i) device->exchange({});
  for (int i = 0; i < 200 && rows < before + 2; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK(rows >= before + 2);  // lost, for all that is known
}

TEST_CASE("sample firmware: a table that begins ends the force of the one before") {
  TableBoard board;
  CHECK(board.force_N() > 0.3);
  std::string line = forceLine("T,2,0,1000000,10000,0,1000000");
  line.pop_back();
  CHECK(firmware::exchange(line).starts_with("A*"));
  CHECK(board.force_N() == 0);
}

TEST_CASE(
    "serial force device: a table that a pause has ended is sent again, and its force rises from nothing") {
  TableBoard board;
  const double before_N = board.force_N();
  CHECK(before_N > 0.3);
  firmware::run(60000);  // the board waits 50 ms
  CHECK(board.force_N() == 0);
  CHECK(board.exchanges(200) == 0);
  board.exchanges(120);
  CHECK(board.force_N() == Approx(before_N).margin(0.02));
}

TEST_CASE(
    "serial force device: a board that refuses another table has lost its place; armed it is given it "
    "again") {
  std::atomic<bool> refuses{false};
  std::atomic<int> forces{0}, rows{0};
  FakeDevice fake([&](const std::string& line) {
    const std::string body = bodyOf(line);
    forces += body.starts_with("F,") && !body.ends_with(",0") ? 1 : 0;
    rows += body.starts_with("R,") ? 1 : 0;
    return refuses && body.starts_with("R,") ? forceLine("N,row") : goodBoard(line, 0);
  });
  auto device = opened(fake);
  REQUIRE(takesTable(*device, benchProgram(test::linearButton())));
  refuses = true;
  device->setProgram(benchProgram(test::tactileButton()));
  bool lost = false;
  for (int i = 0; i < 10 && !lost; ++i) lost = answered(*device).zero == ForceReading::Zero::lost;
  CHECK(lost);
  ForceCommand pushing;
  pushing.force_N = 1;
  rows = 0;
  for (int i = 0; i < 3; ++i) answered(*device, pushing);
  CHECK(rows == 0);
  refuses = false;
  device->rearm();
  for (int i = 0; i < 10; ++i) answered(*device, pushing);
  CHECK(rows >= 8);
  CHECK(forces == 0);
}

TEST_CASE("serial force device: a device whose clock stands still measures nothing anew") {
  std::atomic<bool> frozen{false};
  FakeDevice fake([&](const std::string& line) {
    const std::string body = bodyOf(line);
    return frozen && body.starts_with("F,") ? forceLine("P," + sequenceOf(body) + ",77,1000000,0")
                                            : goodBoard(line, 1000000);
  });
  auto device = opened(fake, 1);
  answered(*device);
  frozen = true;
  device->exchange({});
  CHECK_FALSE(device->exchange({}).fresh);
  CHECK(device->counts().repeated >= 1);
}

TEST_CASE(
    "serial force device: unplugged there is no reading; plugged in again it goes on, without its table "
    "until "
    "it is armed") {
  std::atomic<int> forces{0}, rows{0};
  FakeDevice fake([&](const std::string& line) {
    if (bodyOf(line).starts_with("F,")) ++forces;
    if (bodyOf(line).starts_with("R,")) ++rows;
    return goodBoard(line, 500000);
  });
  auto device = opened(fake, slow_s);
  REQUIRE(takesTable(*device, benchProgram(test::linearButton())));
  answered(*device);
  CHECK(forces == 0);
  fake.unplug();
  for (int i = 0; i < 3; ++i) CHECK_FALSE(device->exchange({}).fresh);
  CHECK(device->state() == ForceDeviceState::lost);
  fake.plugIn();
  bool back = false;
  for (const double end_s = now_s() + 10; !back && now_s() < end_s;) {
    back = device->exchange({}).fresh;
    sleepUntil(now_s() + 0.02);
  }
  CHECK(back);
  CHECK(device->counts().reconnects == 1);
  CHECK(forces > 0);
  rows = 0;
  for (int i = 0; i < 3; ++i) answered(*device);
  CHECK(rows == 0);
  device->rearm();
  for (int i = 0; i < 3; ++i) answered(*device);
  CHECK(rows > 0);
}

TEST_CASE(
    "serial force device: one that resets in the middle loses the force, which then rises from nothing") {
  std::atomic<long> position_nm{3000000};
  FakeDevice fake([&](const std::string& line) { return goodBoard(line, position_nm); });
  auto device = opened(fake, slow_s);
  auto prepared = prepareForce(test::linearButton(), voiceCoilRig());
  REQUIRE(prepared);
  // The guard's times are periods: those of 1 kHz, however slowly the test's machine exchanges.
  ForceEngine engine(prepared->program);
  ForceCommand command;
  for (int i = 0; i < 230; ++i) command = engine.step(answered(*device, command));
  CHECK(command.force_N ==
        Approx(test::linearButton().states().front().graph.curve(Stroke::release).force_N(3)).margin(0.01));
  position_nm = -40000000;  // farther from the last position than a hand moves in this time
  const double held_N = command.force_N;
  for (int i = 0; i < 3; ++i) command = engine.step(answered(*device, command));
  CHECK(command.force_N == Approx(held_N));
  double before_N = command.force_N;
  for (int i = 0; i < 40; ++i) {
    command = engine.step(device->exchange(command));
    CHECK(command.force_N <= before_N + 1e-9);
    before_N = command.force_N;
  }
  CHECK(engine.counts().absurd >= 4);
  CHECK(engine.counts().faded == 1);
  CHECK(engine.silent());
  for (int i = 0; i < 50; ++i) CHECK(engine.step(device->exchange({})).force_N == 0);
  CHECK(engine.halt() == ForceHalt::displaced);
}

TEST_CASE("serial force device: a board without a limit of its own is refused, and gives no force") {
  FakeDevice older([](const std::string& line) {
    return bodyOf(line) == "?" ? forceLine("I,old,10000,5000000,4000,64") : goodBoard(line, 0);
  });
  const auto old = SerialForceDevice::open(older.port, 230400, 0.001, benchLimits());
  REQUIRE_FALSE(old);
  CHECK(old.failure().sentence().find("limit") != std::string::npos);
  FakeDevice boastful([](const std::string& line) {
    const std::string body = bodyOf(line);
    return body.starts_with("L,") ? forceLine("L,9000000" + body.substr(body.find(',', 2)))
                                  : goodBoard(line, 0);
  });
  CHECK_FALSE(SerialForceDevice::open(boastful.port, 230400, 0.001, benchLimits()));
}

TEST_CASE("serial force device: table, host and simulation keep to the same limit and the same ramp") {
  const Button button = longSpring();
  for (const double limit_N : {0.3, 1.0, 5.0}) {
    firmware::setup();
    FakeDevice board([](const std::string& line) { return firmware::exchange(line); });
    const ForceProgram program = benchProgram(button, limit_N);
    auto device = opened(board, slow_s, program.limits);
    firmware::counts = 0;
    REQUIRE(takesTable(*device, program));
    ForceEngine host(program);
    double highest_N = 0;
    for (int i = 0; i <= 2500; ++i) {  // at rest for the ramp, then to far beyond the travel, slowly
      firmware::counts = std::max(0, i - 300) / 2;
      if (i % 10 == 0) answered(*device);
      firmware::run(1000);
      const double table_N = firmware::force_uN * 1e-6,
                   host_N = host.step({firmware::counts * 0.01, {}, true}).force_N;
      highest_N = std::max(highest_N, table_N);
      REQUIRE(std::abs(table_N) <= limit_N);
      REQUIRE(std::abs(table_N) <= limit_N * i / 200 + 0.001 * limit_N + limit_N / 100);
      // The table is thinned to what the board holds, and knows no lead.
      if (i > 300 && i % 2 == 1) CHECK(table_N == Approx(host_N).margin(0.03));
    }
    CHECK(highest_N == Approx(limit_N).margin(1e-6));
  }
}

TEST_CASE("serial force device: the board's switch and the host's stop end the force until somebody arms") {
  firmware::setup();
  FakeDevice board([](const std::string& line) { return firmware::exchange(line); });
  const ForceProgram program = benchProgram(longSpring(), 5);
  auto device = opened(board, slow_s, program.limits);
  ForceEngine engine(program);
  ForceCommand command;
  const auto exchange = [&] {
    firmware::counts = firmware::counts ^ 1;  // a finger trembles
    command = engine.step(answered(*device, command));
    firmware::run(1000);
  };
  firmware::counts = 1500;
  for (int i = 0; i < 300; ++i) exchange();
  REQUIRE(firmware::force_uN == 5000000);
  firmware::stopSwitch = 1;
  firmware::run(10);
  CHECK(firmware::pwm == 0);
  firmware::stopSwitch = 0;
  for (int i = 0; i < 300; ++i) exchange();
  CHECK(firmware::pwm == 0);
  CHECK(engine.halt() == ForceHalt::stopped);
  device->rearm();
  engine.rearm();
  for (int i = 0; i < 300; ++i) exchange();
  CHECK(firmware::force_uN == 5000000);
  engine.emergencyStop();
  for (int i = 0; i < 10; ++i) exchange();
  CHECK(firmware::force_uN == 0);
  // Emergency stop while the board runs its own table.
  engine.rearm();
  REQUIRE(takesTable(*device, program));
  for (int i = 0; i < 300; ++i) exchange();
  CHECK(firmware::force_uN == 5000000);
  engine.emergencyStop();
  for (int i = 0; i < 3; ++i) exchange();
  CHECK(firmware::force_uN == 0);
  for (int i = 0; i < 300; ++i) exchange();
  CHECK(firmware::force_uN == 0);
  engine.rearm();
  for (int i = 0; i < 300; ++i) exchange();
  CHECK(firmware::force_uN == 5000000);
  firmware::run(51000);  // a host that died
  CHECK(firmware::force_uN == 0);
}

TEST_CASE("serial force device: a dead encoder under an uploaded table is a halt by that name until armed") {
  firmware::setup();
  FakeDevice board([](const std::string& line) { return firmware::exchange(line); });
  const ForceProgram program = benchProgram(longSpring(), 5);
  auto device = opened(board, slow_s, program.limits);
  firmware::counts = 1500;
  REQUIRE(takesTable(*device, program));
  ForceProgram watching = program;
  watching.limits.deadCountAbove_N = std::numeric_limits<double>::infinity();  // as for every upload
  ForceEngine engine(watching);
  ForceCommand command;
  bool trembles = true;
  const auto exchange = [&](int times) {
    for (int i = 0; i < times; ++i) {
      if (trembles) firmware::counts = firmware::counts ^ 1;
      command = engine.step(answered(*device, command));
      firmware::run(1000);
    }
  };
  exchange(300);
  REQUIRE(firmware::force_uN == 5000000);
  CHECK(engine.halt() == ForceHalt::none);
  trembles = false;
  exchange(315);
  CHECK(firmware::force_uN == 0);
  exchange(110);
  CHECK(engine.halt() == ForceHalt::deadCount);
  trembles = true;
  exchange(50);
  CHECK(firmware::force_uN == 0);
  CHECK(engine.halt() == ForceHalt::deadCount);
  device->rearm();
  engine.rearm();
  exchange(300);
  CHECK(firmware::force_uN == 5000000);
  CHECK(engine.halt() == ForceHalt::none);
}

TEST_CASE("serial force device: a table longer than the firmware takes is thinned to what it holds") {
  std::atomic<int> rows{0}, announced{0};
  FakeDevice fake([&](const std::string& line) {
    const std::string body = bodyOf(line);
    rows += body.starts_with("R,") ? 1 : 0;
    if (body.starts_with("T,")) announced = std::atoi(body.c_str() + 2), rows = 0;
    return goodBoard(line, 0);
  });
  auto device = opened(fake);
  const ForceProgram program = benchProgram(test::linearButton());
  REQUIRE(program.states[0].rowCount > 64);
  CHECK(takesTable(*device, program));
  CHECK(rows == 64);
  CHECK(announced == 64);
  CHECK_FALSE(SerialForceDevice::open(fake.port, 12345, 0.001, benchLimits()));
}

namespace {

/// An ODrive as its manual describes it: an axis with errors, a state, and a watchdog that counts while it is
/// switched on.
class FakeOdrive {
 public:
  std::atomic<double> torque_Nm{0}, turns{1.5};
  std::atomic<int> state{1}, mode{0};
  std::atomic<unsigned> error{0};
  std::atomic<bool> watchdog{false}, newNames{false}, refusesToArm{false};
  std::atomic<double> fed_s{0}, longestHunger_s{0};

  std::string answer(const std::string& line) {
    const std::size_t star = line.rfind('*');
    if (star == std::string::npos || std::atoi(line.c_str() + star + 1) != lineChecksum(line.substr(0, star)))
      return "";
    if (watchdog && state == 8) longestHunger_s = std::max(longestHunger_s.load(), now_s() - fed_s);
    if (line.starts_with("c 0 ")) torque_Nm = state == 8 ? std::atof(line.c_str() + 4) : 0, fed_s = now_s();
    if (line.starts_with("sc ")) error = 0;
    if (line.starts_with("w axis0.requested_state 1 ")) state = 1;
    if (line.starts_with("w axis0.requested_state 8 ") && error == 0 && !refusesToArm) state = 8;
    if (line.starts_with("w axis0.requested_state 8 ") && refusesToArm) error = 0x40;
    if (line.starts_with("w axis0.config.enable_watchdog ")) watchdog = line[31] == '1', fed_s = now_s();
    if (line.starts_with("r axis0.current_state ")) return std::to_string(state) + "\r\n";
    if (line.starts_with(newNames ? "r axis0.active_errors " : "r axis0.error "))
      return std::to_string(error) + "\r\n";
    if (line.starts_with("w ")) return set(line.substr(2)), "";
    if (line.starts_with("r ")) {
      const std::lock_guard lock(mutex_);
      const auto found = settings_.find(line.substr(2, line.find(' ', 2) - 2));
      return (found == settings_.end() ? "invalid property" : found->second) + "\r\n";
    }
    if (!line.starts_with("f 0")) return "";
    if (mode == 1) return "nonsense\n";
    if (mode == 2) return "";
    if (mode == 3) return "nan 0.0\r\n";
    return std::to_string(turns.load()) + " 0.000000\r\n";
  }

  std::string setting(const std::string& name) {
    const std::lock_guard lock(mutex_);
    return settings_[name];
  }
  void change(const std::string& name, const std::string& value) {
    const std::lock_guard lock(mutex_);
    settings_[name] = value;
  }
  std::string stubborn;  ///< a setting that takes no other value

 private:
  void set(const std::string& text) {
    const std::lock_guard lock(mutex_);
    const std::size_t blank = text.find(' ');
    const auto found = settings_.find(text.substr(0, blank));
    if (found != settings_.end() && found->first != stubborn)
      found->second = text.substr(blank + 1, text.find_last_of(" *") - blank - 1);
    if (found != settings_.end() && found->second.find(' ') != std::string::npos)
      found->second.resize(found->second.find(' '));
  }
  std::mutex mutex_;
  std::map<std::string, std::string> settings_{
      {"axis0.config.enable_watchdog", "0"},
      {"axis0.config.watchdog_timeout", "0.000000"},
      {"axis0.motor.config.torque_lim", "inf"},
      {"axis0.controller.config.control_mode", "3"},
      {"axis0.controller.config.input_mode", "3"},
      {"axis0.controller.config.vel_limit", "2.000000"},
      {"axis0.controller.config.enable_torque_mode_vel_limit", "1"},
      {"axis0.controller.config.anticogging.anticogging_enabled", "1"}};
};

std::unique_ptr<OdriveForceDevice> openedOdrive(const FakeDevice& fake) {
  OdriveSettings settings;
  settings.port = fake.port;
  settings.period_s = 0.4;
  auto device = OdriveForceDevice::open(settings);
  for (int i = 1; i < tries && !device; ++i) device = OdriveForceDevice::open(settings);
  REQUIRE(device);
  return *std::move(device);
}

}  // namespace

TEST_CASE("ODrive: torque out by the capstan, turns back in mm, idle at the end") {
  FakeOdrive odrive;
  odrive.error = 0x800;  // the watchdog of a run before
  odrive.watchdog = true;
  FakeDevice fake([&](const std::string& line) { return odrive.answer(line); });
  {
    auto device = openedOdrive(fake);
    CHECK(device->state() == ForceDeviceState::ready);
    CHECK(odrive.state == 8);
    odrive.turns = 1.55;
    ForceCommand command;
    command.force_N = 2;
    // An ODrive's answers carry no number: one to the opening that comes late is a reading too.
    ForceReading reading = answered(*device, command);
    CHECK(odrive.watchdog);
    for (int i = 1; i < tries && reading.position_mm == 0; ++i) reading = answered(*device, command);
    CHECK(reading.position_mm == Approx(3).margin(1e-4));
    CHECK(odrive.torque_Nm == Approx(-2 * 60 / (2 * 3.14159265 * 1000)).margin(1e-5));
    command.halted = true;
    answered(*device, command);
    CHECK(odrive.torque_Nm == 0);
    odrive.mode = 1;
    CHECK_FALSE(device->exchange({}).fresh);
    CHECK(device->counts().malformed >= 1);
    odrive.mode = 2;
    CHECK_FALSE(device->exchange({}).fresh);
    CHECK(device->counts().late >= 1);
    odrive.mode = 3;  // NaN reaches the guard, which holds the force and then takes it away
    CHECK(std::isnan(answered(*device).position_mm));
  }
  for (const double end_s = now_s() + 20; odrive.state != 1 && now_s() < end_s;) sleepUntil(now_s() + 0.01);
  CHECK(odrive.state == 1);
  CHECK(odrive.torque_Nm == 0);
}

TEST_CASE("ODrive: an axis that does not arm is reported with its error, in both spellings") {
  for (const bool newNames : {false, true}) {
    FakeOdrive odrive;
    odrive.newNames = newNames;
    odrive.refusesToArm = true;
    const std::string named = newNames ? "missing input" : "motor failed";  // 0x40 in either firmware
    FakeDevice fake([&](const std::string& line) { return odrive.answer(line); });
    OdriveSettings settings;
    settings.port = fake.port;
    std::string said;
    for (int i = 0; i < tries && said.find(named) == std::string::npos; ++i) {
      const auto device = OdriveForceDevice::open(settings);
      REQUIRE_FALSE(device);
      said = device.failure().sentence();
    }
    CHECK(said.find(named) != std::string::npos);
    CHECK_FALSE(odrive.watchdog);  // nothing that is not armed starves
  }
}

TEST_CASE(
    "ODrive: an axis in error gives no force and says so, until a person arms it and its rest is taken "
    "anew") {
  FakeOdrive odrive;
  FakeDevice fake([&](const std::string& line) { return odrive.answer(line); });
  auto device = openedOdrive(fake);
  answered(*device);
  odrive.error = 0x100;
  odrive.state = 1;
  bool lost = false;
  for (int i = 0; i < tries && device->state() == ForceDeviceState::ready; ++i) {
    sleepUntil(now_s() + 0.025);
    lost = device->exchange({}).zero == ForceReading::Zero::lost || lost;
  }
  CHECK(device->state() == ForceDeviceState::fault);
  CHECK(english(odriveErrorWords(device->counts().fault, false)).find("encoder failed") != std::string::npos);
  ForceCommand command;
  command.force_N = 1;
  for (int i = 0; i < 3; ++i) lost = device->exchange(command).zero == ForceReading::Zero::lost || lost;
  CHECK(lost);
  CHECK(odrive.torque_Nm == 0);
  odrive.turns = 2.5;
  for (int i = 0; i < tries && device->state() != ForceDeviceState::ready; ++i) device->rearm();
  CHECK(device->state() == ForceDeviceState::ready);
  CHECK(device->counts().fault == 0);
  CHECK(answered(*device).position_mm == Approx(0).margin(1e-6));
}

TEST_CASE("ODrive: plugged in again its rest is taken anew, and the place counts as lost") {
  FakeOdrive odrive;
  FakeDevice fake([&](const std::string& line) { return odrive.answer(line); });
  auto device = openedOdrive(fake);
  answered(*device);
  fake.unplug();
  for (int i = 0; i < 3; ++i) CHECK_FALSE(device->exchange({}).fresh);
  CHECK(device->state() == ForceDeviceState::lost);
  odrive.turns = -7;
  odrive.state = 1;
  fake.plugIn();
  ForceReading reading{.fresh = false};
  for (const double end_s = now_s() + 10; !reading.fresh && now_s() < end_s; sleepUntil(now_s() + 0.02))
    reading = device->exchange({});
  REQUIRE(reading.fresh);
  CHECK(reading.zero == ForceReading::Zero::lost);
  for (int i = 0; i < tries && device->state() != ForceDeviceState::ready; ++i) device->rearm();
  CHECK(answered(*device).position_mm == Approx(0).margin(1e-6));
}

TEST_CASE("ODrive: what the torque depends on is set, read back, and put back at the end") {
  FakeOdrive odrive;
  FakeDevice fake([&](const std::string& line) { return odrive.answer(line); });
  const std::string config = "axis0.controller.config.";
  {
    auto device = openedOdrive(fake);
    CHECK(odrive.setting(config + "control_mode") == "1");
    CHECK(odrive.setting(config + "input_mode") == "1");
    CHECK(odrive.setting(config + "enable_torque_mode_vel_limit") == "0");
    CHECK(odrive.setting(config + "anticogging.anticogging_enabled") == "0");
    CHECK(std::stod(odrive.setting(config + "vel_limit")) == Approx(1.25 * 2000 / 60).epsilon(1e-3));
    CHECK(std::stod(odrive.setting("axis0.motor.config.torque_lim")) == Approx(0.00955).epsilon(1e-3));
  }
  for (const double end_s = now_s() + 20; odrive.setting(config + "control_mode") != "3" && now_s() < end_s;)
    sleepUntil(now_s() + 0.01);
  CHECK(odrive.setting(config + "control_mode") == "3");
  CHECK(odrive.setting(config + "input_mode") == "3");
  CHECK(odrive.setting(config + "enable_torque_mode_vel_limit") == "1");
  CHECK(odrive.setting(config + "anticogging.anticogging_enabled") == "1");
  CHECK(odrive.setting(config + "vel_limit") == "2.000000");
  CHECK(odrive.setting("axis0.motor.config.torque_lim") == "inf");
}

TEST_CASE(
    "ODrive: a setting that does not hold, a lower limit of its owner, a value cut off: refused by name") {
  struct Case {
    const char *name, *value;
    bool stubborn;
  };
  for (const Case& c : {Case{"axis0.controller.config.input_mode", "5", true},
                        Case{"axis0.motor.config.torque_lim", "0.001", false},
                        Case{"axis0.controller.config.vel_limit", "100000000", false}}) {
    FakeOdrive odrive;
    odrive.change(c.name, c.value);
    if (c.stubborn) odrive.stubborn = c.name;
    FakeDevice fake([&](const std::string& line) { return odrive.answer(line); });
    OdriveSettings settings;
    settings.port = fake.port;
    const auto device = OdriveForceDevice::open(settings);
    REQUIRE_FALSE(device);
    const std::string said = device.failure().sentence(), name = std::string(c.name).substr(6);
    INFO(said);
    CHECK(said.find(name) != std::string::npos);
    CHECK(odrive.state != 8);
  }
}

TEST_CASE("ODrive: errors of firmware 0.6 have names of their own; a code that was cut off is said to be") {
  CHECK(english(odriveErrorWords(0x200, true)).find("under-voltage") != std::string::npos);
  CHECK(english(odriveErrorWords(0x200, false)).find("controller failed") != std::string::npos);
  CHECK(english(odriveErrorWords(0x1000000, true)).find("watchdog") != std::string::npos);
  CHECK(english(odriveErrorWords(0x8000000, true)).find("brake resistor") !=
        std::string::npos);  // nine digits, whole
  CHECK(english(odriveErrorWords(107374182, true)).find("cut off") != std::string::npos);  // of 1073741824
}

TEST_CASE("ODrive: an answer that comes after its period is late, whatever the delay") {
  // Every answer to a position is kept back by so many questions or commands: as on a link that became slow.
  for (const int behind : {0, 1, 3}) {
    FakeOdrive odrive;
    std::atomic<int> delay{0};
    std::deque<std::string> waiting;
    FakeDevice fake([&](const std::string& line) {
      const std::string answer = odrive.answer(line);
      if (delay == 0) return answer;
      waiting.push_back(answer);
      if (static_cast<int>(waiting.size()) <= 3 * delay) return std::string();
      const std::string old = waiting.front();
      waiting.pop_front();
      return old;
    });
    OdriveSettings settings;
    settings.port = fake.port;
    settings.period_s = 0.1;
    auto device = OdriveForceDevice::open(settings);
    for (int i = 1; i < tries && !device; ++i) device = OdriveForceDevice::open(settings);
    REQUIRE(device);
    delay = behind;
    int fresh = 0;
    for (int i = 0; i < 15; ++i) fresh += (*device)->exchange({}).fresh ? 1 : 0;
    INFO(behind << " exchanges late: " << fresh << " fresh");
    CHECK((behind == 0 ? fresh > 5 : fresh <= 2));
  }
}

TEST_CASE("ODrive: an answer that comes twice is used once, and no later position is older for it") {
  FakeOdrive odrive;
  std::atomic<bool> doubles{false};
  FakeDevice fake([&](const std::string& line) {
    if (doubles && line.starts_with("f 0")) odrive.turns = odrive.turns + 0.001;
    const std::string answer = odrive.answer(line);
    return doubles ? answer + answer : answer;
  });
  OdriveSettings settings;
  settings.port = fake.port;
  settings.period_s = 0.1;
  auto device = OdriveForceDevice::open(settings);
  for (int i = 1; i < tries && !device; ++i) device = OdriveForceDevice::open(settings);
  REQUIRE(device);
  const double rest_turns = odrive.turns;
  doubles = true;
  int fresh = 0, old = 0;
  for (int i = 0; i < 15; ++i) {
    const ForceReading reading = (*device)->exchange({});
    sleepUntil(now_s() + 0.02);  // until the board has heard every question
    const double newest_mm = (odrive.turns - rest_turns) * settings.mmPerTurn;
    fresh += reading.fresh ? 1 : 0;
    old += reading.fresh && std::abs(reading.position_mm - newest_mm) > 0.03 ? 1 : 0;
  }
  CHECK(fresh > 5);
  CHECK(old == 0);
  CHECK((*device)->counts().repeated > 5);
}

TEST_CASE("serial ports are for one program alone, and the other one is named") {
  FakeDevice fake([](const std::string& line) { return goodBoard(line, 0); });
  const auto first = opened(fake, 0.001);
  const auto second = SerialForceDevice::open(fake.port, 230400, 0.001, benchLimits());
  REQUIRE_FALSE(second);
  CHECK(second.failure().sentence().find("in use") != std::string::npos);
}

TEST_CASE(
    "force loop: its last word is that there must be no force, whatever law the device runs by itself") {
  class Heard : public ForceDevice {
   public:
    explicit Heard(std::vector<ForceCommand>& all) : all_(all) {}
    ForceReading exchange(const ForceCommand& command) override {
      all_.push_back(command);
      return {};
    }

   private:
    std::vector<ForceCommand>& all_;
  };
  for (const bool stopped : {false, true}) {
    std::vector<ForceCommand> heard;
    {
      ForceLoopSettings settings;
      settings.paced = false;
      ForceLoop loop(std::make_unique<Heard>(heard), benchProgram(test::linearButton()), settings);
      if (stopped) loop.emergencyStop();
    }
    REQUIRE_FALSE(heard.empty());
    CHECK(heard.back().halted);
    CHECK(heard.back().force_N == 0);
  }
}

TEST_CASE("serial force device: a stopped board with a table is armed only once the table is gone") {
  std::mutex mutex;
  std::string orders;
  const auto said = [&] {
    const std::lock_guard lock(mutex);
    return orders;
  };
  FakeDevice fake([&](const std::string& line) {
    const std::string body = bodyOf(line);
    if (body == "S" || body == "U" || body == "X") {
      const std::lock_guard lock(mutex);
      if (orders.empty() || orders.back() != body.front()) orders += body;
    }
    return goodBoard(line, 0);
  });
  {
    auto device = opened(fake);
    REQUIRE(takesTable(*device, benchProgram(test::linearButton())));
    answered(*device);
    ForceCommand none;
    none.halted = true;
    answered(*device, none);
  }
  for (int i = 0; i < 1000 && !said().ends_with("U"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK(said().ends_with("SXU"));
}

namespace {

/// Rate of a port as the kernel holds it: the last number of its termios2.
std::uint32_t rateOf(const std::string& port) {
  using Termios2 = std::array<std::uint32_t, 11>;
  Termios2 mode{};
  const int descriptor = ::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  ::ioctl(descriptor, _IOR('T', 0x2A, Termios2), mode.data());
  ::close(descriptor);
  return mode.back();
}

/// Ports of USB devices as the system lists them, in a folder.
class ListedPorts {
 public:
  ListedPorts() { fs::create_directories(root_ / "by-id"); }
  ~ListedPorts() { fs::remove_all(root_); }

  void add(const std::string& name, const std::string& serial, const std::string& product) {
    const fs::path device = root_ / "usb" / name, interface = device / "1.0";
    fs::create_directories(interface);
    fs::create_directories(root_ / "tty" / name);
    write(device / "idVendor", "2341");
    write(device / "idProduct", product);
    if (!serial.empty()) write(device / "serial", serial);
    write(interface / "bInterfaceNumber", "00");
    fs::create_directory_symlink(interface, root_ / "tty" / name / "device");
    write(root_ / name, "");
  }
  fs::path byId(const std::string& name) const {
    const fs::path link = root_ / "by-id" / ("usb-" + name);
    if (!fs::exists(link)) fs::create_symlink(root_ / name, link);
    return link;
  }
  fs::path plain(const std::string& name) const { return root_ / name; }
  fs::path ttys() const { return root_ / "tty"; }

 private:
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text << '\n'; }
  fs::path root_ = fs::temp_directory_path() / ("detent-ports-" + std::to_string(::getpid()));
};

}  // namespace

TEST_CASE("two devices with one serial number are one name for two ports, which is seen") {
  ListedPorts ports;
  ports.add("ttyACM0", "A1", "8036");
  ports.add("ttyACM1", "B2", "8036");
  ports.add("ttyACM2", "A1", "0043");  // the same number on another product
  ports.add("ttyACM3", "", "8036");
  ports.add("ttyACM4", "", "8036");
  CHECK(sameSerialNumber(ports.byId("ttyACM0"), ports.ttys()).empty());
  ports.add("ttyACM5", "A1", "8036");
  CHECK(sameSerialNumber(ports.byId("ttyACM0"), ports.ttys()) == "/dev/ttyACM5");
  CHECK(sameSerialNumber(ports.byId("ttyACM5"), ports.ttys()) == "/dev/ttyACM0");
  CHECK(sameSerialNumber(ports.plain("ttyACM0"), ports.ttys()).empty());  // names a port, not a device
  for (const char* alone : {"ttyACM1", "ttyACM2", "ttyACM3"})
    CHECK(sameSerialNumber(ports.byId(alone), ports.ttys()).empty());
  CHECK(sameSerialNumber(ports.byId("ttyACM9"), ports.ttys()).empty());
  CHECK(sameSerialNumber(ports.byId("ttyACM0"), "/nowhere").empty());
}

TEST_CASE("a serial port runs at any rate: 250000 baud is exact on a 16 MHz AVR") {
  FakeDevice fake([](const std::string& line) { return goodBoard(line, 0); });
  for (const unsigned baud : {1200U, 115200U, 230400U, 250000U, 4000000U}) {
    INFO(baud << " baud");
    const Result<SerialLink> link = SerialLink::open(fake.port, baud);
    REQUIRE(link);
    CHECK(rateOf(fake.port) == baud);
  }
  for (const unsigned baud : {0U, 1199U, 4000001U}) CHECK_FALSE(SerialLink::open(fake.port, baud));
}

TEST_CASE(
    "serial force device: a table's force is withdrawn where its answers stop or are wrong, and comes back "
    "with them") {
  const std::string wrong = GENERATE(as<std::string>(), "none", "of no question", "of the first question",
                                     "of a clock that stands");
  CAPTURE(wrong);
  std::atomic<bool> mute{false};
  std::atomic<int> forcesOfNothing{0}, kept{0}, begun{0};
  std::string stands_us = "1";  // of the device's thread alone
  FakeDevice fake([&](const std::string& line) {
    const std::string body = bodyOf(line);
    if (!mute && (body.starts_with("F,") || body.starts_with("H,"))) stands_us = sequenceOf(body) + "000";
    if (mute && body.starts_with("F,") && body.ends_with(",0")) ++forcesOfNothing;
    if (mute && body.starts_with("H,")) ++kept;
    begun += body == "G" ? 1 : 0;
    if (!mute) return goodBoard(line, 0);
    if (wrong == "none" || !(body.starts_with("F,") || body.starts_with("H,"))) return std::string();
    const unsigned long question = std::stoul(sequenceOf(body));
    const unsigned long said = wrong == "of no question"          ? question + 7
                               : wrong == "of the first question" ? 1
                                                                  : question;
    const std::string time_us =
        wrong == "of a clock that stands" ? stands_us : std::to_string(1000 * question);
    return forceLine("P," + std::to_string(said) + "," + time_us + ",0,1");
  });
  auto device = opened(fake, 0.004);
  REQUIRE(takesTable(*device, benchProgram(test::linearButton())));
  const int before = begun;
  answered(*device);
  mute = true;
  for (int i = 0; i < 30 && forcesOfNothing == 0; ++i) device->exchange({});
  CHECK(forcesOfNothing > 0);
  CHECK(kept <= 20);
  CHECK(device->counts().withdrawn == 1);
  mute = false;
  for (int i = 0; i < 2000 && begun == before; ++i) device->exchange({});
  CHECK(begun > before);
}
