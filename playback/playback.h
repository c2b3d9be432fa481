// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public interface of playback: press a button and feel it.
//
// In:  a model::Button, a device profile, settings, and readings of a finger.
// Out: vibration on a sound device, or samples.
// Reading order of the room:
//   realtime/haptic_program.h   what the callback plays
//   realtime/haptic_engine.h    the callback's engine
//   prepare/prepare_program.h   button -> program
//   offline/render_press.h      program + press -> WAV, FLAC, memory
//   device/*                    sound, serial sensor, messages
//   measurement/*              measuring device and latency
//   study.h, study/*           studies with people: a public interface of their own
//   this file                   everything another room needs, in plain types
//
// Threads: every function here belongs to ordinary threads; nothing here may be called from an audio
// callback. A LivePlayer may be used by several threads. Built without devices (DETENT_WITH_DEVICE=OFF) the
// live part answers deviceTrouble.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/force_feedback.h"
#include "playback/measurement/spectrogram.h"
#include "playback/offline/press_files.h"
#include "playback/offline/press_speed.h"
#include "playback/offline/standard_press.h"
#include "playback/prepare/prepare_program.h"
#include "playback/prepare/prepare_speeds.h"
#include "playback/realtime/live_program.h"
#include "playback/realtime/press_counter.h"
#include "playback/realtime/press_sound.h"

namespace detent::playback {

/// Reads a `.device` file; docs/reference/device-profile.md.
Result<DeviceProfile> loadDeviceProfile(const std::string& file);

// ---- live

struct SoundDevice {
  std::string name;  ///< "ALSA: hw:0,0": choose by this or an unambiguous part of it
  int inputChannels = 0, outputChannels = 0;
  double sampleRate_Hz = 0;
  bool defaultOutput = false, defaultInput = false;
};

/// Returns false in a library built without devices.
bool livePlaybackAvailable();
Result<std::vector<SoundDevice>> listSoundDevices();

/// Masking noise (rain), so that the vibration is felt and not heard (K&L's noisy group wore headphones with
/// it).
struct MaskingNoise {
  double level = 0;  ///< rms, share of full scale, 0..0.3; 0: none
  /// device of the headphones; empty: the player's own device, on up to two outputs behind the vibration's
  std::string device;
};

struct PlayerSettings {
  std::string device;         ///< empty: the default output
  double sampleRate_Hz = 0;   ///< 0: the device's own rate, also when it comes back at another one
  unsigned bufferFrames = 0;  ///< 0: the host's choice, which gives the least delay on JACK
  int channels = 2;           ///< the same signal on each
  MaskingNoise masking;
  /// Uses JACK through PortAudio instead of a separate client; cannot recover a lost server
  /// (docs/develop/decisions/0904).
  bool jackThroughPortAudio = false;
  PressSound sound;  ///< sound of presses, on up to two outputs behind the vibration's
};

enum class SensorCondition : std::uint8_t { none, starting, running, silent, stuck, unplugged };

/// A closing of the button's contact: it was pressed as far as its operating point.
struct ContactClosing {
  double time_s = 0;    ///< on the steady clock of playback/device, interpolated between two readings
  double within_s = 0;  ///< time between the two readings around it
};

/// Values for a display; a snapshot.
struct PlayerStatus {
  bool sounding = true;  ///< false: a player without a sound device (LivePlayer::startSilent)
  std::string device;
  double sampleRate_Hz = 0;
  std::uint32_t blockFrames = 0;
  double outputLatency_s =
      0;  ///< time from a block to the device's output, as reported by the sound system; 0: not reported
  bool deviceLost = false;  ///< at the moment the device is missing; playing continues when it is back
  std::uint64_t deviceLosses = 0;
  /// Force and displacement after the last reading; for a recorded trace those that the callback plays, up to
  /// 20 ms late.
  double force_N = 0, displacement_mm = 0;
  bool releasing = false, contact = false;
  int state = 0;  ///< present state of a self-locking button
  /// speed of the present or last press, for a button with several speeds; 0: unknown
  double speed_mm_per_s = 0;
  double level = 0;  ///< peak of the last 20 ms, share of full scale
  double felt_dB =
      -std::numeric_limits<double>::infinity();  ///< strongest 10 ms of the last 1.5 s, above threshold
  double load = 0, meanLoad = 0;                 ///< share of the block's time spent in the callback
  std::uint64_t xruns = 0;
  EngineCounts counts;
  SensorCondition sensor = SensorCondition::none;
  double sensorRate_Hz = 0;
  double sensorNoise_N = 0;  ///< SD of its readings; 0: not known yet, or none
  /// it sends the converter's numbers, which the profile converts to newtons
  bool sensorSendsCounts = false;
  std::string sensorGreeting;         ///< greeting of its firmware ("detent-force 1 fsr400 divider 1023")
  std::uint64_t messageForces = 0;    ///< readings by OSC, FUDI or pushForce
  std::uint64_t droppedReadings = 0;  ///< arrived faster, or waited longer, than can be played
  /// jumps that were left out or played early because too many came at once
  std::uint64_t droppedEvents = 0;
  std::uint64_t limitedBlocks = 0;  ///< blocks in which the limiter lowered the output
  std::uint64_t sensorReconnects = 0, rejectedReadings = 0, malformedLines = 0;
  std::uint64_t signalMessages = 0, malformedMessages = 0;
};

/// A button that can be pressed now. Destroying it stops the sound and joins every thread it started.
class LivePlayer {
 public:
  static Result<std::unique_ptr<LivePlayer>> start(const PlayerSettings& settings,
                                                   const LiveProgram& program);
  /// The same finger, sensor and messages with the same program, but without a sound device: position,
  /// contact, state and events are tracked, nothing sounds. For displays on machines without a device, or
  /// until one is open. Traces are not played. Failure: deviceTrouble in a library built without devices.
  static Result<std::unique_ptr<LivePlayer>> startSilent(const LiveProgram& program);
  virtual ~LivePlayer() = default;

