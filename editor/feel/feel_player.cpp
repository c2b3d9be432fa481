// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/feel_player.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "editor/document/message_words.h"
#include "editor/feel/drawn_signal.h"

namespace detent::editor {
namespace {

constexpr int movingTick_ms = 8;    // 125 Hz wanted, so that a late timer still shows 60
constexpr int restingTick_ms = 40;  // interval for meters and for a sensor that may begin to press
constexpr double lift_s = 0.06;     // same as the lift time of playback's own finger
constexpr double longestRecord_s = 20, recordStep_s = 1e-3;
constexpr double playLead_s = 0.1;  // delay until a recorded press begins
constexpr double goesOn_s = 1;      // duration after the last movement for which meters are updated quickly

}  // namespace

/// Passes a position to the player 1000 times a second during its lifetime.
class FeelPlayer::DepthFeed {
 public:
  DepthFeed(playback::LivePlayer& player, std::function<double()> position_mm)
      : thread_([this, &player, position_mm = std::move(position_mm)] {
          for (; !ending_; std::this_thread::sleep_for(feedStep)) player.pushDisplacement(position_mm());
        }) {}
  ~DepthFeed() {
    ending_ = true;
    thread_.join();
  }

 private:
  static constexpr std::chrono::milliseconds feedStep{1};
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

FeelPlayer::FeelPlayer(QObject* parent, FeelDevices devices) : QObject(parent), devices_(std::move(devices)) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &FeelPlayer::tick);
  status_.sounding = false;
}

FeelPlayer::~FeelPlayer() {
  if (worker_.joinable()) worker_.join();
}

void FeelPlayer::setProgram(std::shared_ptr<const playback::LiveProgram> program) {
  program_ = std::move(program);
  if (!program_) {
    letGo();
    forgetPress();
    return;
  }
  if (waiting_) waiting_->setProgram(*program_);
  if (player_) {
    player_->setProgram(*program_);
  } else {
    startSilent();
  }
}

// Ends a press at once, so that the next button does not start pressed.
void FeelPlayer::letGo() {
  const Finger held = std::exchange(finger_, Finger::none);
  if (!player_) return;
  if (held == Finger::timed) player_->fingerUp();
  if (held == Finger::force || (held == Finger::lifting && liftsForce_)) player_->pushForce(0);
  if (held == Finger::depth || (held == Finger::lifting && !liftsForce_)) player_->pushDisplacement(0);
}

// Replaces a silent player by a new one. A released force decreases slowly, and the next button must not
// start with the rest of it. A player with a device or a sensor is kept.
void FeelPlayer::forgetPress() {
  if (!player_ || status_.sounding || devicePosition_mm_ || !sensor_.port.empty()) return;
  player_.reset();
  status_ = {};
  status_.sounding = false;
  pressed_ = false;
  record();
  emit moved();
}

void FeelPlayer::startSilent() {
  deviceFeed_.reset();
  player_.reset();
  if (!program_) return;
  Result<Player> silent = playback::LivePlayer::startSilent(*program_);
  if (!silent) {
    setSound(SoundState::failed, sentenceOf(silent.failure()));
    return;
  }
  player_ = *std::move(silent);
  attachSensor();
  attachDevice();
  pace();
}

// ---- sound

void FeelPlayer::setSoundWanted(bool wanted) {
  if (wanted == soundWanted_) return;
  soundWanted_ = wanted;
  const bool open = sound_ != SoundState::off && sound_ != SoundState::failed;
  if (!wanted && open) exchangeDevice();
  setSound(SoundState::off);
}

void FeelPlayer::setOutput(const playback::PlayerSettings& settings) {
  output_ = settings;
  if (sound_ != SoundState::off) exchangeDevice();
}

void FeelPlayer::startSound() {
  if (!program_ || !soundWanted_ || !playback::livePlaybackAvailable()) return;
  if (sound_ == SoundState::off || sound_ == SoundState::failed) exchangeDevice();
}

// Opening and closing may take seconds, and a device can be open only once. So the device in use is closed
// first, on the thread that opens the next one.
void FeelPlayer::exchangeDevice() {
  exchangeAgain_ = busy_;
  if (busy_) return;
  if (worker_.joinable()) worker_.join();
  std::shared_ptr<playback::LivePlayer> old = std::move(waiting_);
  if (player_ && status_.sounding) {
    player_->detachSensor();
    deviceFeed_.reset();
    old = std::move(player_);
    startSilent();
  }
  const bool open = soundWanted_ && program_;
  if (!open && !old) return;
  busy_ = true;
  if (open) setSound(SoundState::starting);
  worker_ = std::thread([this, old = std::move(old), open, settings = output_, program = program_]() mutable {
    old.reset();
    std::shared_ptr<Result<Player>> result;
    if (open) result = std::make_shared<Result<Player>>(devices_.open(settings, *program));
    QMetaObject::invokeMethod(
        this, [this, result] { exchanged(result.get()); }, Qt::QueuedConnection);
  });
}

