// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <numeric>
#include <optional>
#include <random>

#include "playback/device/audio_device.h"
#include "playback/device/serial_sensor.h"
#include "playback/device/steady_clock.h"
#include "playback/playback.h"

namespace detent::playback {

namespace {

constexpr double tactile_N = 0.6;    // tactile force of the button that the measurement presses
constexpr double ramp_N_per_s = 50;  // as in a fast keystroke
constexpr double top_N = 1.2;
constexpr double answerWithin_s = 0.4;
constexpr double settle_s = 0.15;   // pauses between press, release and the next press
constexpr double tapWithin_s = 60;  // time within which a person must tap the sensor
constexpr double faintestOnset = 1e-4;

/// A button with one jump as the only strong event of its press.
Result<PreparedProgram> measuringProgram(const LatencySettings& settings) {
  Result<StrokeCurve> press = StrokeCurve::throughPoints({{0, 0}, {1, tactile_N}, {1.4, 0.3}, {3, 1.0}});
  if (!press) return press.failure();
  Result<StrokeCurve> release = StrokeCurve::throughPoints({{0, 0}, {3, 0.9}});
  if (!release) return release.failure();
  Result<ForceGraph> graph = ForceGraph::fromCurves(*press, *release);
  if (!graph) return graph.failure();
  Result<Button> button = Button::fromStates("latency", {ButtonState{"", *graph, {}, {}, {}}});
  if (!button) return button.failure();
  PlaybackSettings playback;
  playback.mode = FeedbackMode::clickOnly;
  playback.faintestJump = 0.9;
  playback.bottomOutAmplitude = 0;
  playback.placement = settings.placement;
  playback.sensorPeriod_s = 1 / settings.sensorRate_Hz;
  return prepareProgram(*button, {}, playback);
}

class Measurement {
 public:
  Measurement(const LatencySettings& settings, const HapticProgram& program, double rate,
              const std::function<bool()>& cancelled)
      : settings_(settings), program_(program), session_(rate), cancelled_(cancelled) {}

  Result<LatencyResult> run(const std::function<void(std::size_t, std::size_t)>& progress) {
    if (Result<Done> opened = open(); !opened) return opened.failure();
    LatencyResult result;
    result.device = output_->deviceName();
    listenToSilence();
    for (std::size_t trial = 0; trial < settings_.trials; ++trial) {
      progress(trial, settings_.trials);
      const std::optional<double> crossing_s = settings_.sensorPort.empty() ? pressSimulated() : waitForTap();
      if (cancelled_()) return Failure::cancelled("latency");
      if (!crossing_s) {
        return Failure{FailureCode::deviceTrouble, settings_.sensorPort, "", "was not pressed for a minute",
                       "Tap the sensor firmly, above 0.6 N"};
      }
      const std::optional<double> onset_s = onsetAfter(*crossing_s);
      if (onset_s) {
        result.delays_s.push_back(*onset_s - *crossing_s);
      } else {
        ++result.lost;
      }
      if (settings_.sensorPort.empty()) releaseSimulated();
      drainReports();
    }
    return result;
  }

 private:
  Result<Done> open() {
    SessionCommand use;
    use.kind = CommandKind::program;
    use.program = &program_;
    session_.send(Lane::control, use);
    const AudioSettings audio{settings_.player.device, session_.sampleRate_Hz(),
                              settings_.player.bufferFrames, settings_.player.channels};
    Result<std::unique_ptr<AudioOutput>> output = AudioOutput::open(audio, session_);
    if (!output) return output.failure();
    output_ = std::move(*output);
    const std::string& input =
        settings_.inputDevice.empty() ? settings_.player.device : settings_.inputDevice;
    Result<std::unique_ptr<AudioCapture>> capture = AudioCapture::open(input, session_.sampleRate_Hz());
    if (!capture) return capture.failure();
    capture_ = std::move(*capture);
    if (settings_.sensorPort.empty()) return Done{};
    SerialSettings serial;
    serial.port = settings_.sensorPort;
    serial.baud = settings_.baud;
    serial.calibration = settings_.calibration;
    Result<std::unique_ptr<SerialSensor>> sensor =
        SerialSensor::open(serial, [this](const SensorReading& r) { onReading(r); });
    if (!sensor) return sensor.failure();
    sensor_ = std::move(*sensor);
    return Done{};
  }

