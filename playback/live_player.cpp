// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "playback/device/audio_device.h"
#include "playback/device/pd_route.h"
#include "playback/device/press_source.h"
#include "playback/device/serial_sensor.h"
#include "playback/device/signal_server.h"
#include "playback/device/steady_clock.h"
#include "playback/offline/press_speed.h"
#include "playback/offline/resample.h"
#include "playback/playback.h"

namespace detent::playback {

namespace {

constexpr std::size_t mostKeptEvents = 8192, mostKeptClosings = 1024;
constexpr std::size_t mostTakes = 16;
constexpr double traceAhead_s = 0.25;
constexpr double traceStep_s = 0.05;
constexpr double feltHold_s = 1.5;
constexpr double silentRate_Hz = 48000;  // rate at which a player without a device counts frames

AudioSettings audioSettings(const PlayerSettings& s) {
  return {s.device,
          s.sampleRate_Hz,
          s.bufferFrames,
          s.channels,
          s.masking.device.empty() ? s.masking.level : 0,
          s.sound.audible(),
          s.jackThroughPortAudio ? JackRoute::portAudio : JackRoute::ownClient};
}

SensorCondition conditionOf(SensorState state) {
  switch (state) {
    case SensorState::starting:
      return SensorCondition::starting;
    case SensorState::running:
      return SensorCondition::running;
    case SensorState::silent:
      return SensorCondition::silent;
    case SensorState::stuck:
      return SensorCondition::stuck;
    case SensorState::unplugged:
      break;
  }
  return SensorCondition::unplugged;
}

void count(EngineCounts& counts, const Crossing& crossing) {
  if (crossing.kind == CrossingKind::grain) counts.grains += crossing.count;
  if (crossing.kind == CrossingKind::pressJump) ++counts.pressJumps;
  if (crossing.kind == CrossingKind::releaseJump) ++counts.releaseJumps;
  if (crossing.kind == CrossingKind::bottomOut) ++counts.bottomOuts;
}

class Player : public LivePlayer {
 public:
  /// `sounding` false: no output will be opened, and nothing is sent to the session.
  Player(double sampleRate_Hz, bool sounding)
      : sounding_(sounding), session_(sampleRate_Hz), began_s_(now_s()) {}

  ~Player() override {
    stopTrace();
    finger_.reset();
    sensor_.reset();
    fudi_.reset();
    osc_.reset();
    output_.reset();  // after everything else, because the callback reads programs until here
  }

  Result<Done> open(const PlayerSettings& settings, const LiveProgram& program, CallbackHooks hooks) {
    setProgram(program);
    PressSound sound = settings.sound;
    sound.samples = resampled(sound.samples, sound.sampleRate_Hz, session_.sampleRate_Hz());
    sound.sampleRate_Hz = session_.sampleRate_Hz();
    session_.setPressSound(std::move(sound));
    Result<std::unique_ptr<AudioOutput>> output = AudioOutput::open(audioSettings(settings), session_, hooks);
    if (!output) return output.failure();
    output_ = std::move(*output);
    return settings.masking.level > 0 && !settings.masking.device.empty() ? openRain(settings.masking)
                                                                          : Result<Done>(Done{});
  }

  void setProgram(const LiveProgram& program) override {
    receive();
    const std::lock_guard lock(controlMutex_);
    sendProgram(program);
    const std::lock_guard routeLock(readingMutex_);
    const double force_N = follower_.position().force_N;
    auto taken = std::make_unique<LiveProgram>(program);
    follower_.use(&taken->program, &taken->speeds);
    if (heldByDisplacement_)
      // the force of a finger held by displacement is still that of the previous button
      follower_.placeAtDisplacement(held_mm_);
    else
      follower_.placeAtForce(force_N);
    presses_.use(&taken->program);
    presses_.take(follower_.position());
    routeProgram_ = std::move(taken);
    ownForce_.setSettings(limitsFor(program.program));
    if (sensor_) sensor_->setConditioner(limitsFor(program.program));
  }

  void setGain(double gain) override {
    const std::lock_guard lock(controlMutex_);
    ownGain_ = gain;
    sendGain();
  }