void FeelPlayer::exchanged(Result<Player>* result) {
  busy_ = false;
  if (result != nullptr && *result) waiting_ = *std::move(*result);
  if (std::exchange(exchangeAgain_, false)) {
    exchangeDevice();
    return;
  }
  if (!soundWanted_ || result == nullptr) return;
  if (!waiting_) {
    setSound(SoundState::failed, sentenceOf(result->failure()));
    return;
  }
  if (program_) waiting_->setProgram(*program_);
  waiting_->setGain(gain_);
  adopt();
}

// Replaces the player by the waiting one. A running press first ends on the player on which it began. The
// finger of a force device may never rest, so its end is not awaited.
void FeelPlayer::adopt() {
  if (!waiting_ || (!devicePosition_mm_ && (pressed_ || finger_ != Finger::none))) return;
  deviceFeed_.reset();
  player_ = std::move(waiting_);
  attachSensor();
  attachDevice();
  status_ = player_->status();
  setSound(SoundState::on);
  if (toPlay_) play(std::exchange(toPlay_, nullptr));
  if (samplesToPlay_) playSamples(std::exchange(samplesToPlay_, nullptr));
  pace();
}

void FeelPlayer::setGain(double gain) {
  gain_ = gain;
  if (player_) player_->setGain(gain);
  if (waiting_) waiting_->setGain(gain);
}

void FeelPlayer::setSound(SoundState state, const QString& trouble) {
  if (state == SoundState::off || state == SoundState::failed) {
    toPlay_.reset();
    samplesToPlay_.reset();
  }
  if (state == sound_ && trouble == trouble_) return;
  sound_ = state;
  trouble_ = trouble;
  emit soundChanged();
}

void FeelPlayer::followSound() {
  if (!status_.sounding) return;
  setSound(status_.deviceLost ? SoundState::lost : SoundState::on);
}

// ---- sensor

void FeelPlayer::setSensor(const SensorPort& sensor) {
  sensor_ = sensor;
  sensorTrouble_.clear();
  if (player_) player_->detachSensor();
  attachSensor();
  pace();
  emit sensorChanged();
}

void FeelPlayer::attachSensor() {
  if (!player_ || sensor_.port.empty()) return;
  const Result<Done> attached = player_->attachSensor(sensor_.port, sensor_.baud, sensor_.calibration);
  if (attached) return;
  sensorTrouble_ = sentenceOf(attached.failure());
  sensor_ = {};
  emit sensorChanged();
}

// ---- force device

void FeelPlayer::followDevice(std::function<double()> position_mm) {
  const bool lets = devicePosition_mm_ && !position_mm;
  deviceFeed_.reset();
  letGo();
  if (lets && player_) player_->pushDisplacement(0);
  devicePosition_mm_ = std::move(position_mm);
  attachDevice();
  if (devicePosition_mm_ && sound_ == SoundState::off) startSound();
  movedAt_ = Clock::now();
  pace();
}

void FeelPlayer::attachDevice() {
  if (player_ && devicePosition_mm_) deviceFeed_ = std::make_unique<DepthFeed>(*player_, devicePosition_mm_);
}

// ---- finger

bool FeelPlayer::take(Finger finger) {
  if (!player_ || !program_ || playing() || devicePosition_mm_) return false;
  if (finger_ == Finger::lifting) finger_ = Finger::none;
  if (finger_ != Finger::none && finger_ != finger) return false;
  if (finger_ == Finger::none) {
    // not after a failure: opening the device again may take long
    if (sound_ == SoundState::off) startSound();
    finger_ = finger;
    pressed_ = true;
    pace();
  }
  return true;
}

bool FeelPlayer::down(double peak_N) {
  if (!take(Finger::timed)) return false;
  player_->fingerDown(peak_N);
  return true;
}

void FeelPlayer::up() {
  if (finger_ != Finger::timed) return;
  finger_ = Finger::none;
  if (player_) player_->fingerUp();
}

bool FeelPlayer::pushForce(double force_N) {
  const bool begins = finger_ == Finger::none || finger_ == Finger::lifting;
  if (!take(Finger::force)) return false;
  // The engine takes the first reading after a pause for the finger's present position. The finger did not
  // touch the button before, so a force of 0 is sent first.
  if (begins) player_->pushForce(0);
  value_ = force_N;
  pushFinger();
  return true;
}

bool FeelPlayer::pushDepth(double displacement_mm) {
  if (!take(Finger::depth)) return false;
  value_ = displacement_mm;
  pushFinger();
  return true;
}