  void listenToSilence() {
    send(now_s(), 0, true);
    sleepUntil(now_s() + 0.2);
    capture_->take();
    sleepUntil(now_s() + 0.3);
    double squares = 0, count = 0;
    for (const AudioCapture::Block& block : capture_->take()) {
      for (float v : block.samples) squares += static_cast<double>(v) * static_cast<double>(v);
      count += static_cast<double>(block.samples.size());
    }
    const double noise = count > 0 ? std::sqrt(squares / count) : 0;
    threshold_ = settings_.threshold > 0 ? settings_.threshold : std::max(8 * noise, faintestOnset);
  }

  void send(double time_s, double force_N, bool resumed) {
    SessionCommand command;
    command.kind = resumed ? CommandKind::resync : CommandKind::force;
    command.timeBase = TimeBase::clock;
    command.time = time_s;
    command.value = force_N;
    session_.send(Lane::sensor, command);
  }

  // A sensor with its own rhythm: readings arrive at its period, independent of the start of the ramp.
  std::optional<double> pressSimulated() {
    const double period_s = 1 / settings_.sensorRate_Hz;
    const double start_s = now_s() + period_s * (1 + std::uniform_real_distribution<double>(0, 1)(random_));
    double reading_s = now_s() + period_s / 2;
    for (double force = 0; force < top_N; reading_s += period_s) {
      sleepUntil(reading_s);
      const double time_s = now_s();
      force = std::clamp(ramp_N_per_s * (time_s - start_s), 0.0, top_N);
      send(time_s, force, false);
    }
    return start_s + tactile_N / ramp_N_per_s;
  }

  void releaseSimulated() {
    const double period_s = 1 / settings_.sensorRate_Hz;
    for (double force = top_N; force > 0; force -= ramp_N_per_s * period_s) {
      sleepUntil(now_s() + period_s);
      send(now_s(), std::max(force, 0.0), false);
    }
    send(now_s(), 0, false);
    sleepUntil(now_s() + settle_s * (1 + std::uniform_real_distribution<double>(0, 0.1)(random_)));
  }

  // Called on the reader thread.
  void onReading(const SensorReading& r) {
    send(r.time_s, r.force_N, r.resumed);
    const std::lock_guard lock(tapMutex_);
    if (armed_ && !r.resumed && last_.force_N < tactile_N && r.force_N >= tactile_N) {
      const double share = (tactile_N - last_.force_N) / (r.force_N - last_.force_N);
      tap_s_ = last_.time_s + share * (r.time_s - last_.time_s);
      armed_ = false;
    }
    if (r.force_N < tactile_N / 4) released_ = true;
    last_ = r;
  }

  std::optional<double> waitForTap() {
    const double until_s = now_s() + tapWithin_s;
    for (bool ready = false; now_s() < until_s && !cancelled_(); sleepUntil(now_s() + 0.01)) {
      const std::lock_guard lock(tapMutex_);
      if (!ready && released_) {
        ready = armed_ = true;
        tap_s_.reset();
      }
      if (tap_s_) {
        released_ = false;
        return tap_s_;
      }
      capture_->take();  // discards recordings from before the tap
    }
    return {};
  }

  std::optional<double> onsetAfter(double crossing_s) {
    const double rate = session_.sampleRate_Hz();
    while (now_s() < crossing_s + answerWithin_s && !cancelled_()) {
      for (const AudioCapture::Block& block : capture_->take()) {
        for (std::size_t i = 0; i < block.samples.size(); ++i) {
          const double time_s = block.time_s + static_cast<double>(i) / rate;
          if (time_s > crossing_s && std::fabs(block.samples[i]) > threshold_) return time_s;
        }
      }
      sleepUntil(now_s() + 0.01);
    }
    return {};
  }

  void drainReports() {
    capture_->take();
    SessionReport report;
    while (session_.receive(report)) {
    }
  }

