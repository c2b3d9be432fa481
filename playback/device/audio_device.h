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

/// All devices of all host APIs. Looks anew each time while no stream is open.
Result<std::vector<AudioDeviceInfo>> listAudioDevices();

/// How a JACK server is reached (jack_stream.h says why there are two).
enum class JackRoute : std::uint8_t { ownClient, portAudio };

struct AudioSettings {
  std::string device;        ///< empty: the default output; else a full name or an unambiguous part of one
  double sampleRate_Hz = 0;  ///< 0: the device's default (JACK knows only its own)
  /// Samples per callback; 0 lets the host choose, which on JACK is its period without an extra buffer
  /// (a fixed number doubles the delay of full-duplex streams: PortAudio issue 1007).
  unsigned bufferFrames = 0;
  int channels =
      2;  ///< the same signal on each; fewer where the device has fewer; 0: none, it is for the rain alone
  double rainLevel =
      0;  ///< masking noise on up to two channels behind the signal's, which leave it at least one; 0: none
  bool ears = false;  ///< channels behind the signal's also without rain, for the sound of presses
  JackRoute jackRoute = JackRoute::ownClient;
};

enum class StreamState : std::uint8_t { running, lost };

/// An open output stream that renders a session. If the device goes away its thread closes the stream and
/// looks for the device until it is back; the session, its program and its position live on.
class AudioOutput {
 public:
  /// The session must outlive the stream; it is set to the stream's rate, again whenever the device comes back at another one.
  static Result<std::unique_ptr<AudioOutput>> open(const AudioSettings& settings, LiveSession& session,
                                                   CallbackHooks hooks = {});
  ~AudioOutput();

  StreamState state() const;
  std::uint64_t losses() const;  ///< how often the device went away
  std::string deviceName() const;
  double latency_s()
      const;  ///< from a buffer to the device's output, as the sound system says; 0: it does not

 private:
  class Stream;
  explicit AudioOutput(std::unique_ptr<Stream> stream);
  std::unique_ptr<Stream> stream_;
};

/// Sample rate a session for this device should have.
Result<double> sampleRateFor(const AudioSettings& settings);

/// What came back from a device.
struct Recording {
  std::vector<float> samples;
  std::uint64_t dropouts = 0;  ///< blocks the host says were lost or came too late
};

/// Plays `samples` on the device while recording its input's channel 0, for measurements; the recording is as long. Once `cancelled`
/// says so it ends at once and the rest is silence.
Result<Recording> playAndRecord(const AudioSettings& output, const std::string& inputDevice,
                                const std::vector<float>& samples, const std::function<bool()>& cancelled);

/// A recording in progress; samples are stamped so that onsets have times on now_s().
class AudioCapture {
 public:
  struct Block {
    double time_s = 0;  ///< of the first sample
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
