// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The signal messages of the paper's own route ("sends signal messages to a sound synthesizer by UDP
// packets", Apparatus): FUDI text as Pure Data speaks it, `;`-terminated. docs/reference/osc.md lists them
// with their OSC twins. Pure text handling.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "playback/realtime/haptic_program.h"

namespace detent::playback {

enum class SignalKind : std::uint8_t {
  jump,
  bottomOut,
  grain,
  force,
  displacement,
  gain,
  stop,  ///< emergency: removes the force of a force device, silences a player; with or without arguments
  hold,  ///< somebody holds, for hold-to-run
  none   ///< release of a controller's key (`grain` or `hold` with 0): has no effect and is not passed on
};

/// One message. Bursts carry frequency, duration and amplitude; the rest one value.
struct SignalMessage {
  SignalKind kind = SignalKind::force;
  Burst burst;        ///< for jump and bottomOut; for grain if it has numbers
  double value = 0;   ///< N, mm, or gain
  bool bare = false;  ///< "grain;" without numbers: the program's own grain
};

struct SignalCounts {
  std::uint64_t packets = 0, messages = 0, malformed = 0;
};

/// Returns true if the values are within the limits for messages: frequency (0, 2000] Hz, duration (0, 1] s,
/// amplitude [0, 1], gain [0, 1] of the player's own; all finite. Any other message is malformed. Shared by
/// FUDI and OSC.
bool acceptable(const SignalMessage& message);

/// Splits a packet into messages. Accepts any bytes; invalid messages are counted.
void parseFudi(std::string_view packet, SignalCounts& counts,
               const std::function<void(const SignalMessage&)>& onMessage);

/// "jump 390 34 0.5;\n" (Hz, ms, share of full scale). Locale-independent.
std::string toFudi(const SignalMessage& message);

/// An OSC address and its float arguments as a message; false if there is no such message.
bool fromOsc(std::string_view address, const double* arguments, std::size_t count, SignalMessage& message);

}  // namespace detent::playback