  /// Exchanges the button under the finger without a click.
  virtual void setProgram(const LiveProgram& program) = 0;
  /// Output gain >= 0; changes in a 10 ms ramp.
  virtual void setGain(double gain) = 0;

  /// A reading taken now. Values that are not finite or impossible are counted and ignored.
  virtual void pushForce(double force_N) = 0;
  virtual void pushDisplacement(double displacement_mm) = 0;
  /// A displacement reading taken at `time_s` on clock_s(); not before the last one.
  virtual void pushDisplacementAt(double displacement_mm, double time_s) = 0;

  /// The finger of a key or mouse button: presses with a human-like force profile up to `peak_N`.
  virtual void fingerDown(double peak_N) = 0;
  virtual void fingerUp() = 0;
  /// Down and, after `hold_s`, up again: for terminals, which do not report the release of a key.
  virtual void fingerTap(double peak_N, double hold_s) = 0;

  /// A serial force sensor (docs/reference/serial-protocol.md), calibrated by the profile.
  virtual Result<Done> attachSensor(const std::string& port, unsigned baud,
                                    const SensorCalibration& calibration) = 0;
  /// Closes the sensor's port; does nothing without one.
  virtual void detachSensor() = 0;
  /// Receives signal messages of other programs (docs/reference/osc.md): FUDI over UDP, OSC. Port 0: the
  /// system chooses. Returns the port. Only this machine's messages are received unless another of its IPv4
  /// addresses is given (0.0.0.0: all).
  virtual Result<std::uint16_t> listenFudi(std::uint16_t port, const std::string& address = "127.0.0.1") = 0;
  virtual Result<std::uint16_t> listenOsc(std::uint16_t port, const std::string& address = "127.0.0.1") = 0;
  /// The paper's own route, in addition to or instead of our sound: sends a message per event to a
  /// synthesizer such as Pure Data.
  virtual Result<Done> sendSignals(const std::string& host, std::uint16_t port) = 0;

