// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A force sensor on a serial port (USB CDC, FTDI, or a pty in tests). Its own thread reads lines, converts
// them to newtons and passes them on. Survives unplugging and reconnecting.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "model/result.h"
#include "playback/device/sensor_line.h"
#include "playback/realtime/force_conditioner.h"
#include "playback/realtime/sensor_calibration.h"

namespace detent::playback {

struct SerialSettings {
  std::string port;               ///< "/dev/ttyACM0"
  unsigned baud = 230400;         ///< 1 kHz of 16 characters need 160,000; USB CDC ignores it
  double lowestReopen_s = 0.2;    ///< pause between two attempts to reopen the port
  SensorCalibration calibration;  ///< for readings in counts; newtons pass unchanged
  ConditionerSettings conditioner;
};

enum class SensorState : std::uint8_t { starting, running, silent, stuck, unplugged };

/// Condition of the sensor.
struct SensorHealth {
  double noise_N = 0;             ///< SD of the readings; 0: not known yet, or none
  std::uint64_t wrongStamps = 0;  ///< time stamps that were rejected
  std::string greeting;           ///< the firmware's "# detent-force ..." line, without the "# "
  SensorState state = SensorState::starting;
  double rate_Hz = 0;  ///< rate of accepted readings, over the last second or so
  double force_N = 0;  ///< last accepted
  double raw = 0;      ///< the same before calibration
  std::uint64_t reconnects = 0;
  LineCounts lines;
  ConditionerCounts readings;
};

/// One accepted reading. `resumed`: the previous ones are too old to connect to.
struct SensorReading {
  double time_s = 0;  ///< on now_s(); the sensor's own stamp where it sends one
  double force_N = 0;
  double raw = 0;
  bool resumed = false;
};

class SerialSensor {
 public:
  using Receiver = std::function<void(const SensorReading&)>;  ///< called on the reader thread

  /// Opens the port. Failure if it cannot be opened now; later losses are reported by health().
  static Result<std::unique_ptr<SerialSensor>> open(const SerialSettings& settings, Receiver receiver);
  ~SerialSensor();  ///< stops and joins the reader thread

  SensorHealth health() const;  ///< any thread
  /// Sets other limits from the next reading on, when another button is loaded. Any thread.
  void setConditioner(const ConditionerSettings& settings);

 private:
  class Reader;
  explicit SerialSensor(std::unique_ptr<Reader> reader);
  std::unique_ptr<Reader> reader_;
};

}  // namespace detent::playback