  void pushForce(double force_N) override { pushOwn(CommandKind::force, ownForce_, force_N, now_s()); }
  void pushDisplacement(double displacement_mm) override { pushDisplacementAt(displacement_mm, now_s()); }
  void pushDisplacementAt(double displacement_mm, double time_s) override {
    pushOwn(CommandKind::displacement, ownDisplacement_, displacement_mm, time_s);
  }

  void fingerDown(double peak_N) override {
    const std::lock_guard lock(controlMutex_);
    fingerFor(peak_N).down();
  }
  void fingerUp() override {
    const std::lock_guard lock(controlMutex_);
    if (finger_) finger_->up();
  }
  void fingerTap(double peak_N, double hold_s) override {
    const std::lock_guard lock(controlMutex_);
    fingerFor(peak_N).tap(hold_s);
  }

  Result<Done> attachSensor(const std::string& port, unsigned baud,
                            const SensorCalibration& calibration) override {
    SerialSettings settings;
    settings.port = port;
    settings.baud = baud;
    settings.calibration = calibration;
    {
      const std::lock_guard lock(readingMutex_);
      settings.conditioner = limitsFor(routeProgram_->program);
    }
    Result<std::unique_ptr<SerialSensor>> sensor =
        SerialSensor::open(settings, [this](const SensorReading& reading) { forward(reading); });
    if (!sensor) return sensor.failure();
    const std::lock_guard lock(controlMutex_);
    sensor_ = std::move(*sensor);
    return Done{};
  }
  void detachSensor() override {
    const std::lock_guard lock(controlMutex_);
    sensor_.reset();
  }

  Result<std::uint16_t> listenFudi(std::uint16_t port, const std::string& address) override {
    return keep(fudi_, openFudiServer(port, address, receiver()));
  }
  Result<std::uint16_t> listenOsc(std::uint16_t port, const std::string& address) override {
    return keep(osc_, openOscServer(port, address, receiver()));
  }

  Result<Done> sendSignals(const std::string& host, std::uint16_t port) override {
    // Resolving a name may take seconds, so it is done without a lock.
    Result<std::unique_ptr<SignalSender>> sender = SignalSender::open(host, port);
    if (!sender) return sender.failure();
    const std::lock_guard lock(readingMutex_);
    route_ = std::make_unique<PdRoute>(std::move(*sender));
    return Done{};
  }

  Result<std::int64_t> playTrace(const PressTrace& trace, double lead_s) override {
    const std::lock_guard traceLock(traceMutex_);
    const bool replaces = tracePlaying_;
    stopTrace();
    if (!sounding_) {
      return Failure{FailureCode::wrongUsage, "press trace", "",
                     Message("nothing can be played without a sound device"),
                     Message("Start the player with a sound device")};
    }
    if (trace.readings.empty()) {
      return Failure{FailureCode::wrongUsage, "press trace", "",
                     Message("the press trace contains no readings"), Message("Give at least one reading")};
    }
    const double origin_s = std::min(0.0, trace.readings.front().time_s);
    std::vector<EngineInput> inputs = traceInputs(trace, origin_s);
    status();
    const auto start =
        streamFrame() +
        static_cast<std::int64_t>(std::ceil(std::max(lead_s, traceStep_s) * session_.sampleRate_Hz()));
    for (EngineInput& input : inputs) input.time_frames += static_cast<double>(start);
    if (replaces) dropSentAhead(inputs.front());
    tracePlaying_ = true;
    stopTrace_ = false;
    const bool oneSpeed = playAtSpeedOf(trace);
    traceThread_ = std::thread([this, inputs = std::move(inputs), oneSpeed] {
      feedTrace(inputs);
      if (oneSpeed) endSpeed();
      tracePlaying_ = false;
    });
    return start;
  }
  bool tracePlaying() const override { return tracePlaying_; }

  Result<Done> playSamples(const std::vector<float>& samples, double sampleRate_Hz) override {
    if (std::optional<Failure> wrong = unplayable(samples, sampleRate_Hz)) return *std::move(wrong);
    auto take = std::make_unique<OwnedTake>();
    const double rate_Hz = session_.sampleRate_Hz();
    take->samples = sampleRate_Hz == rate_Hz ? samples : resampled(samples, sampleRate_Hz, rate_Hz);
    take->taken = {take->samples.data(), take->samples.size(), peakOf(take->samples)};
    receive();
    const std::lock_guard lock(controlMutex_);
    if (takes_.size() >= mostTakes || !sendTake(&take->taken)) {
      return Failure{FailureCode::wrongUsage, "samples", "",
                     Message("too many requests to play samples came at the same time"),
                     Message("Wait until one of the requests has begun")};
    }
    takes_.push_back(std::move(take));
    return Done{};
  }
  void stopSamples() override {
    const std::lock_guard lock(controlMutex_);
    if (!takes_.empty()) sendTake(nullptr);
  }
  bool samplesPlaying() override {
    receive();
    const std::lock_guard lock(controlMutex_);
    return !takes_.empty();
  }

