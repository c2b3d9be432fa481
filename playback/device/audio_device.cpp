// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/audio_device.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <optional>
#include <thread>

#include <fcntl.h>
#include <portaudio.h>
#include <unistd.h>

#include "model/text.h"
#include "playback/device/jack_stream.h"
#include "playback/device/steady_clock.h"
#include "playback/realtime/stream_clock.h"

namespace detent::playback {

namespace {

constexpr const char* jackApi = "JACK";
constexpr double lostAfter_s = 0.5;   // without a callback for this time, the device counts as lost
constexpr double retryEvery_s = 0.5;  // interval of attempts to reopen a lost device

/// Host libraries print messages about every device they do not find; these do not concern our users.
class QuietStderr {
 public:
  QuietStderr() {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    saved_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (saved_ >= 0) ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~QuietStderr() {
    if (saved_ < 0) return;
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  int saved_ = -1;
};

// PortAudio exists once per process; it makes its device list when it is initialised by the first user.
std::recursive_mutex libraryMutex;
int libraryUsers = 0;

class Library {
 public:
  Library() {
    const std::lock_guard lock(libraryMutex);
    const QuietStderr quiet;
    error_ = Pa_Initialize();
    if (error_ == paNoError) ++libraryUsers;
  }
  ~Library() {
    const std::lock_guard lock(libraryMutex);
    if (error_ != paNoError) return;
    const QuietStderr quiet;
    --libraryUsers;
    Pa_Terminate();
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  PaError error() const { return error_; }

 private:
  PaError error_;
};

Failure troubleOf(const std::string& device, Message what, PaError error) {
  std::string text = Pa_GetErrorText(error);
  if (error == paUnanticipatedHostError) {
    const PaHostErrorInfo* info = Pa_GetLastHostErrorInfo();
    if (info != nullptr && info->errorText != nullptr && *info->errorText != '\0')
      text += std::string(": ") + info->errorText;
  }
  return {FailureCode::deviceTrouble, device.empty() ? Subject("default device") : Subject(device), "",
          Message("%1 (%2)", std::move(what), text),
          Message("Check the connection of the sound device, or choose another one; `detent-play devices` "
                  "and the Feel panel (Setup) list them")};
}

AudioDeviceInfo infoOf(PaDeviceIndex index) {
  const PaDeviceInfo* d = Pa_GetDeviceInfo(index);
  const PaHostApiInfo* api = Pa_GetHostApiInfo(d->hostApi);
  AudioDeviceInfo info;
  info.name = d->name;
  info.hostApi = api->name;
  info.inputChannels = d->maxInputChannels;
  info.outputChannels = d->maxOutputChannels;
  // PortAudio too treats a JACK client's name as a regular expression when it counts ports.
  const bool jack = JackStream::available() && info.hostApi.starts_with(jackApi);
  if (jack && info.name.find_first_of("()[]{}.*+?^$|\\") != std::string::npos)
    info.outputChannels = JackStream::inputCount(info.name);
  info.sampleRate_Hz = d->defaultSampleRate;
  info.defaultOutput = index == Pa_GetDefaultOutputDevice();
  info.defaultInput = index == Pa_GetDefaultInputDevice();
  return info;
}

enum class Direction { input, output };

Result<PaDeviceIndex> findDevice(const std::string& wanted, Direction direction) {
  const bool output = direction == Direction::output;
  if (wanted.empty()) {
    const PaDeviceIndex index = output ? Pa_GetDefaultOutputDevice() : Pa_GetDefaultInputDevice();
    if (index == paNoDevice) {
      return Failure{FailureCode::deviceTrouble, "default device", "",
                     output ? Message("no sound output was found") : Message("no sound input was found"),
                     Message("Connect a sound device, or start a JACK server")};
    }
    return index;
  }
  std::vector<PaDeviceIndex> partly;
  std::string names;
  for (PaDeviceIndex i = 0; i < Pa_GetDeviceCount(); ++i) {
    const AudioDeviceInfo info = infoOf(i);
    if ((output ? info.outputChannels : info.inputChannels) < 1) continue;
    if (info.fullName() == wanted || info.name == wanted) return i;
    if (lowered(info.fullName()).find(lowered(wanted)) == std::string::npos) continue;
    partly.push_back(i);
    names += (names.empty() ? "" : ", ") + info.fullName();
  }
  if (partly.size() == 1) return partly.front();
  // For PortAudio each JACK client is a device; "JACK" alone means the default one.
  const PaDeviceIndex standard = output ? Pa_GetDefaultOutputDevice() : Pa_GetDefaultInputDevice();
  if (std::find(partly.begin(), partly.end(), standard) != partly.end()) return standard;
  if (partly.empty()) {
    return Failure{
        FailureCode::deviceTrouble, wanted, "",
        output ? Message("this computer has no sound output of this name")
               : Message("this computer has no sound input of this name"),
        Message("Choose a sound device from the list of `detent-play devices` or of the Feel panel (Setup)")};
  }
  return Failure{FailureCode::wrongUsage, wanted, "", Message("several devices match this name: %1", names),
                 Message("Give a longer part of the name")};
}

}  // namespace

Result<std::vector<AudioDeviceInfo>> listAudioDevices() {
  const std::lock_guard lock(libraryMutex);
  const Library library;
  if (library.error() != paNoError)
    return troubleOf("PortAudio", Message("the sound system or the sound device cannot be started"),
                     library.error());
  std::vector<AudioDeviceInfo> devices;
  for (PaDeviceIndex i = 0; i < Pa_GetDeviceCount(); ++i) devices.push_back(infoOf(i));
  return devices;
}

Result<double> sampleRateFor(const AudioSettings& settings) {
  const std::lock_guard lock(libraryMutex);
  const Library library;
  if (library.error() != paNoError)
    return troubleOf("PortAudio", Message("the sound system or the sound device cannot be started"),
                     library.error());
  Result<PaDeviceIndex> index = findDevice(settings.device, Direction::output);
  if (!index) return index.failure();
  const double own = infoOf(*index).sampleRate_Hz;
  return settings.sampleRate_Hz > 0 ? settings.sampleRate_Hz : own;
}

/// The stream with the thread that monitors it.
class AudioOutput::Stream {
 public:
  Stream(const AudioSettings& settings, LiveSession& session, CallbackHooks hooks)
      : settings_(settings), session_(session), renderer_(session, hooks, settings.rainLevel) {}

  ~Stream() {
    {
      const std::lock_guard lock(watchMutex_);
      stopping_ = true;
    }
    wake_.notify_all();
    if (watcher_.joinable()) watcher_.join();
    closeStream();
  }

  std::optional<Failure> start() {
    if (std::optional<Failure> trouble = openStream()) return trouble;
    watcher_ = std::thread([this] { watch(); });
    return {};
  }

  StreamState state() const { return lost_ ? StreamState::lost : StreamState::running; }
  std::uint64_t losses() const { return losses_; }
  std::string deviceName() const {
    const std::lock_guard lock(watchMutex_);
    return name_;
  }
  double latency_s() const { return latency_s_; }

 private:
  std::optional<Failure> openStream() {
    // A JACK server that was found once is opened directly, because PortAudio would have to enumerate all
    // devices again.
    if (!jackTarget_.empty()) return openJack(jackTarget_, channels_);
    const std::lock_guard lock(libraryMutex);
    library_ = std::make_unique<Library>();
    if (library_->error() != paNoError)
      return troubleOf("PortAudio", Message("the sound system or the sound device cannot be started"),
                       library_->error());
    Result<PaDeviceIndex> index = findDevice(settings_.device, Direction::output);
    if (!index) return index.failure();
    const AudioDeviceInfo info = infoOf(*index);
    channels_ = channelsOf(info);
    if (channels_.signal < std::min(1, settings_.channels))
      return Failure{
          FailureCode::deviceTrouble,
          info.fullName(),
          "",
          Message("the sound device has only one output, so participants would feel the masking noise"),
          {{RemedyKind::advice, Message("Choose the sound device of the headphones for the masking noise")},
           {RemedyKind::advice, Message("On the command line: --noise-device")}}};
    const bool jack = info.hostApi.rfind(jackApi, 0) == 0;
    if (jack && settings_.jackRoute == JackRoute::ownClient && JackStream::available()) {
      library_.reset();
      return openJack(info.name, channels_);
    }
    return openPortAudio(*index, info);
  }

  OutputChannels channelsOf(const AudioDeviceInfo& info) const {
    const int there = std::clamp(info.outputChannels, 1, 32), wanted = std::min(settings_.channels, there);
    if (!(settings_.rainLevel > 0) && !settings_.ears) return {std::max(1, wanted), 0};
    const int signal = std::min(wanted, there - 1);
    return {signal, std::min(2, there - signal)};
  }

  std::optional<Failure> openJack(const std::string& target, OutputChannels channels) {
    renderer_.touch(now_s());
    Result<std::unique_ptr<JackStream>> stream =
        JackStream::open(target, channels, settings_.sampleRate_Hz, renderer_);
    if (!stream) return stream.failure();
    jack_ = std::move(*stream);
    latency_s_ = jack_->latency_s();
    jackTarget_ = target;
    const std::lock_guard lock(watchMutex_);
    name_ = "JACK: " + target;
    return {};
  }

  std::optional<Failure> openPortAudio(PaDeviceIndex index, const AudioDeviceInfo& info) {
    PaStreamParameters output{};
    output.device = index;
    output.channelCount = channels_.all();
    output.sampleFormat = paFloat32;
    output.suggestedLatency = Pa_GetDeviceInfo(index)->defaultLowOutputLatency;
    const QuietStderr quiet;
    renderer_.setSampleRate(settings_.sampleRate_Hz > 0 ? settings_.sampleRate_Hz : info.sampleRate_Hz);
    const unsigned long frames =
        settings_.bufferFrames > 0 ? settings_.bufferFrames : paFramesPerBufferUnspecified;
    PaError error = Pa_OpenStream(&stream_, nullptr, &output, session_.sampleRate_Hz(), frames, paNoFlag,
                                  &Stream::callback, this);
    if (error != paNoError) {
      stream_ = nullptr;
      return troubleOf(
          info.fullName(),
          Message("the sound device cannot be opened at %1 Hz", std::lround(session_.sampleRate_Hz())),
          error);
    }
    renderer_.touch(now_s());
    error = Pa_StartStream(stream_);
    if (error != paNoError)
      return troubleOf(info.fullName(), Message("the sound system or the sound device cannot be started"),
                       error);
    const PaStreamInfo* const started = Pa_GetStreamInfo(stream_);
    latency_s_ = started != nullptr ? started->outputLatency : 0;
    const std::lock_guard lock(watchMutex_);
    name_ = info.fullName();
    return {};
  }

  void closeStream() {
    jack_.reset();
    const std::lock_guard lock(libraryMutex);
    if (stream_ != nullptr) {
      const QuietStderr quiet;
      Pa_AbortStream(stream_);
      Pa_CloseStream(stream_);
      stream_ = nullptr;
    }
    library_.reset();
  }

  static int callback(const void*, void* out, unsigned long frames, const PaStreamCallbackTimeInfo*,
                      PaStreamCallbackFlags flags, void* self) {
    static_cast<Stream*>(self)->render(static_cast<float*>(out), frames, flags);
    return paContinue;
  }

  // Audio thread: nothing here allocates, locks or waits.
  void render(float* out, std::size_t frames, PaStreamCallbackFlags flags) {
    const double entry_s = now_s();
    if ((flags & paOutputUnderflow) != 0) renderer_.noteXrun();
    const OutputChannels channels = channels_;
    renderer_.render(frames, entry_s, &now_s,
                     [&](std::size_t first, const float* signal, const float* rain, std::size_t count) {
                       float* target = out + first * static_cast<std::size_t>(channels.all());
                       for (std::size_t i = 0; i < count; ++i) {
                         for (int c = 0; c < channels.all(); ++c)
                           *target++ = channels.isSignal(c) ? signal[i] : rain[i];
                       }
                     });
  }

  void watch() {
    std::unique_lock lock(watchMutex_);
    while (!stopping_) {
      wake_.wait_for(lock, std::chrono::duration<double>(lost_ ? retryEvery_s : lostAfter_s / 2));
      if (stopping_) return;
      lock.unlock();
      lost_ ? reopen() : checkAlive();
      lock.lock();
    }
  }

  void checkAlive() {
    const bool there = jack_ ? jack_->alive() : Pa_IsStreamActive(stream_) == 1;
    if (there && now_s() - renderer_.lastEntry_s() < lostAfter_s) return;
    lost_ = true;
    ++losses_;
    closeStream();
  }

  void reopen() {
    renderer_.takeWhileAway();
    if (openStream()) {
      closeStream();
      return;
    }
    lost_ = false;
  }

  AudioSettings settings_;
  LiveSession& session_;
  StreamRenderer renderer_;
  std::unique_ptr<Library> library_;
  PaStream* stream_ = nullptr;
  std::unique_ptr<JackStream> jack_;
  std::string jackTarget_;
  OutputChannels channels_;
  std::atomic<bool> lost_{false};
  std::atomic<std::uint64_t> losses_{0};
  std::atomic<double> latency_s_{0};
  mutable std::mutex watchMutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::string name_;
  std::thread watcher_;
};

AudioOutput::AudioOutput(std::unique_ptr<Stream> stream) : stream_(std::move(stream)) {}
AudioOutput::~AudioOutput() = default;
StreamState AudioOutput::state() const { return stream_->state(); }
std::uint64_t AudioOutput::losses() const { return stream_->losses(); }
std::string AudioOutput::deviceName() const { return stream_->deviceName(); }
double AudioOutput::latency_s() const { return stream_->latency_s(); }

Result<std::unique_ptr<AudioOutput>> AudioOutput::open(const AudioSettings& settings, LiveSession& session,
                                                       CallbackHooks hooks) {
  auto stream = std::make_unique<Stream>(settings, session, hooks);
  if (std::optional<Failure> trouble = stream->start()) return *trouble;
  return std::unique_ptr<AudioOutput>(new AudioOutput(std::move(stream)));
}

namespace {

/// State that the callback of playAndRecord needs.
struct Duplex {
  const std::vector<float>* samples;
  Recording* recording;
  int channels;
  std::atomic<std::size_t> at{0};
  std::atomic<std::uint64_t> dropouts{0};

  static int callback(const void* in, void* out, unsigned long frames, const PaStreamCallbackTimeInfo*,
                      PaStreamCallbackFlags flags, void* self) {
    constexpr PaStreamCallbackFlags lost =
        paInputUnderflow | paInputOverflow | paOutputUnderflow | paOutputOverflow;
    Duplex& d = *static_cast<Duplex*>(self);
    const auto* input = static_cast<const float*>(in);
    auto* output = static_cast<float*>(out);
    std::size_t at = d.at;
    if (at > 0 && (flags & lost) != 0) ++d.dropouts;
    for (unsigned long i = 0; i < frames; ++i, ++at) {
      const bool inside = at < d.samples->size();
      for (int c = 0; c < d.channels; ++c) *output++ = inside ? (*d.samples)[at] : 0;
      if (inside && input != nullptr) d.recording->samples[at] = input[i];
    }
    d.at = at;
    return at < d.samples->size() ? paContinue : paComplete;
  }
};

}  // namespace

Result<Recording> playAndRecord(const AudioSettings& settings, const std::string& inputDevice,
                                const std::vector<float>& samples, const std::function<bool()>& cancelled) {
  std::unique_lock lock(libraryMutex);
  const Library library;
  if (library.error() != paNoError)
    return troubleOf("PortAudio", Message("the sound system or the sound device cannot be started"),
                     library.error());
  Result<PaDeviceIndex> out = findDevice(settings.device, Direction::output);
  if (!out) return out.failure();
  Result<PaDeviceIndex> in =
      findDevice(inputDevice.empty() ? settings.device : inputDevice, Direction::input);
  if (!in) return in.failure();
  const double rate = settings.sampleRate_Hz > 0 ? settings.sampleRate_Hz : infoOf(*out).sampleRate_Hz;
  PaStreamParameters output{}, input{};
  output.device = *out;
  output.channelCount = std::clamp(settings.channels, 1, std::max(1, infoOf(*out).outputChannels));
  input.device = *in;
  input.channelCount = 1;
  output.sampleFormat = input.sampleFormat = paFloat32;
  output.suggestedLatency = Pa_GetDeviceInfo(*out)->defaultLowOutputLatency;
  input.suggestedLatency = Pa_GetDeviceInfo(*in)->defaultLowInputLatency;
  Recording recording{std::vector<float>(samples.size(), 0)};
  Duplex duplex{&samples, &recording, output.channelCount};
  PaStream* stream = nullptr;
  PaError error;
  {
    const QuietStderr quiet;
    error = Pa_OpenStream(&stream, &input, &output, rate, paFramesPerBufferUnspecified, paNoFlag,
                          &Duplex::callback, &duplex);
    if (error == paNoError) error = Pa_StartStream(stream);
  }
  if (error != paNoError) {
    if (stream != nullptr) Pa_CloseStream(stream);
    return troubleOf(settings.device, Message("the sound device cannot play and record at the same time"),
                     error);
  }
  lock.unlock();  // unlocked for minutes, so that other threads can list and open devices
  const double deadline_s = now_s() + static_cast<double>(samples.size()) / rate + 5;
  while (Pa_IsStreamActive(stream) == 1 && now_s() < deadline_s && !cancelled()) sleepUntil(now_s() + 0.02);
  const bool complete = duplex.at >= samples.size() || cancelled();
  lock.lock();
  Pa_AbortStream(stream);
  Pa_CloseStream(stream);
  if (!complete)
    return Failure{FailureCode::deviceTrouble, settings.device, "",
                   Message("the sound device stopped during the measurement"),
                   Message("Check the device and try again")};
  recording.dropouts = duplex.dropouts;
  return recording;
}

/// A ring buffer that the callback writes and one thread reads.
class AudioCapture::Recorder {
 public:
  explicit Recorder(double rate) : rate_(rate), clock_(rate), ring_(static_cast<std::size_t>(rate * 4)) {}
  ~Recorder() {
    const std::lock_guard lock(libraryMutex);
    if (stream_ == nullptr) return;
    Pa_AbortStream(stream_);
    Pa_CloseStream(stream_);
  }

  std::optional<Failure> start(const std::string& device) {
    const std::lock_guard lock(libraryMutex);
    if (library_.error() != paNoError)
      return troubleOf("PortAudio", Message("the sound system or the sound device cannot be started"),
                       library_.error());
    Result<PaDeviceIndex> index = findDevice(device, Direction::input);
    if (!index) return index.failure();
    PaStreamParameters input{};
    input.device = *index;
    input.channelCount = 1;
    input.sampleFormat = paFloat32;
    input.suggestedLatency = Pa_GetDeviceInfo(*index)->defaultLowInputLatency;
    const QuietStderr quiet;
    PaError error = Pa_OpenStream(&stream_, &input, nullptr, rate_, paFramesPerBufferUnspecified, paNoFlag,
                                  &Recorder::callback, this);
    if (error != paNoError) {
      stream_ = nullptr;
      return troubleOf(device, Message("the sound device cannot be used for recording"), error);
    }
    error = Pa_StartStream(stream_);
    if (error != paNoError)
      return troubleOf(device, Message("the sound system or the sound device cannot be started"), error);
    return {};
  }

  double rate() const { return rate_; }
  std::uint64_t dropped() const { return dropped_; }

  std::vector<Block> take() {
    const std::uint64_t written = written_.load(std::memory_order_acquire);
    std::vector<Block> blocks;
    if (written == read_) return blocks;
    Block block;
    block.samples.reserve(static_cast<std::size_t>(written - read_));
    block.time_s = base_s_.load(std::memory_order_acquire) + static_cast<double>(read_) / rate_;
    for (; read_ < written; ++read_)
      block.samples.push_back(ring_[static_cast<std::size_t>(read_ % ring_.size())]);
    taken_.store(read_, std::memory_order_release);
    blocks.push_back(std::move(block));
    return blocks;
  }

 private:
  static int callback(const void* in, void*, unsigned long frames, const PaStreamCallbackTimeInfo*,
                      PaStreamCallbackFlags, void* self) {
    static_cast<Recorder*>(self)->record(static_cast<const float*>(in), frames);
    return paContinue;
  }

  void record(const float* in, unsigned long frames) {
    std::uint64_t at = written_.load(std::memory_order_relaxed);
    clock_.onCallback(now_s(), static_cast<std::int64_t>(at), static_cast<std::int64_t>(frames));
    // The callback is called when a block is complete, so its first sample is one block old.
    base_s_.store(-(clock_.frameAt(0) + static_cast<double>(frames)) / rate_, std::memory_order_release);
    if (at + frames - taken_.load(std::memory_order_acquire) > ring_.size()) {
      dropped_ += frames;
      return;
    }
    for (unsigned long i = 0; i < frames; ++i, ++at)
      ring_[static_cast<std::size_t>(at % ring_.size())] = in != nullptr ? in[i] : 0;
    written_.store(at, std::memory_order_release);
  }

  Library library_;
  double rate_;
  StreamClock clock_;
  PaStream* stream_ = nullptr;
  std::vector<float> ring_;
  std::atomic<std::uint64_t> written_{0}, taken_{0}, dropped_{0};
  std::uint64_t read_ = 0;
  std::atomic<double> base_s_{0};
};

AudioCapture::AudioCapture(std::unique_ptr<Recorder> recorder) : recorder_(std::move(recorder)) {}
AudioCapture::~AudioCapture() = default;
double AudioCapture::sampleRate_Hz() const { return recorder_->rate(); }
std::vector<AudioCapture::Block> AudioCapture::take() { return recorder_->take(); }
std::uint64_t AudioCapture::dropped() const { return recorder_->dropped(); }

Result<std::unique_ptr<AudioCapture>> AudioCapture::open(const std::string& inputDevice,
                                                         double sampleRate_Hz) {
  auto recorder = std::make_unique<Recorder>(sampleRate_Hz);
  if (std::optional<Failure> trouble = recorder->start(inputDevice)) return *trouble;
  return std::unique_ptr<AudioCapture>(new AudioCapture(std::move(recorder)));
}

}  // namespace detent::playback
