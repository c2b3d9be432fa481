// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "playback/measurement/exact_number.h"
#include "playback/study.h"

namespace detent::playback {

namespace {

constexpr double tapHold_s = 0.15;
constexpr double firstReading_s = 3, look_s = 0.02;
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

/// Every stimulus of the study, ready before the first trial.
Result<std::vector<PreparedStimulus>> prepareAll(const Study& study) {
  std::vector<PreparedStimulus> prepared;
  for (const StudyStimulus& stimulus : study.stimuli) {
    Result<PreparedProgram> program = programFor(study, stimulus.button, stimulus.mode);
    if (!program) return program.failure();
    prepared.push_back({stimulus.button, stimulus.mode, program->program});
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
         const StudyPlayerSettings& settings)
      : stimuli_(std::move(stimuli)), player_(std::move(player)), settings_(settings) {}

  bool sounding() const override { return !settings_.rehearse; }
  std::string device() const override { return sounding() ? player_->status().device : std::string(); }

  StudyRoute route() const override {
    StudyRoute route{settings_.sensorPort, "", ""};
    if (sensor()) route.sensorCalibration = wordsOf(settings_.calibration);
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

  void press(std::size_t slot, std::size_t button, FeedbackMode mode) override {
    const auto at = std::find_if(stimuli_.begin(), stimuli_.end(), [&](const PreparedStimulus& s) {
      return s.button == button && s.mode == mode;
    });
    if (at == stimuli_.end()) return;
    if (underFinger_ != slot) exchange(slot, *at);
    takeFelt();
    if (!sensor()) player_->fingerTap(std::max(overPress * strongestForce_N(at->program), 0.1), tapHold_s);
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
  auto made = std::make_unique<Player>(*std::move(stimuli), *std::move(player), settings);
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