  PlayerStatus status() override {
    receive();
    PlayerStatus s;
    const std::lock_guard lock(controlMutex_);
    const SessionStatus& last = lastStatus_;
    s.sounding = sounding_;
    if (sounding_) s.sampleRate_Hz = session_.sampleRate_Hz();
    if (output_) {
      s.device = output_->deviceName();
      s.deviceLost = output_->state() == StreamState::lost;
      s.deviceLosses = output_->losses();
      s.outputLatency_s = output_->latency_s();
    }
    if (rain_) {
      s.deviceLost = s.deviceLost || rain_->state() == StreamState::lost;
      s.deviceLosses += rain_->losses();
    }
    s.blockFrames = last.blockFrames;
    s.counts = last.counts;
    follow(s);
    s.level = static_cast<double>(last.peak);
    s.felt_dB = strongest_.felt_dB;
    s.load = last.load;
    s.meanLoad = last.meanLoad;
    s.xruns = last.xruns;
    if (sensor_) {
      const SensorHealth health = sensor_->health();
      s.sensor = conditionOf(health.state);
      s.sensorRate_Hz = health.rate_Hz;
      s.sensorReconnects = health.reconnects;
      const ConditionerCounts& c = health.readings;
      s.rejectedReadings = c.rejected() + health.wrongStamps;
      s.sensorSendsCounts = health.lines.counts > 0;
      s.sensorGreeting = health.greeting;
      s.sensorNoise_N = health.noise_N;
      s.malformedLines = health.lines.malformed + health.lines.badChecksums + health.lines.overlong;
    }
    s.droppedReadings = last.counts.droppedInputs + last.staleCommands;
    s.droppedEvents = last.counts.crowded + last.counts.hastened + last.droppedReports;
    s.limitedBlocks = last.limitedBlocks;
    {
      const std::lock_guard readingLock(readingMutex_);
      s.messageForces = ownForce_.counts().accepted;
      s.rejectedReadings += ownForce_.counts().rejected();
    }
    for (const auto* server : {fudi_.get(), osc_.get()}) {
      if (server == nullptr) continue;
      s.signalMessages += server->counts().messages;
      s.malformedMessages += server->counts().malformed;
    }
    return s;
  }

  std::vector<EngineEvent> takeEvents() override {
    receive();
    const std::lock_guard lock(controlMutex_);
    const std::lock_guard readingLock(readingMutex_);
    std::deque<EngineEvent>& kept = sounding_ ? events_ : followedEvents_;
    std::vector<EngineEvent> events(kept.begin(), kept.end());
    kept.clear();
    return events;
  }

  double clock_s() const override { return now_s(); }

  PressCount takePresses() override {
    const std::lock_guard lock(readingMutex_);
    return presses_.taken();
  }

  std::vector<ContactClosing> takeClosings() override {
    const std::lock_guard lock(readingMutex_);
    return std::exchange(closings_, {});
  }

 private:
  /// Samples and the description by which the callback knows them.
  struct OwnedTake {
    std::vector<float> samples;
    SoundTake taken;
  };

  static double peakOf(const std::vector<float>& samples) {
    double peak = 0;
    for (const float sample : samples) peak = std::max(peak, std::fabs(static_cast<double>(sample)));
    return peak;
  }

