// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/feel_settings.h"

#include <cmath>

#include "model/named_values.h"

namespace detent::editor {
namespace {

/// Enumerations are kept as words, so that a new value in the middle changes nothing.
constexpr auto drives =
    named<Drive>({{"time", Drive::time}, {"depth", Drive::depth}, {"force", Drive::force}});

template <class Value, std::size_t n>
void read(const QVariantMap& map, const QString& key, const NamedValues<Value, n>& words, Value& value) {
  value = words.value(map.value(key).toString().toStdString()).value_or(value);
}

void read(const QVariantMap& map, const QString& key, double low, double high, double& value) {
  bool isNumber = false;
  const double read = map.value(key).toDouble(&isNumber);
  if (isNumber && read >= low && read <= high) value = read;
}

void read(const QVariantMap& map, const QString& key, unsigned low, unsigned high, unsigned& value) {
  double number = value;
  read(map, key, low, high, number);
  value = static_cast<unsigned>(std::lround(number));
}

void read(const QVariantMap& map, const QString& key, bool& value) {
  if (map.contains(key)) value = map.value(key).toBool();
}

}  // namespace

double gainOf(double dB) { return std::pow(10, dB / 20); }

playback::PlayerSettings outputOf(const FeelSettings& settings) {
  playback::PlayerSettings output;
  output.device = settings.device.toStdString();
  output.sampleRate_Hz = settings.rate_Hz;
  output.bufferFrames = settings.buffer;
  return output;
}

Result<std::optional<playback::ForceDeviceChoice>> forceDeviceOf(const ForceChoices& choices) {
  if (choices.device.isEmpty()) return std::optional<playback::ForceDeviceChoice>();
  Result<playback::ForceDeviceChoice> chosen = playback::forceDeviceFrom(choices.device.toStdString());
  if (!chosen) return chosen.failure();
  chosen->mmPerTurn = choices.mmPerTurn;
  chosen->uploadTable = choices.upload;
  chosen->firmwareFile = choices.firmwareFile.toStdString();
  if (choices.step_mm > 0) chosen->profile.step_mm = choices.step_mm;
  if (choices.largest_N > 0) chosen->profile.limits.force_N = choices.largest_N;
  return std::optional(*std::move(chosen));
}

QVariantMap toMap(const FeelSettings& s) {
  return {{"drive", QLatin1String(drives.word(s.drive))},
          {"full_N", s.full_N},
          {"followState", s.followState},
          {"mode", QLatin1String(playback::feedbackModes.word(s.mode))},
          {"placement", QLatin1String(playback::eventPlacements.word(s.placement))},
          {"profileFile", s.profileFile},
          {"referenceFile", s.referenceFile},
          {"sound", s.sound},
          {"device", s.device},
          {"rate_Hz", s.rate_Hz},
          {"buffer", s.buffer},
          {"gain_dB", s.gain_dB},
          {"sensorPort", s.sensorPort},
          {"sensorBaud", s.sensorBaud},
          {"forceDevice", s.force.device},
          {"forceLargest_N", s.force.largest_N},
          {"forceStep_mm", s.force.step_mm},
          {"forceMmPerTurn", s.force.mmPerTurn},
          {"forceFirmware", s.force.firmwareFile},
          {"forceUpload", s.force.upload},
          {"forceHolds", s.force.holds},
          {"forceController", s.force.controller}};
}

FeelSettings feelSettingsFrom(const QVariantMap& map) {
  FeelSettings s;
  read(map, "drive", drives, s.drive);
  read(map, "full_N", 0, 1000, s.full_N);
  read(map, "followState", s.followState);
  read(map, "mode", playback::feedbackModes, s.mode);
  read(map, "placement", playback::eventPlacements, s.placement);
  s.profileFile = map.value("profileFile").toString();
  s.referenceFile = map.value("referenceFile").toString();
  read(map, "sound", s.sound);
  s.device = map.value("device").toString();
  read(map, "rate_Hz", 0, 192000, s.rate_Hz);
  read(map, "buffer", 0U, 8192U, s.buffer);
  read(map, "gain_dB", lowestGain_dB, highestGain_dB, s.gain_dB);
  s.sensorPort = map.value("sensorPort").toString();
  read(map, "sensorBaud", 300U, 4000000U, s.sensorBaud);
  s.force.device = map.value("forceDevice").toString();
  read(map, "forceLargest_N", 0, strongestDevice_N, s.force.largest_N);
  read(map, "forceStep_mm", 0, coarsestStep_mm, s.force.step_mm);
  read(map, "forceMmPerTurn", -longestTurn_mm, longestTurn_mm, s.force.mmPerTurn);
  s.force.firmwareFile = map.value("forceFirmware").toString();
  read(map, "forceUpload", s.force.upload);
  read(map, "forceHolds", s.force.holds);
  read(map, "forceController", s.force.controller);
  return s;
}

}  // namespace detent::editor