  /// Plays a recorded trace with exactly the samples of renderPress (for a button with several speeds: of the
  /// program nearest to the trace's speed); begins `lead_s` from now. Returns the stream sample at which time
  /// 0 of the trace lies. Ends by itself; a second call replaces the first.
  virtual Result<std::int64_t> playTrace(const PressTrace& trace, double lead_s) = 0;
  virtual bool tracePlaying() const = 0;

  /// Plays samples that another program made, in addition to what is pressed: with the player's gain, at most
  /// at full scale, without the device's equalizer. They begin within one buffer and end by themselves; a
  /// second call replaces the first. Failure wrongUsage: no sample, one beyond [-1, 1], a rate outside
  /// 8000..192000 Hz, more than 15 that have not ended, or a player without a sound device.
  virtual Result<Done> playSamples(const std::vector<float>& samples, double sampleRate_Hz) = 0;
  /// Fades out the samples that are playing.
  virtual void stopSamples() = 0;
  virtual bool samplesPlaying() = 0;

  virtual PlayerStatus status() = 0;
  /// Now, on the clock of takeClosings(). Any thread.
  virtual double clock_s() const = 0;
  /// Events since the last call, oldest first (only the latest few thousand are kept).
  virtual std::vector<EngineEvent> takeEvents() = 0;
  /// Presses since the last call, from any source.
  virtual PressCount takePresses() = 0;
  /// All closings of the contact since the last call, oldest first (only the last 1024 are kept).
  virtual std::vector<ContactClosing> takeClosings() = 0;
};

// ---- measuring a device

struct SoundRecording {
  std::vector<float> samples;
  std::uint64_t dropouts = 0;  ///< blocks that the sound system reports as lost or late
};

/// Played on `device`, recorded from `inputDevice` (empty: the same device), both as long as `samples`.
/// `cancelled` is called often; Failure cancelled if it returns true.
Result<SoundRecording> playAndRecordSamples(const PlayerSettings& settings, const std::string& inputDevice,
                                            const std::vector<float>& samples,
                                            const std::function<bool()>& cancelled);

/// Mean and standard deviation of a sensor's raw readings over `seconds`, for calibration. Waiting input is
/// discarded, and the measurement waits up to 10 s until readings no longer drift. Failure: deviceTrouble if
/// the port cannot be opened or sends nothing; cancelled, as above.
struct RawReading {
  double mean = 0, sd = 0;
  std::size_t n = 0;
  bool steady = true;  ///< false: the reading still drifted after the longest wait
};
Result<RawReading> readRawSensor(const std::string& port, unsigned baud, double seconds,
                                 const std::function<bool()>& cancelled);

struct LatencySettings {
  PlayerSettings player;
  std::string inputDevice;  ///< accelerometer, microphone or a loop of the output
  std::size_t trials = 50;  ///< K&L: N = 50; >= 1
  EventPlacement placement = EventPlacement::timeStamped;
  double sensorRate_Hz = 425;  ///< reading rate of the simulated sensor
  std::string sensorPort;      ///< empty: a simulated sensor ramps through the tactile force
  unsigned baud = 230400;
  SensorCalibration calibration;
  double threshold = 0;  ///< share of full scale on the input; 0: eight times the noise, at least 1e-4
};

/// Delays from the moment at which the force passed the tactile force to the first vibration on the input.
struct LatencyResult {
  std::vector<double> delays_s;
  std::size_t lost = 0;
  std::string device;
};

/// Calls `progress(done, all)` before each trial. Failure cancelled if `cancelled`, which is called often,
/// returns true.
Result<LatencyResult> measureLatency(const LatencySettings& settings,
                                     const std::function<void(std::size_t, std::size_t)>& progress,
                                     const std::function<bool()>& cancelled);

}  // namespace detent::playback