  std::optional<Failure> unplayable(const std::vector<float>& samples, double sampleRate_Hz) const {
    const auto wrong = [](Message problem, const Message& remedy) {
      return Failure{FailureCode::wrongUsage, "samples", "", std::move(problem), remedy};
    };
    if (!sounding_)
      return wrong(Message("nothing can be played without a sound device"),
                   Message("Start the player with a sound device"));
    if (samples.empty()) return wrong(Message("there are no samples"), Message("Give at least one reading"));
    if (!(sampleRate_Hz >= HapticEngine::lowestSampleRate_Hz &&
          sampleRate_Hz <= HapticEngine::highestSampleRate_Hz))
      return wrong(Message("the samples have a rate outside 8000 to 192000 Hz"),
                   Message("Choose another rate"));
    const bool within =
        std::all_of(samples.begin(), samples.end(), [](float v) { return v >= -1 && v <= 1; });
    if (!within)
      return wrong(Message("the samples exceed full scale"), Message("Give samples within -1 and 1"));
    return std::nullopt;
  }

  /// Call with controlMutex_ held. If the lane is full, `receive` sends the program when there is room.
  void sendProgram(const LiveProgram& program) {
    if (!sounding_) return;
    owedProgram_ = std::make_unique<LiveProgram>(program);
    sendOwedProgram();
  }

  /// Call with controlMutex_ held.
  void sendOwedProgram() {
    if (!owedProgram_) return;
    SessionCommand command;
    command.kind = CommandKind::program;
    command.program = &owedProgram_->program;
    command.speeds = &owedProgram_->speeds;
    if (session_.send(Lane::control, command)) programs_.push_back(std::move(owedProgram_));
  }

  /// Plays a trace of known speed with the program of that speed, as it would be rendered. Returns true if
  /// `endSpeed` must be called after it.
  bool playAtSpeedOf(const PressTrace& trace) {
    const std::lock_guard lock(controlMutex_);
    const std::lock_guard readingLock(readingMutex_);
    if (routeProgram_->speeds.empty()) return false;
    const double speed_mm_per_s = pressSpeed_mm_per_s(routeProgram_->program, trace).value_or(0);
    sendProgram(nearest(routeProgram_->speeds, speed_mm_per_s).program);
    return true;
  }
  void endSpeed() {
    const std::lock_guard lock(controlMutex_);
    const std::lock_guard readingLock(readingMutex_);
    sendProgram(*routeProgram_);
  }

  /// Call with controlMutex_ held.
  bool sendTake(const SoundTake* take) {
    SessionCommand command;
    command.kind = CommandKind::take;
    command.take = take;
    return session_.send(Lane::control, command);
  }

  /// Opens the separate device for rain: a stream whose session has no program.
  Result<Done> openRain(const MaskingNoise& masking) {
    rainSession_.emplace(session_.sampleRate_Hz());
    AudioSettings audio;
    audio.device = masking.device;
    audio.channels = 0;
    audio.rainLevel = masking.level;
    Result<std::unique_ptr<AudioOutput>> rain = AudioOutput::open(audio, *rainSession_);
    if (!rain) return rain.failure();
    rain_ = std::move(*rain);
    if (rain_->deviceName() != output_->deviceName()) return Done{};
    return Failure{
        FailureCode::wrongUsage,
        masking.device,
        "",
        Message("this sound device also plays the vibration, so participants would feel the masking noise"),
        {{RemedyKind::advice, Message("Choose the sound device of the headphones for the masking noise")},
         {RemedyKind::advice, Message("On the command line: --noise-device")}}};
  }

  std::int64_t streamFrame() {
    const std::lock_guard lock(controlMutex_);
    // The last status is up to 20 ms old; the caller's lead time is large enough to cover that.
    return lastStatus_.frame;
  }

  /// Fills in the position and, without a device, the counts, from the readings themselves, because the
  /// callback's are one status interval or one buffer old.
  void follow(PlayerStatus& s) {
    StrokePosition position = lastStatus_.position;
    const std::lock_guard lock(readingMutex_);
    if (!tracePlaying_) position = follower_.position();
    if (!sounding_) s.counts = followedCounts_;
    s.force_N = position.force_N;
    s.displacement_mm = position.displacement_mm;
    s.releasing = position.releasing;
    s.contact = position.contact;
    s.state = position.state;
    s.speed_mm_per_s = follower_.speed_mm_per_s();
  }

  void receive() {
    const std::lock_guard lock(controlMutex_);
    sendOwedProgram();
    if (owesGain_) sendGain();
    SessionReport report;
    while (session_.receive(report)) {
      switch (report.kind) {
        case ReportKind::event:
          if (events_.size() == mostKeptEvents) events_.pop_front();
          events_.push_back(report.event);
          break;
        case ReportKind::status:
          lastStatus_ = report.status;
          keepStrongest();
          break;
        case ReportKind::retired:
          std::erase_if(programs_, [&](const auto& p) { return &p->program == report.retired; });
          break;
        case ReportKind::takeEnded:
          std::erase_if(takes_, [&](const auto& t) { return &t->taken == report.endedTake; });
          break;
      }
    }
  }

