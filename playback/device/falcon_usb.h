// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// USB connection of a Falcon: an FTDI serial chip, driven by libusb, which only falcon_usb.cpp includes.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "model/result.h"

namespace detent::playback {

/// Settings of the serial line between the chip and the Falcon's processor.
enum class FalconLine : std::uint8_t {
  hello,   ///< 9600 baud: the processor is reset and identifies itself
  upload,  ///< 140,000 baud: the processor receives a firmware
  run      ///< 1.5 Mbaud: the processor answers packets at once
};

/// One thread, except for construction.
class FalconUsb {
 public:
  /// Opens the `number`th Falcon on the bus, counted from 0. Failure if there is none, or without permission.
  static Result<std::unique_ptr<FalconUsb>> open(unsigned number);
  ~FalconUsb();

  /// Returns false after the device was unplugged or the bus reported an error; it must then be opened again.
  bool alive() const;
  /// Sets the line; returns false if the device does not accept it.
  bool set(FalconLine line);
  /// Passes at most 64 bytes to the device without waiting. Returns false while the previous ones are still
  /// being sent.
  bool send(std::span<const std::uint8_t> bytes);
  /// Waits until everything was sent, or `deadline_s` (on now_s()).
  bool sent(double deadline_s);
  /// Returns the received bytes; waits for them until `deadline_s`. Valid until the next call.
  std::span<const std::uint8_t> receive(double deadline_s);

 private:
  struct Link;
  explicit FalconUsb(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace detent::playback
