// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The finger and its sound: a playback::LivePlayer that is silent without an open sound device, so that the
// pad always works.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <QObject>
#include <QString>
#include <QTimer>
#include <thread>
#include <vector>

#include "editor/feel/feel_devices.h"

namespace detent::editor {

enum class SoundState {
  off,       ///< not requested, or requested but not yet started by a first press
  starting,  ///< the device is being opened; the finger is followed silently meanwhile
  on,
  lost,   ///< the device disappeared; it is opened again when it is back
  failed  ///< the device could not be opened; trouble() says why and what to do
};

/// Source of force readings besides the pad.
struct SensorPort {
  std::string port;  ///< "/dev/ttyACM0"; empty: none
  unsigned baud = 230400;
  playback::SensorCalibration calibration;
};

/// One finger on one program at a time. A press is timed (down, up) or follows a force or a depth (then
/// lift). While one finger holds the button, input of others is ignored. GUI thread; devices are opened and
/// closed on a separate thread.
class FeelPlayer : public QObject {
  Q_OBJECT

 public:
  explicit FeelPlayer(QObject* parent = nullptr, FeelDevices devices = {});
  ~FeelPlayer() override;  ///< stops the sound; waits for a device that is being opened

  /// Sets the pressed program, even under a finger. Null: nothing can be pressed.
  void setProgram(std::shared_ptr<const playback::LiveProgram> program);

  /// Allows a press to open the sound device; `false` closes the device.
  void setSoundWanted(bool wanted);
  /// Changes the sound device, rate or buffer; an open device is opened again.
  void setOutput(const playback::PlayerSettings& settings);
  const playback::PlayerSettings& output() const { return output_; }
  /// Opens the device now, or again after a failure. Otherwise the first press opens it.
  void startSound();
  void setGain(double gain);  ///< factor >= 0, before the limiter

  /// Opens a sensor; an empty port closes it. It stays open while the sound device or the button changes.
  void setSensor(const SensorPort& sensor);
  /// The reason why the sensor's port could not be opened, and the remedy; empty if there is no trouble.
  const QString& sensorTrouble() const { return sensorTrouble_; }

  // Begins a press. Returns false if nothing can be pressed, or if another finger holds the button.
  bool down(double peak_N);  ///< a timed press: human-like rise up to peak_N
  void up();
  bool pushForce(double force_N);
  bool pushDepth(double displacement_mm);
  void lift();  ///< ends a followed press: the force falls to zero within 60 ms

  /// Follows a force device's finger: its position (mm) is read 1000 times a second on a separate thread, and
  /// all other input is ignored. May open the sound device, as a press does. Null ends it.
  void followDevice(std::function<double()> position_mm);

  /// Plays a press on the sound device, and opens the device if necessary. Nothing can be pressed meanwhile.
  /// Returns false if sound is off, or if another press is running.
  bool play(std::shared_ptr<const playback::PressTrace> press);
  bool playing() const { return player_ && (player_->tracePlaying() || player_->samplesPlaying()); }
  /// Plays samples (at 48000 a second) that no button made. Returns false under the same conditions as
  /// play().
  bool playSamples(std::shared_ptr<const std::vector<float>> samples);
  void stopSamples();
  bool samplesPlaying() const { return samplesToPlay_ || (player_ && player_->samplesPlaying()); }

  /// True during a press, or while the sensor's force is above its force at rest.
  bool pressed() const { return pressed_; }
  const playback::PlayerStatus& status() const { return status_; }
  SoundState sound() const { return sound_; }
  /// The reason why there is no sound, and the remedy; empty if there is no trouble.
  const QString& trouble() const { return trouble_; }

 signals:
  /// About 100 times a second while something moves, less often at rest.
  void moved();
  /// A press by hand has ended. The trace has its forces over time, or its depths if a depth was pressed.
  void recorded(std::shared_ptr<const detent::playback::PressTrace> press);
  void felt(const std::vector<detent::playback::EngineEvent>& events);
  void soundChanged();
  void sensorChanged();

 private:
  enum class Finger { none, timed, force, depth, lifting };
  class DepthFeed;
  using Player = std::unique_ptr<playback::LivePlayer>;
  using Clock = std::chrono::steady_clock;

  bool take(Finger finger);
  bool mayPlay() const;
  void letGo();
  void forgetPress();
  void startSilent();
  void attachSensor();
  void attachDevice();
  void exchangeDevice();
  void exchanged(Result<Player>* result);
  void adopt();
  void setSound(SoundState state, const QString& trouble = {});
  void tick();
  void pushFinger();
  void followSound();
  void record();
  bool atRest() const;
  void pace();

  FeelDevices devices_;
  std::shared_ptr<const playback::LiveProgram> program_;
  Player player_;   // null without a program, or in a build without devices
  Player waiting_;  // an open player that replaces `player_` when no finger presses
  std::thread worker_;
  bool busy_ = false, exchangeAgain_ = false;  // the worker is opening or closing a device
  playback::PlayerSettings output_;
  double gain_ = 1;
  bool soundWanted_ = true;
  SensorPort sensor_;
  QString sensorTrouble_;
  std::function<double()> devicePosition_mm_;  // null: none
  std::unique_ptr<DepthFeed> deviceFeed_;      // feeds positions to `player_`
  SoundState sound_ = SoundState::off;
  QString trouble_;

  Finger finger_ = Finger::none;
  double value_ = 0, liftedFrom_ = 0;  // N or mm
  bool liftsForce_ = true;
  Clock::time_point liftedAt_, movedAt_;
  bool pressed_ = false;
  // a press to be played when the device is open
  std::shared_ptr<const playback::PressTrace> toPlay_;
  std::shared_ptr<const std::vector<float>> samplesToPlay_;
  std::shared_ptr<playback::PressTrace> recording_;  // the running press
  Clock::time_point recordedFrom_;
  playback::PlayerStatus status_;
  QTimer timer_;
};

}  // namespace detent::editor
