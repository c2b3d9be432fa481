// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Data on a Falcon's USB connection: packets of 16 bytes each way, and the firmware that it needs once after
// power-on. After libnifalcon (BSD-3); docs/develop/decisions/1103-falcon.md.

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
  std::array<int, 3> counts{};  ///< counts of the encoders
  bool homed = false;           ///< all three have passed their index mark
};

using FalconPacket = std::array<std::uint8_t, 16>;

/// '<', 14 values of four bits as letters from 'A', '>'.
FalconPacket falconPacket(const FalconCommand& command);

/// Takes bytes, returns whole answers; never keeps more than one packet.
class FalconAnswers {
 public:
  /// The answer that `byte` completes.
  std::optional<FalconAnswer> take(std::uint8_t byte);
  /// Number of invalid packets.
  std::uint64_t malformed() const { return malformed_; }
  void forget() { length_ = 0; }

 private:
  FalconPacket packet_{};
  std::size_t length_ = 0;  ///< bytes received of the present packet
  std::uint64_t malformed_ = 0;
};

/// Returns true if the bytes are a boot image for the Falcon's processor: a key, an entry point, blocks with
/// their lengths, and an end exactly at the end.
bool isFalconFirmware(std::span<const std::uint8_t> image);

/// Reads the firmware file that the user names, because its licence forbids distribution. Failure if it
/// cannot be read or is no firmware.
Result<std::vector<std::uint8_t>> readFalconFirmware(const std::string& file);

}  // namespace detent::playback