  /// Call with controlMutex_ held.
  void keepStrongest() {
    const auto passed_frames = static_cast<double>(lastStatus_.frame - strongest_.frame);
    if (lastStatus_.felt_dB < strongest_.felt_dB && passed_frames < feltHold_s * session_.sampleRate_Hz())
      return;
    strongest_ = {lastStatus_.felt_dB, lastStatus_.frame};
  }

  void pushOwn(CommandKind kind, ForceConditioner& conditioner, double value, double time_s) {
    const std::lock_guard lock(readingMutex_);
    const ConditionerVerdict verdict = conditioner.judge(time_s, value);
    if (verdict == ConditionerVerdict::reject) return;
    const bool resumed = verdict == ConditionerVerdict::resume && kind == CommandKind::force;
    sendReading(resumed ? CommandKind::resync : kind, time_s, conditioner.value());
  }

  void forward(const SensorReading& reading) {
    const std::lock_guard lock(readingMutex_);
    sendReading(reading.resumed ? CommandKind::resync : CommandKind::force, reading.time_s, reading.force_N);
  }

  // Call with readingMutex_ held, because the sensor lane has one producer at a time.
  void sendReading(CommandKind kind, double time_s, double value) {
    if (tracePlaying_) return;  // only one finger at a time
    follow(kind, time_s, value);
    if (!sounding_) return;
    // Readings are not queued for a missing device: when it returns, only the finger's position at that time
    // counts.
    const bool away = output_ && output_->state() == StreamState::lost;
    if (away || missedReadings_) {
      missedReadings_ = away;
      if (away) return;
      if (kind == CommandKind::force) kind = CommandKind::resync;
    }
    SessionCommand command;
    command.kind = kind;
    command.timeBase = TimeBase::clock;
    command.time = time_s;
    command.value = value;
    session_.send(Lane::sensor, command);
  }

  /// Call with readingMutex_ held.
  void follow(CommandKind kind, double time_s, double value) {
    ++followedCounts_.inputs;
    heldByDisplacement_ = kind == CommandKind::displacement;
    if (heldByDisplacement_) held_mm_ = value;
    if (kind == CommandKind::resync) {
      follower_.placeAtForce(value);
      presses_.use(&routeProgram_->program);  // the movements since the last reading are unknown
      presses_.take(follower_.position());
      followedAt_s_ = time_s;
      return;
    }
    const Crossings& crossings = kind == CommandKind::force ? follower_.updateForce(value, time_s)
                                                            : follower_.updateDisplacement(value, time_s);
    presses_.take(follower_.position());
    keepClosings(crossings, time_s);
    if (route_) route_->send(crossings, *follower_.program());
    if (sounding_) return;  // with a sound device, the callback reports events
    const double frame = (time_s - began_s_) * session_.sampleRate_Hz();
    for (std::size_t i = 0; i < crossings.count; ++i) {
      const Crossing& c = crossings.items[i];
      count(followedCounts_, c);
      if (followedEvents_.size() == mostKeptEvents) followedEvents_.pop_front();
      followedEvents_.push_back(
          {kindOf(c.kind), c.state, c.jump, c.count, static_cast<std::int64_t>(frame), c.displacement_mm});
    }
  }

  /// Call with readingMutex_ held.
  void keepClosings(const Crossings& crossings, double time_s) {
    const double within_s = time_s - std::exchange(followedAt_s_, time_s);
    for (std::size_t i = 0; i < crossings.count; ++i) {
      const Crossing& c = crossings.items[i];
      if (c.kind != CrossingKind::contactClosed) continue;
      if (closings_.size() == mostKeptClosings) closings_.erase(closings_.begin());
      closings_.push_back({time_s - (1 - c.fraction) * within_s, within_s});
    }
  }

