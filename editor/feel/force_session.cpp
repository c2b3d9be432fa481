// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/force_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/document/message_words.h"

namespace detent::editor {
namespace {

constexpr int tick_ms = 8;     // 125 Hz wanted, so that a late timer still shows 60
constexpr int settle_ms = 60;  // delay after an edit before margin and device follow it
constexpr double atRest_mm = 0.02;

playback::FingerChoice fingerOf(const ForceChoices& choices) {
  playback::FingerChoice finger;
  if (choices.holds) finger.kind = playback::FingerChoice::Kind::hold;
  return finger;
}

}  // namespace

ForceSession::ForceSession(QObject* parent, FeelDevices devices)
    : QObject(parent), devices_(std::move(devices)) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(tick_ms);
  connect(&timer_, &QTimer::timeout, this, &ForceSession::tick);
  soon_.setSingleShot(true);
  soon_.setInterval(settle_ms);
  connect(&soon_, &QTimer::timeout, this, &ForceSession::follow);
}

ForceSession::~ForceSession() {
  if (worker_.joinable()) worker_.join();
}

void ForceSession::setDocument(ButtonDocument* document) {
  if (document_ == document) return;
  if (document_) document_->disconnect(this);
  document_ = document;
  if (document_) connect(document_, &ButtonDocument::changed, this, &ForceSession::buttonChanged);
  computeMargin();
  if (!document_) return stop();
  // The simulated finger is exchanged, because its travel is that of the button. A real finger stays where
  // it is.
  if (player_ && simulated()) {
    exchange();
  } else {
    follow();
  }
}

void ForceSession::setWatched(bool watched) {
  if (watched == watched_) return;
  watched_ = watched;
  if (!watched) stop();
  computeMargin();
}

// ---- the device

// An exchanged device is stopped: it starts only on request, because nobody may hold it yet.
void ForceSession::setChoices(const ForceChoices& choices) {
  if (choices == choices_) return;
  const bool exchanged = choices.device != choices_.device;
  choices_ = choices;
  if (exchanged) stop();
  const QString trouble = takeDevice();
  computeMargin();
  if (!trouble.isEmpty()) {
    setState(ForceState::failed, trouble);
  } else if (wanted_) {
    exchange();
  } else {
    setState(ForceState::off);
  }
}

QString ForceSession::takeDevice() {
  Result<std::optional<playback::ForceDeviceChoice>> chosen = forceDeviceOf(choices_);
  if (!chosen) {
    device_.reset();
    return sentenceOf(chosen.failure());
  }
  device_ = *std::move(chosen);
  return {};
}

double ForceSession::rate_Hz() const { return device_ ? device_->profile.rate_Hz : 0; }

void ForceSession::start() {
  if (!device_ || !document_) return;
  wanted_ = true;
  exchange();
}

void ForceSession::stop() {
  wanted_ = false;
  if (player_ || busy_) exchange();
  setState(ForceState::off);
}

// Opening and closing may take seconds, and a device can be open only once. So the device in use is closed
// first, on the thread that opens the next one.
void ForceSession::exchange() {
  exchangeAgain_ = busy_;
  timer_.stop();
  if (busy_) return;
  if (worker_.joinable()) worker_.join();
  const bool open = wanted_ && device_ && document_;
  Player old = std::move(player_);
  if (!open && !old) return;
  setState(open ? ForceState::starting : ForceState::off);  // listeners release the old player here
  busy_ = true;
  playback::ForcePlayerSettings settings;
  if (open) {
    settings.device = *device_;
    settings.finger = fingerOf(choices_);
    settings.force.passivityController = choices_.controller;
  }
  const std::optional<Button> button = open ? std::optional(document_->button()) : std::nullopt;
  worker_ = std::thread([this, old = std::move(old), button, settings]() mutable {
    old.reset();
    std::shared_ptr<Result<std::unique_ptr<playback::ForcePlayer>>> result;
    if (button)
      result = std::make_shared<Result<std::unique_ptr<playback::ForcePlayer>>>(
          devices_.openForce(*button, settings));
    QMetaObject::invokeMethod(
        this, [this, result] { exchanged(result.get()); }, Qt::QueuedConnection);
  });
}

