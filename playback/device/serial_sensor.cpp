// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/serial_sensor.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "playback/device/serial_link.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {
constexpr int readerPriority = 60;  // lower than that of the audio callback (JACK: 65)
constexpr double rateWindow_s = 1.0;
constexpr double healthCheck_s = 0.05;
constexpr std::string_view whoIsThere = "?\n";  // a sensor without this command ignores it
}  // namespace

class SerialSensor::Reader {
 public:
  Reader(const SerialSettings& settings, Receiver receiver, SerialLink link)
      : settings_(settings),
        receiver_(std::move(receiver)),
        conditioner_(settings.conditioner),
        link_(std::move(link)),
        thread_([this] { run(); }) {}

  ~Reader() {
    stopping_ = true;
    thread_.join();
  }

  SensorHealth health() const {
    const std::lock_guard lock(mutex_);
    return health_;
  }

  void setConditioner(const ConditionerSettings& settings) {
    const std::lock_guard lock(mutex_);
    nextConditioner_ = settings;
  }

 private:
  void run() {
    requestRealtime(readerPriority);
    link_.send(whoIsThere);
    while (!stopping_) {
      if (link_.isOpen()) {
        const std::string_view bytes = link_.bytes(now_s() + healthCheck_s);
        takeConditioner();
        const double arrival_s = now_s();
        assembler_.feed(bytes, [&](const SensorLine& line) { handle(line, arrival_s); });
      } else {
        sleepUntil(now_s() + std::min(healthCheck_s, settings_.lowestReopen_s));
        if (link_.reopen()) restart();
      }
      publish(now_s());
    }
  }

  void restart() {
    assembler_.restart();
    aligner_.restart();
    reconnected_ = true;
    ++reconnects_;
    link_.send(whoIsThere);
  }

  void takeConditioner() {
    const std::lock_guard lock(mutex_);
    if (nextConditioner_) conditioner_.setSettings(*std::exchange(nextConditioner_, {}));
  }

  void handle(const SensorLine& line, double arrival_s) {
    SensorReading reading;
    reading.raw = line.value;
    reading.force_N = line.newtons ? line.value : settings_.calibration.force_N(line.value);
    reading.time_s = line.timed ? aligner_.hostTime_s(line.time_us, arrival_s) : arrival_s;
    // Several lines without time stamps in one read were sent at different times; they are kept in order with
    // small distances.
    if (!line.timed && reading.time_s <= lastTime_s_) reading.time_s = lastTime_s_ + 1e-6;
    const ConditionerVerdict verdict = conditioner_.judge(reading.time_s, reading.force_N);
    if (verdict == ConditionerVerdict::reject) return;
    reading.force_N = conditioner_.value();
    reading.resumed = verdict == ConditionerVerdict::resume || reconnected_;
    reconnected_ = false;
    lastTime_s_ = reading.time_s;
    last_ = reading;
    ++windowCount_;
    receiver_(reading);
  }

  void publish(double time_s) {
    if (time_s - windowStart_s_ > rateWindow_s) {
      rate_Hz_ = static_cast<double>(windowCount_) / (time_s - windowStart_s_);
      windowStart_s_ = time_s;
      windowCount_ = 0;
    }
    const std::lock_guard lock(mutex_);
    health_.reconnects = reconnects_;
    health_.lines = assembler_.counts();
    health_.readings = conditioner_.counts();
    health_.noise_N = conditioner_.noise();
    health_.wrongStamps = aligner_.wrongStamps();
    health_.greeting = assembler_.greeting();
    health_.force_N = last_.force_N;
    health_.raw = last_.raw;
    health_.rate_Hz = rate_Hz_;
    if (!link_.isOpen()) {
      health_.state = SensorState::unplugged;
    } else if (conditioner_.counts().accepted == 0 && time_s - startTime_s_ < 1) {
      health_.state = SensorState::starting;
    } else if (conditioner_.silent(time_s)) {
      health_.state = SensorState::silent;
    } else {
      health_.state = conditioner_.stuck() ? SensorState::stuck : SensorState::running;
    }
  }

  SerialSettings settings_;
  Receiver receiver_;
  LineAssembler assembler_;
  ClockAligner aligner_;
  ForceConditioner conditioner_;
  SerialLink link_;
  bool reconnected_ = false;
  std::uint64_t reconnects_ = 0;
  double lastTime_s_ = 0;
  double startTime_s_ = now_s(), windowStart_s_ = now_s(), rate_Hz_ = 0;
  std::uint64_t windowCount_ = 0;
  SensorReading last_;
  mutable std::mutex mutex_;
  SensorHealth health_;
  std::optional<ConditionerSettings> nextConditioner_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;  ///< declared last, because it uses the other members until it is done
};

SerialSensor::SerialSensor(std::unique_ptr<Reader> reader) : reader_(std::move(reader)) {}
SerialSensor::~SerialSensor() = default;

Result<std::unique_ptr<SerialSensor>> SerialSensor::open(const SerialSettings& settings, Receiver receiver) {
  Result<SerialLink> link = SerialLink::open(settings.port, settings.baud, settings.lowestReopen_s);
  if (!link) return link.failure();
  auto reader = std::make_unique<Reader>(settings, std::move(receiver), *std::move(link));
  return std::unique_ptr<SerialSensor>(new SerialSensor(std::move(reader)));
}

SensorHealth SerialSensor::health() const { return reader_->health(); }
void SerialSensor::setConditioner(const ConditionerSettings& settings) { reader_->setConditioner(settings); }

}  // namespace detent::playback
