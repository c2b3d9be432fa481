// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/study_player.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>
#include <utility>

#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

constexpr double tapHold_s = 0.15;
constexpr double firstReading_s = 3, poll_s = 0.02;
// audible, but above the frequencies that a fingertip feels
constexpr double tone_Hz = 2000, tone_s = 0.015, toneLevel = 0.25;
constexpr double twoPi = 2 * std::numbers::pi;
constexpr double overPress = 1.25;  // a quarter more than the bottom-out needs, as in standardPress

struct PreparedStimulus {
  std::size_t button = 0;
  FeedbackMode mode = FeedbackMode::full;
  HapticProgram program;
};

/// One stimulus of the trial.
struct Slot {
  bool locked = false;  ///< of a self-locking button: its state after the last actuation
};

/// The same button, starting in its other state: it alternates at each actuation, even if others were pressed
/// in between (K&L, Table 3: EF).
HapticProgram beginningLocked(HapticProgram program) {
  if (program.stateCount > 1) std::swap(program.states[0], program.states[1]);
  return program;
}

/// Adds a contact at half the travel to a button without one, because a press needs a time. Nothing that is
/// felt changes.
void giveContact(HapticProgram& program) {
  for (std::size_t i = 0; i < program.stateCount; ++i) {
    StateProgram& state = program.states[i];
    if (state.hasOperatingPoint) continue;
    state.hasOperatingPoint = true;
    state.operating_mm = (state.start_mm + state.end_mm) / 2;
    state.hasResetPoint = true;
    state.reset_mm = state.operating_mm;
  }
}

/// Prepares every stimulus of the study before the first trial.
Result<std::vector<PreparedStimulus>> prepareAll(const Study& study) {
  std::vector<PreparedStimulus> prepared;
  for (const StudyStimulus& stimulus : study.stimuli) {
    Result<PreparedProgram> program = programFor(study, stimulus.button, stimulus.mode);
    if (!program) return program.failure();
    prepared.push_back({stimulus.button, stimulus.mode, program->program});
    if (study.design.kind == StudyKind::timing) giveContact(prepared.back().program);
  }
  return prepared;
}

StudyTrouble troubleOf(SensorCondition condition) {
  switch (condition) {
    case SensorCondition::none:
    case SensorCondition::running:
      return StudyTrouble::none;
    case SensorCondition::stuck:
      return StudyTrouble::sensorStuck;
    case SensorCondition::unplugged:
      return StudyTrouble::sensorUnplugged;
    case SensorCondition::starting:
    case SensorCondition::silent:
      break;
  }
  return StudyTrouble::sensorSilent;
}

/// "c0 + c1 u ... N, residual 0.02 N, 14 weights": the calibration that converted readings to newtons.
std::string calibrationText(const SensorCalibration& c) {
  std::string text = c.circuit == SensorCircuit::newtons  ? "newtons"
                     : c.circuit == SensorCircuit::linear ? "linear"
                                                          : "divider";
  for (std::size_t i = 0; i < c.coefficientCount; ++i) text += " " + exact(c.coefficients[i]);
  return text + "; residual " + exact(c.residual_N) + " N; " + std::to_string(c.weights) + " weights";
}

/// Failure if this study is impossible on a force device, or if a button cannot be rendered.
Result<Done> checkForce(const Study& study, const StudyPlayerSettings& settings) {
  const auto wrong = [](Message problem, const Message& remedy) {
    return Failure{FailureCode::wrongUsage, "force device", "", std::move(problem), remedy};
  };
  if (!settings.sensorPort.empty())
    return wrong(Message("on a force device, the participant presses the device itself, so a force sensor "
                         "cannot be used as well"),
                 Message("Use either the force device or the force sensor"));
  if (settings.force->uploadTable)
    return wrong(
        Message(
            "the device would play only the button that was uploaded, but a study switches between buttons"),
        Message("Switch the upload of the force table off"));
  const bool modes = std::any_of(study.stimuli.begin(), study.stimuli.end(),
                                 [](const StudyStimulus& s) { return s.mode != FeedbackMode::full; });
  const LevelQuantity quantity = study.design.quantity;
  const bool vibration = study.design.kind == StudyKind::threshold &&
                         (quantity == LevelQuantity::eventSize || quantity == LevelQuantity::grainStrength);
  if (modes || vibration)
    return wrong(
        Message(
            "a force device produces forces, but this study compares properties that only a vibration has"),
        Message(
            "Either run this study without the force device, or make a study whose only mode is \"full\""));
  for (const StudyStimulus& stimulus : study.stimuli) {
    const Result<PreparedForce> prepared =
        prepareForce(study.buttons[stimulus.button].button, settings.force->profile);
    if (!prepared) return prepared.failure();
  }
  return Done{};
}

