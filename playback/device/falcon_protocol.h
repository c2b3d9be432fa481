// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What goes over a Falcon's wire: 16 bytes each way, and the firmware it has to be given once after power-on. After libnifalcon
// (BSD-3); docs/develop/decisions/1103-falcon.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/result.h"

namespace detent::playback {

enum class FalconLight : std::uint8_t { none = 0, green = 2, blue = 4, red = 8 };

struct FalconCommand {
  std::array<int, 3> motors{};  ///< -32768..32767
  FalconLight light = FalconLight::none;
  bool homing = false;  ///< watch the encoders' index marks
};

struct FalconAnswer {
  std::array<int, 3> counts{};  ///< of the encoders
  bool homed = false;           ///< all three have passed their index mark
};

using FalconPacket = std::array<std::uint8_t, 16>;

/// '<', 14 values of four bits as letters from 'A', '>'.
FalconPacket falconPacket(const FalconCommand& command);

/// Bytes in, whole answers out; never more than one packet is kept.
class FalconAnswers {
 public:
  /// The answer that `byte` completes.
  std::optional<FalconAnswer> take(std::uint8_t byte);
  /// Packets that were none.
  std::uint64_t malformed() const { return malformed_; }
  void forget() { length_ = 0; }

 private:
  FalconPacket packet_{};
  std::size_t length_ = 0;  ///< of what has come of a packet
  std::uint64_t malformed_ = 0;
};

/// Whether bytes are a boot image as the Falcon's processor takes it: a key, an entry point, blocks with their lengths, an end
/// exactly at the end.
bool isFalconFirmware(std::span<const std::uint8_t> image);

/// A firmware file that the user names; its licence forbids to ship it. Trouble where it cannot be read or is none.
Result<std::vector<std::uint8_t>> readFalconFirmware(const std::string& file);

}  // namespace detent::playback
