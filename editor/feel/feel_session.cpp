// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/feel_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/document/message_words.h"

namespace detent::editor {
namespace {

constexpr double overPress = 1.25;                          // same as playback's standard press
constexpr double stillBelow_mm_per_s = 3, touch_mm = 0.05;  // limits for the finger of a force device

double fullForceOf(const playback::HapticProgram& program) {
  return std::max(overPress * playback::strongestForce_N(program), 4 * program.hysteresis_N);
}

}  // namespace

FeelSession::FeelSession(QObject* parent, const FeelDevices& devices)
    : QObject(parent),
      soundDevices_(nullptr, devices),
      player_(nullptr, devices),
      force_(nullptr, devices),
      references_(this, [this](const auto& query) {
        const auto drawing = std::make_shared<const ReferenceDrawing>(referenceDrawingOf(query.request));
        query.tell([this, drawing] { takeReference(drawing); });
      }) {
  for (const FeelSide side : {FeelSide::a, FeelSide::b})
    connect(&slot(side).source, &PressSignalSource::ready, this,
            [this, side](const auto& signal) { takeSignal(side, signal); });
  connect(&player_, &FeelPlayer::moved, this, &FeelSession::followPlayer);
  connect(&player_, &FeelPlayer::felt, this, &FeelSession::eventsFelt);
  connect(&player_, &FeelPlayer::recorded, this, [this](const auto& press) {
    ownPress_ = press;
    ownState_ = pressBegan_;
    drawOwnPress(drawsOwn_);
    emit ownPressChanged();
  });
  connect(&player_, &FeelPlayer::sensorChanged, this, &FeelSession::followSensor);
  connect(&force_, &ForceSession::stateChanged, this, &FeelSession::followForceState);
  connect(&force_, &ForceSession::moved, this, &FeelSession::followForce);
  connect(&force_, &ForceSession::said, this, &FeelSession::said);
}

// ---- the pair

void FeelSession::setDocument(FeelSide side, ButtonDocument* document) {
  Slot& changed = slot(side);
  if (document != nullptr && changed.document == document) return;
  if (changed.document) changed.document->disconnect(this);
  changed.document = document;
  changed.signal.reset();
  if (document != nullptr) {
    connect(document, &ButtonDocument::changed, this, [this, side] { request(slot(side)); });
    connect(document, &ButtonDocument::titleChanged, this, &FeelSession::pairChanged);
    connect(document, &QObject::destroyed, this, [this, side] { setDocument(side, nullptr); });
    request(changed);
  }
  emit pairChanged();
  const FeelSide other = felt_ == FeelSide::a ? FeelSide::b : FeelSide::a;
  if (!feltDocument() && slot(other).document) {
    feel(other);
  } else if (side == felt_) {
    underFinger();
    emit feltDocumentChanged(feltDocument());
  }
}

void FeelSession::feel(FeelSide side) {
  if (!slot(side).document || side == felt_) return;
  if (motion_.pressed) tellFinger(std::nullopt);  // the finger leaves the graph of the previous button
  felt_ = side;
  underFinger();
  emit feltDocumentChanged(feltDocument());
  emit said(tr("You are pressing %1 at its true strength").arg(feltDocument()->title()));
}

std::shared_ptr<const playback::LiveProgram> FeelSession::program() const {
  return felt().document && felt().signal ? felt().signal->program : nullptr;
}

double FeelSession::full_N() const {
  if (settings_.full_N > 0) return settings_.full_N;
  const auto pressed = program();
  return pressed ? fullForceOf(pressed->program) : 1;
}

void FeelSession::underFinger() {
  force_.setDocument(feltDocument());
  player_.setProgram(program());
  if (!force_.running()) state_ = firstState();
  emit feltChanged();
}

// ---- signals of a press

void FeelSession::takeSignal(FeelSide side, std::shared_ptr<const PressSignal> signal) {
  if (!slot(side).document) return;
  slot(side).signal = std::move(signal);
  if (side == felt_) underFinger();
}

void FeelSession::setWatched(bool watched) {
  watched_ = watched;
  force_.setWatched(watched);
  for (Slot& each : slots_)
    if (watched && each.stale) request(each);
}

void FeelSession::request(Slot& slot) {
  slot.stale = !watched_;
  if (slot.stale || !slot.document) return;
  playback::PlaybackSettings settings = playback::usualSettings();
  settings.mode = settings_.mode;
  settings.placement = settings_.placement;
  slot.source.request({slot.document->button(), profile_.value_or(playback::DeviceProfile{}), settings,
                       drawsOwn_ ? ownPress_ : nullptr, drawsOwn_ ? ownState_ : 0});
}

void FeelSession::requestAll() {
  for (Slot& each : slots_) request(each);
}

void FeelSession::drawOwnPress(bool own) {
  const bool changes = own || own != drawsOwn_;
  drawsOwn_ = own;
  if (changes) requestAll();
}

bool FeelSession::playable() const { return program() && settings_.sound && !player_.playing(); }

void FeelSession::play() {
  if (!program()) return;
  // the last press left the button in its other state
  if (!player_.pressed() && state_ != firstState()) underFinger();
  if (!player_.play(std::make_shared<const playback::PressTrace>(signal()->press)))
    emit said(settings_.sound ? tr("Only one press can be played at a time")
                              : tr("Switch the sound on to play a press"));
}

// ---- a signal of another program

void FeelSession::setReference(const QString& file) {
  FeelSettings next = settings_;
  next.referenceFile = file;
  if (next.referenceFile == settings_.referenceFile) {
    loadReference();  // reloaded, because the file may have changed
  } else {
    setSettings(next);
  }
}

void FeelSession::loadReference() {
  references_.cancel();
  player_.stopSamples();
  reference_.reset();
  referenceTrouble_.clear();
  if (!settings_.referenceFile.isEmpty()) references_.ask(settings_.referenceFile.toStdString());
  emit referenceChanged();
}

void FeelSession::takeReference(std::shared_ptr<const ReferenceDrawing> drawing) {
  if (drawing->failure) {
    referenceTrouble_ = sentenceOf(*drawing->failure);
    settings_.referenceFile.clear();
    emit said(referenceTrouble_);
    emit settingsChanged();
  } else {
    reference_ = std::move(drawing);
  }
  emit referenceChanged();
}

void FeelSession::playReference() {
  if (!reference_) return;
  if (!player_.playSamples({reference_, &reference_->samples}))
    emit said(settings_.sound ? tr("Only one press can be played at a time")
                              : tr("Switch the sound on to play the reference"));
}

// ---- settings

void FeelSession::setSettings(const FeelSettings& settings) {
  const FeelSettings before = std::exchange(settings_, settings);
  force_.setChoices(settings.force);
  player_.setGain(gainOf(settings.gain_dB));
  player_.setSoundWanted(settings.sound);
  if (settings.device != before.device || settings.rate_Hz != before.rate_Hz ||
      settings.buffer != before.buffer)
    player_.setOutput(outputOf(settings));
  const bool profileChanged = settings.profileFile != before.profileFile;
  if (profileChanged) loadProfile();
  if (settings.referenceFile != before.referenceFile) loadReference();
  if (settings_.sensorPort != before.sensorPort || settings_.sensorBaud != before.sensorBaud ||
      (profileChanged && !settings_.sensorPort.isEmpty()))
    connectSensor();
  if (profileChanged || settings.mode != before.mode || settings.placement != before.placement) requestAll();
  emit settingsChanged();
}

void FeelSession::restoreState(const QVariantMap& state) {
  FeelSettings settings = feelSettingsFrom(state);
  const QString port = std::exchange(settings.sensorPort, QString());
  setSettings(settings);
  if (!port.isEmpty()) emit sensorOffered(port);
}

void FeelSession::loadProfile() {
  profile_.reset();
  profileTrouble_.clear();
  if (settings_.profileFile.isEmpty()) return;
  Result<playback::DeviceProfile> loaded = playback::loadDeviceProfile(settings_.profileFile.toStdString());
  if (loaded) {
    profile_ = *std::move(loaded);
    return;
  }
  profileTrouble_ = sentenceOf(loaded.failure());
  settings_.profileFile.clear();
  emit said(profileTrouble_);
}

void FeelSession::connectSensor() {
  SensorPort sensor;
  sensor.port = settings_.sensorPort.toStdString();
  sensor.baud = settings_.sensorBaud;
  if (profile_) sensor.calibration = profile_->sensor;
  player_.setSensor(sensor);
}

void FeelSession::followSensor() {
  if (player_.sensorTrouble().isEmpty() || settings_.sensorPort.isEmpty()) return;
  const QString port = std::exchange(settings_.sensorPort, QString());
  emit settingsChanged();
  emit sensorOffered(port);
}

// ---- the finger

void FeelSession::pushDepth(double share) {
  const playback::StateProgram* pressed = pressedState();
  if (pressed != nullptr)
    player_.pushDepth(pressed->start_mm + share * (pressed->end_mm - pressed->start_mm));
}

const playback::StateProgram* FeelSession::pressedState() const {
  const auto played = program();  // the felt slot owns the program too, so the returned pointer stays valid
  if (!played) return nullptr;
  const playback::HapticProgram& front = played->program;
  return &front.states[(state_ + front.stateCount - firstState()) % front.stateCount];
}

void FeelSession::followPlayer() {
  if (force_.running()) {
    emit moved();
    return;
  }
  const playback::PlayerStatus& s = player_.status();
  const bool pressed = player_.pressed();
  const std::size_t states = program() ? program()->program.stateCount : 1;
  // A finger that trembles at one place makes the engine change its stroke often. The display changes it only
  // when the finger moves.
  const bool rests = pressed && s.displacement_mm == motion_.displacement_mm;
  show({s.displacement_mm, s.force_N, pressed, rests ? motion_.releasing : s.releasing, s.contact},
       (static_cast<std::size_t>(s.state) + firstState()) % states);
}

void FeelSession::followForce() {
  const playback::ForceStep& last = force_.status().last;
  const playback::StateProgram* felt = pressedState();
  const double start_mm = felt != nullptr ? felt->start_mm : 0;
  const bool rests = std::abs(last.velocity_mm_per_s) < stillBelow_mm_per_s;
  const bool releasing = rests ? motion_.releasing : last.velocity_mm_per_s < 0;
  show({last.position_mm, last.force_N, last.position_mm > start_mm + touch_mm, releasing,
        player_.status().contact},
       last.state);
}

// Force and vibration belong to one press, so the vibration follows the device's position.
void FeelSession::followForceState() {
  const bool runs = force_.running();
  if (runs == forceFollowed_) return;
  forceFollowed_ = runs;
  if (!runs) {
    player_.followDevice({});
    return;
  }
  player_.followDevice([running = force_.player()] { return running->status().last.position_mm; });
}

void FeelSession::show(const FeelMotion& motion, std::size_t state) {
  const bool wasPressed = motion_.pressed;
  if (motion.pressed && !wasPressed) pressBegan_ = state_;
  followState(state, motion.pressed);
  motion_ = motion;
  if (motion.pressed || wasPressed) {
    std::optional<FingerPosition> finger;
    const ButtonDocument* document = feltDocument();
    // The position in one state has no meaning on the graph of the other state.
    if (motion.pressed && document != nullptr && document->activeState() == state_)
      finger = FingerPosition{motion.displacement_mm, motion.force_N,
                              motion.releasing ? Stroke::release : Stroke::press};
    tellFinger(finger);
  }
  emit moved();
}

void FeelSession::tellFinger(const std::optional<FingerPosition>& position) {
  emit(felt_ == FeelSide::a ? fingerMoved(position) : otherFingerMoved(position));
}

void FeelSession::followState(std::size_t state, bool pressed) {
  ButtonDocument* document = feltDocument();
  if (document == nullptr || state >= document->button().states().size()) return;
  const bool turned = state != state_;
  if (turned) {
    state_ = state;
    emit stateChanged();
  }
  if (!settings_.followState || document->history().dragging() || document->activeState() == state) return;
  if (turned || pressed) document->setActiveState(state);
}

}  // namespace detent::editor