/// The device under the finger, with the first button. It runs in real time, even a simulated one.
Result<std::unique_ptr<ForcePlayer>> forceUnder(const Study& study, const StudyPlayerSettings& settings) {
  if (Result<Done> ok = checkForce(study, settings); !ok) return ok.failure();
  ForcePlayerSettings force;
  force.device = *settings.force;
  force.stopSignals = true;
  Result<std::unique_ptr<ForcePlayer>> started =
      ForcePlayer::start(study.buttons[study.stimuli.front().button].button, force);
  if (!started) return started;
  for (const StudyStimulus& stimulus : study.stimuli) {  // a slow link allows less than the device itself
    Result<Done> ok = (*started)->setButton(study.buttons[stimulus.button].button);
    if (!ok) return ok.failure();
  }
  return started;
}

class Player final : public StudyPlayer {
 public:
  /// `force`: null without a force device. `heard`: the player uses a sound device.
  Player(const Study& study, std::vector<PreparedStimulus> stimuli, std::unique_ptr<LivePlayer> player,
         bool heard, std::unique_ptr<ForcePlayer> force, const StudyPlayerSettings& settings)
      : stimuli_(std::move(stimuli)),
        player_(std::move(player)),
        heard_(heard),
        force_(std::move(force)),
        settings_(settings) {
    if (study.design.kind == StudyKind::timing) timed_ = study.design.task;
    if (force_)
      for (const StudyButton& button : study.buttons) buttons_.push_back(button.button);
  }

  bool sounding() const override {
    return !settings_.rehearse && (!force_ || settings_.force->kind != ForceDeviceKind::simulated);
  }
  std::string device() const override {
    if (!sounding()) return {};
    return force_ ? settings_.force->profile.name : player_->status().device;
  }

  StudyRoute route() const override {
    StudyRoute route{settings_.sensorPort, "", ""};
    if (sensor()) route.sensorCalibration = calibrationText(settings_.calibration);
    if (timed_) route.timing = timing();
    if (force_)
      route.force = force_->device().name +
                    (settings_.force->port.empty() ? "" : " at " + settings_.force->port) + ", " +
                    exact(force_->device().rate_Hz) + " Hz, at most " +
                    exact(force_->device().limits.force_N) + " N";
    if (!heard_) return route;
    const PlayerStatus status = player_->status();
    route.sound = status.device + ", " + exact(status.sampleRate_Hz) + " Hz, " +
                  std::to_string(status.blockFrames) + " frames";
    return route;
  }

  void beginTrial() override {
    slots_.clear();
    underFinger_.reset();
    takeFelt();
  }

  void place(std::size_t slot, std::size_t button, FeedbackMode mode) override {
    if (const PreparedStimulus* stimulus = stimulusOf(button, mode)) bring(slot, *stimulus);
  }

  void press(std::size_t slot, std::size_t button, FeedbackMode mode) override {
    const PreparedStimulus* const stimulus = stimulusOf(button, mode);
    if (stimulus == nullptr) return;
    bring(slot, *stimulus);
    if (!sensed())
      player_->fingerTap(std::max(overPress * strongestForce_N(stimulus->program), 0.1), tapHold_s);
  }

  bool sensed() const override { return sensor() || force_ != nullptr; }
  std::vector<ContactClosing> takeClosings() override {
    follow();
    return player_->takeClosings();
  }
  double clock_s() const override { return player_->clock_s(); }

  void soundBeats(const std::vector<double>& delays_s) override {
    if (!heard_ || delays_s.empty()) return;
    const double rate_Hz = player_->status().sampleRate_Hz;
    std::vector<float> samples(static_cast<std::size_t>((delays_s.back() + tone_s) * rate_Hz) + 1, 0.0F);
    for (const double delay_s : delays_s) {
      const auto first = static_cast<std::size_t>(std::lround(delay_s * rate_Hz));
      for (std::size_t i = 0; i < static_cast<std::size_t>(tone_s * rate_Hz); ++i) {
        const double t_s = static_cast<double>(i) / rate_Hz;
        samples.at(first + i) =
            static_cast<float>(toneLevel * (1 - t_s / tone_s) * std::sin(twoPi * tone_Hz * t_s));
      }
    }
    (void)player_->playSamples(samples, rate_Hz);  // takeTrouble reports a lost device
  }

