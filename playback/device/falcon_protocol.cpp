// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/falcon_protocol.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace detent::playback {

namespace {

constexpr std::uint8_t opening = '<', closing = '>', zero = 'A';
constexpr std::size_t bytesPerValue = 4, stateByte = 13;
constexpr std::uint8_t homingBit = 1, allHomed = 7;

constexpr std::uintmax_t largestFirmware_bytes = 1 << 18;
// Boot image of a TMS320F281x (SPRU095, "8-bit data stream"): key, 8 words reserved, entry point, blocks.
constexpr std::uint16_t bootKey = 0x08AA;
constexpr std::size_t firstBlock = 22, addressBytes = 4;

std::uint16_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

/// Value of four letters, the lowest four bits first; none if one is not such a letter.
std::optional<int> valueAt(const FalconPacket& packet, std::size_t at) {
  std::uint16_t value = 0;
  for (std::size_t i = 0; i < bytesPerValue; ++i) {
    const int digit = packet[at + i] - zero;
    if (digit < 0 || digit > 15) return {};
    value = static_cast<std::uint16_t>(value | digit << (4 * i));
  }
  return static_cast<std::int16_t>(value);
}

std::optional<FalconAnswer> answerOf(const FalconPacket& packet) {
  FalconAnswer answer;
  for (std::size_t i = 0; i < answer.counts.size(); ++i) {
    const std::optional<int> count = valueAt(packet, 1 + i * bytesPerValue);
    if (!count) return {};
    answer.counts[i] = *count;
  }
  answer.homed = ((packet[stateByte] - zero) >> 4 & allHomed) == allHomed;
  return answer;
}

Failure notReadable(const std::string& file, Message problem) {
  return {
      FailureCode::unreadableInput, file, "", std::move(problem),
      Message("Name the firmware file that came with the Falcon's driver (docs/guide/force-feedback.md)")};
}

}  // namespace

FalconPacket falconPacket(const FalconCommand& command) {
  FalconPacket packet;
  packet.fill(zero);
  packet.front() = opening;
  packet.back() = closing;
  for (std::size_t i = 0; i < command.motors.size(); ++i) {
    for (std::size_t digit = 0; digit < bytesPerValue; ++digit) {
      const unsigned bits = static_cast<unsigned>(command.motors[i]) >> (4 * digit) & 15U;
      packet[1 + i * bytesPerValue + digit] = static_cast<std::uint8_t>(zero + bits);
    }
  }
  packet[stateByte] = static_cast<std::uint8_t>(zero + static_cast<std::uint8_t>(command.light) +
                                                (command.homing ? homingBit : 0));
  return packet;
}

// '<' and '>' occur only at the ends of a packet, so wherever one stands, a packet begins or ends.
std::optional<FalconAnswer> FalconAnswers::take(std::uint8_t byte) {
  if (byte == opening) {
    malformed_ += length_ > 0 ? 1 : 0;
    length_ = 0;
  } else if (length_ == 0) {
    return {};
  }
  packet_[length_++] = byte;
  if (byte != closing && length_ < packet_.size()) return {};
  const bool whole = byte == closing && length_ == packet_.size();
  length_ = 0;
  const std::optional<FalconAnswer> answer = whole ? answerOf(packet_) : std::nullopt;
  malformed_ += answer ? 0 : 1;
  return answer;
}

bool isFalconFirmware(std::span<const std::uint8_t> image) {
  if (image.size() < firstBlock + 2 || wordAt(image, 0) != bootKey) return false;
  std::size_t at = firstBlock, blocks = 0;
  while (at + 2 <= image.size()) {
    const std::size_t words = wordAt(image, at);
    at += 2;
    if (words == 0) return blocks > 0 && at == image.size();
    at += addressBytes + 2 * words;
    ++blocks;
  }
  return false;
}

Result<std::vector<std::uint8_t>> readFalconFirmware(const std::string& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return notReadable(file, Message("the file cannot be read (%1)", error.message()));
  if (size > largestFirmware_bytes)
    return notReadable(file, Message("the file is not Falcon firmware: it is too large"));
  std::vector<std::uint8_t> image(static_cast<std::size_t>(size));
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(image.data()), static_cast<std::streamsize>(image.size()));
  if (!in) return notReadable(file, Message("the file cannot be read"));
  if (!isFalconFirmware(image))
    return notReadable(
        file, Message("the file is not Falcon firmware: it is not a boot image of the Falcon's processor"));
  return image;
}

}  // namespace detent::playback
