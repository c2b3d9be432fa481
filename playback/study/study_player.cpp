// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "playback/study.h"

namespace detent::playback {

namespace {

constexpr double tapHold_s = 0.15;
constexpr double overPress = 1.25;  // a quarter more than the bottom-out needs, as standardPress

struct PreparedStimulus {
  std::size_t button = 0;
  FeedbackMode mode = FeedbackMode::full;
  HapticProgram program;
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

class Player final : public StudyPlayer {
 public:
  Player(std::vector<PreparedStimulus> stimuli, std::unique_ptr<LivePlayer> player, bool sounding,
         bool sensor)
      : stimuli_(std::move(stimuli)), player_(std::move(player)), sounding_(sounding), sensor_(sensor) {}

  bool sounding() const override { return sounding_; }
  std::string device() const override { return sounding_ ? player_->status().device : std::string(); }

  void press(std::size_t button, FeedbackMode mode) override {
    const auto at = std::find_if(stimuli_.begin(), stimuli_.end(), [&](const PreparedStimulus& s) {
      return s.button == button && s.mode == mode;
    });
    if (at == stimuli_.end()) return;
    if (&*at != underFinger_) exchange(*at);
    if (!sensor_) player_->fingerTap(std::max(overPress * strongestForce_N(at->program), 0.1), tapHold_s);
  }

  bool lostSinceAsked() override {
    const PlayerStatus status = player_->status();
    const bool lost = status.deviceLosses > losses_ || status.deviceLost;
    losses_ = status.deviceLosses;
    return lost;
  }

 private:
  void exchange(PreparedStimulus& next) {
    if (underFinger_ != nullptr && player_->status().state == 1) underFinger_->locked = !underFinger_->locked;
    player_->setProgram(next.locked ? beginningLocked(next.program) : next.program);
    underFinger_ = &next;
  }

  std::vector<PreparedStimulus> stimuli_;
  std::unique_ptr<LivePlayer> player_;
  bool sounding_, sensor_;
  PreparedStimulus* underFinger_ = nullptr;
  std::uint64_t losses_ = 0;
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
  return std::unique_ptr<StudyPlayer>(std::make_unique<Player>(
      *std::move(stimuli), *std::move(player), !settings.rehearse, !settings.sensorPort.empty()));
}

}  // namespace detent::playback