  SignalReceiver receiver() {
    return [this](const SignalMessage& m, double arrival_s) {
      SessionCommand command;
      command.timeBase = TimeBase::clock;
      command.time = arrival_s;
      switch (m.kind) {
        case SignalKind::grain:
          command.kind = m.bare ? CommandKind::grain : CommandKind::burst;
          command.burst = m.burst;
          break;
        case SignalKind::jump:
        case SignalKind::bottomOut:
          command.kind = CommandKind::burst;
          command.burst = m.burst;
          break;
        case SignalKind::force:
          pushForce(m.value);
          return;
        case SignalKind::displacement:
          pushDisplacement(m.value);
          return;
        case SignalKind::hold:
        case SignalKind::none:
          return;
        case SignalKind::stop:
        case SignalKind::gain: {
          const std::lock_guard lock(controlMutex_);
          gainShare_ = m.value;
          sendGain();
          return;
        }
      }
      if (!sounding_) return;
      const std::lock_guard lock(networkMutex_);
      session_.send(Lane::network, command);
    };
  }

  Result<std::uint16_t> keep(std::unique_ptr<SignalServer>& place,
                             Result<std::unique_ptr<SignalServer>> server) {
    if (!server) return server.failure();
    const std::uint16_t port = (*server)->port();
    {
      const std::lock_guard lock(controlMutex_);
      place.swap(*server);
    }
    // the thread of the old server may need the lock, so that server is destroyed after it was released
    return port;
  }

  /// Call with controlMutex_ held. Other programs may lower the gain that was set here, but not raise it.
  void sendGain() {
    if (!sounding_) return;
    SessionCommand command;
    command.kind = CommandKind::gain;
    command.value = ownGain_ * gainShare_;
    owesGain_ = !session_.send(Lane::control, command);
  }

  /// Call with controlMutex_ held.
  VirtualFinger& fingerFor(double peak_N) {
    if (!finger_ || fingerPeak_N_ != peak_N) {
      finger_.reset();
      FingerProfile profile;
      profile.peak_N = peak_N;
      fingerPeak_N_ = peak_N;
      finger_ = std::make_unique<VirtualFinger>(profile,
                                                [this](const SensorReading& reading) { forward(reading); });
    }
    return *finger_;
  }

  std::vector<EngineInput> traceInputs(const PressTrace& trace, double origin_s) {
    const std::lock_guard lock(readingMutex_);
    ConditionerCounts counts;
    return conditionedInputs(trace, routeProgram_->program, session_.sampleRate_Hz(), origin_s, counts);
  }

  // Drops inputs of the previous trace that were sent ahead, and moves the finger to the new trace's start.
  void dropSentAhead(const EngineInput& first) {
    SessionCommand command;
    command.kind = CommandKind::forget;
    session_.send(Lane::trace, command);
    command.kind =
        first.kind == InputKind::displacement ? CommandKind::resyncDisplacement : CommandKind::resync;
    command.value = first.value;
    session_.send(Lane::trace, command);
  }

  void feedTrace(const std::vector<EngineInput>& inputs) {
    const double rate = session_.sampleRate_Hz();
    std::size_t next = 0;
    // A lost device ends the trace, because the missed part cannot be played later.
    const auto away = [&] { return output_->state() == StreamState::lost; };
    while (!stopTrace_ && !away() && next < inputs.size()) {
      receive();
      const double ahead = static_cast<double>(streamFrame()) + traceAhead_s * rate;
      while (next < inputs.size() && inputs[next].time_frames < ahead) {
        SessionCommand command;
        command.kind =
            inputs[next].kind == InputKind::displacement ? CommandKind::displacement : CommandKind::force;
        command.timeBase = TimeBase::streamFrames;
        command.time = inputs[next].time_frames;
        command.value = inputs[next].value;
        if (!session_.send(Lane::trace, command)) break;
        ++next;
      }
      sleepUntil(now_s() + traceStep_s);
    }
    // Readings sent ahead must have been applied before another source may send.
    if (!stopTrace_) sleepUntil(now_s() + traceAhead_s + 0.05);
  }

  void stopTrace() {
    stopTrace_ = true;
    if (traceThread_.joinable()) traceThread_.join();
    tracePlaying_ = false;
  }

