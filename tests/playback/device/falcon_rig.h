// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A simulated Novint Falcon: its USB chip and its processor's boot loader under umockdev, so that Debian's
// own libusb talks to it. Its behaviour is taken from libnifalcon, not measured.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace detent::test {

/// Made before libusb is first used; one at a time.
class FalconRig {
 public:
  FalconRig();
  ~FalconRig();
  FalconRig(const FalconRig&) = delete;
  FalconRig& operator=(const FalconRig&) = delete;

  /// The handle: counts of the three encoders, and whether all index marks have been passed.
  std::array<std::atomic<int>, 3> counts{};
  std::atomic<bool> homed{true};
  /// Last commands to the motors and the light.
  std::array<std::atomic<int>, 3> motors{};
  std::atomic<int> light{0};
  std::atomic<std::uint64_t> packets{0};  ///< good ones

  // Faults.
  std::atomic<int> badEchoes{0};  ///< number of uploads that are spoilt in the middle
  enum class Answer : std::uint8_t { good, none, half, twice, nonsense };
  std::atomic<Answer> answer{Answer::good};

  void unplug();
  void plugIn();
  /// As after the power switch: no firmware.
  void powerCycle();
  /// The last complete firmware that was uploaded.
  std::vector<std::uint8_t> firmware() const;

 private:
  struct Bus;
  std::unique_ptr<Bus> bus_;
};

/// A boot image with one block; its words count up.
std::vector<std::uint8_t> anyFalconFirmware();

}  // namespace detent::test
