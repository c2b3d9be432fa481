// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The USB side of a Falcon: an FTDI serial chip under libusb. falcon_usb.cpp alone includes it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "model/result.h"

namespace detent::playback {

/// How the chip talks to the Falcon's processor.
enum class FalconLine : std::uint8_t {
  hello,   ///< 9600 baud: the processor is reset and asked who it is
  upload,  ///< 140,000 baud: it takes a firmware
  run      ///< 1.5 Mbaud, answers at once
};

/// One thread, besides construction.
class FalconUsb {
 public:
  /// The `number`th Falcon on the bus, counted from 0. Trouble where there is none, or no right to it.
  static Result<std::unique_ptr<FalconUsb>> open(unsigned number);
  ~FalconUsb();

  /// False once it was unplugged or the bus gave an error: it has to be opened anew.
  bool alive() const;
  /// Sets the line; false where the device does not take it.
  bool set(FalconLine line);
  /// Hands bytes (at most 64) to the device without waiting; false while the ones before are still on their way.
  bool send(std::span<const std::uint8_t> bytes);
  /// Waits until everything was sent, or `deadline_s` (on now_s()).
  bool sent(double deadline_s);
  /// What came, waiting until something does or `deadline_s`. Valid until the next call.
  std::span<const std::uint8_t> receive(double deadline_s);

 private:
  struct Link;
  explicit FalconUsb(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace detent::playback
