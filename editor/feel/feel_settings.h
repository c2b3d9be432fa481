// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a person chooses in the feel panel; no part of any button.

#include <QString>
#include <QVariantMap>

#include "editor/feel/press_pad.h"
#include "playback/playback.h"

namespace detent::editor {

/// Plain value. The panel keeps it, the setup form edits it.
struct FeelSettings {
  Drive drive = Drive::time;
  double full_N = 0;        ///< force of a full press; 0: a quarter more than the button's strongest force
  bool followState = true;  ///< the graph shows the state that is felt
  playback::FeedbackMode mode = playback::FeedbackMode::full;
  playback::EventPlacement placement = playback::EventPlacement::timeStamped;
  QString profileFile;  ///< empty: a perfect device

  bool sound = true;    ///< the first press opens the device
  QString device;       ///< empty: the default output
  double rate_Hz = 0;   ///< 0: the device's own
  unsigned buffer = 0;  ///< frames; 0: the host's choice
  double gain_dB = 0;   ///< lowestGain_dB..highestGain_dB

  QString sensorPort;
  unsigned sensorBaud = 230400;

  friend bool operator==(const FeelSettings&, const FeelSettings&) = default;
};

inline constexpr double lowestGain_dB = -40, highestGain_dB = 20;
double gainOf(double dB);  ///< factor

QVariantMap toMap(const FeelSettings& settings);
/// Unknown keys are left out, missing and impossible values become defaults.
FeelSettings feelSettingsFrom(const QVariantMap& map);

}  // namespace detent::editor