  Felt takeFelt() override {
    follow();
    const PressCount count = player_->takePresses();
    const std::uint64_t inputs = player_->status().counts.inputs;
    const bool played = inputs > playedInputs_;  // the callback has taken readings, so it is running
    if (count.whole > 0) playedInputs_ = inputs;
    return {static_cast<std::size_t>(count.begun), static_cast<std::size_t>(played ? count.whole : 0),
            count.peak_N, count.travel_mm};
  }

  StudyTrouble takeTrouble() override {
    const PlayerStatus status = player_->status();
    const bool lost = status.deviceLosses > losses_ || status.deviceLost;
    losses_ = status.deviceLosses;
    if (lost) return StudyTrouble::soundLost;
    if (const StudyTrouble trouble = forceTrouble(); trouble != StudyTrouble::none) return trouble;
    const bool reconnected = status.sensorReconnects > reconnects_;
    reconnects_ = status.sensorReconnects;
    const StudyTrouble trouble = sensor() ? troubleOf(status.sensor) : StudyTrouble::none;
    return trouble == StudyTrouble::none && reconnected ? StudyTrouble::sensorUnplugged : trouble;
  }

  void stopForce() override {
    if (force_) force_->emergencyStop();
  }
  void rearm() override {
    if (force_) force_->rearm();
  }

  /// Returns true if readings and blocks arrive as expected; waits for the first of them.
  bool runs() {
    const auto running = [this] {
      const PlayerStatus status = player_->status();
      return (!heard_ || status.blockFrames > 0) && (!sensor() || status.sensor == SensorCondition::running);
    };
    // The delay of a cue is stored in the journal's first line, but some sound systems report it late.
    const bool needsLatency = heard_ && timed_ == TimingTask::cue;
    for (double waited_s = 0; waited_s < firstReading_s; waited_s += poll_s) {
      if (running() && (!needsLatency || waited_s > 1 || player_->status().outputLatency_s > 0)) return true;
      std::this_thread::sleep_for(std::chrono::duration<double>(poll_s));
    }
    return !sensor();  // a sound device that is slow to start is monitored anyway
  }

 private:
  bool sensor() const { return !settings_.sensorPort.empty(); }

  /// Moves the player's finger to the force device's positions, at their times.
  void follow() {
    if (!force_) return;
    steps_.clear();
    force_->takeSteps(steps_);
    for (const ForceStep& step : steps_)
      if (step.good) player_->pushDisplacementAt(step.position_mm, step.time_s);
  }

  StudyTrouble forceTrouble() {
    if (!force_) return StudyTrouble::none;
    const ForceStatus status = force_->status();
    const bool lost = !status.connected || status.finished || status.reconnects > forceReconnects_;
    forceReconnects_ = status.reconnects;
    if (lost) return StudyTrouble::forceLost;
    const bool stopped =
        status.homing || status.halt != ForceHalt::none || !status.fault.empty() || unrendered_;
    return stopped ? StudyTrouble::forceStopped : StudyTrouble::none;
  }

  const PreparedStimulus* stimulusOf(std::size_t button, FeedbackMode mode) const {
    const auto at = std::find_if(stimuli_.begin(), stimuli_.end(), [&](const PreparedStimulus& s) {
      return s.button == button && s.mode == mode;
    });
    return at == stimuli_.end() ? nullptr : &*at;
  }

  void bring(std::size_t slot, const PreparedStimulus& stimulus) {
    if (underFinger_ != slot) exchange(slot, stimulus);
    takeFelt();
    takeClosings();
  }