void ForceSession::exchanged(Result<std::unique_ptr<playback::ForcePlayer>>* result) {
  busy_ = false;
  if (result != nullptr && *result) player_ = *std::move(*result);
  if (std::exchange(exchangeAgain_, false)) return exchange();
  if (!wanted_ || result == nullptr) return;
  if (!player_) {
    wanted_ = false;
    return setState(ForceState::failed, sentenceOf(result->failure()));
  }
  status_ = {};
  energy_ = {};
  energyAtRest_mJ_ = 0;
  remarks_ = player_->summary().remarks;
  travel_mm_ = player_->summary().travel_mm;
  rest_mm_ = player_->summary().rest_mm;
  timer_.start();
  setState(ForceState::on);
}

void ForceSession::setState(ForceState state, const QString& trouble) {
  if (state == state_ && trouble == trouble_) return;
  state_ = state;
  trouble_ = trouble;
  emit stateChanged();
}

// ---- the button

void ForceSession::buttonChanged() {
  if (!soon_.isActive()) soon_.start();
}

/// Sends edits to the finger.
void ForceSession::follow() {
  computeMargin();
  if (!player_ || !document_) return;
  const Button& button = document_->button();
  const double travel_mm = button.states().front().graph.travel_mm();
  if (simulated() && std::abs(travel_mm - travel_mm_) > atRest_mm) return exchange();
  if (const Result<Done> taken = player_->setButton(button); !taken) {
    emit said(sentenceOf(taken.failure()));
    return;
  }
  remarks_ = player_->summary().remarks;
  rest_mm_ = player_->summary().rest_mm;
  emit marginChanged();
}

void ForceSession::computeMargin() {
  const bool known = document_ && device_ && watched_;
  margin_ = known ? std::make_shared<const playback::StabilityMargin>(
                        playback::stabilityOf(document_->button(), device_->profile, rate_Hz()))
                  : nullptr;
  if (!stable_ || !document_ || !(document_->button() == *stable_)) {
    stable_.reset();
    changes_.clear();
  }
  emit marginChanged();
}

void ForceSession::makeStable() {
  if (!document_ || !device_ || document_->history().dragging()) return;
  const Result<playback::StableButton> stable =
      playback::nearestStable(document_->button(), device_->profile, rate_Hz());
  if (!stable) {
    emit said(sentenceOf(stable.failure()));
    return;
  }
  if (stable->changes.empty()) {
    emit said(tr("No change is needed: the device can reproduce every slope of this button."));
    return;
  }
  document_->history().apply(stable->button, tr("Make button stable"));
  stable_ = stable->button;
  changes_ = stable->changes;
  computeMargin();
  emit said(tr("Changed to the nearest stable button. Use Undo to go back."));
}

// ---- the run

void ForceSession::tick() {
  if (!player_) return timer_.stop();
  status_ = player_->status();
  steps_.clear();
  player_->takeSteps(steps_);
  for (const playback::ForceStep& step : steps_) count(step);
  energy_.lowestBalance_mJ = status_.lowestBalance_mJ;
  setState(status_.connected ? ForceState::on : ForceState::lost);
  emit moved();
}

void ForceSession::count(const playback::ForceStep& step) {
  if (step.position_mm <= rest_mm_ + atRest_mm) {
    if (energy_.held_mJ != 0) energy_.givenBack_mJ = energy_.most_mJ - energy_.held_mJ;
    energyAtRest_mJ_ = step.energy_mJ;
    energy_.held_mJ = 0;
    return;
  }
  const bool begins = energy_.held_mJ == 0;
  energy_.held_mJ = step.energy_mJ - energyAtRest_mJ_;
  if (begins || energy_.held_mJ > energy_.most_mJ) energy_.most_mJ = energy_.held_mJ;
  energy_.givenBack_mJ = energy_.most_mJ - energy_.held_mJ;
}

}  // namespace detent::editor
