// SPDX-License-Identifier: GPL-3.0-or-later
// The live half of the public interface for a library built without devices.

#include "playback/playback.h"

namespace detent::playback {

namespace {
Failure withoutDevices() {
  return {FailureCode::deviceTrouble, "live playback", "",
          Message("this build of Detent has no live playback"),
          Message("Install a build of Detent with live playback, or write the vibration to a sound file (in "
                  "the window: File > Export; on the command line: `detent-play render`)")};
}
}  // namespace

bool livePlaybackAvailable() { return false; }
Result<std::vector<SoundDevice>> listSoundDevices() { return withoutDevices(); }
Result<std::unique_ptr<LivePlayer>> LivePlayer::start(const PlayerSettings&, const LiveProgram&) {
  return withoutDevices();
}
Result<std::unique_ptr<LivePlayer>> LivePlayer::startSilent(const LiveProgram&) { return withoutDevices(); }
Result<SoundRecording> playAndRecordSamples(const PlayerSettings&, const std::string&,
                                            const std::vector<float>&, const std::function<bool()>&) {
  return withoutDevices();
}
Result<RawReading> readRawSensor(const std::string&, unsigned, double, const std::function<bool()>&) {
  return withoutDevices();
}
Result<LatencyResult> measureLatency(const LatencySettings&,
                                     const std::function<void(std::size_t, std::size_t)>&,
                                     const std::function<bool()>&) {
  return withoutDevices();
}
Result<DeviceMeasurement> measureForceDevice(const DeviceMeasurementSettings&,
                                             const std::function<bool(double)>&) {
  return withoutDevices();
}
Result<std::unique_ptr<ForcePlayer>> ForcePlayer::start(const Button&, const ForcePlayerSettings&) {
  return withoutDevices();
}

}  // namespace detent::playback