  const bool sounding_;
  LiveSession session_;
  const double began_s_;
  std::mutex controlMutex_, readingMutex_, networkMutex_;  // lock control before reading if both are needed
  std::mutex traceMutex_;                                  // lock before all others: one playTrace at a time
  std::vector<std::unique_ptr<LiveProgram>> programs_;     // guarded by controlMutex_; in use by the callback
  std::unique_ptr<LiveProgram> owedProgram_;  // guarded by controlMutex_; the newest program, not sent yet
  std::vector<std::unique_ptr<OwnedTake>> takes_;  // guarded by controlMutex_; in use by the callback
  SessionStatus lastStatus_;
  struct {
    double felt_dB = -std::numeric_limits<double>::infinity();
    std::int64_t frame = 0;
  } strongest_;
  std::deque<EngineEvent> events_;
  ForceConditioner ownForce_;
  ForceConditioner ownDisplacement_{ConditionerSettings{-1e9, 1e9, 1e12, 0.25, 0.25, 1e12, 1e12, 0, 0}};
  std::unique_ptr<LiveProgram> routeProgram_;
  SpeedTracker follower_;                 // follows routeProgram_
  bool heldByDisplacement_ = false;       // guarded by readingMutex_: how the finger's position is known
  double held_mm_ = 0;                    // guarded by readingMutex_
  PressCounter presses_;                  // guarded by readingMutex_
  double followedAt_s_ = 0;               // guarded by readingMutex_; time of the last reading
  std::vector<ContactClosing> closings_;  // guarded by readingMutex_
  EngineCounts followedCounts_;
  std::deque<EngineEvent> followedEvents_;
  std::unique_ptr<PdRoute> route_;
  bool missedReadings_ = false;         // guarded by readingMutex_
  double ownGain_ = 1, gainShare_ = 1;  // guarded by controlMutex_
  bool owesGain_ = false;               // guarded by controlMutex_; the lane was full
  double fingerPeak_N_ = 0;
  std::atomic<bool> tracePlaying_{false}, stopTrace_{false};
  std::thread traceThread_;
  std::unique_ptr<AudioOutput> output_;
  std::optional<LiveSession> rainSession_;
  std::unique_ptr<AudioOutput> rain_;
  std::unique_ptr<SignalServer> fudi_, osc_;
  std::unique_ptr<SerialSensor> sensor_;
  std::unique_ptr<VirtualFinger> finger_;
};

}  // namespace

bool livePlaybackAvailable() { return true; }

Result<std::vector<SoundDevice>> listSoundDevices() {
  Result<std::vector<AudioDeviceInfo>> found = listAudioDevices();
  if (!found) return found.failure();
  std::vector<SoundDevice> devices;
  for (const AudioDeviceInfo& d : *found) {
    devices.push_back(
        {d.fullName(), d.inputChannels, d.outputChannels, d.sampleRate_Hz, d.defaultOutput, d.defaultInput});
  }
  return devices;
}

Result<std::unique_ptr<LivePlayer>> LivePlayer::start(const PlayerSettings& settings,
                                                      const LiveProgram& program) {
  Result<double> rate = sampleRateFor(audioSettings(settings));
  if (!rate) return rate.failure();
  if (*rate < HapticEngine::lowestSampleRate_Hz || *rate > HapticEngine::highestSampleRate_Hz) {
    return Failure{FailureCode::wrongUsage, "sample rate", "",
                   Message("the sample rate %1 Hz lies outside 8000 to 192000 Hz", std::lround(*rate)),
                   Message("Choose another rate")};
  }
  auto player = std::make_unique<Player>(*rate, true);
  if (Result<Done> opened = player->open(settings, program, {}); !opened) return opened.failure();
  return std::unique_ptr<LivePlayer>(std::move(player));
}

Result<std::unique_ptr<LivePlayer>> LivePlayer::startSilent(const LiveProgram& program) {
  auto player = std::make_unique<Player>(silentRate_Hz, false);
  player->setProgram(program);
  return std::unique_ptr<LivePlayer>(std::move(player));
}

Result<SoundRecording> playAndRecordSamples(const PlayerSettings& settings, const std::string& inputDevice,
                                            const std::vector<float>& samples,
                                            const std::function<bool()>& cancelled) {
  Result<Recording> recorded = playAndRecord(audioSettings(settings), inputDevice, samples, cancelled);
  if (!recorded) return recorded.failure();
  if (cancelled()) return Failure::cancelled("recording");
  return SoundRecording{std::move(recorded->samples), recorded->dropouts};
}

}  // namespace detent::playback
