// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>
#include <utility>

#include "playback/measurement/exact_number.h"
#include "playback/study.h"

namespace detent::playback {

namespace {

constexpr double tapHold_s = 0.15;
constexpr double firstReading_s = 3, look_s = 0.02;
constexpr double tone_Hz = 2000, tone_s = 0.015, toneLevel = 0.25;  // heard, but above what a fingertip feels
constexpr double twoPi = 2 * std::numbers::pi;
constexpr double overPress = 1.25;  // a quarter more than the bottom-out needs, as standardPress

struct PreparedStimulus {
  std::size_t button = 0;
  FeedbackMode mode = FeedbackMode::full;
  HapticProgram program;
};

/// One stimulus of the trial.
struct Slot {
  bool locked = false;  ///< of a self-locking button: where the last actuation left it
};

/// The same button found in its other state: it alternates at each actuation, also when others were pressed
/// in between (K&L, Table 3: EF).
HapticProgram beginningLocked(HapticProgram program) {
  if (program.stateCount > 1) std::swap(program.states[0], program.states[1]);
  return program;
}

/// A press has a time: where the button says nothing of a contact, it closes at half the travel. Nothing that is felt changes.
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

/// Every stimulus of the study, ready before the first trial.
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

/// "c0 + c1 u ... N, residual 0.02 N, 14 weights": which calibration turned readings into newtons.
std::string wordsOf(const SensorCalibration& c) {
  std::string text = c.circuit == SensorCircuit::newtons  ? "newtons"
                     : c.circuit == SensorCircuit::linear ? "linear"
                                                          : "divider";
  for (std::size_t i = 0; i < c.coefficientCount; ++i) text += " " + exact(c.coefficients[i]);
  return text + "; residual " + exact(c.residual_N) + " N; " + std::to_string(c.weights) + " weights";
}

class Player final : public StudyPlayer {
 public:
  Player(std::vector<PreparedStimulus> stimuli, std::unique_ptr<LivePlayer> player,
         const StudyPlayerSettings& settings, std::optional<TimingTask> timed)
      : stimuli_(std::move(stimuli)), player_(std::move(player)), settings_(settings), timed_(timed) {}

  bool sounding() const override { return !settings_.rehearse; }
  std::string device() const override { return sounding() ? player_->status().device : std::string(); }

  StudyRoute route() const override {
    StudyRoute route{settings_.sensorPort, "", ""};
    if (sensor()) route.sensorCalibration = wordsOf(settings_.calibration);
    if (timed_) route.timing = timing();
    if (!sounding()) return route;
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
    if (!sensor())
      player_->fingerTap(std::max(overPress * strongestForce_N(stimulus->program), 0.1), tapHold_s);
  }

  bool sensed() const override { return sensor(); }
  std::vector<ContactClosing> takeClosings() override { return player_->takeClosings(); }

  void soundBeats(const std::vector<double>& delays_s) override {
    if (!sounding() || delays_s.empty()) return;
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
    (void)player_->playSamples(samples, rate_Hz);  // a device that is lost is told of by troubleSinceAsked
  }

  Felt takeFelt() override {
    const PressCount count = player_->takePresses();
    const std::uint64_t inputs = player_->status().counts.inputs;
    const bool played = inputs > playedInputs_;  // the callback has taken readings: it runs
    if (count.whole > 0) playedInputs_ = inputs;
    return {static_cast<std::size_t>(count.begun), static_cast<std::size_t>(played ? count.whole : 0),
            count.peak_N, count.travel_mm};
  }

  StudyTrouble troubleSinceAsked() override {
    const PlayerStatus status = player_->status();
    const bool lost = status.deviceLosses > losses_ || status.deviceLost;
    losses_ = status.deviceLosses;
    if (lost) return StudyTrouble::soundLost;
    const bool reconnected = status.sensorReconnects > reconnects_;
    reconnects_ = status.sensorReconnects;
    const StudyTrouble trouble = sensor() ? troubleOf(status.sensor) : StudyTrouble::none;
    return trouble == StudyTrouble::none && reconnected ? StudyTrouble::sensorUnplugged : trouble;
  }

  /// Whether readings come; waits for the first of them.
  bool sensorRuns() {
    for (double waited_s = 0; waited_s < firstReading_s; waited_s += look_s) {
      if (player_->status().sensor == SensorCondition::running) return true;
      std::this_thread::sleep_for(std::chrono::duration<double>(look_s));
    }
    return false;
  }

 private:
  bool sensor() const { return !settings_.sensorPort.empty(); }

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
    route.cue = "picture: when it was drawn; the screen's delay is not known";
    if (!sounding() || *timed_ != TimingTask::cue) return route;
    const PlayerStatus status = player_->status();
    route.cue += ". Sound: within " + exact(1000 * status.blockFrames / status.sampleRate_Hz) +
                 " ms (a buffer), then the device's delay, which is not known";
    return route;
  }

  void exchange(std::size_t slot, const PreparedStimulus& next) {
    if (underFinger_ && player_->status().state == 1)
      slots_[*underFinger_].locked = !slots_[*underFinger_].locked;
    if (slots_.size() <= slot) slots_.resize(slot + 1);
    player_->setProgram(slots_[slot].locked ? beginningLocked(next.program) : next.program);
    underFinger_ = slot;
  }

  std::vector<PreparedStimulus> stimuli_;
  std::unique_ptr<LivePlayer> player_;
  StudyPlayerSettings settings_;
  std::optional<TimingTask> timed_;  ///< of a timing study
  std::vector<Slot> slots_;
  std::optional<std::size_t> underFinger_;
  std::uint64_t losses_ = 0, reconnects_ = 0, playedInputs_ = 0;
};

}  // namespace

Result<std::unique_ptr<StudyPlayer>> StudyPlayer::start(const Study& study,
                                                        const StudyPlayerSettings& settings) {
  Result<std::vector<PreparedStimulus>> stimuli = prepareAll(study);
  if (!stimuli) return stimuli.failure();
  const HapticProgram& first = stimuli->front().program;
  Result<std::unique_ptr<LivePlayer>> player =
      settings.rehearse ? LivePlayer::startSilent(first) : LivePlayer::start(settings.player, first);
  if (!player) return player.failure();
  if (!settings.sensorPort.empty()) {
    if (Result<Done> ok = (*player)->attachSensor(settings.sensorPort, settings.baud, settings.calibration);
        !ok)
      return ok.failure();
  }
  std::optional<TimingTask> timed;
  if (study.design.kind == StudyKind::timing) timed = study.design.task;
  auto made = std::make_unique<Player>(*std::move(stimuli), *std::move(player), settings, timed);
  if (!settings.sensorPort.empty() && !made->sensorRuns())
    return Failure{FailureCode::deviceTrouble, settings.sensorPort, "", "sends no readings",
                   "Check the sensor, its cable and the port's speed"};
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
      break;
  }
  return "sensor stuck";
}

}  // namespace detent::playback
