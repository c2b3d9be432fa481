// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pressed button as force on a force device, without widgets: the running loop, what it does to the
// finger, and whether the device can render the button at all. docs/guide/force-feedback.md.

#include <memory>
#include <optional>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <thread>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/feel/feel_devices.h"
#include "editor/feel/feel_settings.h"

namespace detent::editor {

enum class ForceState : std::uint8_t {
  off,
  starting,  ///< the device is being opened
  on,
  lost,   ///< the device disappeared, so there is no force; it is opened again when it is back
  failed  ///< the device could not be opened; trouble() says why and what to do
};

/// Energy that finger and button exchange.
struct ForceEnergy {
  double held_mJ = 0;       ///< in the button now, counted from its rest
  double most_mJ = 0;       ///< largest value in this press, or in the last one
  double givenBack_mJ = 0;  ///< share of `most_mJ` that came back to the finger, in mJ
  /// lowest balance since the start; below 0: the button gave more energy than it had stored
  double lowestBalance_mJ = 0;
};

/// Runs the pressed button on a force device. Never starts without the user's request, so that
/// no device moves by itself. GUI thread; devices are opened and closed on a separate thread.
class ForceSession : public QObject {
  Q_OBJECT

 public:
  explicit ForceSession(QObject* parent = nullptr, FeelDevices devices = {});
  ~ForceSession() override;  ///< removes the force; waits for a device that is being opened

  /// Says whether the panel is visible. There is no margin and no force while it is hidden, because the
  /// switch must be visible.
  void setWatched(bool watched);
  /// Sets the pressed button, even under a finger. May be null.
  void setDocument(ButtonDocument* document);
  /// Sets the device and its options. A newly chosen device does not start by itself, even while one runs.
  void setChoices(const ForceChoices& choices);
  const ForceChoices& choices() const { return choices_; }
  ButtonDocument* document() const { return document_; }
  /// The chosen device; empty if none is chosen or its name is unknown.
  const std::optional<playback::ForceDeviceChoice>& device() const { return device_; }
  bool simulated() const { return device_ && device_->kind == playback::ForceDeviceKind::simulated; }

  void start();
  void stop();
  ForceState state() const { return state_; }
  bool running() const { return state_ == ForceState::on || state_ == ForceState::lost; }
  /// The reason why there is no force, and the remedy; empty if there is no trouble.
  const QString& trouble() const { return trouble_; }
  /// The running loop, for a reader of its position on another thread; null if none runs.
  std::shared_ptr<const playback::ForcePlayer> player() const { return player_; }

  const playback::ForceStatus& status() const { return status_; }
  const ForceEnergy& energy() const { return energy_; }
  /// Properties of the button that the device cannot render; empty until it runs.
  const std::vector<playback::ForceRemark>& remarks() const { return remarks_; }

  /// Slopes that the chosen device can render along the button's travel; null without a device or a button.
  /// Shared and never changed.
  const std::shared_ptr<const playback::StabilityMargin>& margin() const { return margin_; }
  /// Replaces the button, in one undoable step, by the nearest one that the device can render.
  void makeStable();
  /// Changes that makeStable made to the present button; empty if the button is another one.
  const std::vector<playback::StabilityChange>& changes() const { return changes_; }

 signals:
  void stateChanged();
  /// About 100 times a second while it runs.
  void moved();
  /// The margin, the device or the changes by makeStable changed.
  void marginChanged();
  void said(const QString& message);

 private:
  using Player = std::shared_ptr<playback::ForcePlayer>;

  QString takeDevice();
  void buttonChanged();
  void follow();
  void computeMargin();
  void exchange();
  void exchanged(Result<std::unique_ptr<playback::ForcePlayer>>* result);
  void setState(ForceState state, const QString& trouble = {});
  void tick();
  void count(const playback::ForceStep& step);
  double rate_Hz() const;

  FeelDevices devices_;
  QPointer<ButtonDocument> document_;
  ForceChoices choices_;
  std::optional<playback::ForceDeviceChoice> device_;
  Player player_;
  std::thread worker_;
  bool watched_ = false, wanted_ = false, busy_ = false, exchangeAgain_ = false;
  ForceState state_ = ForceState::off;
  QString trouble_;
  double travel_mm_ = 0, rest_mm_ = 0;  ///< of the button for which the running device was prepared
  playback::ForceStatus status_;
  std::vector<playback::ForceStep> steps_;
  std::vector<playback::ForceRemark> remarks_;
  ForceEnergy energy_;
  double energyAtRest_mJ_ = 0;
  std::shared_ptr<const playback::StabilityMargin> margin_;
  std::optional<Button> stable_;  ///< result of the last makeStable
  std::vector<playback::StabilityChange> changes_;
  QTimer timer_, soon_;
};

}  // namespace detent::editor