  TimingRoute timing() const {
    TimingRoute route;
    route.press =
        sensor() ? "sensor: the operating point was passed, between two readings, each at its own stamp or, "
                   "without one, when it arrived"
                 : "key: when this program got it; keyboard, system and screen before it are not known";
    if (force_) route.press = "force device: the operating point was passed, between two steps of its loop";
    route.cue = "picture: when it was drawn; the screen's delay is not known";
    if (!heard_ || *timed_ != TimingTask::cue) return route;
    const PlayerStatus status = player_->status();
    const double block_s = status.blockFrames / status.sampleRate_Hz;
    route.cue += ". Sound: within " + exact(1000 * block_s) + " ms (a buffer), then ";
    if (status.outputLatency_s <= 0) {
      route.cue += "the device's delay, which is not known";
      return route;
    }
    route.cue += exact(1000 * status.outputLatency_s) +
                 " ms, as the sound system says; what the converter and the transducer add is not known";
    route.cueLatency_s = block_s / 2 + status.outputLatency_s;
    return route;
  }

  void exchange(std::size_t slot, const PreparedStimulus& next) {
    if (underFinger_ && player_->status().state == 1)
      slots_[*underFinger_].locked = !slots_[*underFinger_].locked;
    if (slots_.size() <= slot) slots_.resize(slot + 1);
    follow();  // completes the previous stimulus
    // A force device starts every button unlocked.
    player_->setProgram(slots_[slot].locked && !force_ ? beginningLocked(next.program) : next.program);
    if (force_) unrendered_ = !force_->setButton(buttons_[next.button]);
    underFinger_ = slot;
  }

  std::vector<PreparedStimulus> stimuli_;
  std::unique_ptr<LivePlayer> player_;
  bool heard_;
  std::unique_ptr<ForcePlayer> force_;
  std::vector<Button> buttons_;  ///< the study's buttons, for a force device
  std::vector<ForceStep> steps_;
  bool unrendered_ = false;  ///< the link has become too slow for the present button
  StudyPlayerSettings settings_;
  std::optional<TimingTask> timed_;  ///< task of a timing study
  std::vector<Slot> slots_;
  std::optional<std::size_t> underFinger_;
  std::uint64_t losses_ = 0, reconnects_ = 0, playedInputs_ = 0, forceReconnects_ = 0;
};

}  // namespace

Result<std::unique_ptr<StudyPlayer>> StudyPlayer::start(const Study& study,
                                                        const StudyPlayerSettings& settings) {
  const bool unheard = settings.force && settings.player.device.empty() &&
                       settings.player.masking.level == 0 && study.design.sound.source.empty();
  const bool heard = !settings.rehearse && !unheard;
  Result<std::vector<PreparedStimulus>> stimuli = prepareAll(study);
  if (!stimuli) return stimuli.failure();
  std::unique_ptr<ForcePlayer> force;
  if (settings.force) {
    Result<std::unique_ptr<ForcePlayer>> started = forceUnder(study, settings);
    if (!started) return started.failure();
    force = *std::move(started);
  }
  const HapticProgram& first = stimuli->front().program;
  Result<PressSound> sound = pressSoundOf(study);
  if (!sound) return sound.failure();
  PlayerSettings audible = settings.player;
  audible.sound = *std::move(sound);
  Result<std::unique_ptr<LivePlayer>> player =
      heard ? LivePlayer::start(audible, first) : LivePlayer::startSilent(first);
  if (!player) return player.failure();
  if (!settings.sensorPort.empty()) {
    if (Result<Done> ok = (*player)->attachSensor(settings.sensorPort, settings.baud, settings.calibration);
        !ok)
      return ok.failure();
  }
  auto made = std::make_unique<Player>(study, *std::move(stimuli), *std::move(player), heard,
                                       std::move(force), settings);
  if (!made->runs())
    return Failure{FailureCode::deviceTrouble, settings.sensorPort, "",
                   Message("the force sensor sends no readings"),
                   Message("Check the sensor, its cable and the speed of the port")};
  return std::unique_ptr<StudyPlayer>(std::move(made));
}

const char* nameOf(StudyTrouble trouble) {
  switch (trouble) {
    case StudyTrouble::none:
      return "none";
    case StudyTrouble::soundLost:
      return "sound device lost";
    case StudyTrouble::sensorUnplugged:
      return "sensor unplugged";
    case StudyTrouble::sensorSilent:
      return "sensor silent";
    case StudyTrouble::sensorStuck:
      return "sensor stuck";
    case StudyTrouble::forceLost:
      return "force device lost";
    case StudyTrouble::forceStopped:
      break;
  }
  return "force stopped";
}

}  // namespace detent::playback
