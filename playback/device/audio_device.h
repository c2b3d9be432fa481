// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sound devices through PortAudio (JACK, ALSA, PulseAudio behind ALSA). One file includes PortAudio.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/result.h"
#include "playback/device/stream_renderer.h"
#include "playback/realtime/live_session.h"

namespace detent::playback {

struct AudioDeviceInfo {
  std::string name;     ///< as PortAudio gives it
  std::string hostApi;  ///< "JACK Audio Connection Kit", "ALSA", ...
  int inputChannels = 0, outputChannels = 0;
  double sampleRate_Hz = 0;  ///< the device's default
  bool defaultOutput = false, defaultInput = false;

  /// "ALSA: hw:0,0", the name to choose it by.
  std::string fullName() const { return hostApi + ": " + name; }
};

/// All devices of all host APIs. Searches for them again at each call while no stream is open.
Result<std::vector<AudioDeviceInfo>> listAudioDevices();

/// Way to reach a JACK server (jack_stream.h explains why there are two).
enum class JackRoute : std::uint8_t { ownClient, portAudio };

struct AudioSettings {
  std::string device;        ///< empty: the default output; else a full name or an unambiguous part of one
  double sampleRate_Hz = 0;  ///< 0: the device's default (JACK knows only its own)
  /// Samples per callback; 0 lets the host choose, which on JACK is its period without an extra buffer
  /// (a fixed number doubles the delay of full-duplex streams: PortAudio issue 1007).
  unsigned bufferFrames = 0;
  /// channels with the vibration, the same signal on each; fewer if the device has fewer; 0: none, the
  /// stream is for the rain alone
  int channels = 2;
  /// level of masking noise, on at most two channels behind those of the vibration, which keeps at least
  /// one; 0: no noise
  double rainLevel = 0;
  /// keeps the channels behind those of the vibration even without rain, for the sound of presses
  bool ears = false;
  JackRoute jackRoute = JackRoute::ownClient;
};

enum class StreamState : std::uint8_t { running, lost };

/// An open output stream that renders a session. If the device disappears, the stream's thread closes the
/// stream and tries to open it again until the device is back. The session, its program and its position are
/// kept.
class AudioOutput {
 public:
  /// The session must outlive the stream. Its sample rate is set to that of the stream, again each time the
  /// device comes back at another rate.
  static Result<std::unique_ptr<AudioOutput>> open(const AudioSettings& settings, LiveSession& session,
                                                   CallbackHooks hooks = {});
  ~AudioOutput();

  StreamState state() const;
  std::uint64_t losses() const;  ///< number of times the device disappeared
  std::string deviceName() const;
  /// seconds from a buffer to the device's output, as reported by the sound system; 0: not reported
  double latency_s() const;

 private:
  class Stream;
  explicit AudioOutput(std::unique_ptr<Stream> stream);
  std::unique_ptr<Stream> stream_;
};

/// Sample rate a session for this device should have.
Result<double> sampleRateFor(const AudioSettings& settings);

/// Samples recorded from a device.
struct Recording {
  std::vector<float> samples;
  std::uint64_t dropouts = 0;  ///< blocks that the host reports as lost or late
};

/// Plays `samples` on the device and records channel 0 of the input, for measurements. The recording is as
/// long as `samples`. After `cancelled` has returned true it ends at once, and the rest is silence.
Result<Recording> playAndRecord(const AudioSettings& output, const std::string& inputDevice,
                                const std::vector<float>& samples, const std::function<bool()>& cancelled);

/// A recording in progress; samples are stamped so that onsets have times on now_s().
class AudioCapture {
 public:
  struct Block {
    double time_s = 0;  ///< time of the first sample
    std::vector<float> samples;
  };
  static Result<std::unique_ptr<AudioCapture>> open(const std::string& inputDevice, double sampleRate_Hz);
  ~AudioCapture();
  double sampleRate_Hz() const;
  /// Everything recorded since the last call. One thread.
  std::vector<Block> take();
  std::uint64_t dropped() const;

 private:
  class Recorder;
  explicit AudioCapture(std::unique_ptr<Recorder> recorder);
  std::unique_ptr<Recorder> recorder_;
};

}  // namespace detent::playback