void FeelPlayer::lift() {
  if (finger_ != Finger::force && finger_ != Finger::depth) return;
  liftsForce_ = finger_ == Finger::force;
  finger_ = Finger::lifting;
  liftedFrom_ = value_;
  liftedAt_ = Clock::now();
}

bool FeelPlayer::mayPlay() const {
  return player_ && program_ && soundWanted_ && !pressed_ && !playing() && !devicePosition_mm_;
}

bool FeelPlayer::play(std::shared_ptr<const playback::PressTrace> press) {
  if (!mayPlay() || !press) return false;
  if (!status_.sounding) {
    startSound();
    toPlay_ = std::move(press);
    return true;
  }
  const bool plays = static_cast<bool>(player_->playTrace(*press, playLead_s));
  movedAt_ = Clock::now();
  pace();
  return plays;
}

bool FeelPlayer::playSamples(std::shared_ptr<const std::vector<float>> samples) {
  if (!mayPlay() || !samples) return false;
  if (!status_.sounding) {
    startSound();
    samplesToPlay_ = std::move(samples);
    return true;
  }
  const bool plays = static_cast<bool>(player_->playSamples(*samples, drawnRate_Hz));
  movedAt_ = Clock::now();
  pace();
  return plays;
}

void FeelPlayer::stopSamples() {
  samplesToPlay_.reset();
  if (player_) player_->stopSamples();
}

// Records from the first touch to rest, with zero at both ends, so that the record can be played again.
void FeelPlayer::record() {
  if (playing() || !pressed_) {
    const auto ended = std::exchange(recording_, nullptr);
    if (!ended || playing() || ended->readings.empty()) return;
    const double end_s = std::chrono::duration<double>(Clock::now() - recordedFrom_).count();
    ended->readings.push_back({std::max(end_s, ended->readings.back().time_s + recordStep_s), 0});
    emit recorded(ended);
    return;
  }
  if (!recording_) {
    recording_ = std::make_shared<playback::PressTrace>();
    recordedFrom_ = Clock::now();
    const bool depth =
        devicePosition_mm_ || finger_ == Finger::depth || (finger_ == Finger::lifting && !liftsForce_);
    using Quantity = playback::PressTrace::Quantity;
    recording_->quantity = depth ? Quantity::displacement_mm : Quantity::force_N;
    recording_->readings.push_back({0, 0});
  }
  const double time_s = std::chrono::duration<double>(Clock::now() - recordedFrom_).count();
  if (time_s > longestRecord_s || time_s <= recording_->readings.back().time_s) return;
  const bool force = recording_->quantity == playback::PressTrace::Quantity::force_N;
  recording_->readings.push_back({time_s, force ? status_.force_N : status_.displacement_mm});
}

// Readings must continue while a finger rests. Otherwise the engine takes the next reading for that of a
// reconnected sensor.
void FeelPlayer::pushFinger() {
  switch (finger_) {
    case Finger::force:
      player_->pushForce(value_);
      break;
    case Finger::depth:
      player_->pushDisplacement(value_);
      break;
    case Finger::lifting: {
      const double share = std::chrono::duration<double>(Clock::now() - liftedAt_).count() / lift_s;
      const double value = liftedFrom_ * (1 - playback::minimumJerk(share));
      liftsForce_ ? player_->pushForce(value) : player_->pushDisplacement(value);
      if (share >= 1) finger_ = Finger::none;
      break;
    }
    case Finger::none:
    case Finger::timed:
      break;
  }
}

// ---- time

bool FeelPlayer::atRest() const {
  if (finger_ != Finger::none) return false;
  if (!program_) return true;
  const std::size_t state = std::min<std::size_t>(static_cast<std::size_t>(status_.state), 1);
  const playback::HapticProgram& front = program_->program;
  return status_.force_N <= front.hysteresis_N || status_.displacement_mm <= front.states[state].start_mm;
}

void FeelPlayer::tick() {
  if (!player_) {
    timer_.stop();
    return;
  }
  pushFinger();
  status_ = player_->status();
  followSound();
  pressed_ = !atRest();
  if (pressed_) movedAt_ = Clock::now();
  record();
  if (!pressed_ || devicePosition_mm_) adopt();
  const std::vector<playback::EngineEvent> events = player_->takeEvents();
  if (!events.empty()) emit felt(events);
  emit moved();
  pace();
}

void FeelPlayer::pace() {
  if (!player_) return;
  const bool idle = !pressed_ && std::chrono::duration<double>(Clock::now() - movedAt_).count() > goesOn_s;
  if (idle && !status_.sounding && sensor_.port.empty() && !waiting_ && finger_ == Finger::none &&
      !devicePosition_mm_) {
    timer_.stop();  // nothing can move without input
    return;
  }
  const int interval = idle ? restingTick_ms : movingTick_ms;
  if (!timer_.isActive() || timer_.interval() != interval) timer_.start(interval);
}

}  // namespace detent::editor
