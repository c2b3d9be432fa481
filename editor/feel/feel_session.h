// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Two buttons and one finger, without widgets: the pressed button, its signals and the finger's position.
// The window owns it; the feel panel shows it.

#include <array>
#include <memory>
#include <optional>
#include <QObject>
#include <QPointer>
#include <QVariantMap>
#include <string>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/finger_position.h"
#include "editor/document/latest_request.h"
#include "editor/feel/feel_devices.h"
#include "editor/feel/feel_player.h"
#include "editor/feel/feel_settings.h"
#include "editor/feel/force_session.h"
#include "editor/feel/press_signal_source.h"
#include "editor/feel/reference_drawing.h"
#include "editor/feel/sound_device_list.h"

namespace detent::editor {

/// A: the button being edited; B: the one it is exchanged with.
enum class FeelSide : std::uint8_t { a, b };

/// Position of the felt button. Plain value.
struct FeelMotion {
  double displacement_mm = 0, force_N = 0;
  bool pressed = false, releasing = false, contact = false;
};

/// Lets one finger press one of two buttons. Opens no device before the first press; without a device,
/// everything else works. GUI thread.
class FeelSession : public QObject {
  Q_OBJECT

 public:
  explicit FeelSession(QObject* parent = nullptr, const FeelDevices& devices = {});

  /// `document` may be null. The session notices its destruction as a QObject.
  void setDocument(FeelSide side, ButtonDocument* document);
  ButtonDocument* document(FeelSide side) const { return slot(side).document; }
  FeelSide feltSide() const { return felt_; }
  /// The pressed button: A, or B after an exchange.
  ButtonDocument* feltDocument() const { return felt().document; }
  /// Selects the button under the finger; does nothing if this side has none.
  void feel(FeelSide side);
  void exchange() { feel(felt_ == FeelSide::a ? FeelSide::b : FeelSide::a); }
  bool exchangeable() const { return slots_[0].document && slots_[1].document; }

  /// Signals are computed only while they are visible.
  void setWatched(bool watched);
  /// Signals of a press of the felt button; null until they are computed.
  const std::shared_ptr<const PressSignal>& signal() const { return felt().signal; }
  /// The program of the felt button; null if it cannot be pressed.
  std::shared_ptr<const playback::LiveProgram> program() const;
  /// State of the felt button that is pressed.
  std::size_t state() const { return state_; }
  /// The felt button's state under the finger, as it is played; null without a program.
  const playback::StateProgram* pressedState() const;
  /// Force of a full press (N, > 0).
  double full_N() const;
  const FeelMotion& motion() const { return motion_; }

  const FeelSettings& settings() const { return settings_; }
  void setSettings(const FeelSettings& settings);
  /// State as plain text and numbers. Restoring opens no device: sound begins with the next press, and the
  /// sensor's port is only offered.
  QVariantMap saveState() const { return toMap(settings_); }
  void restoreState(const QVariantMap& state);
  const std::optional<playback::DeviceProfile>& profile() const { return profile_; }
  /// The reason why the profile's file could not be read; empty if it could.
  const QString& profileTrouble() const { return profileTrouble_; }

  // The finger of the pad; shares are of a full press and of the travel, 0..1.
  void down() { player_.down(full_N()); }
  void up() { player_.up(); }
  void pushForce(double share) { player_.pushForce(share * full_N()); }
  void pushDepth(double share);
  void lift() { player_.lift(); }

  /// True if a last press by hand exists, which can be drawn and played instead of the standard press.
  bool ownPressKnown() const { return ownPress_ != nullptr; }
  void drawOwnPress(bool own);
  bool playable() const;
  /// Plays the drawn press on the sound device, from the state in which it was drawn.
  void play();

  /// A signal of another program beside the button's; null: none, or it could not be read. No part of any
  /// document.
  const std::shared_ptr<const ReferenceDrawing>& reference() const { return reference_; }
  /// The reason why there is no reference; empty if there is no trouble.
  const QString& referenceTrouble() const { return referenceTrouble_; }
  /// Reads a file as the reference; an empty path removes the reference.
  void setReference(const QString& file);
  /// Plays the reference on the sound device, or ends it.
  void playReference();
  void stopReference() { player_.stopSamples(); }

  FeelPlayer& player() { return player_; }
  /// The felt button on the force device. While the device runs, its finger presses, and vibration follows
  /// it.
  ForceSession& force() { return force_; }
  SoundDeviceList& soundDevices() { return soundDevices_; }

 signals:
  /// The documents or their titles changed.
  void pairChanged();
  void feltDocumentChanged(detent::editor::ButtonDocument* document);
  /// The signal or the program under the finger changed.
  void feltChanged();
  /// Emitted if another state of a self-locking button is pressed.
  void stateChanged();
  void settingsChanged();
  void ownPressChanged();
  void referenceChanged();
  /// Offers a port for connecting by hand: one that was stored, or one that could not be opened.
  void sensorOffered(const QString& port);
  /// motion() has changed; at least 60 times a second while a finger presses.
  void moved();
  void eventsFelt(const std::vector<detent::playback::EngineEvent>& events);
  /// Position of the finger on A's graph; nullopt when it has left, and while B is pressed.
  void fingerMoved(std::optional<detent::editor::FingerPosition> position);
  /// The same for the finger on B's graph.
  void otherFingerMoved(std::optional<detent::editor::FingerPosition> position);
  /// Text for the status bar.
  void said(const QString& message);

 private:
  struct Slot {
    QPointer<ButtonDocument> document;
    PressSignalSource source;
    std::shared_ptr<const PressSignal> signal;
    bool stale = false;  ///< the button changed while the panel was hidden
  };
  Slot& slot(FeelSide side) { return slots_[static_cast<std::size_t>(side)]; }
  const Slot& slot(FeelSide side) const { return slots_[static_cast<std::size_t>(side)]; }
  Slot& felt() { return slot(felt_); }
  const Slot& felt() const { return slot(felt_); }
  void request(Slot& slot);
  void requestAll();
  void takeSignal(FeelSide side, std::shared_ptr<const PressSignal> signal);
  void underFinger();
  void loadProfile();
  void loadReference();
  void takeReference(std::shared_ptr<const ReferenceDrawing> drawing);
  void connectSensor();
  void followSensor();
  void followPlayer();
  void followForce();
  void followForceState();
  void show(const FeelMotion& motion, std::size_t state);
  void followState(std::size_t state, bool pressed);
  std::size_t firstState() const { return felt().signal ? felt().signal->firstState : 0; }
  void tellFinger(const std::optional<FingerPosition>& position);

  FeelSettings settings_;
  std::optional<playback::DeviceProfile> profile_;
  QString profileTrouble_;
  SoundDeviceList soundDevices_;
  FeelPlayer player_;
  ForceSession force_;
  bool forceFollowed_ = false;
  std::array<Slot, 2> slots_;
  FeelSide felt_ = FeelSide::a;
  std::size_t state_ = 0;
  bool watched_ = false;
  std::shared_ptr<const playback::PressTrace> ownPress_;  ///< the last press by hand
  /// state in which the last press by hand began; state in which the running press began
  std::size_t ownState_ = 0, pressBegan_ = 0;
  bool drawsOwn_ = false;
  std::shared_ptr<const ReferenceDrawing> reference_;
  QString referenceTrouble_;
  FeelMotion motion_;
  LatestAnswer<std::string> references_;
};

}  // namespace detent::editor