  const LatencySettings& settings_;
  const HapticProgram& program_;
  LiveSession session_;
  const std::function<bool()>& cancelled_;
  std::unique_ptr<AudioOutput> output_;
  std::unique_ptr<AudioCapture> capture_;
  std::mt19937 random_{20261121};
  double threshold_ = faintestOnset;
  std::mutex tapMutex_;
  bool armed_ = false, released_ = true;
  std::optional<double> tap_s_;
  SensorReading last_;
  std::unique_ptr<SerialSensor> sensor_;
};

}  // namespace

namespace {

constexpr double waitedInThePort_s = 0.3;
constexpr double longestWait_s = 10;

/// SD of the changes between successive readings (von Neumann 1941). Unlike the SD of the readings, it hardly
/// depends on a slow drift.
double noiseIn(const std::vector<double>& readings) {
  double squares = 0;
  for (std::size_t i = 1; i < readings.size(); ++i)
    squares += (readings[i] - readings[i - 1]) * (readings[i] - readings[i - 1]);
  return std::sqrt(squares / (2 * static_cast<double>(readings.size() - 1)));
}

/// Returns true if the later half of the readings differs from the earlier one by more than their noise
/// explains.
bool drifts(const std::vector<double>& readings) {
  const std::size_t half = readings.size() / 2;
  if (half < 4) return false;
  const auto n = static_cast<std::ptrdiff_t>(half);
  const double early = std::accumulate(readings.begin(), readings.begin() + n, 0.0);
  const double late = std::accumulate(readings.end() - n, readings.end(), 0.0);
  const double one = 0.5;  // a constant voltage may alternate between two counts of the converter
  const double apart = std::fabs(late - early) / static_cast<double>(half);
  return apart > one + 4 * noiseIn(readings) * std::sqrt(2 / static_cast<double>(half));
}

}  // namespace

Result<RawReading> readRawSensor(const std::string& port, unsigned baud, double seconds,
                                 const std::function<bool()>& cancelled) {
  SerialSettings settings;
  settings.port = port;
  settings.baud = baud;
  settings.conditioner.lowest = -1e9;  // raw readings are counts, not newtons
  settings.conditioner.highest = 1e9;
  settings.conditioner.fastest_per_s = 1e12;
  std::mutex mutex;
  std::vector<double> arriving;
  Result<std::unique_ptr<SerialSensor>> sensor = SerialSensor::open(settings, [&](const SensorReading& r) {
    const std::lock_guard lock(mutex);
    arriving.push_back(r.raw);
  });
  if (!sensor) return sensor.failure();
  const auto readFor = [&](double time_s) {
    for (const double end_s = now_s() + time_s; now_s() < end_s && !cancelled();)
      sleepUntil(std::min(end_s, now_s() + 0.02));
    const std::lock_guard lock(mutex);
    return std::exchange(arriving, {});
  };
  readFor(waitedInThePort_s);
  std::vector<double> readings = readFor(seconds);
  for (double waited_s = 0; waited_s < longestWait_s && !readings.empty() && drifts(readings) && !cancelled();
       waited_s += seconds) {
    readings = readFor(seconds);
  }
  if (cancelled()) return Failure::cancelled(port);
  if (readings.empty()) {
    return Failure{FailureCode::deviceTrouble, port, "", "sent no reading",
                   "Check baud rate and wiring; docs/reference/serial-protocol.md"};
  }
  RawReading raw;
  raw.steady = !drifts(readings);
  raw.n = readings.size();
  for (double r : readings) raw.mean += r / static_cast<double>(raw.n);
  for (double r : readings) raw.sd += (r - raw.mean) * (r - raw.mean);
  raw.sd = raw.n > 1 ? std::sqrt(raw.sd / static_cast<double>(raw.n - 1)) : 0;
  return raw;
}

Result<LatencyResult> measureLatency(const LatencySettings& settings,
                                     const std::function<void(std::size_t, std::size_t)>& progress,
                                     const std::function<bool()>& cancelled) {
  if (settings.trials < 1 || !(settings.sensorRate_Hz >= 20 && settings.sensorRate_Hz <= 20000)) {
    return Failure{FailureCode::wrongUsage, "latency", "",
                   "needs at least 1 trial and a sensor rate of 20..20000 Hz", "Change them"};
  }
  Result<PreparedProgram> program = measuringProgram(settings);
  if (!program) return program.failure();
  Result<double> rate = sampleRateFor({settings.player.device, settings.player.sampleRate_Hz, 0, 1});
  if (!rate) return rate.failure();
  return std::make_unique<Measurement>(settings, program->program, *rate, cancelled)->run(progress);
}

}  // namespace detent::playback
