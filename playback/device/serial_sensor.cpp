// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/serial_sensor.h"

#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>
#include <termios.h>

#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {
constexpr int readerPriority = 60;  // below the audio callback (JACK: 65)
constexpr double rateWindow_s = 1.0;
constexpr double healthCheck_s = 0.1;
namespace asio = boost::asio;
using ErrorCode = boost::system::error_code;
}  // namespace

class SerialSensor::Reader {
 public:
  Reader(const SerialSettings& settings, Receiver receiver)
      : settings_(settings),
        receiver_(std::move(receiver)),
        conditioner_(settings.conditioner),
        port_(context_),
        reopen_(context_),
        watch_(context_) {}

  ~Reader() {
    context_.stop();
    if (thread_.joinable()) thread_.join();
  }

  std::optional<DeviceTrouble> start() {
    if (const ErrorCode error = openPort()) {
      return DeviceTrouble{settings_.port, "cannot be opened (" + error.message() + ")",
                           "Check the name, the cable and your right to read it (group dialout)"};
    }
    thread_ = std::thread([this] {
      requestRealtime(readerPriority);
      read();
      watch();
      context_.run();
    });
    return {};
  }

  SensorHealth health() const {
    const std::lock_guard lock(mutex_);
    return health_;
  }

  void setConditioner(const ConditionerSettings& settings) {
    asio::post(context_, [this, settings] { conditioner_.setSettings(settings); });
  }

 private:
  ErrorCode openPort() {
    ErrorCode error;
    port_.close(error);
    port_.open(settings_.port, error);
    if (error) return error;
    // Asio opens ports raw; a pty refuses some of the line's options, which a pty does not need.
    ErrorCode ignored;
    port_.set_option(asio::serial_port_base::baud_rate(settings_.baud), ignored);
    port_.set_option(asio::serial_port_base::character_size(8), ignored);
    port_.set_option(asio::serial_port_base::parity(asio::serial_port_base::parity::none), ignored);
    port_.set_option(asio::serial_port_base::stop_bits(asio::serial_port_base::stop_bits::one), ignored);
    port_.set_option(asio::serial_port_base::flow_control(asio::serial_port_base::flow_control::none),
                     ignored);
    ::tcflush(port_.native_handle(), TCIFLUSH);  // what waited in the port was read at another time
    assembler_.restart();
    aligner_.restart();
    return {};
  }

  void read() {
    port_.async_read_some(asio::buffer(buffer_), [this](const ErrorCode& error, std::size_t count) {
      if (error) {
        lost();
        return;
      }
      const double arrival_s = now_s();
      assembler_.feed({buffer_.data(), count}, [&](const SensorLine& line) { handle(line, arrival_s); });
      publish(arrival_s);
      read();
    });
  }

  void handle(const SensorLine& line, double arrival_s) {
    SensorReading reading;
    reading.raw = line.value;
    reading.force_N = line.newtons ? line.value : settings_.calibration.force_N(line.value);
    reading.time_s = line.timed ? aligner_.hostTime_s(line.time_us, arrival_s) : arrival_s;
    // Several unstamped lines in one read came at different times; keep them ordered, a little apart.
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
    health_.lines = assembler_.counts();
    health_.readings = conditioner_.counts();
    health_.noise_N = conditioner_.noise();
    health_.wrongStamps = aligner_.wrongStamps();
    health_.greeting = assembler_.greeting();
    health_.force_N = last_.force_N;
    health_.raw = last_.raw;
    health_.rate_Hz = rate_Hz_;
    if (!connected_) {
      health_.state = SensorState::unplugged;
    } else if (conditioner_.counts().accepted == 0 && time_s - startTime_s_ < 1) {
      health_.state = SensorState::starting;
    } else if (conditioner_.silent(time_s)) {
      health_.state = SensorState::silent;
    } else {
      health_.state = conditioner_.stuck() ? SensorState::stuck : SensorState::running;
    }
  }

  void lost() {
    ErrorCode ignored;
    port_.close(ignored);
    connected_ = false;
    publish(now_s());
    scheduleReopen();
  }

  void scheduleReopen() {
    reopen_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(settings_.lowestReopen_s)));
    reopen_.async_wait([this](const ErrorCode& error) {
      if (error) return;
      if (openPort()) {
        scheduleReopen();
        return;
      }
      connected_ = true;
      reconnected_ = true;
      {
        const std::lock_guard lock(mutex_);
        ++health_.reconnects;
      }
      read();
    });
  }

  void watch() {
    watch_.expires_after(std::chrono::milliseconds(static_cast<int>(healthCheck_s * 1000)));
    watch_.async_wait([this](const ErrorCode& error) {
      if (error) return;
      publish(now_s());
      watch();
    });
  }

  SerialSettings settings_;
  Receiver receiver_;
  LineAssembler assembler_;
  ClockAligner aligner_;
  ForceConditioner conditioner_;
  asio::io_context context_;
  asio::serial_port port_;
  asio::steady_timer reopen_, watch_;
  std::array<char, 4096> buffer_{};
  bool connected_ = true, reconnected_ = false;
  double lastTime_s_ = 0;
  double startTime_s_ = now_s(), windowStart_s_ = now_s(), rate_Hz_ = 0;
  std::uint64_t windowCount_ = 0;
  SensorReading last_;
  mutable std::mutex mutex_;
  SensorHealth health_;
  std::thread thread_;
};

SerialSensor::SerialSensor(std::unique_ptr<Reader> reader) : reader_(std::move(reader)) {}
SerialSensor::~SerialSensor() = default;

DeviceResult<std::unique_ptr<SerialSensor>> SerialSensor::open(const SerialSettings& settings,
                                                               Receiver receiver) {
  auto reader = std::make_unique<Reader>(settings, std::move(receiver));
  if (std::optional<DeviceTrouble> trouble = reader->start()) return *trouble;
  return std::unique_ptr<SerialSensor>(new SerialSensor(std::move(reader)));
}

SensorHealth SerialSensor::health() const { return reader_->health(); }
void SerialSensor::setConditioner(const ConditionerSettings& settings) { reader_->setConditioner(settings); }

}  // namespace detent::playback
